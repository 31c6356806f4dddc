// What has to hold inside, whatever the bus, a file or the application does: where it does not, the
// library itself is wrong, and stops at once, where a debugger or a sanitizer shows the place.
//
//     must_hold(size_ <= backlog_.size());
//
// In all builds for an operating system; nothing is left of it in firmware. It is for what costs a
// comparison or two: neither for what a caller may do wrong, which has its answer, nor for what
// takes longer than the code around it.
#pragma once

namespace canvoy {

#if defined(__linux__) || defined(__APPLE__) || defined(_WIN32)
inline constexpr bool has_checks = true;
#else
inline constexpr bool has_checks = false;
#endif

constexpr void must_hold(bool condition) {
  if constexpr (has_checks) {
    if (!condition) [[unlikely]] {
      __builtin_trap();
    }
  }
}

}  // namespace canvoy
