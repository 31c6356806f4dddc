# canvoy_warnings(<target>): the warnings that all of our code is free of, under both compilers.
function(canvoy_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast
    $<$<BOOL:${CANVOY_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
