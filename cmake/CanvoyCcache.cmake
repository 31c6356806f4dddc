# Compiles through ccache where there is one, unless the caller has chosen a launcher.
find_program(CANVOY_CCACHE ccache)
mark_as_advanced(CANVOY_CCACHE)
if(CANVOY_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CANVOY_CCACHE})
endif()
