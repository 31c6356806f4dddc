# What sources of the library include of the standard library: a quarter to a half of what most take to be compiled.
set(canvoy_standard_headers <algorithm> <array> <bit> <bitset> <chrono> <cmath> <cstddef> <cstdint> <cstring> <functional>
  <limits> <map> <memory> <optional> <span> <string> <string_view> <tuple> <utility> <variant> <vector>)

# What the fuzz targets count of a library, where its tests share it with them: that takes no time that could be
# measured. A campaign's build (preset fuzz) looks at comparisons as well.
set(canvoy_coverage -fsanitize-coverage=inline-8bit-counters,pc-table)

# Of the libraries for boards, the sources that take memory from the heap: the simulated bus, and nodes that are put
# together when the program runs. They are objects of their own, also in batches, so that a board links none of them.
set(canvoy_on_the_heap "(simulated_[a-z_]+|frame_errors|heap_node|part_tables|car_device|bus_device|kinds)[.]cpp")

# canvoy_library(<name> [FREESTANDING] [NO_INSTALL] [TESTS_BY_FOLDER] [DEPENDS <name>...] [LINK <target>...] [EXCLUDE <path>...])
#
# Called in a folder's CMakeLists.txt, it makes
#   canvoy_<name>, alias canvoy::<name>, of all *.cpp of the folder and its subfolders but *_test.cpp, and
#   canvoy_<name>_test of all *_test.cpp, each test known to ctest as <name>.<suite>.<test>.
# A folder without sources is an interface library, so that others can depend on it from the first day.
#
#   FREESTANDING  without exceptions and RTTI (the tests have them: GoogleTest needs them)
#   NO_INSTALL    not part of the installed package
#   TESTS_BY_FOLDER  where tests are run in parts, each folder has its own
#   DEPENDS       the folders that this one is built on, by name
#   LINK          other targets that it needs
#   EXCLUDE       files and subfolders that belong to something else
#   GATHER        a header that takes long: in batches, the sources that include it stand together
#   PRECOMPILE    headers that most of its sources include, compiled once with those of the standard library
#
# The target's property CANVOY_ARCHIVES names it and all that it is built on, the lowest first.
function(canvoy_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FREESTANDING;NO_INSTALL;TESTS_BY_FOLDER" "GATHER" "DEPENDS;LINK;EXCLUDE;PRECOMPILE")
  canvoy_sources(sources tests ${arg_EXCLUDE})
  if(arg_GATHER)
    canvoy_gather(sources "${arg_GATHER}")
  endif()
  list(TRANSFORM arg_DEPENDS PREPEND canvoy_)

  set(target canvoy_${name})
  if(sources)
    set(scope PUBLIC)
    add_library(${target} ${sources})
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
    # Nobody replaces a function of the library at load time, so that one may be compiled into another, as clang does.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
    if(arg_FREESTANDING)
      canvoy_warnings(${target} FREESTANDING)
      target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti -fno-threadsafe-statics)
      set(on_the_heap ${sources})
      list(FILTER on_the_heap INCLUDE REGEX "/${canvoy_on_the_heap}$")
      if(on_the_heap)
        set_source_files_properties(${on_the_heap} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      endif()
    else()
      canvoy_warnings(${target})
    endif()
    if(CANVOY_FUZZ AND NOT CMAKE_CXX_FLAGS MATCHES "fuzzer")
      target_compile_options(${target} PRIVATE ${canvoy_coverage})
    endif()
    if(CANVOY_PRECOMPILED_HEADERS)
      target_precompile_headers(${target} PRIVATE ${canvoy_standard_headers} ${arg_PRECOMPILE})
    endif()
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(canvoy::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} ${scope} ${arg_DEPENDS} ${arg_LINK})

  set(archives "")
  foreach(dependency IN LISTS arg_DEPENDS)
    get_target_property(below ${dependency} CANVOY_ARCHIVES)
    list(APPEND archives ${below})
  endforeach()
  if(sources)
    list(APPEND archives ${target})
  endif()
  list(REMOVE_DUPLICATES archives)
  set_target_properties(${target} PROPERTIES CANVOY_ARCHIVES "${archives}")

  if(NOT arg_NO_INSTALL)
    set_property(GLOBAL APPEND PROPERTY CANVOY_INSTALLED_LIBRARIES ${target})
  endif()
  if(CANVOY_TESTS AND CANVOY_UNIT_TESTS AND tests)
    if(arg_TESTS_BY_FOLDER)
      list(PREPEND tests BY_FOLDER)
    endif()
    canvoy_test(${name} ${tests})
  endif()
endfunction()

# canvoy_gather(<sources> <header>): those of the sources that include the header come first.
function(canvoy_gather sources_inout header)
  foreach(source IN LISTS ${sources_inout})
    file(STRINGS "${source}" includes REGEX "^#include <${header}>" LIMIT_COUNT 1)
    if(includes)
      list(APPEND gathered "${source}")
    else()
      list(APPEND others "${source}")
    endif()
  endforeach()
  set(${sources_inout} ${gathered} ${others} PARENT_SCOPE)
endfunction()

# canvoy_sources(<sources> <tests> <exclude>...): the current folder's sources, without and with a test's name.
function(canvoy_sources sources_out tests_out)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  foreach(path IN LISTS ARGN)
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${path}(/|$)")
  endforeach()
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  set(${sources_out} ${sources} PARENT_SCOPE)
  set(${tests_out} ${tests} PARENT_SCOPE)
endfunction()
