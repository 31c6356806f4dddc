// A bus with its passenger information on a simulated CAN bus (CiA 407): seventeen devices, four in
// a second car behind a train bus gateway, a driver who logs in his journeys, passengers, faults by
// plan, and referees.
//
//     BusNetworkOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .node = 1, .start = Time(20min)}};
//     BusNetwork network(options);
//     network.run_until(network.end());
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// It begins five minutes before the first departure of its block. The same options give the same
// frames at the same times.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"
#include "canvoy/sim/bus/bus_fault.hpp"
#include "canvoy/sim/bus/bus_invariant.hpp"
#include "canvoy/sim/bus/bus_network_event.hpp"
#include "canvoy/sim/bus/bus_node.hpp"
#include "canvoy/sim/bus/bus_referee.hpp"
#include "canvoy/sim/bus/bus_vehicle.hpp"
#include "canvoy/sim/bus/line_control.hpp"
#include "canvoy/sim/bus/local_clock.hpp"
#include "canvoy/sim/bus/message_referee.hpp"
#include "canvoy/sim/bus/mirror_control.hpp"
#include "canvoy/sim/bus/shown_display.hpp"
#include "canvoy/sim/bus/train_link.hpp"
#include "canvoy/sim/bus/true_data.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::bus {

inline constexpr NodeId computer_id = 1;
inline constexpr NodeId identification_id = 2;
inline constexpr NodeId front_display_id = 4;
inline constexpr NodeId next_stop_id = 5;
inline constexpr NodeId canceller_id = 6;
inline constexpr NodeId printer_id = 7;
inline constexpr NodeId information_id = 8;
inline constexpr NodeId announcer_id = 9;
inline constexpr NodeId side_display_id = 10;
inline constexpr NodeId vehicle_gateway_id = 11;
inline constexpr NodeId tachograph_id = 12;
inline constexpr NodeId driver_display_id = 13;
inline constexpr NodeId positioning_id = 16;
inline constexpr NodeId first_counter_id = 20;
inline constexpr NodeId counting_manager_id = 21;
inline constexpr NodeId second_counter_id = 22;
inline constexpr NodeId train_gateway_id = 30;
// In the second car, which has a segment of its own: node-IDs that the first one does not have.
inline constexpr NodeId second_gateway_id = 31;
inline constexpr NodeId second_destination_id = 34;
inline constexpr NodeId second_next_stop_id = 35;
inline constexpr NodeId second_announcer_id = 39;

/// A physical device of the bus.
struct DevicePlace {
  NodeId id = 0;
  std::string_view name;
  unsigned car = 1;
};
/// In the order of their node-IDs.
inline constexpr std::array<DevicePlace, 21> device_places = {{
    {computer_id, "on-board-computer"},
    {identification_id, "identification"},
    {front_display_id, "destination-front"},
    {next_stop_id, "next-stop"},
    {canceller_id, "ticket-canceller"},
    {printer_id, "ticket-printer"},
    {information_id, "information"},
    {announcer_id, "announcer"},
    {side_display_id, "destination-side"},
    {vehicle_gateway_id, "vehicle-gateway"},
    {tachograph_id, "tachograph"},
    {driver_display_id, "driver-display"},
    {positioning_id, "positioning-time"},
    {first_counter_id, "counter-1"},
    {counting_manager_id, "counting-manager"},
    {second_counter_id, "counter-2"},
    {train_gateway_id, "train-gateway"},
    {second_gateway_id, "second-gateway", 2},
    {second_destination_id, "second-destination", 2},
    {second_next_stop_id, "second-next-stop", 2},
    {second_announcer_id, "second-announcer", 2},
}};
constexpr unsigned car_of(NodeId id) {
  const auto place = std::ranges::find(device_places, id, &DevicePlace::id);
  return place == device_places.end() ? 1 : place->car;
}
/// The virtual devices of one of them, as the catalogue names them:
/// `geographical-positioning+time-fixing`.
std::string device_name_of(NodeId id);
constexpr InvariantKind announcements_in(unsigned car) {
  return car == 1 ? InvariantKind::announcements : InvariantKind::second_announcements;
}

/// What no fault of a plan does, so that each referee has something to see.
struct Sabotage {
  bool cuts_next_stop = false;    ///< the wires to its lamps
  bool cuts_destination = false;  ///< of the front display
  bool cuts_information = false;
  bool freezes_destination = false;  ///< the side display shows its first text for ever
  bool short_memory = false;         ///< the information display keeps 40 octets
  bool no_sign_lamp = false;         ///< of the next stop indicator
  bool mute_announcer = false;       ///< the wire to the loudspeakers
  bool stuck_zone_wheel = false;     ///< of the canceller's stamp
  bool blind_counter = false;        ///< of the first door
  bool false_messages = false;       ///< a stranger sends the driver's message
  bool slow_clocks = false;          ///< satellites and own clock are ten minutes late
  bool jammed_canceller = false;     ///< its slot takes no tickets
  bool cuts_second_car = false;      ///< the next stop indicator of the second car
  bool freezes_second_car = false;   ///< it shows its first text for ever
  bool mute_second_announcer = false;
  bool no_second_sign_lamp = false;  ///< of the next stop indicator of the second car
  bool dead_second_button = false;   ///< the wire from the buttons of the second car
  bool stuck_sign = false;           ///< of the next stop indicator: it is lit for ever
};

struct BusNetworkOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  Duration length{};  ///< of the whole run; 0: until ten minutes after the end of the block
  BusLine line = built_in_line();
  std::size_t block = 0;  ///< of the line; it has a journey
  std::chrono::year_month_day date{std::chrono::year(2026), std::chrono::month(11),
                                   std::chrono::day(23)};  ///< of the day of service
  LocalClock clock{{OffsetChange{.offset = 3600}}};        ///< of the line: UTC + 1 h
  BusOptions vehicle{};  ///< its seed is that of the faults; each third rides in the second car
  std::vector<NodeId> real{};  ///< who is not played here
  Sabotage sabotage{};
};

/// When a run is over.
Time end_of(const BusNetworkOptions& options);

struct BusNetworkStatistics {
  std::size_t journeys = 0;  ///< begun
  std::size_t stops = 0;     ///< at which it stood, or went past
  std::size_t announced = 0;
  std::size_t texts = 0;  ///< that came up on displays
  Duration worst_delay{};
};

/// A look at everything.
struct BusNetworkSnapshot {
  Time at{};
  std::array<BusSnapshot, 2> buses{};  ///< of each car
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  struct Shown {
    NodeId node = 0;
    std::string text;
    bool is_sign_lit = false;
  };
  std::vector<Shown> displays;
  cia407::CivilTime local_time{};
  EpochSeconds utc = 0;
  BusTruth truth;  ///< its pointers live as long as the network
  BusState state = BusState::at_stop;
  GeoPoint position;
  double heading = 0;
  double speed = 0;  ///< m/s
  double odometer = 0;
  double metres_on_route = 0;
  Duration delay{};
  std::vector<DoorState> doors;
  unsigned counted = 0;  ///< aboard, by the on-board computer
  RiderStatistics riders;
  BusNetworkStatistics statistics;

  /// Of both cars: the higher load, and all frames.
  BusSnapshot traffic() const {
    return {.load = std::max(buses[0].load, buses[1].load),
            .frames = buses[0].frames + buses[1].frames,
            .error_frames = buses[0].error_frames + buses[1].error_frames};
  }
};

class BusNetwork {
 public:
  explicit BusNetwork(BusNetworkOptions options);
  ~BusNetwork();
  BusNetwork(const BusNetwork&) = delete;
  BusNetwork& operator=(const BusNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  Time now() const { return world_.now(); }
  /// When it is over, by its options.
  Time end() const { return end_of(options_); }

  BusNetworkSnapshot snapshot();
  /// All since the start, oldest first.
  std::span<const NetworkEvent> events() const { return events_; }
  /// As they stand now.
  std::vector<Invariant> invariants() const { return referee_.verdicts(); }
  /// None is broken.
  bool all_hold() const;

  // For tests, and for tools that take part.
  World& world() { return world_; }
  BusVehicle& vehicle() { return *vehicle_; }
  const BusLine& line() const { return options_.line; }
  BusNode& node(NodeId id) { return *by_id_.at(id); }
  std::span<const std::unique_ptr<BusNode>> nodes() const { return nodes_; }
  const ShownDisplay& display(NodeId id) const { return *displays_.at(id); }
  /// Null: the node is none.
  const ShownDisplay* find_display(NodeId id) const { return displays_.at(id).get(); }
  const BusNetworkOptions& options() const { return options_; }
  /// Of the day of service: above 24 h after its midnight.
  Duration time_of_day() const { return vehicle_->time_of_day(now()); }

 private:
  // bus_network.cpp: the vehicle, its people, what is judged
  void move_vehicle(Time now);
  void step(Time now);
  void happened(Time now, BusEvent event, std::size_t stop);
  void learn_truth(Time now);
  void log_in();
  void clear_counts(Time now);
  RiderHands rider_hands();
  bool press_stop(Time now, unsigned car);
  void press_again(Time now, unsigned car);
  bool is_stop_wanted() const;
  bool is_sign_lit(unsigned car) const;
  bool is_sign_seen(unsigned car) const;
  void look_at_signs(Time now);
  void judge_signs(Time now);
  void judge(Time now);
  void judge_blindness(Time now);
  bool can_log_in();
  void judge_displays(Time now);
  void judge_passengers(Time now);
  void judge_people(Time now);
  void displays_changed();
  std::string expected_text(NodeId display) const;
  bool is_whole_text(const std::string& text) const;
  void count_ticket(const cia407::TicketData& ticket, bool is_printed);
  void check(Time now);
  EpochSeconds true_utc() const;
  cia407::CivilTime true_time() const;
  Time clock() { return now(); }
  void heard(Time now, const canvoy::BusEvent& event);
  void frame_sent(Time now, ControllerId sender, const Frame& frame);
  void frame_sent_in_second_car(Time now, ControllerId sender, const Frame& frame);
  BusSnapshot bus_snapshot(BusIndex index, NodeId id);
  BusIndex bus_of(NodeId id) const { return car_of(id) == 1 ? bus_ : second_bus_; }
  bool all_doors_closed() const;
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  // bus_network_real.cpp: devices that are not played here
  bool is_played(NodeId id) const;
  InvariantSet unknown_to_referees() const;
  BusWatch& watch_of(NodeId id);
  bool is_at_work(NodeId id);
  void lead_vehicle(Time now);
  bool is_awaited(NodeId id, Time now);
  bool is_led_by_us(NodeId display) const;
  bool has_unseen_sign() const;
  Duration heartbeat_time_out(NodeId id) const;

  // bus_network_devices.cpp
  void add_nodes();
  void configure();
  void link(NodeId sender, std::span<const std::uint32_t> sent, std::uint32_t can_id,
            std::span<const std::uint32_t> received, std::initializer_list<NodeId> receivers);
  Site& add_site() { return sites_.emplace_back(); }
  void add(NodeId id);
  void add_computer();
  void add_displays();
  void add_display(NodeId id, const ShownDisplay::Sabotage& sabotage);
  void add_tickets();
  void add_vehicle_devices();
  void add_counters();
  void add_second_car();
  cia407::BusSegment second_segment() {
    return {.has_main_computer = false, .has_diagnostics = false};
  }
  MirrorControlHardware mirror_hardware();
  MirrorControlSettings mirror_settings();
  cia407::AcousticAnnouncerHardware second_announcer_hardware();
  bool announce_in_second_car(std::uint32_t stop_point, std::string_view text);
  bool announce_in(unsigned car, std::uint32_t stop_point, bool is_mute);
  void power(BusNode& node, bool is_on);
  LineControlHardware line_control_hardware();
  LineControlSettings line_control_settings();
  cia407::MainOnBoardComputerHardware computer_hardware();
  cia407::MainOnBoardComputerSettings computer_settings();
  void is_computer(cia407::MainOnBoardComputerUnit& unit, Node&) { computer_ = &unit; }
  void is_line_control(LineControl& control, Node&) { line_control_ = &control; }
  double pulses_as_metres();
  bool has_open_door();
  std::optional<cia407::CivilTime> own_clock();
  std::optional<cia407::CivilTime> computer_clock();
  cia407::IdentificationHardware identification_hardware();
  cia407::Assignment remembered() { return remembered_; }
  void is_identification(cia407::IdentificationUnit& unit, Node&) { identification_ = &unit; }
  cia407::TicketCancellerHardware canceller_hardware();
  void stamp(const cia407::TicketData& ticket);
  void is_canceller(cia407::TicketCancellerUnit& unit, Node&) { canceller_ = &unit; }
  cia407::TicketPrinterHardware printer_hardware();
  bool print(const cia407::TicketData& ticket);
  bool has_paper() { return !is_present(FaultKind::no_paper); }
  void is_printer(cia407::TicketPrinterUnit& unit, Node&) { printer_ = &unit; }
  cia407::AcousticAnnouncerHardware announcer_hardware();
  bool announce(std::uint32_t stop_point, std::string_view text);
  cia407::VehicleGatewayHardware gateway_hardware();
  cia407::VehicleReading read_vehicle();
  cia407::TachographHardware tachograph_hardware();
  cia407::TachographReading read_tachograph();
  cia407::PositioningHardware positioning_hardware();
  cia447::GpsReading read_position();
  cia407::TimeFixingHardware time_hardware();
  std::chrono::minutes local_offset();
  std::optional<cia407::CivilTime> satellite_time();
  cia407::PassengerCounterSettings first_counter() { return {.door = 1}; }
  cia407::PassengerCounterSettings second_counter() { return {.door = 2}; }
  void is_first_counter(cia407::PassengerCounterUnit& unit, Node&) { counters_[0] = &unit; }
  void is_second_counter(cia407::PassengerCounterUnit& unit, Node&) { counters_[1] = &unit; }
  void is_counting_manager(cia407::CountingManagerUnit& unit, Node&) { counting_ = &unit; }
  void passed(Time now, std::size_t door, bool is_in);

  // bus_network_faults.cpp
  void plan_faults();
  void begin(std::size_t fault);
  void end(std::size_t fault);
  void set_fault(const ScheduledFault& fault, bool present);
  void set_power(NodeId id, bool is_on);
  bool is_present(FaultKind kind) const { return present_[static_cast<std::size_t>(kind)] != 0; }

  BusNetworkOptions options_;
  EpochSeconds service_begin_;
  World world_;
  BusIndex bus_;
  BusIndex second_bus_;
  TrainLink train_;
  std::unique_ptr<BusVehicle> vehicle_;
  PlantIndex vehicle_plant_ = 0;
  std::deque<Site> sites_;
  std::vector<std::unique_ptr<BusNode>> nodes_;
  std::array<BusNode*, node_id_max + 1> by_id_{};
  std::array<std::unique_ptr<ShownDisplay>, node_id_max + 1> displays_;
  cia407::MainOnBoardComputerUnit* computer_ = nullptr;
  LineControl* line_control_ = nullptr;
  cia407::IdentificationUnit* identification_ = nullptr;
  cia407::TicketCancellerUnit* canceller_ = nullptr;
  cia407::TicketPrinterUnit* printer_ = nullptr;
  std::array<cia407::PassengerCounterUnit*, 2> counters_{};
  cia407::CountingManagerUnit* counting_ = nullptr;
  cia407::Assignment remembered_;  ///< by the identification device
  BusWatch bus_watch_;
  BusWatch second_watch_;
  std::vector<NetworkEvent> events_;
  BusNetworkStatistics counted_;

  // Judged
  TrueHistory truth_;
  BusReferee referee_;
  MessageReferee messages_;
  MessageReferee second_messages_;
  bool wants_log_in_ = false;  ///< the driver
  Time next_log_in_{};
  bool counts_are_lost_ = false;
  bool needs_fix_ = true;  ///< the on-board computer has begun anew
  /// The stop buttons of a car, on the way to the next stop.
  struct Pressed {
    Time last{};
    unsigned times = 0;
  };
  std::array<Pressed, 2> pressed_{};                         ///< in each car
  std::array<std::optional<std::uint32_t>, 2> to_announce_;  ///< in each car
  Time announce_since_{};
  std::uint64_t badly_served_ = 0;
  bool displays_are_new_ = true;
  bool has_lie_ = false;
  std::array<std::string, node_id_max + 1> told_texts_;
  std::array<bool, 2> told_signs_{};  ///< in each car
  std::vector<std::string> whole_texts_;

  // Faults
  std::array<unsigned, fault_kinds> present_{};  ///< how many of each kind
  std::array<unsigned, node_id_max + 1> without_power_{};
  ControllerId babbler_ = no_controller;
  std::array<bool, invariant_kinds> told_{};
};

/// Which invariants cannot hold while a device, or what a fault is about, is missing.
InvariantSet affected_by(FaultKind kind, NodeId node);

}  // namespace canvoy::bus
