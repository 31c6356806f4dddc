// Target of the build: a small processor, which is short of code and data memory, or a host, which
// is optimised for speed. But for CollisionWatch both behave alike on the bus. Their objects have
// different layouts: a program for one does not link with the library for the other (Node::start).
//
//     if constexpr (!is_small_machine) remember(found);
#pragma once

namespace canvoy {

/// A build for a microcontroller defines CANVOY_SMALL_MACHINE for the library and for its users
/// (CMake: the option of this name, which canvoy::can passes on). A gateway of 32 bits is a host
/// without it, and a host with it compiles, and tests, the code of a microcontroller.
#ifdef CANVOY_SMALL_MACHINE
/// True in a build for a microcontroller.
inline constexpr bool is_small_machine = true;
#else
/// True in a build for a microcontroller.
inline constexpr bool is_small_machine = false;
#endif

/// A member that only a host has in an object. A small machine saves the memory, and never reads
/// it:
///
///     [[no_unique_address]] HostOnly<std::uint32_t> revision_;
template <class Value, bool is_kept = !is_small_machine>
struct HostOnly {
  Value value{};  ///< on a host only
};
/// The empty member of a small machine.
template <class Value>
struct HostOnly<Value, false> {
  static inline Value value{};  ///< never read
};

}  // namespace canvoy
