# canvoy_test(<name> [BY_FOLDER] <source>...): the test program canvoy_<name>_test of library canvoy_<name>. Each of its tests is one
# for ctest, <name>.<suite>.<test>; or with CANVOY_TESTS_IN_PARTS some dozens of them are, <name>.part_<n>, and their
# results stand in test-reports/<name>.part_<n>.xml. With BY_FOLDER, each folder has parts of its own. The label of all is `unit`.
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
include(GoogleTest)

# Tests take longer to be compiled than to run. The sanitizers' builds are of type Debug. Where a build of another type
# optimises them, g++ takes a test's own operator new for the library's.
set(canvoy_test_options $<$<CONFIG:Release,Debug>:-O0> -Wno-mismatched-new-delete)
# g++ takes a designated initialiser for an incomplete one, and an `if` in front of GoogleTest's for an ambiguous one.
list(APPEND canvoy_test_options -Wno-missing-field-initializers -Wno-dangling-else)
# What a test does itself is not what is tested: its memory is watched, its arithmetic is not, and a failure names its line
# without the debugger's help. That halves the time that clang takes for it.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=address,undefined")
  list(APPEND canvoy_test_options -fno-sanitize=undefined -g0)
endif()

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
  set(by_folder FALSE)
  if(BY_FOLDER IN_LIST ARGN)
    list(REMOVE_ITEM ARGN BY_FOLDER)
    set(by_folder TRUE)
  endif()
  add_executable(${target} ${ARGN})
  canvoy_warnings(${target})
  target_compile_options(${target} PRIVATE ${canvoy_test_options})
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${target} PRIVATE canvoy_${name} GTest::gmock_main rapidcheck)
  target_precompile_headers(${target} REUSE_FROM canvoy_test_headers)
  # Of an inline function that the library and a test have compiled, the linker takes the first: the library's, which is
  # optimised, so that the library is tested as
  # it is, not as its tests are compiled. With sanitizers, what simulates takes 8 s in place of 12.
  get_target_property(archives canvoy_${name} CANVOY_ARCHIVES)
  list(TRANSFORM archives REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  target_link_options(${target} BEFORE PRIVATE LINKER:--whole-archive ${archives} LINKER:--no-whole-archive)
  if(CANVOY_TESTS_IN_PARTS AND by_folder)
    canvoy_test_folders(${name} ${target} ${ARGN})
    return()
  elseif(CANVOY_TESTS_IN_PARTS)
    list(LENGTH ARGN sources)
    canvoy_test_parts(${name} ${target} ${sources})
    return()
  endif()
  gtest_discover_tests(${target} TEST_PREFIX ${name}. NO_PRETTY_VALUES WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300 LABELS unit)
endfunction()

# canvoy_test_parts(<name> <target> <sources> [<filter>]): as many parts as give each about ten of that many sources, of the
# tests that GoogleTest's filter leaves. They are shuffled, so that a test that rests on another is seen. Order and the cases
# of properties are the same each time, so that what fails is a change's fault: `make properties` tries others.
function(canvoy_test_parts name target sources)
  math(EXPR parts "(${sources} + 9) / 10")
  math(EXPR last "${parts} - 1")
  list(TRANSFORM ARGN PREPEND --gtest_filter=)
  foreach(part RANGE ${last})
    set(test ${name}.part_${part})
    canvoy_add_test(${test} unit 900 $<TARGET_FILE:${target}>
      --gtest_brief=1 --gtest_shuffle --gtest_random_seed=301 ${ARGN})
    set(environment GTEST_TOTAL_SHARDS=${parts} GTEST_SHARD_INDEX=${part}
      RC_PARAMS=seed=301 GTEST_OUTPUT=xml:${PROJECT_BINARY_DIR}/test-reports/${test}.xml)
    set_tests_properties(${test} PROPERTIES ENVIRONMENT "${environment}")
  endforeach()
endfunction()

# canvoy_test_folders(<name> <target> <source>...): parts of each folder below the current one, <name>_<folder>.part_<n>, and
# of what stands in no folder, <name>.part_<n>: so that those of one folder can be left out.
function(canvoy_test_folders name target)
  set(folders "")
  set(others "")
  foreach(source IN LISTS ARGN)
    file(RELATIVE_PATH path "${CMAKE_CURRENT_SOURCE_DIR}" "${source}")
    if(NOT path MATCHES "^([a-z0-9_]+)/")
      list(APPEND others "${source}")
      continue()
    endif()
    set(folder ${CMAKE_MATCH_1})
    list(APPEND folders ${folder})
    list(APPEND sources_${folder} "${source}")
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(of_folders "")
  foreach(folder IN LISTS folders)
    canvoy_suites(filter ${sources_${folder}})
    list(LENGTH sources_${folder} count)
    canvoy_test_parts(${name}_${folder} ${target} ${count} "${filter}")
    string(APPEND of_folders ":${filter}")
  endforeach()
  list(LENGTH others count)
  if(count)
    string(SUBSTRING "${of_folders}" 1 -1 of_folders)
    canvoy_test_parts(${name} ${target} ${count} "*-${of_folders}")
  endif()
endfunction()

# canvoy_suites(<filter> <source>...): GoogleTest's filter of the suites in the sources.
function(canvoy_suites filter_out)
  set(suites "")
  foreach(source IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(STRINGS "${source}" lines REGEX "^(TYPED_)?TEST(_F|_P)?\\(")
    list(TRANSFORM lines REPLACE "^[A-Z_]+\\( *([A-Za-z0-9_]+).*" "\\1")
    list(APPEND suites ${lines})
  endforeach()
  list(REMOVE_DUPLICATES suites)
  list(TRANSFORM suites REPLACE "(.+)" "\\1.*:\\1/*:*/\\1.*:*/\\1/*")
  list(JOIN suites ":" filter)
  set(${filter_out} "${filter}" PARENT_SCOPE)
endfunction()
