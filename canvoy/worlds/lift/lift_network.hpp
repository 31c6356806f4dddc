// A building with lifts in a simulated world: all devices as CANopen nodes on their buses, cars,
// doors and scales behind them, people before them, faults by plan, and referees.
//
//     LiftNetwork network(standard_lift_network({.lifts = 4, .floors = 20, .seed = 1}));
//     network.run_until(Time(60min));
//     const LiftSummary summary = network.summary();
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// Equal descriptions give the same frames at the same times.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/lift_event.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/lift_shaft.hpp"
#include "canvoy/worlds/lift/lift_snapshot.hpp"

namespace canvoy::lift {

class LiftNetwork {
 public:
  /// check(description) must be empty. The description is copied.
  explicit LiftNetwork(const LiftNetworkDescription& description);
  ~LiftNetwork();
  LiftNetwork(const LiftNetwork&) = delete;
  LiftNetwork& operator=(const LiftNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until);
  /// Time since the start of the run.
  Time now() const;
  /// Adds a person at the present time, beside those of the traffic. False: no lift connects these
  /// floors.
  bool visit(FloorNumber from, FloorNumber to);

  /// The first value that a node of the description refused at its last boot-up.
  std::optional<RefusedValue> refused() const;
  /// Adds a further observer of a bus, for a log; false where there are too many.
  bool observe(std::size_t bus, const BusTap& tap);
  /// State at present, for a drawing; linear in the size of the network.
  LiftNetworkSnapshot snapshot() const;
  /// Summary up to now.
  LiftSummary summary() const;
  /// All events since the start, oldest first.
  std::span<const LiftEvent> events() const;

  /// Verdicts at present.
  std::vector<Invariant> invariants() const;
  /// True if no invariant is broken.
  bool all_hold() const;

  /// The copy of the description.
  const LiftNetworkDescription& description() const;

  // Access for tests, and for tools that take part: a real device in place of a node that the
  // description leaves out is connected to the bus.
  /// The world of all buses; time passes only in run_until().
  World& world();
  /// Shaft of a lift, from 1.
  LiftShaft& shaft(LiftNumber lift);
  /// Notes an action at a device as an event, at the present time.
  void note_hand(const HandActed& acted);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace canvoy::lift
