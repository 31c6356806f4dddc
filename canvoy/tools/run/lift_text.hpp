// A building with lifts in words and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "canvoy/sim/lift/lift_event.hpp"
#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/lift/lift_snapshot.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// `lift 2 stops at floor 7`
ToldEvent told_event(const lift::LiftEvent& event, const lift::LiftNetworkDescription& network);

/// Floors and lifts, for who draws them.
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
  /// `lift 2 stops at floor 7`
  static ToldEvent event(const lift::LiftEvent& event, const lift::LiftNetwork& network);
  /// What a terminal shows: the shafts with cars, doors, calls and people.
  static std::string picture(lift::LiftNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(lift::LiftNetwork& network);
  static std::string summary_text(lift::LiftNetwork& network);
  static nlohmann::ordered_json summary(lift::LiftNetwork& network);
};

}  // namespace canvoy::tools
