# Each fuzz/<name>.cpp is a libFuzzer program <name>. As a test, fuzz.<name>, it runs for CANVOY_FUZZ_SECONDS from
# the seeds in fuzz/corpus/<name>, and keeps what it finds in the build directory.
set(CANVOY_FUZZ_SECONDS 60 CACHE STRING "How long each fuzz target runs as a test")

function(canvoy_fuzz source)
  cmake_path(GET source STEM name)
  add_executable(${name} ${source})
  canvoy_warnings(${name})
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE canvoy::sim canvoy::host)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)

  set(found "${PROJECT_BINARY_DIR}/corpus/${name}")
  file(MAKE_DIRECTORY "${found}")
  set(corpora "${found}")
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/fuzz/corpus/${name}")
    list(APPEND corpora "${PROJECT_SOURCE_DIR}/fuzz/corpus/${name}")
  endif()
  math(EXPR timeout "${CANVOY_FUZZ_SECONDS} + 120")
  add_test(NAME fuzz.${name}
    COMMAND ${name} -max_total_time=${CANVOY_FUZZ_SECONDS} -timeout=10 -rss_limit_mb=2048 -print_final_stats=1
            -artifact_prefix=${PROJECT_BINARY_DIR}/crash-${name}- ${corpora})
  set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz TIMEOUT ${timeout})
endfunction()

enable_testing()
file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/fuzz/*.cpp")
foreach(source IN LISTS sources)
  canvoy_fuzz(${source})
endforeach()
