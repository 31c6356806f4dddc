// A bus with its passenger information on a simulated CAN bus (CiA 407): seventeen devices, four in
// a second car behind a train bus gateway, a driver who logs in his journeys, passengers, faults by
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

#include <memory>
#include <span>
#include <vector>

#include "canvoy/sim/bus/announcements.hpp"
#include "canvoy/sim/bus/bus_displays.hpp"
#include "canvoy/sim/bus/bus_faults.hpp"
#include "canvoy/sim/bus/bus_network_event.hpp"
#include "canvoy/sim/bus/bus_network_options.hpp"
#include "canvoy/sim/bus/bus_network_snapshot.hpp"
#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/bus_places.hpp"
#include "canvoy/sim/bus/bus_referee.hpp"
#include "canvoy/sim/bus/display_watch.hpp"
#include "canvoy/sim/bus/excused_kinds.hpp"
#include "canvoy/sim/bus/heard_bus.hpp"
#include "canvoy/sim/bus/message_referee.hpp"
#include "canvoy/sim/bus/on_board_computer.hpp"
#include "canvoy/sim/bus/second_car.hpp"
#include "canvoy/sim/bus/service_watch.hpp"
#include "canvoy/sim/bus/stop_requests.hpp"
#include "canvoy/sim/bus/ticket_devices.hpp"
#include "canvoy/sim/bus/true_clock.hpp"
#include "canvoy/sim/bus/true_data.hpp"
#include "canvoy/sim/bus/vehicle_sensors.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/told_invariants.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::bus {

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
  std::span<const NetworkEvent> events() const { return events_.all(); }
  /// As they stand now.
  std::vector<Invariant> invariants() const { return referee_.verdicts(); }
  /// None is broken.
  bool all_hold() const;

  // For tests, and for tools that take part.
  World& world() { return world_; }
  BusVehicle& vehicle() { return vehicle_; }
  const BusLine& line() const { return options_.line; }
  BusNode& node(NodeId id) { return nodes_.node(id); }
  std::span<const std::unique_ptr<BusNode>> nodes() const { return nodes_.all(); }
  const ShownDisplay& display(NodeId id) const { return displays_.at(id); }
  /// Null: the node is none.
  const ShownDisplay* find_display(NodeId id) const { return displays_.find(id); }
  const BusNetworkOptions& options() const { return options_; }
  /// What the frames of the first car have told somebody who listens there.
  const HeardBus& heard() const { return heard_; }
  /// Of the day of service: above 24 h after its midnight.
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
  bool wants_log_in_ = false;  ///< the driver
  Time next_log_in_{};
};

}  // namespace canvoy::bus
