// The units of a lift that its controller monitors: their node-IDs, for heartbeats (1016h) and
// emergencies (1028h; CiA 301, 7.5.2.19 and 7.5.2.31).
//
//     watch(node.dictionary(), {.drive = 2, .position_unit = 4, .others = panels});
//
// The default settings are the recommendations of the special interest group.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia417/kit/door_words.hpp"

namespace canvoy::cia417 {

/// Recommended for units without which a lift can operate: a second position unit, gateway (which
/// may have light barriers), car top box, emergency call, car panels (16 to 20), and landing
/// panels.
inline constexpr auto recommended_others = [] {
  std::array<NodeId, 109> ids{5, 9, 12, 14};
  for (std::size_t i = 4; i < ids.size(); ++i) ids[i] = static_cast<NodeId>(16 + i - 4);
  return ids;
}();
static_assert(recommended_others.back() == 120);

/// Their node-IDs; 0: no such unit.
struct LiftUnits {
  NodeId drive = 2;                                          ///< car drive unit
  NodeId position_unit = 4;                                  ///< car position unit
  std::array<NodeId, door_count> door_units = {6, 7, 8, 0};  ///< of doors 1 to 4
  std::array<NodeId, door_count> light_barrier_units = {};   ///< of doors 1 to 4, as separate nodes
  NodeId load_unit = 13;                                     ///< load measuring unit
  /// Units that no trip needs: their loss is only reported. Must outlive the controller.
  std::span<const NodeId> others = recommended_others;
  /// Time after which they are lost. Panels send heartbeats rarely.
  std::uint16_t unit_time_ms = 1500;
  std::uint16_t other_time_ms = 3000;  ///< for the units that no trip needs

  /// True for a unit that a trip needs.
  bool has(NodeId id) const;
};

/// Writes 1016h, each node once, as far as there is room, and 1028h for emergencies of units on
/// their pre-defined CAN-IDs. For power-on values (Node::on_defaults_restored).
void watch(Dictionary& dictionary, const LiftUnits& units);

}  // namespace canvoy::cia417
