# Debian's emscripten with clang 16 in place of emscripten's own clang 14, which has not been tried, and with the headers of
# libc++ 16, as those of emscripten (libc++ 13) lack the algorithms of std::ranges. scripts/playground sets its environment.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER em++)
set(CMAKE_AR emar CACHE FILEPATH "")
set(CMAKE_RANLIB emranlib CACHE FILEPATH "")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# What is checked when it is compiled takes more steps with the functions of libc++, by clang's count.
set(CMAKE_CXX_FLAGS_INIT "-nostdinc++ -isystem /usr/include/wasm32-wasi/c++/v1 -fconstexpr-steps=100000000")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
