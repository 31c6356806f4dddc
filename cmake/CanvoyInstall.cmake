# What `cmake --install` writes: headers, libraries, the command, and the files by which CMake and pkg-config find them,
# a component for each library.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY CANVOY_INSTALLED_LIBRARIES)
install(TARGETS ${libraries} EXPORT canvoy)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET canvoy)
  install(TARGETS canvoy)
  install(FILES scripts/completion/canvoy.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME canvoy)
  install(FILES scripts/completion/_canvoy DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES scripts/completion/canvoy.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  # The command writes its pages itself, from its help.
  if(NOT CMAKE_CROSSCOMPILING)
    install(CODE "
      set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
      file(MAKE_DIRECTORY \"\${folder}\")
      execute_process(COMMAND \"$<TARGET_FILE:canvoy>\" man --all \"\${folder}\" COMMAND_ERROR_IS_FATAL ANY)")
  endif()
endif()

install(DIRECTORY canvoy TYPE INCLUDE
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*_test.hpp" EXCLUDE PATTERN testing EXCLUDE PATTERN tools EXCLUDE
  PATTERN web EXCLUDE PATTERN clauses EXCLUDE)
install(FILES "${PROJECT_BINARY_DIR}/include/canvoy/version.hpp" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/canvoy)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/canvoy)
install(EXPORT canvoy NAMESPACE canvoy:: DESTINATION ${package_dir} FILE canvoyTargets.cmake)
write_basic_package_version_file(canvoyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/canvoyConfig.cmake cmake/CanvoyDataSheet.cmake "${PROJECT_BINARY_DIR}/canvoyConfigVersion.cmake" DESTINATION ${package_dir})

# canvoy-<library>.pc for each; canvoy.pc stands for all that need no library of others.
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pc "/${pc_dir}" "/")
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")

function(canvoy_pkg_config name libs)
  set(pc_name ${name})
  set(pc_libs "${libs}")
  list(JOIN ARGN " " pc_requires)
  configure_file(cmake/canvoy.pc.in ${name}.pc @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION ${pc_dir})
endfunction()

set(bare "")
foreach(library IN LISTS libraries)
  get_target_property(type ${library} TYPE)
  get_target_property(links ${library} INTERFACE_LINK_LIBRARIES)
  set(requires ${links})
  if(NOT links)
    set(requires "")
  endif()
  set(of_others ${requires})
  list(FILTER of_others INCLUDE REGEX "::")
  list(TRANSFORM requires REPLACE "^.*::" "")
  list(TRANSFORM requires REPLACE "^canvoy_" "canvoy-")
  list(TRANSFORM requires TOLOWER)  # CMake's ZLIB is pkg-config's zlib
  string(REPLACE "canvoy_" "canvoy-" name ${library})
  set(needs_${library} ${of_others})
  foreach(link IN LISTS links)
    list(APPEND needs_${library} ${needs_${link}})
  endforeach()
  if(NOT needs_${library})
    list(PREPEND bare ${name})
  endif()
  set(libs "")
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    set(libs " -l${library}")
  endif()
  canvoy_pkg_config(${name} "${libs}" ${requires})
endforeach()
canvoy_pkg_config(canvoy "" ${bare})
