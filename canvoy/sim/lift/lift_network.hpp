// A building with lifts in a simulated world: all devices as CANopen nodes on their buses, cars,
// doors and scales behind them, people before them, faults by plan, and referees.
//
//     LiftNetwork network(standard_lift_network({.lifts = 4, .floors = 20, .seed = 1}));
//     network.run_until(Time(60min));
//     const LiftSummary summary = network.summary();
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The same description gives the same frames at the same times.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/sim/lift/lift_event.hpp"
#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/lift/lift_snapshot.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

class LiftNetwork {
 public:
  /// check(description) has to be empty. It is copied.
  explicit LiftNetwork(const LiftNetworkDescription& description);
  ~LiftNetwork();
  LiftNetwork(const LiftNetwork&) = delete;
  LiftNetwork& operator=(const LiftNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until);
  Time now() const;
  /// Somebody comes now, beside those of the traffic. False: no lift goes from there to there.
  bool visit(FloorNumber from, FloorNumber to);

  /// The first value that a node of the description did not take at its last boot-up.
  std::optional<RefusedValue> refused() const;
  /// A further observer of a bus, for a log; false where there are too many.
  bool observe(std::size_t bus, const BusTap& tap);
  LiftNetworkSnapshot snapshot() const;
  LiftSummary summary() const;
  /// All since the start, oldest first.
  std::span<const LiftEvent> events() const;

  /// As they stand now.
  std::vector<Invariant> invariants() const;
  /// None is broken.
  bool all_hold() const;

  const LiftNetworkDescription& description() const;

  // For tests, and for tools that take part: a real device that plays a node which the description
  // leaves out is connected to the bus.
  World& world();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace canvoy::lift
