// A bus with its passenger information on a simulated CAN bus (CiA 407): seventeen devices, four in
// a second car behind a train bus gateway, a driver who logs in the journeys, passengers, faults by
// plan, and referees.
//
//     BusNetworkOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 1}};
//     BusNetwork network(options);
//     network.run_until(network.end());
//     for (const Invariant& invariant : network.invariants()) ok = ok && invariant.held;
//
// It begins five minutes before the first departure of its block. The same options give the same
// frames at the same times.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/bus_line/announcements.hpp"
#include "canvoy/worlds/bus_line/bus_displays.hpp"
#include "canvoy/worlds/bus_line/bus_faults.hpp"
#include "canvoy/worlds/bus_line/bus_network_event.hpp"
#include "canvoy/worlds/bus_line/bus_network_options.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/display_watch.hpp"
#include "canvoy/worlds/bus_line/excused_kinds.hpp"
#include "canvoy/worlds/bus_line/headways.hpp"
#include "canvoy/worlds/bus_line/heard_bus.hpp"
#include "canvoy/worlds/bus_line/local_clock.hpp"
#include "canvoy/worlds/bus_line/on_board_computer.hpp"
#include "canvoy/worlds/bus_line/second_car.hpp"
#include "canvoy/worlds/bus_line/service_watch.hpp"
#include "canvoy/worlds/bus_line/ticket_devices.hpp"
#include "canvoy/worlds/bus_line/true_clock.hpp"
#include "canvoy/worlds/bus_line/true_data.hpp"
#include "canvoy/worlds/bus_line/vehicle_sensors.hpp"

namespace canvoy::bus_line {

// Reads the eight pre-defined messages on the wire, byte by byte, and checks that they carry what
// their table requires, and the truth (CiA 407, 8.1.4.3).
//
//     messages.is_right(now, frame, sender, truth)      // nothing: it is none of them

class MessageReferee {
 public:
  /// Names their senders: the main on-board computer and the identification device.
  void name(ControllerId computer, ControllerId identification) {
    computer_ = computer;
    identification_ = identification;
  }
  /// Empty where the frame is none of the eight messages. Unknown values are zero in them.
  std::optional<bool> is_right(Time now, ControllerId sender, const Frame& frame,
                               const TrueHistory& truth) const;
  /// True if the message with the time has the true time, or a second before or after it.
  static bool is_time(const Frame& frame, const cia407::CivilTime& time);
  static constexpr std::uint32_t time_id = 0x181;  ///< CAN-ID of the message with the time

 private:
  ControllerId computer_ = no_controller;
  ControllerId identification_ = no_controller;
};

// State of a bus at one instant: its two cables and their devices, the displays, the vehicle on its
// route, and its passengers.
//
//     const BusNetworkSnapshot look = network.snapshot();
//     print(look.truth.stop->name, look.delay);

/// Counts since the start of a run.
struct BusNetworkStatistics {
  std::size_t journeys = 0;   ///< journeys begun
  std::size_t stops = 0;      ///< stops at which it stood, or which it passed
  std::size_t announced = 0;  ///< stops announced, in both cars
  std::size_t texts = 0;      ///< texts that appeared on displays
  Duration worst_delay{};     ///< behind the timetable, at a stop
  Headways headways{};        ///< to the vehicle ahead, where people come at random
};

/// State of the whole network.
struct BusNetworkSnapshot {
  Time at{};                            ///< since the start of the run
  std::array<BusSnapshot, 2> buses{};   ///< of each car
  std::vector<NodeSnapshot> nodes;      ///< of the devices, real ones too
  std::vector<std::string_view> names;  ///< of the nodes

  /// What a display shows.
  struct Shown {
    NodeId node = 0;           ///< of the display
    std::string text;          ///< UTF-8, a line for each element; empty: dark
    bool is_sign_lit = false;  ///< the lamp "stop requested"
  };
  std::vector<Shown> displays;         ///< for passengers, in both cars
  cia407::CivilTime local_time{};      ///< where the line runs
  EpochSeconds utc = 0;                ///< seconds since 1970-01-01
  BusTruth truth;                      ///< its pointers are valid as long as the network
  BusState state = BusState::at_stop;  ///< what the vehicle does
  GeoPoint position;                   ///< of the vehicle
  double heading = 0;                  ///< degrees clockwise from north
  double speed = 0;                    ///< m/s
  double odometer = 0;                 ///< m since the start
  double metres_on_route = 0;          ///< m from the first stop
  Duration delay{};                 ///< at the last arrival, departure or passing; negative: early
  std::vector<DoorState> doors;     ///< the first door first
  unsigned counted = 0;             ///< people aboard, by the on-board computer
  RiderStatistics riders;           ///< counts of its passengers
  BusNetworkStatistics statistics;  ///< counts of its network

  /// Both cars together: the higher load, and all frames.
  BusSnapshot traffic() const {
    return {.load = std::max(buses[0].load, buses[1].load),
            .frames = buses[0].frames + buses[1].frames,
            .error_frames = buses[0].error_frames + buses[1].error_frames};
  }
};

class BusNetwork {
 public:
  /// Makes all devices that are simulated here, and gives them power at time 0.
  explicit BusNetwork(BusNetworkOptions options);
  ~BusNetwork();
  BusNetwork(const BusNetwork&) = delete;
  BusNetwork& operator=(const BusNetwork&) = delete;

  /// Runs up to and including `until`.
  void run_until(Time until) { world_.run_until(until); }
  /// Time since the start of the run.
  Time now() const { return world_.now(); }
  /// End of the run, by its options.
  Time end() const { return end_of(options_); }

  /// State at present, for a drawing.
  BusNetworkSnapshot snapshot();
  /// All events since the start, oldest first.
  std::span<const NetworkEvent> events() const { return events_.all(); }
  /// Verdicts at present.
  /// Those of the second car are missing where the bus has one car.
  std::vector<Invariant> invariants() const;
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// The world of both cables; time passes only in run_until().
  World& world() { return world_; }
  /// The vehicle, its doors and passengers.
  BusVehicle& vehicle() { return vehicle_; }
  /// Its timetable.
  const BusLine& line() const { return options_.line; }
  /// Device with a node-ID; throws std::out_of_range where there is none.
  BusNode& node(NodeId id) { return nodes_.node(id); }
  /// All devices.
  std::span<const std::unique_ptr<BusNode>> nodes() const { return nodes_.all(); }
  /// Display with a node-ID; throws std::out_of_range where there is none.
  const ShownDisplay& display(NodeId id) const { return displays_.at(id); }
  /// Null where the node is no display.
  const ShownDisplay* find_display(NodeId id) const { return displays_.find(id); }
  /// Options that it was made with.
  const BusNetworkOptions& options() const { return options_; }
  /// Data that a listener has received from the frames of the first car.
  const HeardBus& heard() const { return heard_; }
  /// Time of the day of service: above 24 h after its midnight.
  Duration time_of_day() const { return vehicle_.time_of_day(now()); }

 private:
  void add_nodes();
  void hear_messages();
  void send_false_message();
  RiderHands rider_hands();
  void move_vehicle(Time now);
  void wake_vehicle() { world_.wake(vehicle_plant_, vehicle_.deadline()); }
  void lead_vehicle(Time now);
  void happened(Time now, BusEvent event, std::size_t stop);
  void begin_journey(Time now);
  void leave_stop(Time now, std::size_t stop);
  void reach_stop(Time now, StopReached::How how, std::size_t stop);
  void learn_truth(Time now);
  std::uint32_t driver() const;
  void log_in();
  void frame_sent(Time now, ControllerId sender, const Frame& frame);
  void frame_sent_in_second_car(Time now, ControllerId sender, const Frame& frame);
  void step(Time now);
  void judge(Time now);

  BusNetworkOptions options_;
  World world_;
  EventLog<NetworkEvent> events_;
  BusReferee referee_;
  BusNodes nodes_;
  BusVehicle vehicle_;
  PlantIndex vehicle_plant_ = 0;
  TrueClock clock_;
  TrueHistory truth_;
  OnBoardComputer computer_;
  BusDisplays displays_;
  TicketDevices tickets_;
  Announcements announcements_;
  VehicleSensors sensors_;
  SecondCar second_car_;
  StopRequests stop_requests_;
  BusFaults faults_;
  DisplayWatch display_watch_;
  ServiceWatch service_;
  HeardBus heard_;
  MessageReferee messages_;
  MessageReferee second_messages_;
  ToldInvariants<invariant_kinds> told_;
  BusNetworkStatistics counted_;
  bool wants_log_in_ = false;  ///< of the driver
  Time next_log_in_{};
};

}  // namespace canvoy::bus_line
