# canvoy_soak_<world>: hours of a world with faults, one for each seed; canvoy_soak_gaps: all worlds with short gaps. As
# tests, soak.<world>, they have the seeds 1 to CANVOY_SOAK_SEEDS.
set(CANVOY_SOAK_SEEDS 5 CACHE STRING "How many seeds of each world the tests play")
foreach(world IN ITEMS lift charger taxi police bus excavator gaps)
  add_executable(canvoy_soak_${world} "${PROJECT_SOURCE_DIR}/bench/soak/soak_${world}.cpp")
  canvoy_warnings(canvoy_soak_${world})
  set_target_properties(canvoy_soak_${world} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(canvoy_soak_${world} PRIVATE canvoy::sim)
  if(CANVOY_TESTS)
    canvoy_add_test(soak.${world} soak 3600 canvoy_soak_${world} ${CANVOY_SOAK_SEEDS})
  endif()
endforeach()
