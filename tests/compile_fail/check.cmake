# cmake -D compiler=... -D program=... -D includes=... -P check.cmake
#
# The program names its misuses in lines such as
#     // MISUSE_POINT_PLUS_POINT: no match for 'operator\+'|invalid operands
# and encloses each in #ifdef MISUSE_POINT_PLUS_POINT and #endif. It must compile without these macros, and must not compile with any one of
# them; the compiler's message must match the regular expression after the colon. The names and the sections are the same, in the same order.

cmake_minimum_required(VERSION 3.25)
set(ENV{LC_ALL} C)
list(TRANSFORM includes PREPEND -I)

function(compile out_status out_message)
  execute_process(
    COMMAND ${compiler} -std=c++20 -fsyntax-only ${includes} ${ARGN} ${program}
    RESULT_VARIABLE status
    OUTPUT_VARIABLE message
    ERROR_VARIABLE message
  )
  set(${out_status} ${status} PARENT_SCOPE)
  set(${out_message} "${message}" PARENT_SCOPE)
endfunction()

compile(status message)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${program} must compile without misuse, and does not:\n${message}")
endif()

file(STRINGS ${program} misuses REGEX "^// MISUSE_[A-Z_]+: .+$")
file(STRINGS ${program} sections REGEX "^#ifdef MISUSE_[A-Z_]+$")
list(TRANSFORM sections REPLACE "#ifdef (.+)" "\\1")
list(TRANSFORM misuses REPLACE "^// (MISUSE_[A-Z_]+): .+$" "\\1" OUTPUT_VARIABLE names)
if(NOT sections OR NOT "${names}" STREQUAL "${sections}")
  message(FATAL_ERROR "${program} names the misuses ${names}, and has the sections ${sections}")
endif()
foreach(line IN LISTS misuses)
  string(REGEX MATCH "^// (MISUSE_[A-Z_]+): (.+)$" line "${line}")
  set(misuse ${CMAKE_MATCH_1})
  set(expected "${CMAKE_MATCH_2}")
  compile(status message -D${misuse})
  if(status EQUAL 0)
    message(FATAL_ERROR "${program} compiles with ${misuse}, and must not")
  elseif(NOT message MATCHES "${expected}")
    message(FATAL_ERROR "${program} fails with ${misuse} as it must, but not with '${expected}':\n${message}")
  endif()
  message(STATUS "${misuse} does not compile")
endforeach()
