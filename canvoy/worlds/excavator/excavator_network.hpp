// A shift of an excavator in a simulated world: a seat (CiA 852) with an armrest on a network
// behind it, an input and output module on the valves (CiA 401), a host between both, an operator,
// faults by plan, and a referee.
//
//     ExcavatorOptions options;
//     options.faults.faults = {{.kind = FaultKind::stuck_axis, .start = Time(20min)}};
//     ExcavatorNetwork network(options);
//     network.run_until(Time(8h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// Equal options give the same frames at the same times.
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/sim/bus_trouble.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/sim/plants/excavator.hpp"
#include "canvoy/sim/power_cuts.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/excavator/excavator_devices.hpp"
#include "canvoy/worlds/excavator/excavator_event.hpp"
#include "canvoy/worlds/excavator/excavator_operator.hpp"
#include "canvoy/worlds/excavator/excavator_options.hpp"
#include "canvoy/worlds/excavator/excavator_referees.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"
#include "canvoy/worlds/excavator/valves_hardware.hpp"

namespace canvoy::excavator {

/// The faults of a plan in an excavator: it makes and mends them, and reports them as events and to
/// the referees.
///
///     ExcavatorFaults faults(world, bus, options, devices, panel, referees, events);   // plans
///     all
class ExcavatorFaults {
 public:
  /// All must outlive the last run of `world`. `bus` is that of the machine.
  ExcavatorFaults(World& world, BusIndex bus, const ExcavatorOptions& options,
                  ExcavatorDevices& devices, SeatPanel& panel, ExcavatorReferees& referees,
                  std::vector<ExcavatorEvent>& events);
  ExcavatorFaults(const ExcavatorFaults&) = delete;
  ExcavatorFaults& operator=(const ExcavatorFaults&) = delete;

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool present);
  void power(NodeId id, bool is_on) { devices_->power(devices_->node(id), is_on); }
  void cut_cables();

  World* world_;
  BusIndex bus_;
  const ExcavatorOptions* options_;
  ExcavatorDevices* devices_;
  SeatPanel* panel_;
  ExcavatorReferees* referees_;
  std::vector<ExcavatorEvent>* events_;
  BusTrouble trouble_;  ///< of the machine's bus
  Engine faults_;
  PowerCuts cuts_;  ///< a node-ID is on one of the two buses only
};

/// A trainer on a second seat of an excavator, who takes the command over and gives it back, while
/// the operator lets go: both watch the lamps that show which seat has the command.
///
///     Trainer trainer(own_panel, panel_of_the_operator, driver, moved);
///     trainer.step(now);            // each step
///     trainer.lessons();            // lessons in which both had what they asked for
///
/// In a lesson the trainer slews to one side; then the operator pulls a stick without the command,
/// which moves nothing; then the trainer slews back.
class Trainer {
 public:
  /// All must outlive this object. `moved` is called when sticks or buttons of a seat have moved.
  Trainer(SeatPanel& own, SeatPanel& panel, ExcavatorOperator& driver, std::function<void()> moved)
      : own_(own), panel_(panel), driver_(driver), moved_(std::move(moved)) {}
  Trainer(const Trainer&) = delete;
  Trainer& operator=(const Trainer&) = delete;

  /// Call it each ExcavatorOperator::step_time.
  void step(Time now);
  /// Number of lessons that went as both wanted.
  unsigned lessons() const { return lessons_; }

 private:
  enum class Step : std::uint8_t {
    waits,
    comes_to_rest,  ///< the operator lets go
    takes,          ///< with a finger on the button
    slews,
    looks_on,  ///< while the operator pulls a stick
    slews_back,
    rests,
    gives,  ///< the operator's finger is on the button
  };

  void enter(Time now, Step step);
  void act(Time now, Duration passed);
  /// Holds the button for a moment, again and again, until the lamp of that seat is lit. True when
  /// it is; false for good if it never is.
  bool has_asked(SeatPanel& seat, std::size_t number, Duration passed);

  SeatPanel& own_;
  SeatPanel& panel_;
  ExcavatorOperator& driver_;
  std::function<void()> moved_;
  Step step_ = Step::waits;
  Time since_{};
  unsigned lessons_ = 0;
};

/// Counts since the start of a shift.
struct ExcavatorStatistics {
  unsigned cycles = 0;     ///< of dig, lift, slew, dump, return
  unsigned presses = 0;    ///< of buttons
  Excavator::Earth earth;  ///< taken up, heaped and spilled, in m3
  double metres = 0;       ///< m driven
};

/// State of the whole network.
struct ExcavatorSnapshot {
  Time at{};                            ///< since the start of the run
  BusSnapshot bus;                      ///< of host, seat and valves
  BusSnapshot embedded;                 ///< behind the seat
  std::vector<NodeSnapshot> nodes;      ///< in the order of ExcavatorNetwork::nodes()
  std::vector<std::string_view> names;  ///< of the nodes

  Activity activity = Activity::sits_down;  ///< of the operator
  Wishes wishes;                            ///< switch states that the operator wants
  ExcavatorStatistics statistics;           ///< counts up to now

  // true values
  std::array<double, movements> angles{};  ///< degrees, of a track m; in the order of Movement
  std::array<double, movements> speeds{};  ///< shares of the greatest speed, -1 to 1
  std::array<double, movements> hands{};   ///< commands of the hands for each movement
  std::array<Excavator::Point, 4> arm{};   ///< foot and end of the boom, end of the stick, tip
  std::bitset<button_count> pressed;       ///< bits as in Button
  bool is_lever_lowered = false;           ///< the safety lever permits movements
  std::bitset<5> switched;                 ///< bits as in Switched
  Lamps lit;                               ///< lamps that give light
  std::array<std::int16_t, shown_parameters> display{};  ///< as shown; no_value: nothing
  double rpm = 0;                                        ///< of the engine
  double fuel_percent = 0;                               ///< of the tank
  double oil_celsius = 0;                                ///< of the hydraulic oil
};

class ExcavatorNetwork {
 public:
  /// Makes all devices that are simulated here, and gives them power at time 0.
  explicit ExcavatorNetwork(ExcavatorOptions options);
  ExcavatorNetwork(const ExcavatorNetwork&) = delete;
  ExcavatorNetwork& operator=(const ExcavatorNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  /// Time since the start of the run.
  Time now() const { return world_.now(); }

  /// State at present, for a drawing.
  ExcavatorSnapshot snapshot();
  /// All events since the start, oldest first.
  std::span<const ExcavatorEvent> events() const { return events_; }
  /// Verdicts at present.
  std::vector<Invariant> invariants() const { return referees_.verdicts(); }
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// The world of both buses; time passes only in run_until().
  World& world() { return world_; }
  /// The machine itself, whatever its devices say.
  Excavator& machine() { return machine_; }
  /// Sticks, buttons, lamps and wires at the seat.
  SeatPanel& panel() { return panel_; }
  /// The operator.
  const ExcavatorOperator& driver() const { return driver_; }
  /// Gives no lessons where the options have no trainer.
  const Trainer& trainer() const { return trainer_; }
  /// Device with a node-ID, which must exist.
  MachineNode& node(NodeId id) { return devices_.node(id); }
  /// See ExcavatorDevices::nodes().
  std::span<const std::unique_ptr<MachineNode>> nodes() const { return devices_.nodes(); }
  /// Settings of the host, by the options.
  HostSettings host_settings() const { return excavator::host_settings(options_); }
  /// Actions of hands, where the options have them recorded.
  const RecordedShift& recorded_shift() const { return recorder_.shift(); }
  /// Options that it was made with.
  const ExcavatorOptions& options() const { return options_; }

 private:
  void name_nodes();
  void observe_buses();
  void step(Time now);
  void hear(const Frame& frame);
  void heard(Time now, const BusEvent& event);
  void press(Button button, Duration down);
  void hands_moved();
  void switched(Button button, bool is_on);
  void report_changes(Time now);
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  ExcavatorOptions options_;
  World world_;
  ExcavatorBuses buses_;
  std::vector<ExcavatorEvent> events_;
  Excavator machine_;
  SeatPanel panel_;
  SeatPanel trainer_panel_;
  ShiftRecorder recorder_;
  ExcavatorOperator driver_;
  Trainer trainer_;
  ValvesHardware valves_;
  ExcavatorDevices devices_;
  BusWatch bus_watch_;
  BusWatch embedded_watch_;
  ExcavatorReferees referees_;
  PlantIndex stepping_;
  ExcavatorFaults faults_;
  Lamps told_lamps_;
  double told_heap_ = 0;
};

}  // namespace canvoy::excavator
