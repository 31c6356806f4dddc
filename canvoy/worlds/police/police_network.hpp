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

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/crew.hpp"
#include "canvoy/worlds/police/patrol_watch.hpp"
#include "canvoy/worlds/police/police_car.hpp"
#include "canvoy/worlds/police/police_event.hpp"
#include "canvoy/worlds/police/police_excuses.hpp"
#include "canvoy/worlds/police/police_options.hpp"
#include "canvoy/worlds/police/police_referee.hpp"
#include "canvoy/worlds/police/signal_devices.hpp"
#include "canvoy/worlds/police/surroundings.hpp"

namespace canvoy::police {

/// Makes and mends the faults of the plan in a police car, and reports what they excuse.
///
///     PoliceFaults faults(car, options.faults, excuses, events);
///     faults.plan();
///     faults.step();       // each 100 ms
class PoliceFaults {
 public:
  /// All must outlive this object.
  PoliceFaults(PoliceCar& car, const FaultPlan& plan, PoliceExcuses& excuses,
               EventLog<PoliceEvent>& events);
  PoliceFaults(const PoliceFaults&) = delete;
  PoliceFaults& operator=(const PoliceFaults&) = delete;

  /// Plans the faults; this object must outlive the world's last run.
  void plan();
  /// Call it in each step: a client that must lose its power loses it while it has the terminal.
  void step();

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  Time now() const { return car_.bus().world().now(); }
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool is_present);
  void let_client_die(bool shall_die);
  void power(NodeId id, bool is_on) { car_.power(car_.bus().node(id), is_on); }

  PoliceCar& car_;
  PoliceExcuses& excuses_;
  EventLog<PoliceEvent>& events_;
  Engine faults_;
  BusTrouble trouble_;
  PowerCuts cuts_;
  bool client_shall_die_ = false;
  NodeId dead_client_ = 0;
};

// State of a police car at one instant: its bus and devices, what the crew does and wants, and what
// is really seen, heard and read.
//
//     const PoliceSnapshot look = network.snapshot();
//     if (look.is_blue) ...

/// Counts since the start of a patrol.
struct PoliceStatistics {
  std::size_t calls = 0;     ///< calls for help
  std::size_t attended = 0;  ///< and reported
  Duration response_time{};  ///< sum of the times from a call to the arrival, over all attended
                             ///< calls
  unsigned keys = 0;         ///< keys pressed at the terminal
  unsigned statuses = 0;     ///< status messages that the control room received
  Duration longest_wait{};   ///< of a person at the terminal, excused or not
};

/// State of everything.
struct PoliceSnapshot {
  Time at{};                            ///< since the start of the run
  BusSnapshot bus;                      ///< of the car, with its load since the start
  std::vector<NodeSnapshot> nodes;      ///< in the order of their node-IDs
  std::vector<std::string_view> names;  ///< of the nodes

  Activity crew = Activity::off_duty;  ///< what the crew does
  Wish wish;                           ///< what the crew wants
  bool is_asleep = false;              ///< all devices sleep
  PoliceStatistics statistics;         ///< counts up to now

  // true state
  Surroundings around;                         ///< heard and read
  std::array<bool, beacon_count> beacons{};    ///< that give light at this instant
  std::array<bool, flasher_count> flashers{};  ///< that give light at this instant
  bool is_blue = false;                        ///< true while it flashes
  bool has_work_light = false;                 ///< search lamp and alley lights
  std::optional<Client> client{};              ///< client on display 1
  bool crew_speaks = false;                    ///< a person in the car speaks to the radio
  bool crew_is_heard = false;                  ///< in the control room
  bool room_speaks = false;                    ///< a person in the control room speaks
  bool room_is_heard = false;                  ///< in the car
  double metres = 0;                           ///< m driven since the start
  double speed = 0;                            ///< m/s
};

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
  void report_changes(Time now);
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
