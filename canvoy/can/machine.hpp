// What this is compiled for: a small processor, where code and memory are dear, or a host, where
// time is. Both do the same on the bus. Objects of the library have other layouts: a program for
// one does not link with the library for the other (Node::start).
//
//     if constexpr (!is_small_machine) remember(found);
#pragma once

namespace canvoy {

/// Whoever compiles for a microcontroller defines CANVOY_SMALL_MACHINE for the library and for what
/// uses it (CMake: the option of this name, which canvoy::can hands on). A gateway of 32 bits is a
/// host without it, and a host with it compiles, and tests, what a microcontroller gets.
#ifdef CANVOY_SMALL_MACHINE
inline constexpr bool is_small_machine = true;
#else
inline constexpr bool is_small_machine = false;
#endif

/// What only a host keeps in an object. A small machine spares the memory, and never looks at it:
///
///     [[no_unique_address]] HostOnly<std::uint32_t> revision_;
template <class Value, bool is_kept = !is_small_machine>
struct HostOnly {
  Value value{};
};
template <class Value>
struct HostOnly<Value, false> {
  static inline Value value{};
};

}  // namespace canvoy
