// 1016h of a device that monitors certain nodes from the start: those with the recommended
// node-IDs.
//
//     describe(..., watched_nodes<1000, 6, 7, 8, 0>)  // three within a second each, and a free
//     place
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"

namespace canvoy::cia417 {

/// 1029h:01h of devices that stay operational when they lose a node that they monitor: a car with a
/// dead door still has to report its position. By default, CiA 301 takes such devices out of NMT
/// state operational.
inline constexpr std::uint8_t keeps_state = 1;

namespace detail {

constexpr EntryInfo watched_node(std::uint8_t sub, std::uint16_t time_ms, std::uint8_t node) {
  EntryInfo entry = cia301::consumer_heartbeat_entries[1];
  entry.sub_first = sub;
  entry.sub_last = sub;
  entry.initial = node == 0 ? 0U : static_cast<std::uint32_t>(node) << 16 | time_ms;
  return entry;
}

template <std::uint16_t time_ms, std::uint8_t... nodes>
inline constexpr auto watched_node_entries = [] {
  std::array<EntryInfo, sizeof...(nodes) + 1> entries{cia301::consumer_heartbeat_entries[0]};
  std::uint8_t sub = 0;
  ((++sub, entries[sub] = watched_node(sub, time_ms, nodes)), ...);
  return entries;
}();

constexpr ObjectInfo with_subs(ObjectInfo object, Items<EntryInfo> subs) {
  object.subs = subs;
  return object;
}

}  // namespace detail

/// A node-ID of 0 marks a free entry.
template <std::uint16_t time_ms, std::uint8_t... nodes>
inline constexpr ObjectInfo watched_nodes = detail::with_subs(
    cia301::consumer_heartbeat_object, detail::watched_node_entries<time_ms, nodes...>);

}  // namespace canvoy::cia417
