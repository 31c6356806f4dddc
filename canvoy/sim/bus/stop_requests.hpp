// The stop buttons of a bus and the signs by which passengers and the driver see that it will stop:
// who has pressed, and sees no sign, presses again; and whether the signs are right is judged.
//
//     StopRequests requests(nodes, parts, events);
//     requests.press(now, 2);       // a passenger in the second car
//     requests.look(now);           // each 100 ms: all look at the signs
//     requests.judge(now);
#pragma once

#include <array>

#include "canvoy/sim/bus/bus_displays.hpp"
#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/bus_referee.hpp"
#include "canvoy/sim/bus/on_board_computer.hpp"
#include "canvoy/sim/bus/second_car.hpp"

namespace canvoy::bus {

class StopRequests {
 public:
  /// Where buttons and signs are; all must outlive the requests.
  struct Parts {
    const BusDisplays& displays;
    OnBoardComputer& computer;
    SecondCar& second_car;
    BusVehicle& vehicle;
    BusReferee& referee;
  };

  /// All must outlive this.
  StopRequests(BusNodes& nodes, const Parts& parts, EventLog<NetworkEvent>& events)
      : nodes_(nodes), parts_(parts), events_(events) {}
  StopRequests(const StopRequests&) = delete;
  StopRequests& operator=(const StopRequests&) = delete;

  /// Buttons of the first car are wired to the on-board computer, those of the second one to its
  /// train bus gateway. False: nobody hears of it.
  bool press(Time now, unsigned car);
  /// It stands at a stop: from now on people press for the next one.
  void has_stopped() {
    pressed_.fill({});
    has_stopped_ = true;
  }
  /// The driver sees the signs that passengers of the first car see.
  void look(Time now);
  void judge(Time now);

 private:
  /// The stop buttons of a car, on the way to the next stop.
  struct Pressed {
    Time since{};  ///< the first time
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

}  // namespace canvoy::bus
