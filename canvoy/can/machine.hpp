// What this is compiled for: a small processor, where code and memory are dear, or a host, where
// time is. Both do the same on the bus.
//
//     if constexpr (!is_small_machine) remember(found);
#pragma once

namespace canvoy {

/// Defining CANVOY_SMALL_MACHINE has a host compile, and test, what a microcontroller would get.
#ifdef CANVOY_SMALL_MACHINE
inline constexpr bool is_small_machine = true;
#else
inline constexpr bool is_small_machine = sizeof(void*) < 8;
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
