// Judges how a bus serves its passengers: tickets, people carried past their stop or left at one,
// punctuality and occupancy, the count of people aboard, and which devices are at work; and whether
// its on-board computer can determine its position.
//
//     ServiceWatch watch(nodes, parts, events);
//     watch.step(now);                  // each 100 ms
//     watch.judge_devices(now);
#pragma once

#include <array>

#include "canvoy/devices/cia407/ticket/ticket_data.hpp"
#include "canvoy/worlds/bus_line/bus_displays.hpp"
#include "canvoy/worlds/bus_line/bus_faults.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/on_board_computer.hpp"
#include "canvoy/worlds/bus_line/second_car.hpp"
#include "canvoy/worlds/bus_line/true_data.hpp"
#include "canvoy/worlds/bus_line/vehicle_sensors.hpp"

namespace canvoy::bus_line {

// The stop buttons of a bus and the signs that show passengers and the driver that it will stop. A
// passenger who has pressed, and sees no sign, presses again; the signs are judged.
//
//     StopRequests requests(nodes, parts, events);
//     requests.press(now, 2);       // a passenger in the second car
//     requests.look(now);           // each 100 ms: all look at the signs
//     requests.judge(now);

class StopRequests {
 public:
  /// Devices with buttons and signs; all must outlive the requests.
  struct Parts {
    const BusDisplays& displays;  ///< with signs
    OnBoardComputer& computer;    ///< that shows the request to the driver
    SecondCar& second_car;        ///< with buttons of its own
    BusVehicle& vehicle;          ///< the truth about requests
    BusReferee& referee;          ///< takes the judgements
  };

  /// All must outlive this object.
  StopRequests(BusNodes& nodes, const Parts& parts, EventLog<NetworkEvent>& events)
      : nodes_(nodes), parts_(parts), events_(events) {}
  StopRequests(const StopRequests&) = delete;
  StopRequests& operator=(const StopRequests&) = delete;

  /// Presses a button: those of the first car are wired to the on-board computer, those of the
  /// second car to its train bus gateway. False: the press has no effect.
  bool press(Time now, unsigned car);
  /// The bus stands at a stop: further presses are for the next one.
  void has_stopped() {
    pressed_.fill({});
    has_stopped_ = true;
  }
  /// Looks at the signs. The driver sees those of the first car.
  void look(Time now);
  /// Judges whether each sign shows the truth; call it in each step.
  void judge(Time now);

 private:
  /// Presses in a car, on the way to the next stop.
  struct Pressed {
    Time since{};  ///< of the first press
    Time last{};
    unsigned times = 0;
  };

  bool is_wanted() const;
  bool has_unseen_sign() const;
  bool is_sign_seen(unsigned car) const;
  void press_again(Time now, unsigned car);

  BusNodes& nodes_;
  Parts parts_;
  EventLog<NetworkEvent>& events_;
  std::array<Pressed, 2> pressed_{};  ///< in each car
  std::array<bool, 2> told_signs_{};  ///< in each car
  bool has_stopped_ = false;          ///< since it left the first stop of the day
};

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
