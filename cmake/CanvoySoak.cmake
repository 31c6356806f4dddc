# canvoy_soak WORLD: hours of a world with faults, one for each seed; canvoy_soak gaps: all worlds with short gaps;
# canvoy_soak bus-places: each fault of a bus at a terminal, between stops and at one. As tests, soak.<world>, they have the
# seeds 1 to CANVOY_SOAK_SEEDS.
set(CANVOY_SOAK_SEEDS 5 CACHE STRING "How many seeds of each world the tests play")
add_executable(canvoy_soak "${PROJECT_SOURCE_DIR}/bench/soak/soak.cpp")
canvoy_warnings(canvoy_soak)
set_target_properties(canvoy_soak PROPERTIES CXX_EXTENSIONS OFF)
target_link_libraries(canvoy_soak PRIVATE canvoy::worlds)
if(CANVOY_TESTS)
  foreach(world IN ITEMS lift charger taxi police bus excavator gaps bus-places)
    canvoy_add_test(soak.${world} soak 3600 canvoy_soak ${world} ${CANVOY_SOAK_SEEDS})
  endforeach()
endif()
