# Settings and functions for all targets of the project.

add_library(blossom_warnings INTERFACE)
target_compile_options(
  blossom_warnings
  INTERFACE
    -Wall
    -Wextra
    -Wpedantic
    -Wcast-align
    -Wcast-qual
    -Wconversion
    -Wdouble-promotion
    -Wextra-semi
    -Wformat=2
    -Wimplicit-fallthrough
    -Wnon-virtual-dtor
    -Wold-style-cast
    -Woverloaded-virtual
    -Wshadow
    -Wsign-conversion
    -Wundef
    -Wunused
    $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-branches>
    $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond>
    $<$<CXX_COMPILER_ID:GNU>:-Wlogical-op>
    # GCC 12 warns about its own std::string where texts are concatenated (its bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    # Clang sees the deprecated function that libstdc++ 12 calls in its own std::stable_sort.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
)

# Sanitizers change what memory costs, so that tests of memory have other bounds.
set(BLOSSOM_SANITIZED OFF)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(BLOSSOM_SANITIZED ON)
endif()

# All layers together, for consumers that do not choose layers.
add_library(blossom_all INTERFACE)
add_library(blossom::blossom ALIAS blossom_all)
set_target_properties(blossom_all PROPERTIES EXPORT_NAME blossom)

# The settings that libraries, programs and tests share.
function(blossom_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:blossom_warnings>)
  set_target_properties(
    ${target} PROPERTIES CXX_EXTENSIONS OFF COMPILE_WARNING_AS_ERROR ${BLOSSOM_WERROR} UNITY_BUILD OFF
  )
endfunction()

# In a build of fuzzers, libFuzzer observes the control flow of the target.
function(blossom_show_to_fuzzers target)
  if(BLOSSOM_BUILD_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# blossom_add_layer(core DEPENDS rational SOURCES src/polynomial.cpp ...)
#
# Makes the library blossom_core, known as blossom::core here and to consumers, from the folder's sources and its
# public headers under include/, and adds it to blossom::blossom. Layers are added in dependency order.
function(blossom_add_layer layer)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;SOURCES")
  set(target blossom_${layer})
  add_library(${target} ${arg_SOURCES})
  add_library(blossom::${layer} ALIAS ${target})
  blossom_configure_target(${target})
  blossom_show_to_fuzzers(${target})
  target_include_directories(
    ${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE src
  )
  foreach(dependency IN LISTS arg_DEPENDS)
    target_link_libraries(${target} PUBLIC blossom_${dependency})
  endforeach()
  set_target_properties(
    ${target}
    PROPERTIES EXPORT_NAME ${layer}
               POSITION_INDEPENDENT_CODE ON
               DEFINE_SYMBOL "" # sources are compiled alike for shared and for static libraries
               UNITY_BUILD ${BLOSSOM_JOIN_SOURCES} # what is not a layer is never joined
               UNITY_BUILD_BATCH_SIZE 16
               SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
               VERSION ${PROJECT_VERSION}
               WINDOWS_EXPORT_ALL_SYMBOLS ON
  )
  target_link_libraries(blossom_all INTERFACE ${target})
  set_property(GLOBAL APPEND PROPERTY BLOSSOM_LAYERS ${layer})
endfunction()
