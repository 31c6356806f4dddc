// Checks invariants, which must hold whatever the bus, a file or the application does: if one
// fails, the library itself is wrong, and stops at once, so that a debugger or a sanitizer shows
// the position.
//
//     check_invariant(size_ <= backlog_.size());
//
// Active in all builds for an operating system; absent in firmware. For checks of a comparison or
// two: not for errors of a caller, which have their answer, nor for checks slower than the code
// around them.
#pragma once

namespace canvoy {

#if defined(__linux__) || defined(__APPLE__) || defined(_WIN32)
/// Whether this build checks invariants: builds for an operating system do.
inline constexpr bool has_checks = true;
#else
/// Whether this build checks invariants: firmware does not.
inline constexpr bool has_checks = false;
#endif

/// Stops the program by a trap if `condition` is false; costs a branch, and nothing without
/// has_checks.
constexpr void check_invariant(bool condition) {
  if constexpr (has_checks) {
    if (!condition) [[unlikely]] {
      __builtin_trap();
    }
  }
}

}  // namespace canvoy
