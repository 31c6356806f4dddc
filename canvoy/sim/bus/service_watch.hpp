// Looks on how a bus serves its passengers: tickets, who is carried past his stop or left at one,
// whether it keeps its timetable and how full it is, who is counted aboard, which devices are
// there; and whether its on-board computer can know where it is.
//
//     ServiceWatch watch(nodes, parts, events);
//     watch.step(now);                  // each 100 ms
//     watch.judge_devices(now);
#pragma once

#include "canvoy/devices/cia407/ticket/ticket_data.hpp"
#include "canvoy/sim/bus/bus_faults.hpp"
#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/bus_referee.hpp"
#include "canvoy/sim/bus/on_board_computer.hpp"
#include "canvoy/sim/bus/true_data.hpp"
#include "canvoy/sim/bus/vehicle_sensors.hpp"

namespace canvoy::bus {

class ServiceWatch {
 public:
  /// What it looks at; all must outlive the watch.
  struct Parts {
    const BusFaults& faults;
    const BusVehicle& vehicle;
    const OnBoardComputer& computer;
    VehicleSensors& sensors;
    const TrueHistory& truth;
    BusReferee& referee;
    unsigned capacity;  ///< people for whom there is room
  };

  /// All must outlive this.
  ServiceWatch(BusNodes& nodes, const Parts& parts, EventLog<NetworkEvent>& events)
      : nodes_(nodes), parts_(parts), events_(events) {}
  ServiceWatch(const ServiceWatch&) = delete;
  ServiceWatch& operator=(const ServiceWatch&) = delete;

  /// A fault has begun that affects these.
  void fault_begins(const InvariantSet& kinds);
  /// At the end of the one before nobody is aboard, and the driver sets the counts to 0.
  void journey_begins();
  /// It leaves a stop, or goes past it, so long after the time of the timetable.
  void stop_left(const Passing& passing, Duration late);
  /// A passenger reads it.
  void ticket_issued(const cia407::TicketData& ticket, bool is_printed);
  void step(Time now);
  void judge_devices(Time now);

 private:
  bool can_log_in();
  bool can_tell_satellites();
  void judge_people(Time now);
  void judge_counts(Time now);
  void excuse_blindness(Time now);
  void excuse_clock(Time now);

  BusNodes& nodes_;
  Parts parts_;
  EventLog<NetworkEvent>& events_;
  bool counts_are_lost_ = false;
  bool needs_fix_ = true;           ///< the on-board computer has begun anew
  std::uint64_t badly_served_ = 0;  ///< that were judged, as the next
  std::uint64_t well_served_ = 0;
  std::uint64_t ignored_ = 0;
  std::uint64_t boarded_ = 0;
};

}  // namespace canvoy::bus
