# canvoy_test(<name> <source>...): the test program canvoy_<name>_test of library canvoy_<name>.
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
include(GoogleTest)

function(canvoy_test name)
  set(target canvoy_${name}_test)
  add_executable(${target} ${ARGN})
  canvoy_warnings(${target})
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${target} PRIVATE canvoy_${name} GTest::gmock_main rapidcheck)
  gtest_discover_tests(${target} TEST_PREFIX ${name}. WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endfunction()
