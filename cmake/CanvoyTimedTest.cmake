# canvoy_add_test(<name> <label> <seconds> <command>...): a test that ctest runs in the project's folder and selects by its
# label. Where the program time(1) is there, the processor time of the test and of all that it waits for is appended to
# test-times.tsv of the build folder, a line each: seconds by the clock, of user and system, and the name.
find_program(CANVOY_TIME time)
mark_as_advanced(CANVOY_TIME)

function(canvoy_add_test name label seconds)
  set(timed "")
  if(CANVOY_TIME)
    set(timed "${CANVOY_TIME}" -q -a -o "${PROJECT_BINARY_DIR}/test-times.tsv" -f "%e\t%U\t%S\t${name}")
  endif()
  add_test(NAME ${name} COMMAND ${timed} ${ARGN} COMMAND_EXPAND_LISTS WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${seconds})
endfunction()
