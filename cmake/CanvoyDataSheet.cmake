# canvoy_data_sheet(<target> HEADER <header> DEVICE <description> [OUTPUT <file>] [VENDOR <name>] [PRODUCT <name>] [NODE_ID <n>])
#
# Writes the EDS of the target's device beside the target, each time that it is built: pump.eds beside pump. HEADER declares the
# description (what `describe` has put together), DEVICE is its name there, with namespaces. Objects of the manufacturer have the
# names of the description. With a NODE_ID, the file is a DCF.
#
#     canvoy_data_sheet(pump HEADER pump.hpp DEVICE pump::description VENDOR "My company" PRODUCT "Pump")
#
# It needs canvoy::formats, and a program that runs where it is built: for another machine, nothing is written, and CMake says so.
function(canvoy_data_sheet target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER;DEVICE;OUTPUT;VENDOR;PRODUCT;NODE_ID" "")
  if(NOT arg_HEADER OR NOT arg_DEVICE OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "canvoy_data_sheet(${target}): say HEADER and DEVICE; unknown: '${arg_UNPARSED_ARGUMENTS}'")
  endif()
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(STATUS "canvoy_data_sheet(${target}): no data sheet from a build for another machine")
    return()
  endif()
  if(NOT TARGET canvoy::formats)
    message(FATAL_ERROR "canvoy_data_sheet(${target}): needs canvoy::formats: find_package(canvoy COMPONENTS formats), or CANVOY_FORMATS")
  endif()
  foreach(default IN ITEMS "VENDOR:not set" "PRODUCT:${target}" "NODE_ID:0" "OUTPUT:$<TARGET_FILE_DIR:${target}>/${target}.eds")
    string(REGEX MATCH "^([A-Z_]+):(.*)$" matched "${default}")
    if(NOT arg_${CMAKE_MATCH_1})
      set(arg_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    endif()
  endforeach()
  get_filename_component(header "${arg_HEADER}" ABSOLUTE)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${target}_sheet.cpp")
  file(GENERATE OUTPUT "${source}" CONTENT "// Writes the data sheet of ${target}: made by canvoy_data_sheet().
#include \"${header}\"

#include \"canvoy/formats/sheet/own_sheet.hpp\"

int main(int, char** arguments) {
  return canvoy::formats::write_own_sheet(
      ${arg_DEVICE},
      {.vendor_name = \"${arg_VENDOR}\", .product_name = \"${arg_PRODUCT}\", .node_id = ${arg_NODE_ID}}, arguments[1]);
}
")
  add_executable(${target}_sheet "${source}")
  target_compile_features(${target}_sheet PRIVATE cxx_std_20)
  target_include_directories(${target}_sheet PRIVATE "$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>")
  target_link_libraries(${target}_sheet PRIVATE canvoy::formats)
  add_dependencies(${target} ${target}_sheet)
  add_custom_command(TARGET ${target} POST_BUILD COMMAND ${target}_sheet "${arg_OUTPUT}" VERBATIM)
endfunction()
