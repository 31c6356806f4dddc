// The units of a lift, as its controller watches over them: which node-IDs they have, so that it
// hears their heartbeats (1016h) and emergencies (1028h; CiA 301, 7.5.2.19 and 7.5.2.31).
//
//     watch(node.dictionary(), {.drive = 2, .position_unit = 4, .others = panels});
//
// Without other settings they are those that the special interest group recommends.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/devices/cia417/door/door_words.hpp"

namespace canvoy::cia417 {

/// Recommended for what a lift can do without: a second position unit, gateway (where light
/// barriers may be), car top box, emergency call, car panels (16 to 20), and landing panels.
inline constexpr auto recommended_others = [] {
  std::array<NodeId, 109> ids{5, 9, 12, 14};
  for (std::size_t i = 4; i < ids.size(); ++i) ids[i] = static_cast<NodeId>(16 + i - 4);
  return ids;
}();
static_assert(recommended_others.back() == 120);

/// Their node-IDs; 0: there is none.
struct LiftUnits {
  NodeId drive = 2;
  NodeId position_unit = 4;
  std::array<NodeId, door_count> door_units = {6, 7, 8, 0};
  std::array<NodeId, door_count> light_barrier_units = {};
  NodeId load_unit = 13;
  /// A trip needs none of them: that they are lost is told, no more. Must outlive the controller.
  std::span<const NodeId> others = recommended_others;
  /// After which they are lost. Panels send heartbeats seldom.
  std::uint16_t unit_time_ms = 1500;
  std::uint16_t other_time_ms = 3000;

  /// It is one that a trip needs.
  bool has(NodeId id) const;
};

/// Writes 1016h, each node once, as far as it has room, and 1028h, where emergencies of units are
/// heard on their pre-defined CAN-IDs. For power-on values (Node::on_defaults_restored).
void watch(Dictionary& dictionary, const LiftUnits& units);

}  // namespace canvoy::cia417
