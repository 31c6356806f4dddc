// The stop buttons of a bus and the signs that show passengers and the driver that it will stop. A
// passenger who has pressed, and sees no sign, presses again; the signs are judged.
//
//     StopRequests requests(nodes, parts, events);
//     requests.press(now, 2);       // a passenger in the second car
//     requests.look(now);           // each 100 ms: all look at the signs
//     requests.judge(now);
#pragma once

#include <array>

#include "canvoy/worlds/bus_line/bus_displays.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/bus_referee.hpp"
#include "canvoy/worlds/bus_line/following_cars.hpp"
#include "canvoy/worlds/bus_line/on_board_computer.hpp"

namespace canvoy::bus_line {

class StopRequests {
 public:
  /// Devices with buttons and signs; all must outlive the requests.
  struct Parts {
    const BusDisplays& displays;  ///< with signs
    OnBoardComputer& computer;    ///< that shows the request to the driver
    FollowingCars& following;     ///< with buttons of their own
    BusVehicle& vehicle;          ///< the truth about requests
    BusReferee& referee;          ///< takes the judgements
  };

  /// All must outlive this object.
  StopRequests(BusNodes& nodes, const Parts& parts, EventLog<NetworkEvent>& events)
      : nodes_(nodes), parts_(parts), events_(events) {}
  StopRequests(const StopRequests&) = delete;
  StopRequests& operator=(const StopRequests&) = delete;

  /// Presses a button: those of the first car are wired to the on-board computer, those of
  /// another car to its train bus gateway. False: the press has no effect.
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
  bool has_pressed(unsigned car) const { return pressed_.at(car - 1).times != 0; }
  bool is_due_in(unsigned car) const;
  bool has_unseen_sign() const;
  bool is_sign_seen(unsigned car) const;
  void press_again(Time now, unsigned car);

  BusNodes& nodes_;
  Parts parts_;
  EventLog<NetworkEvent>& events_;
  std::array<Pressed, cars_max> pressed_{};  ///< in each car
  std::array<bool, cars_max> told_signs_{};  ///< in each car
  bool has_stopped_ = false;                 ///< since it left the first stop of the day
};

}  // namespace canvoy::bus_line
