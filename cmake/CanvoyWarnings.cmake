# canvoy_warnings(<target> [FREESTANDING]): the warnings that all of our code is free of, under both compilers. Where
# std::string may be used, without those that g++ 12 gives for std::string itself (GCC bugs 105329 and 105651). Where
# sources are compiled in batches, a name in one file hides nothing in another.
function(canvoy_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast
    $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-shadow>
    $<$<BOOL:${CANVOY_WARNINGS_AS_ERRORS}>:-Werror>)
  if(NOT "FREESTANDING" IN_LIST ARGN)
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds>)
  endif()
endfunction()
