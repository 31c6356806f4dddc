// A patrol of a police car in a simulated world: the car and its IVN gateway, the add-on devices
// that the gateway names and starts, a crew, a control room that calls it, faults by plan, and
// referees.
//
//     PoliceOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .node = 2, .start = Time(20min)}};
//     PoliceNetwork network(options);
//     network.run_until(Time(8h));
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// The patrol begins when the network is up, and ends an hour before the end; then radio and
// periphery have power for their after-run, the network is sent to sleep, and woken once more. The
// same options give the same frames at the same times.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/car/car_node.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/sim/police/crew.hpp"
#include "canvoy/sim/police/fault.hpp"
#include "canvoy/sim/police/invariant.hpp"
#include "canvoy/sim/police/navigation_control.hpp"
#include "canvoy/sim/police/police_event.hpp"
#include "canvoy/sim/police/police_referee.hpp"
#include "canvoy/sim/police/radio_control.hpp"
#include "canvoy/sim/police/signal_control.hpp"
#include "canvoy/sim/police/surroundings.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::police {

inline constexpr NodeId terminal_id = 2;
inline constexpr NodeId roof_light_id = 3;
inline constexpr NodeId roof_sound_id = 4;
inline constexpr NodeId blue_light_id = 5;
inline constexpr NodeId radio_id = 6;
inline constexpr NodeId audio_switch_id = 7;
inline constexpr NodeId hands_free_id = 8;
inline constexpr NodeId power_supply_id = 9;
inline constexpr NodeId inputs_id = 10;
inline constexpr NodeId navigation_id = 11;
/// In the order of their node-IDs, from 1 on.
inline constexpr std::array<std::string_view, 11> device_names = {
    "ivn-gateway",  "terminal",   "roof-bar-light", "roof-bar-sound",  "blue-light",    "radio",
    "audio-switch", "hands-free", "power-supply",   "discrete-inputs", "gps-navigation"};

/// What no fault of a plan does, so that each referee has something to see. What is a setting of a
/// client has to be chosen before the network is made.
struct Sabotage {
  bool greedy_navigation = false;  ///< it takes keys that are another client's
  bool hogging_signals = false;    ///< they do not give the number pad back
  bool cuts_flashers = false;      ///< the wires to the blue flashers
  bool cuts_siren = false;         ///< the wire to the loudspeaker
  bool slow_handset = false;       ///< its contact closes four seconds late
  bool sticking_relay = false;     ///< of the transmitter: it goes on
  bool cuts_display = false;       ///< the wires to display 2
  bool cuts_locks = false;         ///< the wires to the motors of the locks
  bool welded_supply = false;      ///< the relay of the radio's power never opens
  bool speaks_asleep = false;      ///< somebody sends a frame while all sleep
  bool sleepy_crew = false;        ///< which does not answer calls
};

struct PoliceOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  Duration length = 8h;  ///< of the whole run
  cia447::PowerSupplySettings supply{};
  std::vector<NodeId> real{};  ///< who is not played here
  Sabotage sabotage{};
};

struct PoliceStatistics {
  std::size_t calls = 0;
  std::size_t attended = 0;  ///< and reported
  Duration response_time{};  ///< from a call to the arrival: of all that were attended to, together
  unsigned keys = 0;         ///< pressed at the terminal
  unsigned statuses = 0;     ///< status messages that the control room got
  Duration longest_wait{};   ///< of somebody at the terminal, excused or not
};

/// A look at everything.
struct PoliceSnapshot {
  Time at{};
  BusSnapshot bus;
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  Activity crew = Activity::off_duty;
  Wish wish;
  bool is_asleep = false;
  PoliceStatistics statistics;

  // The truth
  Surroundings around;
  std::array<bool, beacon_count> beacons{};  ///< that give light at this instant
  std::array<bool, flasher_count> flashers{};
  bool is_blue = false;            ///< flashes
  std::optional<Client> client{};  ///< who is read on display 1
  bool crew_speaks = false;
  bool crew_is_heard = false;
  bool room_speaks = false;
  bool room_is_heard = false;
  double metres = 0;
  double speed = 0;  ///< m/s
};

class PoliceNetwork {
 public:
  explicit PoliceNetwork(PoliceOptions options);
  ~PoliceNetwork();
  PoliceNetwork(const PoliceNetwork&) = delete;
  PoliceNetwork& operator=(const PoliceNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  Time now() const { return world_.now(); }

  PoliceSnapshot snapshot();
  /// All since the start, oldest first.
  std::span<const PoliceEvent> events() const { return events_; }
  std::span<const EmergencyCall> calls() const { return crew_.calls(); }
  /// As they stand now.
  std::vector<Invariant> invariants() const;
  /// None is broken.
  bool all_hold() const;

  // For tests, and for tools that take part.
  World& world() { return world_; }
  const Surroundings& around() const { return around_; }
  const Crew& crew() const { return crew_; }
  cia447::TerminalUnit& terminal() { return *terminal_; }
  car::CarNode& node(NodeId id) { return *nodes_.at(id - std::size_t{1}); }
  std::span<const std::unique_ptr<car::CarNode>> nodes() const { return nodes_; }
  const PoliceOptions& options() const { return options_; }

 private:
  /// A device that has lost its power, or its bus, is named, booted and started in this time.
  static constexpr Duration return_bound = 20s;

  // police_network.cpp
  void step(Time now);
  void frame_sent();
  void heard(Time now, const BusEvent& event);
  void car_event(const cia447::CarEvent& event);
  void sleep_and_wake(Time parked);
  bool is_asleep() const;
  bool anybody_sleeps() const;
  bool is_excused(Time now) const;
  bool is_played(NodeId id) const;
  bool room_hears_crew() const;
  bool crew_hears_room() const;
  Wish look() const;
  bool talks_are_played() const;
  std::vector<InvariantKind> undecided_kinds() const;
  bool display_is_right() const;
  bool power_is_right(Time now) const;
  std::optional<Client> shown_client() const;
  bool is_at_work(car::CarNode& node);
  void judge(Time now);
  void tell_changes(Time now);
  void check(Time now);
  template <class What>
  void note(Time now, const What& what) {
    events_.push_back({now, what});
  }

  // police_network_car.cpp
  void add_nodes();
  Site& add_site() { return sites_.emplace_back(); }
  void add(std::span<const cia447::CarUnit* const> units);
  void add_terminal();
  void add_lights();
  void add_radio();
  void add_others();
  void power(car::CarNode& node, bool is_on);
  void lost_power(NodeId id);
  void report_car();
  CrewHands crew_hands();
  TerminalHands terminal_hands();
  void open(Client client);
  void press(Client client, cia447::NumberPadKey key);
  void press(cia447::FunctionKey key);
  void acted(const KeyAction& action) { referee_.acted(action); }
  void lift_handset(bool is_pressed);
  void press_handset(bool is_pressed);
  void press_hands_free();
  void turn_ignition(bool is_on);
  void turn_key(bool is_locked);
  bool has_power(NodeId id) { return node(id).is_powered(); }
  void touched(NodeId id) { world_.touched(id - SlotIndex{1}); }

  cia447::CarHardware car_hardware();
  void car_became(const cia447::FieldPlace& status, std::uint32_t code);
  cia447::CarMemory memory();
  cia447::KnownDevices known() { return known_; }
  void keep(const cia447::KnownDevices& known) { known_ = known; }
  void is_gateway(cia447::IvnGatewayUnit& unit, Node& /*node*/) { gateway_ = &unit; }
  cia447::TerminalHardware terminal_hardware();
  void show(const cia447::DisplayContent& content);
  void is_terminal(cia447::TerminalUnit& unit, Node& /*node*/) { terminal_ = &unit; }
  cia447::SwitchedHardware roof_light_hardware();
  void roof_light_became(const cia447::FieldPlace& status, std::uint32_t code);
  cia447::SwitchedHardware blue_light_hardware();
  void blue_light_became(const cia447::FieldPlace& status, std::uint32_t code);
  void is_blue_light(cia447::BlueLightUnit& unit, Node& /*node*/) { blue_light_ = &unit; }
  cia447::RoofBarSoundHardware sound_hardware();
  void play(const cia447::RoofBarSound& sound);
  void is_sound(cia447::RoofBarSoundUnit& unit, Node& /*node*/) { sound_ = &unit; }
  SignalControlHardware signal_hardware();
  SignalControlSettings signal_settings();
  cia447::SwitchedHardware radio_hardware();
  void radio_became(const cia447::FieldPlace& status, std::uint32_t code);
  void is_radio(cia447::RadioUnit& unit, Node& /*node*/) { radio_ = &unit; }
  RadioControlHardware radio_control_hardware();
  RadioControlSettings radio_control_settings();
  void is_radio_control(RadioControl& control, Node& /*node*/) { radio_control_ = &control; }
  void send_status(int status);
  cia447::AudioSwitchHardware audio_hardware();
  void connect(unsigned input, unsigned output, std::uint8_t gain);
  cia447::HandsFreeHardware hands_free_hardware();
  void show_led(bool is_on) { around_.led_is_lit = is_on; }
  void is_hands_free(cia447::HandsFreeUnit& unit, Node& /*node*/) { hands_free_ = &unit; }
  cia447::PowerSupplyHardware supply_hardware();
  cia447::PowerSupplySettings supply_settings() { return options_.supply; }
  void switch_power(cia447::Supply supply, bool is_on);
  void is_supply(cia447::PowerSupplyUnit& unit, Node& /*node*/) { supply_ = &unit; }
  void is_inputs(cia447::DiscreteInputsUnit& unit, Node& /*node*/) { inputs_ = &unit; }
  cia447::GpsHardware gps_hardware();
  cia447::GpsReading gps_reading();
  cia447::NavigationHardware navigation_hardware();
  cia447::GeoPosition here() const;
  std::optional<cia447::GeoPosition> position() { return here(); }
  double road(const cia447::GeoPosition& from, const cia447::GeoPosition& to);
  void is_navigation(cia447::NavigationUnit& unit, Node& /*node*/) { navigation_ = &unit; }
  NavigationControlHardware navigation_control_hardware();
  NavigationControlSettings navigation_control_settings();
  double guide(unsigned destination);
  void is_navigation_control(NavigationControl& control, Node& /*node*/) {
    navigation_control_ = &control;
  }
  std::optional<double> speed() { return drive_.speed(); }
  std::optional<double> distance() { return drive_.metres(); }

  // police_network_faults.cpp
  void plan_faults();
  void begin(std::size_t fault);
  void end(std::size_t fault);
  void set_fault(const ScheduledFault& fault, bool present);
  void set_power(NodeId id, bool is_on);
  void burn_lamp(bool is_burnt);
  bool is_present(FaultKind kind) const { return present_[static_cast<std::size_t>(kind)] != 0; }
  /// Nobody notices that frames are sent again.
  static constexpr Duration excuse_of(FaultKind kind) {
    return kind == FaultKind::corrupted_frames ? Duration{} : return_bound;
  }
  void look_for_client();

  PoliceOptions options_;
  World world_;
  BusIndex bus_;
  car::Drive drive_;
  Surroundings around_;
  std::deque<Site> sites_;
  car::CarNodes nodes_;
  cia447::KnownDevices known_;  ///< kept by the gateway
  cia447::IvnGatewayUnit* gateway_ = nullptr;
  cia447::TerminalUnit* terminal_ = nullptr;
  cia447::BlueLightUnit* blue_light_ = nullptr;
  cia447::RoofBarSoundUnit* sound_ = nullptr;
  cia447::RadioUnit* radio_ = nullptr;
  RadioControl* radio_control_ = nullptr;
  cia447::HandsFreeUnit* hands_free_ = nullptr;
  cia447::PowerSupplyUnit* supply_ = nullptr;
  cia447::DiscreteInputsUnit* inputs_ = nullptr;
  cia447::NavigationUnit* navigation_ = nullptr;
  NavigationControl* navigation_control_ = nullptr;
  bool is_making_gateway_ = false;
  double scene_at_ = 0;                ///< m of the drive
  Time ignition_off_at_ = Time(-24h);  ///< last
  Crew crew_;
  BusWatch bus_watch_;
  std::vector<PoliceEvent> events_;
  PoliceStatistics counted_;  ///< keys, statuses, longest wait

  // Judged
  PoliceReferee referee_;
  std::vector<InvariantKind> undecided_;
  Time settled_at_ = Time(return_bound);  ///< all have booted
  bool waits_for_real_ = !options_.real.empty();
  Time free_at_{};  ///< when nothing was judged last
  bool is_asleep_ = false;
  Time asleep_at_{};
  SignalsChanged told_signals_;
  std::optional<Client> told_client_;

  // Faults
  std::array<unsigned, fault_kinds> present_{};  ///< how many of each kind
  std::array<unsigned, cia447::node_id_max + 1> without_power_{};
  unsigned faults_present_ = 0;
  Time excused_until_{};
  ControllerId babbler_ = no_controller;
  bool client_shall_die_ = false;
  NodeId dead_client_ = 0;
  std::array<bool, static_cast<std::size_t>(InvariantKind::device_missing) + 1> told_{};
};

}  // namespace canvoy::police
