// Text and JSON of a building with lifts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/worlds/lift/lift_event.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/lift_snapshot.hpp"

namespace canvoy::tools {

/// Text of an event: `lift 2 stops at floor 7`.
ReportedEvent reported_event(const lift::LiftEvent& event,
                             const lift::LiftNetworkDescription& network);

/// Floors and lifts, for drawing.
nlohmann::ordered_json building_json(const lift::LiftNetworkDescription& network);
nlohmann::ordered_json lift_snapshot_json(const lift::LiftNetworkDescription& network,
                                          const lift::LiftNetworkSnapshot& snapshot);

std::string lift_invariant_text(const lift::Invariant& invariant,
                                const lift::LiftNetworkDescription& network);
std::string lift_summary_text(const lift::LiftSummary& summary,
                              std::span<const lift::Invariant> invariants,
                              const lift::LiftNetworkDescription& network);
nlohmann::ordered_json lift_summary_json(const lift::LiftSummary& summary,
                                         std::span<const lift::Invariant> invariants,
                                         const lift::LiftNetworkDescription& network);

template <>
struct WorldText<lift::LiftNetwork> {
  /// Text of an event: `lift 2 stops at floor 7`.
  static ReportedEvent event(const lift::LiftEvent& event, const lift::LiftNetwork& network);
  /// Picture for a terminal: the shafts with cars, doors, calls and people.
  static std::string picture(lift::LiftNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(lift::LiftNetwork& network);
  static std::string summary_text(lift::LiftNetwork& network);
  static nlohmann::ordered_json summary(lift::LiftNetwork& network);
};

}  // namespace canvoy::tools
