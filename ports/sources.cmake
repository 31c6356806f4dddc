# canvoy_board_sources(<variable> <folder>...): the sources of canvoy/<folder> for a board: without those that need Linux,
# tests and the simulated bus. The linker selects the objects to link: -ffunction-sections, --gc-sections.
get_filename_component(CANVOY_ROOT "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

function(canvoy_board_sources variable)
  set(found "")
  foreach(folder IN LISTS ARGN)
    file(GLOB_RECURSE sources "${CANVOY_ROOT}/canvoy/${folder}/*.cpp")
    list(APPEND found ${sources})
  endforeach()
  list(FILTER found EXCLUDE REGEX "_test\\.cpp$|/(host|testing|simulated)/|heap_node\\.cpp$")
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# Writes the header of the version into a folder, as a build of the whole project does.
function(canvoy_board_version folder)
  file(STRINGS "${CANVOY_ROOT}/CMakeLists.txt" line REGEX "^project\\(canvoy VERSION")
  string(REGEX MATCH "([0-9]+)\\.([0-9]+)\\.([0-9]+)" PROJECT_VERSION "${line}")
  set(PROJECT_VERSION_MAJOR ${CMAKE_MATCH_1})
  set(PROJECT_VERSION_MINOR ${CMAKE_MATCH_2})
  set(PROJECT_VERSION_PATCH ${CMAKE_MATCH_3})
  configure_file("${CANVOY_ROOT}/cmake/version.hpp.in" "${folder}/canvoy/version.hpp" @ONLY)
endfunction()
