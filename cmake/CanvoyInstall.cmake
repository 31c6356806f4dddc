# What `cmake --install` writes: headers, libraries, the command, and the files by which CMake and pkg-config find them.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY CANVOY_INSTALLED_LIBRARIES)
install(TARGETS ${libraries} EXPORT canvoy)
if(TARGET canvoy)
  install(TARGETS canvoy)
endif()

install(DIRECTORY canvoy TYPE INCLUDE FILES_MATCHING PATTERN "*.hpp" PATTERN "*_test.hpp" EXCLUDE PATTERN tools EXCLUDE)
install(FILES "${PROJECT_BINARY_DIR}/include/canvoy/version.hpp" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/canvoy)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/canvoy)
install(EXPORT canvoy NAMESPACE canvoy:: DESTINATION ${package_dir} FILE canvoyConfig.cmake)
write_basic_package_version_file(canvoyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/canvoyConfigVersion.cmake" DESTINATION ${package_dir})

# A static linker reads from left to right: the libraries built on others come first.
set(pc_libraries "")
foreach(library IN LISTS libraries)
  get_target_property(type ${library} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    string(PREPEND pc_libraries " -l${library}")
  endif()
endforeach()
file(RELATIVE_PATH prefix_from_pc "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
configure_file(cmake/canvoy.pc.in canvoy.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/canvoy.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
