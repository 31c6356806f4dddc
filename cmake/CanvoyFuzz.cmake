# Each fuzz/<name>_fuzz.cpp is a libFuzzer program. As a test, fuzz.<name>_fuzz, it runs for CANVOY_FUZZ_SECONDS from
# the seeds in fuzz/corpus/<name>_fuzz. Inputs that break something go to fuzz/found/<name>, which `make clean` leaves
# alone, and are tried first from then on; so do new ways through the code where a campaign asks for that. Those that
# feed no node but a reader of text or bytes have soon seen all: half of the time is theirs.
set(CANVOY_FUZZ_SECONDS 10 CACHE STRING "How long each fuzz target runs as a test")
set(CANVOY_FUZZ_FOUND "${PROJECT_SOURCE_DIR}/fuzz/found" CACHE PATH "Where inputs that break something are kept")
set(CANVOY_FUZZ_CORPUS "${PROJECT_BINARY_DIR}/corpus" CACHE PATH "Where inputs that go new ways are kept")

function(canvoy_fuzz source)
  cmake_path(GET source STEM name)
  add_executable(${name} ${source})
  canvoy_warnings(${name})
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE canvoy::gateway canvoy::sim canvoy::host)
  if(name MATCHES "^(data_sheet|trace)_fuzz$")
    target_link_libraries(${name} PRIVATE canvoy::formats)
  endif()
  if(name STREQUAL "decoder_fuzz")
    target_link_libraries(${name} PRIVATE canvoy::decoder)
  endif()
  if(name MATCHES "^(network_file|arrival_list)_fuzz$")
    target_link_libraries(${name} PRIVATE canvoy::tools)
  endif()
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)

  set(found "${CANVOY_FUZZ_FOUND}/${name}")
  set(corpora "${CANVOY_FUZZ_CORPUS}/${name}" "${found}")
  file(MAKE_DIRECTORY ${corpora})
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/fuzz/corpus/${name}")
    list(APPEND corpora "${PROJECT_SOURCE_DIR}/fuzz/corpus/${name}")
  endif()
  set(seconds ${CANVOY_FUZZ_SECONDS})
  if(NOT name MATCHES "node_fuzz$")
    math(EXPR seconds "${seconds} / 2")
  endif()
  math(EXPR timeout "${seconds} + 120")
  add_test(NAME fuzz.${name}
    COMMAND ${name} -max_total_time=${seconds} -timeout=10 -rss_limit_mb=2048 -print_final_stats=1
            -artifact_prefix=${found}/ ${corpora})
  set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz TIMEOUT ${timeout})
endfunction()

enable_testing()
file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/fuzz/*_fuzz.cpp")
foreach(source IN LISTS sources)
  canvoy_fuzz(${source})
endforeach()
