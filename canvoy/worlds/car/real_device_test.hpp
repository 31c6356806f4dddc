// A device that a test puts on the bus of a simulated car, with its own hardware, in place of one
// that is not simulated there.
//
//     RealDevice alarm(network.world(), car::units_of<cia447::TaxiAlarmKind>, {.id = 8, ...}, 9);
//     alarm.join();
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/car/car_node.hpp"

namespace canvoy::car {

class RealDevice {
 public:
  /// `slot` is the first free one of the world.
  RealDevice(World& world, std::span<const cia447::CarUnit* const> units,
             const CarNode::Place& place, SlotIndex slot)
      : world_(world), units_(units), place_(place), slot_(slot) {}

  template <class Source>
  void provide(const Source& source) {
    environment_.provide(source);
  }
  template <class Watcher>
  void watch(Watcher&& watcher) {
    environment_.watch(std::forward<Watcher>(watcher));
  }
  /// Joins the bus, also again after it was away.
  void join() {
    if (!node_) node_.emplace(world_, 0, units_, place_, environment_);
    node_->power(true);
  }
  void vanish() { node_->power(false); }
  /// Call it after the device was changed from outside of the world.
  void touched() { world_.touched(slot_); }
  CarNode& node() { return *node_; }
  NodeId id() const { return place_.id; }

 private:
  World& world_;
  std::span<const cia447::CarUnit* const> units_;
  CarNode::Place place_;
  SlotIndex slot_;
  Environment environment_;
  std::optional<CarNode> node_;
};

/// Names of the invariants of a world that cannot be judged, each followed by a space.
template <class Network>
std::string undecided_names(const Network& network) {
  std::string names;
  for (const auto& invariant : network.invariants()) {
    if (!invariant.is_decided()) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

/// Checks the first minute, in which a device may still come: this one has come already.
template <class Network>
void expect_early_loss_is_told(Network& network, RealDevice& device) {
  constexpr Time all_have_started(25s);
  network.run_until(all_have_started);
  for (const auto& node : network.nodes()) {
    EXPECT_NE(node->is_operational(), node->place().id == device.id()) << node->place().name;
  }
  EXPECT_TRUE(device.node().is_operational());
  device.vanish();
  network.run_until(all_have_started + 21s);
  EXPECT_EQ(broken_names(network), "");
  network.run_until(all_have_started + 24s);
  EXPECT_EQ(broken_names(network), "device_missing ");
}

/// Checks a device that starts, is away for ten seconds, and stays for the rest of the run, over
/// sleep and waking. Then it goes, and is missed: its last heartbeat holds for 3 s, and 20 s are
/// allowed.
template <class Network>
void expect_supervision(Network& network, RealDevice& device, Time away, Time end) {
  network.run_until(away);
  EXPECT_TRUE(device.node().is_operational());
  EXPECT_EQ(broken_names(network), "");
  device.vanish();
  network.run_until(away + 10s);
  device.join();
  network.run_until(away + 20s);
  EXPECT_TRUE(device.node().is_operational()) << "it is back";
  network.run_until(end);
  EXPECT_TRUE(device.node().is_operational());
  EXPECT_EQ(broken_names(network), "");
  device.vanish();
  network.run_until(end + 21s);
  EXPECT_EQ(broken_names(network), "");
  network.run_until(end + 24s);
  EXPECT_EQ(broken_names(network), "device_missing ");
}

}  // namespace canvoy::car
