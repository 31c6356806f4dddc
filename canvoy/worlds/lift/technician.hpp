// A technician who comes to a lift that has caught its car, keeps people in it, reports a fault
// that stays, or does not serve: they press a stop switch, move the car by hand to a floor, let all
// people out, wait until what is broken is mended, inspect, close the safety chain again, and ride
// on the roof of the car by inspection control.
//
//     Technician technician(hands, seed);
//     technician.call(now, TechnicianCause::trip);
//     technician.look(now, view);      // each second, and at technician.deadline()
//
// The rescue is that of EN 81-20: at most 0.3 m/s, to the nearest landing. A lift that does not
// obey the inspection control (5.12.1.5) is switched off and on, once; then it is left out of
// service.
#pragma once

#include <cstdint>
#include <functional>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// Cause of the call.
enum class TechnicianCause : std::uint8_t {
  trip,       ///< the safety chain, which must be closed by hand
  trapped,    ///< people in the car, by its alarm button
  fault,      ///< its controller reports that the lift stays out of service
  complaint,  ///< of people: a referee has found that the lift breaks a rule
};
/// Steps of the work, as they are told.
enum class TechnicianStep : std::uint8_t {
  called_for_trip,
  called_for_people,
  arrives,    ///< and presses the stop switch
  moves_car,  ///< by hand, to a floor
  lets_out,   ///< with the key of the door there
  inspects,   ///< on the roof of the car and in the pit, with the stop switch pressed
  resets,     ///< the safety chain
  leaves,     ///< the work is done
  called_for_fault,
  called_for_complaint,
  rides,     ///< on the roof of the car, by inspection control
  restarts,  ///< switches controller and drive off and on
  gives_up,  ///< the lift stays out of service
};

/// Actions at the lift. None may be empty.
struct TechnicianHands {
  std::function<void(bool is_pressed)> stop_switch;  ///< opens the safety chain
  /// Opens the brake and moves the car at this speed; 0: closes it. False: the car cannot be moved.
  std::function<bool(double metre_per_second)> crank;
  std::function<void(bool is_held)> hold_door;  ///< opens or closes it with a key
  std::function<void()> reset;                  ///< resets what must be closed by hand
  std::function<void(bool is_on)> inspection;   ///< turns the switch on the roof of the car
  std::function<void(Direction)> drive;         ///< holds that button there; none: lets go
  std::function<void()> restart;                ///< switches controller and drive off and on
  std::function<void(TechnicianStep, FloorNumber)> tell;  ///< reports a step; no_floor: anywhere
};

/// Visible state of the lift.
struct TechnicianView {
  bool is_tripped = false;  ///< a part of the safety chain must be closed by hand
  bool is_shut_in = false;  ///< people are behind shut doors, in a car that stands
  bool is_out = false;      ///< its display shows that it is out of order
  bool stands = true;       ///< at a speed below 1 mm/s
  bool is_low = true;       ///< in the lower half of its travel
  bool is_whole = true;     ///< nothing is broken that keeps the lift from working
  bool is_empty = true;     ///< of passengers
  double to_floor_m = 0;    ///< distance to the nearest floor with a door, up or down
  FloorNumber nearest = 1;  ///< that floor
};

class Technician {
 public:
  /// Speed at which the technician moves a car.
  static constexpr double crank_m_s = 0.3;

  /// `seed` draws the times of the work.
  Technician(TechnicianHands hands, std::uint64_t seed);

  /// Calls the technician, who comes after a time that is drawn; does nothing for one who is called
  /// already.
  void call(Time now, TechnicianCause cause);
  /// Call it each second, and at deadline().
  void look(Time now, const TechnicianView& car);
  /// Time of the next look(), beside each second.
  Time deadline() const { return step_ == Step::cranking ? until_ : never; }
  /// True if the technician was called, or is at work.
  bool is_called() const { return step_ != Step::away; }
  /// True if the technician has come.
  bool is_there() const { return is_called() && step_ != Step::coming; }
  /// True if the last work was in vain.
  bool has_given_up() const { return has_given_up_; }

 private:
  enum class Step : std::uint8_t {
    away,
    coming,
    cranking,
    letting_out,
    waiting,
    inspecting,
    riding,      ///< a button is held
    pausing,     ///< between two rides
    restarting,  ///< the devices boot
  };

  void enter(Step step, Time until) {
    step_ = step;
    until_ = until;
  }
  void arrive(Time now, const TechnicianView& car);
  void let_out(Time now, const TechnicianView& car);
  void wait(Time now, const TechnicianView& car);
  void reset(Time now, const TechnicianView& car);
  void begin_rides(Time now, Direction first);
  void hold_button(Time now);
  void ride(Time now, const TechnicianView& car);
  void pause(Time now);
  void end_in_vain(Time now);
  void leave();

  TechnicianHands hands_;
  Random random_;
  TechnicianCause cause_ = TechnicianCause::trip;
  Step step_ = Step::away;
  Time until_{};  ///< of the step
  Direction way_ = Direction::up;
  unsigned rides_left_ = 0;
  bool has_moved_ = false;  ///< since the button is held
  bool has_restarted_ = false;
  bool has_given_up_ = false;
};

}  // namespace canvoy::lift
