// Judges how a bus serves its passengers: tickets, people carried past their stop or left at one,
// punctuality and occupancy, the count of people aboard, and which devices are at work; and whether
// its on-board computer can determine its position.
//
//     ServiceWatch watch(nodes, parts, events);
//     watch.step(now);                  // each 100 ms
//     watch.judge_devices(now);
#pragma once

#include "canvoy/devices/cia407/ticket/ticket_data.hpp"
#include "canvoy/worlds/bus_line/bus_faults.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/on_board_computer.hpp"
#include "canvoy/worlds/bus_line/true_data.hpp"
#include "canvoy/worlds/bus_line/vehicle_sensors.hpp"

namespace canvoy::bus_line {

class ServiceWatch {
 public:
  /// The objects that it watches; all must outlive the watch.
  struct Parts {
    const BusFaults& faults;          ///< what excuses a judgement
    const BusVehicle& vehicle;        ///< the truth about passengers
    const OnBoardComputer& computer;  ///< whose position and clock are judged
    VehicleSensors& sensors;          ///< counters and satellites
    const TrueHistory& truth;         ///< data that messages must carry
    BusReferee& referee;              ///< takes the judgements
    unsigned capacity;                ///< most people aboard
  };

  /// All must outlive this object.
  ServiceWatch(BusNodes& nodes, const Parts& parts, EventLog<NetworkEvent>& events)
      : nodes_(nodes), parts_(parts), events_(events) {}
  ServiceWatch(const ServiceWatch&) = delete;
  ServiceWatch& operator=(const ServiceWatch&) = delete;

  /// A fault has begun that affects these invariants.
  void fault_begins(const InvariantSet& kinds);
  /// A journey begins: all people have got out at the end of the one before, and the driver sets
  /// the counts to 0.
  void journey_begins();
  /// The bus leaves or passes a stop, this much later than in the timetable.
  void stop_left(const Passing& passing, Duration late);
  /// A passenger reads a new ticket.
  void ticket_issued(const cia407::TicketData& ticket, bool is_printed);
  /// Judges what can be seen at `now`; call it in each step.
  void step(Time now);
  /// Judges which devices are at work; call it in each step.
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
  bool needs_fix_ = true;           ///< the on-board computer has booted
  std::uint64_t badly_served_ = 0;  ///< number of people badly served that were judged
  std::uint64_t well_served_ = 0;
  std::uint64_t ignored_ = 0;
  std::uint64_t boarded_ = 0;
};

}  // namespace canvoy::bus_line
