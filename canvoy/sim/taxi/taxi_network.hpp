// A shift of a taxi in a simulated world: the car and its IVN gateway, the add-on devices that the
// gateway names and starts, a driver, those whom he carries, faults by plan, and referees.
//
//     TaxiOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .node = 2, .start = Time(20min)}};
//     TaxiNetwork network(options);
//     network.run_until(Time(12h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The shift begins when the network is up, and ends an hour before the end; then the driver has the
// network sent to sleep, and woken once more. The same options give the same frames at the same
// times.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/taximeter/trip_reader.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/car/car_node.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/taxi/fare_display.hpp"
#include "canvoy/sim/taxi/fare_referee.hpp"
#include "canvoy/sim/taxi/fault.hpp"
#include "canvoy/sim/taxi/invariant.hpp"
#include "canvoy/sim/taxi/kept_flash.hpp"
#include "canvoy/sim/taxi/paper_text.hpp"
#include "canvoy/sim/taxi/real_devices.hpp"
#include "canvoy/sim/taxi/route_display.hpp"
#include "canvoy/sim/taxi/shift.hpp"
#include "canvoy/sim/taxi/taxi_event.hpp"
#include "canvoy/sim/taxi/town.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::taxi {

inline constexpr NodeId taximeter_id = 2;
inline constexpr NodeId printer_id = 3;
inline constexpr NodeId driver_id = 4;
inline constexpr NodeId sign_id = 5;
inline constexpr NodeId terminal_id = 6;
inline constexpr NodeId navigation_id = 7;
inline constexpr NodeId alarm_id = 8;
/// In the order of their node-IDs, from 1 on.
inline constexpr std::array<std::string_view, 8> device_names = {
    "ivn-gateway",    "taximeter", "printer",        "driver-and-clock",
    "tariff-display", "terminal",  "gps-navigation", "taxi-alarm"};

/// What we assume of the network of a car.
struct CarNetworkOptions {
  cia447::CarNetworkSettings nodes{};
  cia447::CarMasterSettings master{};
  cia447::CarSleepSettings sleep{};
};

struct TaxiOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  /// What clocks show at the start.
  CivilTime begin = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + 18h;
  Duration clock_ahead{};        ///< of what is right: of the real time clock on the bus
  Duration meter_clock_ahead{};  ///< of the meter's own
  Duration length = 12h;         ///< of the whole run
  Duration alarm = 4h;           ///< from the start to the press of the alarm key
  ShiftOptions shift{};          ///< its end and presses_max follow from the rest
  CarNetworkOptions car_network{};
  cia447::CarSettings car{};
  cia447::TaximeterSettings meter{.k = 24'000};
  /// What passengers owe; the meter's own is in its settings, and has to be the same.
  cia447::Tariff tariff_of_town = cia447::example_tariff;
  /// How the car goes; null: as the people want it by chance.
  std::shared_ptr<const car::DriveRecord> record{};
  /// What the navigation system knows; who gives them keeps them.
  std::span<const cia447::NamedPlace> places = town_places;
  std::vector<NodeId> real{};  ///< who is not played here
};

/// What no fault of a plan does, so that each referee has something to see.
struct Sabotage {
  double pocketed = 0;           ///< beside what the meter shows, from each passenger
  bool cuts_sign = false;        ///< the wires from the tariff display to its lamps
  bool speaks_asleep = false;    ///< somebody sends a frame while all sleep
  bool blocks_keys = false;      ///< the keys of the meter
  bool cuts_screen = false;      ///< the wires to display 1 of the terminal
  bool blinds_receiver = false;  ///< the GPS receiver says where the car was at the start
};

/// What is read on a display of the terminal.
struct Screen {
  unsigned holder = 0;  ///< whose text it is; 0: the car has it
  std::string text;
};

/// A look at everything.
struct TaxiSnapshot {
  Time at{};
  BusSnapshot bus;
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  cia447::Taximeter meter = cia447::Taximeter::signed_off;
  cia447::TripData trip;  ///< as the meter shows it
  Activity driver = Activity::off_duty;
  bool is_asleep = false;
  unsigned carried = 0;
  double paid = 0;                                             ///< in all, in currency units
  std::array<cia447::Lamp, cia447::tariff_lamps_max> lamps{};  ///< on the roof, from lamp 1 on
  std::array<Screen, 2> screens;                               ///< of the terminal
  std::vector<std::string> paper;                              ///< its last lines

  // The truth
  double metres = 0;
  double speed = 0;  ///< m/s
};

class TaxiNetwork {
 public:
  explicit TaxiNetwork(TaxiOptions options);
  ~TaxiNetwork();
  TaxiNetwork(const TaxiNetwork&) = delete;
  TaxiNetwork& operator=(const TaxiNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  Time now() const { return world_.now(); }

  TaxiSnapshot snapshot();
  /// All since the start, oldest first.
  std::span<const TaxiEvent> events() const { return events_; }
  std::span<const Trip> trips() const { return trips_; }
  /// As they stand now.
  std::vector<Invariant> invariants() const;
  /// None is broken.
  bool all_hold() const;

  // For tests, and for tools that take part.
  Sabotage& sabotage() { return sabotage_; }
  World& world() { return world_; }
  cia447::TaximeterUnit& meter() { return *meter_; }
  cia447::IvnGatewayUnit& gateway() { return *gateway_; }
  cia447::NavigationUnit& navigation() { return *navigation_; }
  car::Drive& drive() { return drive_; }
  car::CarNode& node(NodeId id) { return *nodes_.at(id - std::size_t{1}); }
  std::span<const std::unique_ptr<car::CarNode>> nodes() const { return nodes_; }
  const TaxiOptions& options() const { return options_; }
  /// What is read on the printer's paper.
  PaperText& paper() { return paper_; }

 private:
  /// A device that has lost its power, or its bus, is named, booted and started in this time.
  static constexpr Duration return_bound = 20s;
  /// The driver presses a key twice at most.
  static constexpr Duration wait_bound = 3s;
  /// The lights on the roof follow the meter in this time.
  static constexpr Duration sign_bound = 3s;
  /// What the terminal shows of trip and place.
  static constexpr Duration screen_bound = 5s;
  /// In this time somebody is carried.
  static constexpr Duration long_enough = 2h;

  // taxi_network.cpp
  void add_nodes();
  void add(std::span<const cia447::CarUnit* const> units, const Site& site);
  void power(car::CarNode& node, bool is_on);
  void darken(NodeId id);
  cia447::CarHardware car_hardware();
  Site& add_site();
  cia447::CarNetworkSettings network_settings() { return options_.car_network.nodes; }
  cia447::CarMasterSettings master_settings() { return options_.car_network.master; }
  cia447::CarSleepSettings sleep_settings() { return options_.car_network.sleep; }
  cia447::CarSettings car_settings() { return options_.car; }
  cia447::CarMemory memory();
  cia447::KnownDevices known() { return known_; }
  void keep(const cia447::KnownDevices& known) { known_ = known; }
  void is_gateway(cia447::IvnGatewayUnit& unit, Node& /*node*/) { gateway_ = &unit; }
  cia447::TaximeterHardware meter_hardware();
  cia447::TaximeterSettings meter_settings();
  void is_meter(cia447::TaximeterUnit& unit, Node& /*node*/) { meter_ = &unit; }
  void is_network_of_meter(cia447::CarNetwork& network, Node& node);
  cia447::PrinterHardware printer_hardware() { return {.paper = paper_.paper()}; }
  void is_driver_reader(cia447::DriverIdentificationUnit& unit, Node& /*node*/) {
    driver_reader_ = &unit;
  }
  cia447::DriverIdentificationHardware reader_hardware();
  cia447::TariffDisplayHardware sign_hardware();
  void drive_lamp(unsigned lamp, cia447::Lamp wanted);
  cia447::GpsHardware gps_hardware();
  cia447::GpsReading gps_reading();
  void is_alarm(cia447::TaxiAlarmUnit& unit, Node& /*node*/) { alarm_ = &unit; }
  cia447::LocalTime local_time(Duration ahead) const;
  std::optional<cia447::LocalTime> meter_clock() { return local_time(options_.meter_clock_ahead); }
  std::optional<cia447::LocalTime> reader_clock() { return local_time({}); }
  cia447::RealTimeClockHardware clock_hardware();
  std::optional<cia447::ChipTime> chip_time();
  std::optional<double> speed() { return drive_.speed(); }
  std::optional<double> distance();
  MeterKeys keys();

  // taxi_network_real.cpp
  bool is_real(NodeId id) const;
  bool can_be_judged(InvariantKind kind) const;
  MeterKeys real_keys();
  void hear_real_devices();
  void real_meter_says(cia447::Taximeter state);
  NodeId trip_reader_id() const;
  void is_network_of_reader(cia447::CarNetwork& network, Node& node);
  void read_trip(Time now);
  void trip_came(const cia447::TripData* trip);
  void look_for_receipt(double paid, std::size_t first_line);
  void ask_for_totals();
  void totals_came(SdoClient::Outcome outcome);
  void real_wheels_turn(std::uint32_t pulses);

  // taxi_network_terminal.cpp
  cia447::TerminalHardware terminal_hardware();
  void terminal_shows(const cia447::DisplayContent& content);
  cia447::NavigationHardware navigation_hardware();
  void is_navigation(cia447::NavigationUnit& unit, Node& /*node*/) { navigation_ = &unit; }
  void is_network_of_navigation(cia447::CarNetwork& network, Node& node);
  cia447::TerminalSettings terminal_settings();
  FareDisplaySettings fare_display_settings();
  RouteDisplaySettings route_display_settings();
  void is_fare_display(FareDisplay& display, Node& /*node*/) { fare_display_ = &display; }
  void is_route_display(RouteDisplay& display, Node& /*node*/) { route_display_ = &display; }
  void choose_destination();
  void arrive();
  void judge_terminal(Time now);
  bool fare_is_right() const;
  bool is_near(std::string_view street, const cia447::GeoPosition& position) const;
  bool place_is_right() const;

  // taxi_network_events.cpp
  void step(Time now);
  void shift_changed(Time now, Activity from, Activity to);
  void pay(Time now);
  void print_receipt();
  void press_alarm(Time now);
  void judge_sign(Time now);
  bool is_only_local() const;
  double receipts_error() const;
  void show(const cia447::TaximeterDisplay& display);
  void car_event(const cia447::CarEvent& event);
  void heard(Time now, const BusEvent& event);
  void frame_sent();
  void judge_service(Time now);
  void judge_devices(Time now);
  bool is_at_work(car::CarNode& node);
  bool is_excused(Time now) const;
  bool is_excused_all_along() const;
  cia447::CarMaster* gateway_master() { return nodes_.front()->device().master(); }
  bool all_sleep() const;
  void check(Time now);
  void end_of_shift(Time now);
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  // taxi_network_faults.cpp
  void plan_faults();
  void begin(std::size_t fault);
  void end(std::size_t fault);
  void excuse(FaultKind kind);
  void set_fault(const ScheduledFault& fault, bool present);
  void take_paper(bool is_out);
  void is_printer(cia447::PrinterUnit& unit, Node& node);
  void set_power(NodeId id, bool is_on);

  TaxiOptions options_;
  Sabotage sabotage_;
  World world_;
  BusIndex bus_;
  car::Drive drive_;
  std::deque<Site> sites_;
  car::CarNodes nodes_;
  cia447::KnownDevices known_;  ///< kept by the gateway
  KeptFlash meter_flash_{4, 1024};
  cia447::IvnGatewayUnit* gateway_ = nullptr;
  cia447::TaximeterUnit* meter_ = nullptr;
  std::optional<cia447::MeterOutputs> outputs_;  ///< of the meter
  cia447::PrinterUnit* printer_ = nullptr;
  PaperText paper_;
  cia447::DriverIdentificationUnit* driver_reader_ = nullptr;
  cia447::TaxiAlarmUnit* alarm_ = nullptr;
  bool vacant_light_ = false;
  std::array<cia447::Lamp, cia447::tariff_lamps_max> lamps_{};
  cia447::NavigationUnit* navigation_ = nullptr;
  FareDisplay* fare_display_ = nullptr;             ///< of the meter; null while that has no power
  RouteDisplay* route_display_ = nullptr;           ///< of the driver's unit
  std::optional<cia447::GeoPosition> destination_;  ///< where the passengers want to go
  std::array<Screen, 2> screens_;
  cia447::TaximeterDisplay display_;
  Shift shift_;
  BusWatch bus_watch_;
  std::optional<RealDevices> real_;
  std::optional<cia447::TripReader> trip_reader_;  ///< of a real meter's trip
  bool is_trip_read_ = false;                      ///< since the meter is in its state
  std::optional<SdoClient> totals_reader_;         ///< of a real meter's shift
  std::array<std::uint8_t, 4> shift_income_{};
  std::size_t lines_before_trip_ = 0;  ///< on the paper
  Time rolled_{};                      ///< when the wheels of a real car were heard last
  std::vector<TaxiEvent> events_;

  // Judged
  FareReferee fares_;
  std::vector<Trip> trips_;
  double paid_ = 0;  ///< in 0,001 of the currency unit
  std::uint64_t frames_asleep_ = 0;
  bool is_asleep_ = false;
  Time waiting_since_{};
  Duration waited_{};
  std::array<Time, cia447::node_id_max + 1> missing_since_{};
  Duration missing_{};
  bool is_over_ = false;  ///< the shift, with its totals judged
  double totals_error_ = 0;
  double receipts_error_ = 0;
  Time sign_is_right_at_{};
  Duration sign_was_wrong_{};
  std::array<Time, 2> screen_is_right_at_{};
  std::array<Duration, 2> screen_was_wrong_{};

  // Faults
  std::array<unsigned, fault_kinds> present_{};  ///< how many of each kind
  std::array<unsigned, cia447::node_id_max + 1> without_power_{};
  unsigned faults_present_ = 0;
  Time excused_until_{};
  bool waits_for_real_ = !options_.real.empty();
  bool wheel_is_lost_ = false;
  bool paper_is_out_ = false;
  bool fix_is_lost_ = false;
  ControllerId babbler_ = no_controller;
  std::array<bool, static_cast<std::size_t>(InvariantKind::device_missing) + 1> told_{};
};

}  // namespace canvoy::taxi
