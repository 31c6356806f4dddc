// Hands of a network file at played devices of a car: those of hand_file.hpp, except for what the
// car around the device does by itself.
//
//     file.parts.push_back(hands_part<TaxiNetwork, Run>(TaxiOptions{}, node_count));
//     plan_hands(network, run.hands);
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/tools/device/car/car_hands.hpp"
#include "canvoy/tools/play/hand_file.hpp"
#include "canvoy/worlds/car/car_node.hpp"

namespace canvoy::tools {

/// A place of a car, with its virtual devices.
struct HandPlace {
  std::string name;
  std::vector<const cia447::CarUnit*> units;
};

/// Throws Failure with file and line: no such device, no such hand of it, or a hand that the world
/// does not allow.
void check_hand(const TomlTable& table, const HandOfFile& hand, std::span<const HandPlace> places);
/// Performs an order at a device; no effect without power.
HandActed act(const HandOrder& order, car::CarNode& node, const std::string& text);

/// The places of a world.
template <class Network, class Options>
std::vector<HandPlace> hand_places(const Options& options) {
  const auto network = std::make_unique<Network>(options);
  std::vector<HandPlace> places;
  for (const auto& node : network->nodes()) {
    places.push_back(
        {std::string(node->place().name), {node->units().begin(), node->units().end()}});
  }
  return places;
}

/// Reads each `[[hands]]` of the file; the devices must be read before. `all` are options with all
/// devices, and `nodes` gives how many of them a run has.
template <class Network, class Run, class Options>
FilePart<Run> hands_part(const Options& all, std::size_t (*nodes)(const Run&)) {
  return several<Run, HandOfFile>(
      [](const Run&) { return hand_table(); }, [](const Run& run) { return run.hands; },
      [all, nodes](const TomlTable& table, Run& run, HandOfFile hand) {
        static const std::vector<HandPlace> places = hand_places<Network>(all);
        check_hand(table, hand, std::span(places).first(nodes(run)));
        for (const NodeId real : run.network.real) {
          if (places[real - std::size_t{1}].name != hand.device) continue;
          table.refuse("device", "it is not played here: its hands are where it is");
        }
        add_hand(table, run.hands, std::move(hand));
      });
}

/// Plans the hands in the world, where they are events. The network must outlive its run.
template <class Network>
void plan_hands(Network& network, const std::vector<HandOfFile>& hands) {
  for (const HandOfFile& hand : hands) {
    for (const auto& node : network.nodes()) {
      if (node->place().name != hand.device) continue;
      plan_hand(
          network.world(), hand, checked_order(hand, hand_tables(node->units())),
          [&network, at = node.get()](Time now, const HandOrder& order, const std::string& text) {
            network.note_hand(now, act(order, *at, text));
            network.world().touched(at->slot());
          });
    }
  }
}

}  // namespace canvoy::tools
