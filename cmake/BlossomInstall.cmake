# The files that `cmake --install` copies: libraries, headers, the program, and the files for CMake and pkg-config.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY BLOSSOM_LAYERS)
list(TRANSFORM layers PREPEND blossom_ OUTPUT_VARIABLE targets)
if(TARGET blossom_cli)
  install(TARGETS blossom_cli)
endif()
install(TARGETS blossom_all ${targets} EXPORT blossom)
foreach(layer IN LISTS layers)
  get_target_property(folder blossom_${layer} SOURCE_DIR)
  install(DIRECTORY ${folder}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()
if(TARGET blossom_completions)
  set(completions ${CMAKE_CURRENT_BINARY_DIR}/cli/completions)
  set(share ${CMAKE_INSTALL_DATADIR})
  install(FILES ${completions}/bash DESTINATION ${share}/bash-completion/completions RENAME blossom)
  install(FILES ${completions}/fish DESTINATION ${share}/fish/vendor_completions.d RENAME blossom.fish)
  install(FILES ${completions}/zsh DESTINATION ${share}/zsh/site-functions RENAME _blossom)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Shared libraries are found relative to the program, so that the tree can be moved.
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(origin $<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>)
  set_target_properties(${targets} PROPERTIES INSTALL_RPATH "${origin}")
  if(TARGET blossom_cli)
    set_target_properties(blossom_cli PROPERTIES INSTALL_RPATH "${origin}/${bin_to_lib}")
  endif()
endif()

# The consumer of a static blossom must link GMP; a shared blossom has linked it.
set(consumer_needs_gmp FALSE)
if(NOT BUILD_SHARED_LIBS AND BLOSSOM_NUMBERS STREQUAL "gmp")
  set(consumer_needs_gmp TRUE)
endif()

# The same holds for pugixml, which writes pages and pictures, and for fmt.
set(consumer_needs_writers TRUE)
if(BUILD_SHARED_LIBS)
  set(consumer_needs_writers FALSE)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/blossom)
install(EXPORT blossom NAMESPACE blossom:: FILE blossomTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(
  cmake/blossomConfig.cmake.in blossomConfig.cmake INSTALL_DESTINATION ${package_dir}
)
write_basic_package_version_file(blossomConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES ${CMAKE_CURRENT_BINARY_DIR}/blossomConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/blossomConfigVersion.cmake
  DESTINATION ${package_dir}
)
if(consumer_needs_gmp)
  install(FILES cmake/FindGMP.cmake DESTINATION ${package_dir})
endif()

# A linker needs libraries after those that use them.
set(pc_libraries ${layers})
list(REVERSE pc_libraries)
list(TRANSFORM pc_libraries PREPEND -lblossom_)
if(consumer_needs_writers)
  list(APPEND pc_libraries -lpugixml -lfmt)
endif()
if(consumer_needs_gmp)
  list(APPEND pc_libraries -lgmp)
endif()
list(JOIN pc_libraries " " pc_libraries)
file(RELATIVE_PATH pc_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pc_to_prefix "${pc_to_prefix}")
configure_file(cmake/blossom.pc.in blossom.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/blossom.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
