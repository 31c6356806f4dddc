// Inserts and removes items of an array: the others keep their order.
//
//     items[count++] = item;
//     move_into(items, count, position);
//     take_out(items, count--, position);
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "canvoy/can/machine.hpp"

namespace canvoy {

namespace detail {

/// One function for all items, whatever their size: a small machine needs it once.
[[gnu::noinline]] inline void rotate_up(std::uint8_t* place, std::uint8_t* end, std::size_t size) {
  for (std::uint8_t* byte = end - size; byte != place;) {
    --byte;
    std::swap(*byte, byte[size]);
  }
}
[[gnu::noinline]] inline void rotate_down(std::uint8_t* place, std::uint8_t* end,
                                          std::size_t size) {
  for (; place + size != end; ++place) std::swap(*place, place[size]);
}

template <class Item>
std::uint8_t* bytes_of(Item* item) {
  static_assert(std::is_trivially_copyable_v<Item>);
  return reinterpret_cast<std::uint8_t*>(item);
}

}  // namespace detail

/// Moves the last of `count` items to `position`.
template <class Item>
void move_into(Item* items, std::size_t count, std::size_t position) {
  if constexpr (is_small_machine) {
    detail::rotate_up(detail::bytes_of(items + position), detail::bytes_of(items + count),
                      sizeof(Item));
  } else {
    std::rotate(items + position, items + count - 1, items + count);
  }
}

/// Moves the item at `position` behind the others.
template <class Item>
void take_out(Item* items, std::size_t count, std::size_t position) {
  if constexpr (is_small_machine) {
    detail::rotate_down(detail::bytes_of(items + position), detail::bytes_of(items + count),
                        sizeof(Item));
  } else {
    std::rotate(items + position, items + position + 1, items + count);
  }
}

}  // namespace canvoy
