# find_package(canvoy CONFIG REQUIRED [COMPONENTS canopen devices ...]): a target canvoy::<component> for each library.
# Of them formats, decoder and words are built on libraries of others, which are looked for where one of these is asked for.
include(CMakeFindDependencyMacro)
foreach(component IN LISTS canvoy_FIND_COMPONENTS)
  if(component MATCHES "^(formats|decoder|words)$")
    find_dependency(fmt)
    find_dependency(nlohmann_json)
    find_dependency(pugixml)
    break()
  endif()
endforeach()

include("${CMAKE_CURRENT_LIST_DIR}/canvoyTargets.cmake")

foreach(component IN LISTS canvoy_FIND_COMPONENTS)
  if(TARGET canvoy::${component})
    set(canvoy_${component}_FOUND TRUE)
  elseif(canvoy_FIND_REQUIRED_${component})
    set(canvoy_FOUND FALSE)
    set(canvoy_NOT_FOUND_MESSAGE "there is no canvoy::${component}")
  endif()
endforeach()
