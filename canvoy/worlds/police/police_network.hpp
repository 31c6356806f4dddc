// A patrol of a police car in a simulated world: the car and its IVN gateway, the add-on devices
// that the gateway assigns node-IDs to and starts, a crew, a control room that calls it, faults by
// plan, and referees.
//
//     PoliceOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 2}};
//     PoliceNetwork network(options);
//     network.run_until(Time(8h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The patrol begins when the network is up, and ends an hour before the end; then radio and
// periphery have power for their after-run, the network is sent to sleep, and woken once more. The
// same options give the same frames at the same times.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/police/crew.hpp"
#include "canvoy/worlds/police/patrol_watch.hpp"
#include "canvoy/worlds/police/police_car.hpp"
#include "canvoy/worlds/police/police_event.hpp"
#include "canvoy/worlds/police/police_faults.hpp"
#include "canvoy/worlds/police/police_options.hpp"
#include "canvoy/worlds/police/police_referee.hpp"
#include "canvoy/worlds/police/police_snapshot.hpp"

namespace canvoy::police {

class PoliceNetwork {
 public:
  /// Makes all devices that are simulated here, and gives them power at time 0.
  explicit PoliceNetwork(PoliceOptions options);
  ~PoliceNetwork();
  PoliceNetwork(const PoliceNetwork&) = delete;
  PoliceNetwork& operator=(const PoliceNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  /// Time since the start of the run.
  Time now() const { return world_.now(); }

  /// State at present, for a drawing.
  PoliceSnapshot snapshot() const;
  /// All events since the start, oldest first.
  std::span<const PoliceEvent> events() const { return events_.all(); }
  /// All calls for help, the oldest first.
  std::span<const EmergencyCall> calls() const { return crew_.calls(); }
  /// Verdicts at present.
  std::vector<Invariant> invariants() const { return referee_.verdicts(crew_.calls()); }
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// The world of the bus; time passes only in run_until().
  World& world() { return world_; }
  /// What is heard and read at present.
  Surroundings around() const { return car_.around(); }
  /// The crew.
  const Crew& crew() const { return crew_; }
  /// The terminal, for hands from outside; made again when it gets power.
  cia447::TerminalUnit& terminal() { return car_.terminal().unit(); }
  /// Device with a node-ID, which must exist.
  car::CarNode& node(NodeId id) { return bus_.node(id); }
  /// All devices, in the order of their node-IDs.
  std::span<const std::unique_ptr<car::CarNode>> nodes() const { return bus_.nodes(); }
  /// Options that it was made with.
  const PoliceOptions& options() const { return options_; }
  /// Notes an action by hand from outside.
  void note_hand(Time now, const HandActed& acted) { events_.note(now, acted); }

 private:
  CrewHands crew_hands();
  TerminalHands terminal_hands();
  void open(Client client);
  void press(Client client, cia447::NumberPadKey key);
  void press(cia447::FunctionKey key);
  void press_emergency();
  void status_heard(int status) { crew_.status_is_heard(now(), status); }
  void step(Time now);
  void crew_changed(Time now, Activity to);
  void car_event(const cia447::CarEvent& event);
  void sleep_and_wake(Time parked);
  void tell_changes(Time now);
  PoliceStatistics statistics() const;

  PoliceOptions options_;
  World world_;
  EventLog<PoliceEvent> events_;
  PoliceReferee referee_;
  car::CarBus bus_;
  PoliceCar car_;
  Crew crew_;
  PoliceExcuses excuses_;
  PoliceFaults faults_;
  PatrolWatch watch_;
  ToldInvariants<invariant_kinds> told_;
  SignalsChanged told_signals_;
  std::optional<Client> told_client_;
};

}  // namespace canvoy::police
