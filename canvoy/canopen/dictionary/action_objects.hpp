// Objects of CiA 301 and 302 that are not parameters: writing to them triggers an action, or they
// report a state. They are not stored, and a write to them does not change the configuration.
//
//     if (is_action_or_state(entry.index)) return;
#pragma once

#include <algorithm>
#include <cstdint>

namespace canvoy {

namespace detail {

struct IndexRange {
  std::uint16_t first;
  std::uint16_t last;
  constexpr bool contains(std::uint16_t index) const { return index >= first && index <= last; }
};

inline constexpr IndexRange actions_and_states[] = {
    {0x1000, 0x1003},  // device type, error register, manufacturer status, error field
    {0x1010, 0x1011},  // store, restore
    {0x1013, 0x1013},  // high resolution time stamp
    {0x1023, 0x1026},  // OS command and debugger
    {0x1F00, 0x1F01},  // request and release SDO
    {0x1F03, 0x1F06},  // SDO connections that were assigned
    {0x1F10, 0x1F11},  // dynamic SDO connection state, failed slaves
    {0x1F25, 0x1F25},  // configure slaves
    {0x1F50, 0x1F52},  // program data, control, verification
    {0x1F56, 0x1F57},  // program identification, flash status
    {0x1F82, 0x1F83},  // request NMT, request guarding
};

}  // namespace detail

/// True for an object that triggers an action or reports a state. Indices outside of 1000h to 1FFFh
/// are never one. Linear in eleven ranges.
constexpr bool is_action_or_state(std::uint16_t index) {
  return std::ranges::any_of(detail::actions_and_states, [index](const detail::IndexRange& range) {
    return range.contains(index);
  });
}

}  // namespace canvoy
