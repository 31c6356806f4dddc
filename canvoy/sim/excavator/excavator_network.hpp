// A shift of an excavator in a simulated world: a seat (CiA 852) with an armrest on a network
// behind it, an input and output module on the valves (CiA 401), a host between both, somebody who
// digs, faults by plan, and a referee.
//
//     ExcavatorOptions options;
//     options.faults.faults = {{.kind = FaultKind::stuck_axis, .start = Time(20min)}};
//     ExcavatorNetwork network(options);
//     network.run_until(Time(8h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The same options give the same frames at the same times.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/excavator/excavator_event.hpp"
#include "canvoy/sim/excavator/excavator_operator.hpp"
#include "canvoy/sim/excavator/excavator_referee.hpp"
#include "canvoy/sim/excavator/machine_control.hpp"
#include "canvoy/sim/excavator/machine_node.hpp"
#include "canvoy/sim/excavator/seat_module.hpp"
#include "canvoy/sim/plants/excavator.hpp"
#include "canvoy/sim/snapshot.hpp"

namespace canvoy::excavator {

struct DevicePlace {
  NodeId id = 0;
  std::string_view name;
};
/// In the order of their node-IDs, and along the cable.
inline constexpr std::array<DevicePlace, 3> device_places = {
    {{host_id, "host"}, {seat_id, "seat"}, {valves_id, "valves"}}};
/// On the bus behind the seat.
inline constexpr DevicePlace armrest_place = {armrest_id, "armrest"};

/// What no fault of a plan does, so that each referee has something to see.
struct Sabotage {
  bool trusting_host = false;   ///< it believes a sensor without its contact
  bool patient_host = false;    ///< it waits for the seat for three seconds
  bool patient_valves = false;  ///< they wait for the host so long
  bool old_lever = false;       ///< the host believes what the armrest said last
  bool slow_buttons = false;    ///< the seat filters them for 40 ms
  bool counts_levels = false;   ///< each PDO with a button that is down is a press
  bool coarse_deltas = false;   ///< the host has axes told by a fifth of their way
  bool burnt_lamp = false;      ///< of the work light
  bool keeps_lamps = false;     ///< they have no error values
  bool frozen_display = false;  ///< its first parameter
  bool pierced_bucket = false;  ///< no earth stays in it
  bool forgetful_host = false;  ///< who has booted again is not started again
};

struct ExcavatorOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 250'000;
  Duration length = 8h;        ///< of the whole run
  Duration sensing_period{};   ///< of the seat; 0: it is told of each movement
  OperatorOptions shift{};     ///< its end is that of the run
  std::vector<NodeId> real{};  ///< who is not played here
  bool records_shift = false;  ///< see recorded_shift()
  bool has_armrest = true;     ///< where the seat has none, the host asks for none
  Sabotage sabotage{};
};

struct ExcavatorStatistics {
  unsigned cycles = 0;   ///< of dig, lift, slew, dump, return
  unsigned presses = 0;  ///< of buttons
  Excavator::Earth earth;
  double metres = 0;  ///< that it has driven
};

/// A look at everything.
struct ExcavatorSnapshot {
  Time at{};
  BusSnapshot bus;
  BusSnapshot embedded;  ///< behind the seat
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  Activity activity = Activity::sits_down;
  Wishes wishes;
  ExcavatorStatistics statistics;

  // The truth
  std::array<double, movements> angles{};
  std::array<double, movements> speeds{};
  std::array<double, movements> hands{};  ///< where they want each to move
  std::array<Excavator::Point, 4> arm{};  ///< foot and end of the boom, end of the stick, tip
  std::bitset<button_count> pressed;
  bool is_lever_lowered = false;
  std::bitset<5> switched;  ///< as Switched has them
  Lamps lit;
  std::array<std::int16_t, shown_parameters> display{};
  double rpm = 0;
  double fuel_percent = 0;
  double oil_celsius = 0;
};

class ExcavatorNetwork {
 public:
  explicit ExcavatorNetwork(ExcavatorOptions options);
  ~ExcavatorNetwork();
  ExcavatorNetwork(const ExcavatorNetwork&) = delete;
  ExcavatorNetwork& operator=(const ExcavatorNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  Time now() const { return world_.now(); }

  ExcavatorSnapshot snapshot();
  /// All since the start, oldest first.
  std::span<const ExcavatorEvent> events() const { return events_; }
  /// As they stand now.
  std::vector<Invariant> invariants() const { return referee_.verdicts(); }
  /// None is broken.
  bool all_hold() const;

  // For tests, and for tools that take part.
  World& world() { return world_; }
  Excavator& machine() { return machine_; }
  SeatPanel& panel() { return panel_; }
  const ExcavatorOperator& driver() const { return driver_; }
  MachineNode& node(NodeId id);
  std::span<const std::unique_ptr<MachineNode>> nodes() const { return nodes_; }
  /// As the options have the host.
  HostSettings host_settings() const;
  /// What hands have done, where it is recorded.
  const RecordedShift& recorded_shift() const { return recorder_.shift(); }
  const ExcavatorOptions& options() const { return options_; }

 private:
  // excavator_network.cpp: the machine, its operator, what is judged
  void step(Time now);
  void frame_sent(const Frame& frame);
  void frame_sent_behind(const Frame& frame);
  void heard(Time now, const BusEvent& event);
  void press(Button button, Duration down);
  void hands_moved();
  void judge(Time now);
  bool is_locked_in_sight(Time now);
  void judge_lamps(Time now);
  void judge_axes(Time now);
  bool lamps_are_right(bool has_valves);
  bool display_is_right(bool has_valves) const;
  bool is_as_without_host() const;
  bool is_armrest_at_work();
  void tell_changes(Time now);
  void check(Time now);
  bool is_played(NodeId id) const;
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  // excavator_network_devices.cpp
  void add_nodes();
  void add_node(const DevicePlace& place, BusIndex bus, MachineNode::Make make);
  void add_armrest();
  MachineNode::Made make_host(const Port& port);
  MachineNode::Made make_seat(const Port& port);
  MachineNode::Made make_valves(const Port& port);
  MachineNode::Made make_armrest(const Port& port);
  void power(MachineNode& node, bool is_on);
  cia852::OperatorEnvironment elements() { return cia852::usual_elements; }
  cia852::OperatorHardware seat_hardware() { return panel_.hardware(); }
  cia852::OperatorSettings seat_settings();
  void is_seat(cia852::OperatorUnit& unit, Node&) { seat_unit_ = &unit; }
  cia401::IoHardware valves_hardware();
  cia401::IoSettings valves_settings();
  cia401::IoHardware armrest_hardware();
  cia401::IoSettings armrest_settings() { return {.sensing_period = Duration::zero()}; }
  void is_armrest(cia401::IoUnit& unit, Node&) { armrest_unit_ = &unit; }
  std::uint8_t sense_lever(unsigned group);
  void is_valves(cia401::IoUnit& unit, Node&) { valves_unit_ = &unit; }
  void drive_digital(unsigned group, std::uint8_t outputs);
  void drive_analogue(unsigned channel, std::int32_t value);
  std::int32_t sense_analogue(unsigned channel);
  std::uint8_t sense_digital(unsigned group);
  void switch_outputs(unsigned outputs);
  void set_valve(unsigned channel, double share);
  void lead_by_real_valves(const Frame& frame);
  void release_outputs();

  // excavator_network_faults.cpp
  void plan_faults();
  void begin(std::size_t fault);
  void end(std::size_t fault);
  void set_fault(const ScheduledFault& fault, bool present);
  void set_power(NodeId id, bool is_on);
  BusIndex bus_of(NodeId id) const { return id == armrest_id ? embedded_bus_ : bus_; }
  void cut_cables();

  ExcavatorOptions options_;
  World world_;
  BusIndex bus_;
  BusIndex embedded_bus_;
  Excavator machine_;
  SeatPanel panel_;
  ShiftRecorder recorder_;
  ExcavatorOperator driver_;
  Site seat_site_;
  Site valves_site_;
  Site armrest_site_;
  std::unique_ptr<MachineHost> host_;
  std::unique_ptr<CatalogueDevice> seat_;
  std::unique_ptr<CatalogueDevice> valves_;
  std::unique_ptr<CatalogueDevice> armrest_;
  SeatModule seat_module_;
  cia852::OperatorUnit* seat_unit_ = nullptr;
  cia401::IoUnit* valves_unit_ = nullptr;
  cia401::IoUnit* armrest_unit_ = nullptr;
  std::vector<std::unique_ptr<MachineNode>> nodes_;
  BusWatch bus_watch_;
  BusWatch embedded_watch_;
  std::vector<ExcavatorEvent> events_;

  // The truth beside the plant
  unsigned outputs_ = 0;  ///< of the module, as Switched has them
  unsigned told_outputs_ = 0;
  Lamps told_lamps_;
  double heaped_ = 0;  ///< at the last step
  double told_heap_ = 0;
  Time moved_at_{};               ///< last
  bool seat_was_set_up_ = false;  ///< since it has power
  bool had_fault_ = false;        ///< of the plan, since the start
  bool is_out_of_step_ = false;   ///< a recorded shift, since a fault has locked the hydraulics
  /// Where each stick was in the last steps: what is told now is one of these.
  std::array<std::array<double, 3>, stick_count> axes_{};

  // Judged
  ExcavatorReferee referee_;
  std::array<bool, invariant_kinds> told_{};

  // Faults: how many of each are present, and where
  std::array<std::array<unsigned, node_id_max + 1>, fault_kinds> at_node_{};
  std::array<std::array<unsigned, stick_count>, fault_kinds> at_axis_{};
  std::array<unsigned, node_id_max + 1> without_power_{};  ///< a node-ID is on one of both buses
  ControllerId babbler_ = no_controller;
};

}  // namespace canvoy::excavator
