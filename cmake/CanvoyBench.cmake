# canvoy_bench: one program of all bench/*.cpp, with Google Benchmark.
file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/bench/*.cpp")
if(sources)
  find_package(benchmark REQUIRED)
  add_executable(canvoy_bench ${sources})
  canvoy_warnings(canvoy_bench)
  set_target_properties(canvoy_bench PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(canvoy_bench PRIVATE canvoy::sim benchmark::benchmark_main)
endif()
