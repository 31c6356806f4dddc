# canvoy_bench: one program of all bench/*.cpp, with Google Benchmark. It measures the tools, too.
if(NOT CANVOY_TOOLS)
  message(FATAL_ERROR "the benchmarks need CANVOY_TOOLS")
endif()
find_package(benchmark REQUIRED)
file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/bench/*.cpp")
add_executable(canvoy_bench ${sources})
canvoy_warnings(canvoy_bench)
set_target_properties(canvoy_bench PROPERTIES CXX_EXTENSIONS OFF)
target_link_libraries(canvoy_bench PRIVATE canvoy::sim canvoy::formats canvoy::tools benchmark::benchmark_main)

# canvoy_soak_lift, canvoy_soak_charger, canvoy_soak_taxi, canvoy_soak_police, canvoy_soak_bus and canvoy_soak_excavator: hours of each with faults, one for each seed; canvoy_soak_gaps: all of them with short gaps.
foreach(world IN ITEMS lift charger taxi police bus excavator gaps)
  add_executable(canvoy_soak_${world} "${PROJECT_SOURCE_DIR}/bench/soak/soak_${world}.cpp")
  canvoy_warnings(canvoy_soak_${world})
  set_target_properties(canvoy_soak_${world} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(canvoy_soak_${world} PRIVATE canvoy::sim)
endforeach()
