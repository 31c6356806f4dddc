# canvoy_test(<name> <source>...): the test program canvoy_<name>_test of library canvoy_<name>.
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
include(GoogleTest)

# Tests take longer to be compiled than to run. The sanitizers' builds are of type Debug. At -O1, g++ takes a test's
# own operator new for the library's.
set(canvoy_test_options $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-O0> -Wno-mismatched-new-delete)

# GoogleTest's headers compiled once for all of them: they take longer than most tests.
file(GENERATE OUTPUT test_headers.cpp CONTENT "// Only carries the precompiled headers of the tests.\n")
add_library(canvoy_test_headers OBJECT "${PROJECT_BINARY_DIR}/test_headers.cpp")
target_compile_features(canvoy_test_headers PUBLIC cxx_std_20)
target_link_libraries(canvoy_test_headers PUBLIC GTest::gmock_main rapidcheck)
canvoy_warnings(canvoy_test_headers)
target_compile_options(canvoy_test_headers PRIVATE ${canvoy_test_options})
set_target_properties(canvoy_test_headers PROPERTIES CXX_EXTENSIONS OFF)
target_precompile_headers(canvoy_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h>)

function(canvoy_test name)
  set(target canvoy_${name}_test)
  add_executable(${target} ${ARGN})
  canvoy_warnings(${target})
  target_compile_options(${target} PRIVATE ${canvoy_test_options})
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${target} PRIVATE canvoy_${name} GTest::gmock_main rapidcheck)
  target_precompile_headers(${target} REUSE_FROM canvoy_test_headers)
  gtest_discover_tests(${target} TEST_PREFIX ${name}. NO_PRETTY_VALUES WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endfunction()
