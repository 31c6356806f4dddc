// A bus with its passenger information on a simulated CAN bus (CiA 407): seventeen devices, four in
// each further car behind a train bus gateway, a driver who logs in the journeys, passengers,
// faults by plan, and referees.
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

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/bus_line/announcements.hpp"
#include "canvoy/worlds/bus_line/bus_displays.hpp"
#include "canvoy/worlds/bus_line/bus_faults.hpp"
#include "canvoy/worlds/bus_line/bus_network_event.hpp"
#include "canvoy/worlds/bus_line/bus_network_options.hpp"
#include "canvoy/worlds/bus_line/bus_network_snapshot.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/display_watch.hpp"
#include "canvoy/worlds/bus_line/excused_kinds.hpp"
#include "canvoy/worlds/bus_line/following_cars.hpp"
#include "canvoy/worlds/bus_line/heard_bus.hpp"
#include "canvoy/worlds/bus_line/message_referee.hpp"
#include "canvoy/worlds/bus_line/on_board_computer.hpp"
#include "canvoy/worlds/bus_line/service_watch.hpp"
#include "canvoy/worlds/bus_line/stop_requests.hpp"
#include "canvoy/worlds/bus_line/ticket_devices.hpp"
#include "canvoy/worlds/bus_line/true_clock.hpp"
#include "canvoy/worlds/bus_line/true_data.hpp"
#include "canvoy/worlds/bus_line/vehicle_sensors.hpp"

namespace canvoy::bus_line {

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
  /// Those of cars that the bus does not have are missing.
  std::vector<Invariant> invariants() const;
  /// True if no invariant is broken.
  bool all_hold() const;

  // Access for tests, and for tools that take part.
  /// The world of all cables; time passes only in run_until().
  World& world() { return world_; }
  /// The vehicle, its doors and passengers.
  BusVehicle& vehicle() { return vehicle_; }
  /// Its timetable.
  const BusLine& line() const { return options_.line; }
  /// Device with a node-ID, which one of this bus has.
  BusNode& node(NodeId id) { return nodes_.node(key_of(options_.design, id)); }
  /// All devices.
  std::span<const std::unique_ptr<BusNode>> nodes() const { return nodes_.all(); }
  /// Display with a node-ID, which one of this bus has.
  const ShownDisplay& display(NodeId id) const { return displays_.at(key_of(options_.design, id)); }
  /// Null where the node is no display.
  const ShownDisplay* find_display(NodeId id) const {
    return displays_.find(key_of(options_.design, id));
  }
  /// Options that it was made with.
  const BusNetworkOptions& options() const { return options_; }
  /// Data that a listener has received from the frames of the first car.
  const HeardBus& heard() const { return heard_; }
  /// Time of the day of service: above 24 h after its midnight.
  Duration time_of_day() const { return vehicle_.time_of_day(now()); }

 private:
  /// Listens to the messages on the cable of a car behind the first.
  struct FollowingMessages {
    explicit FollowingMessages(BusNetwork& its_network) : network(its_network) {}
    BusNetwork& network;
    MessageReferee referee{};

    void frame_sent(Time now, ControllerId sender, const Frame& frame);
  };

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
  FollowingCars following_;
  StopRequests stop_requests_;
  BusFaults faults_;
  DisplayWatch display_watch_;
  ServiceWatch service_;
  HeardBus heard_;
  MessageReferee messages_;
  std::deque<FollowingMessages> following_messages_;
  ToldInvariants<invariant_kinds> told_;
  BusNetworkStatistics counted_;
  bool wants_log_in_ = false;  ///< of the driver
  Time next_log_in_{};
};

}  // namespace canvoy::bus_line
