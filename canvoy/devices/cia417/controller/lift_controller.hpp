// The controller of a lift: answers the calls of its CallController with the doors and the drive of
// its car, one trip after the other, in every service that keys can request, and stops safely on
// faults.
//
//     LiftController lift(node, calls, {.motion = drive.interface(), .doors = doors.interface()},
//                         {.floors = positions, .doors = 0b01});
//     // each of calls, drive and doors tells lift.update() of its changes
//
// A trip: doors close and lock; the car drives, stops for the calls of its collective control, and
// halts within 10 mm of the floor; doors open, wait, and close again. A car that sinks under its
// load is levelled at its floor with open doors.
//
// This class goes from phase to phase. The state is in other classes: the service
// (LiftServiceState), the dwell time of doors (DoorDwell), the floors (LiftFloors), the faults
// (LiftFaults).
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/controller/lift_faults.hpp"
#include "canvoy/devices/cia417/controller/lift_service.hpp"
#include "canvoy/devices/cia417/lift/collective_control.hpp"
#include "canvoy/devices/cia417/lift/door_dwell.hpp"
#include "canvoy/devices/cia417/lift/hand_drive.hpp"
#include "canvoy/devices/cia417/lift/levelling.hpp"
#include "canvoy/devices/cia417/lift/lift_floors.hpp"
#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"

namespace canvoy::cia417 {

/// Times of a lift's work.
struct LiftTimes {
  Duration dwell_car = 3s;         ///< doors stay open for passengers who get out
  Duration dwell_hall = 4s;        ///< doors stay open for passengers who get in
  Duration dwell_again = 2s;       ///< after a button or something in the door
  Duration dwell_long = 15s;       ///< load time, bed passenger service
  Duration nudging = 20s;          ///< then doors close gently, even if obstructed
  Duration door_opens_max = 10s;   ///< then they close again, and retry
  Duration door_closes_max = 10s;  ///< then they open again, and retry
  Duration travel_max = 45s;       ///< without a floor on the way (EN 81-20, 5.9.2.7)
  Duration parking = 60s;          ///< without a call, before it goes to the parking floor
  Duration start = 3s;             ///< for drive and doors to be received after power-on
  Duration retry = 5s;             ///< after the end of a fault, and for an action that failed
  Duration steady = 500ms;         ///< of a car's position, before doors open in a fault
};

/// Settings of a lift controller that no object of its dictionary has.
struct LiftControllerSettings {
  /// Of floor 1 and up, rising, at most 254: in micrometres, as in LiftMotion. Must outlive the
  /// controller.
  std::span<const std::int32_t> floors{};
  DoorMask doors = 0b0001;  ///< of the car
  /// From the floor, at which the car has arrived.
  std::int32_t floor_tolerance_micrometre = 10'000;
  /// On both sides of a floor, where the car may move with open doors.
  std::int32_t door_zone_micrometre = 200'000;
  std::uint8_t fire_floor = 1;                                 ///< where all passengers get out
  std::uint8_t parking_floor = 0;                              ///< 0: it stays where it is
  std::int32_t service_speed_micrometre_per_second = 630'000;  ///< EN 81-20: inspection
  std::int32_t dogging_speed_micrometre_per_second = 300'000;  ///< by two buttons
  LiftTimes times{};                                           ///< of its work
};

/// Load of the car, as far as it matters for trips.
struct LiftLoad {
  bool known = true;      ///< false: the load unit is lost, or has an error
  bool zero = false;      ///< empty
  bool full = false;      ///< no room for further passengers
  bool overload = false;  ///< it must not start

  friend constexpr bool operator==(const LiftLoad&, const LiftLoad&) = default;
};

/// The parts that a lift controller uses; each calls update() when it has changed.
struct LiftParts {
  LiftMotion motion;          ///< drive and position unit
  LiftDoors doors;            ///< of all doors
  Callback<LiftLoad()> load;  ///< without one the car is neither empty nor full
  /// Requests the state of the parts again, as the known one may be out of date. Called when a trip
  /// or a door movement does not end in time, and repeatedly during a fault.
  Callback<void()> ask_anew = {};
};

/// Progress of a trip.
enum class LiftPhase : std::uint8_t {
  idle,     ///< at rest with closed doors
  driving,  ///< to target()
  opening,
  open,
  closing,
  manual,   ///< driven by buttons
  stopped,  ///< by a fault
};

class LiftController {
 public:
  /// All arguments must outlive the controller.
  LiftController(Node& node, CallController& calls, const LiftParts& parts,
                 const LiftControllerSettings& settings);

  /// Evaluates all inputs after a change, and acts. From outside of a callback of the node, call
  /// Node::advance() before and after.
  void update();
  /// Calls `changed` when phase, service, fault, floor or direction have changed.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// For a group: called when the car answers the hall calls of a floor, with its further direction
  /// (none: it takes passengers for both) and the doors that open.
  void on_stop(Callback<void(const Landing&, DoorMask)> stopped) { stopped_ = stopped; }

  /// Progress of the present trip.
  LiftPhase phase() const { return phase_; }
  /// Service that the lift is in.
  LiftService service() const { return service_.now(); }
  /// Fault that stops it; none while it works.
  LiftFault fault() const { return faults_.now(); }
  /// The next floor that the car reaches, or at which it stands.
  std::uint8_t floor() const { return floor_; }
  /// Floor of the present trip; 0: none.
  std::uint8_t target() const { return target_; }
  /// Direction of the present trip, or of the calls that it will answer next; none: no call.
  Direction direction() const { return direction_; }
  /// True soon after start: drive and doors may not have been received yet, and panels show an old
  /// state.
  bool is_starting() const { return node_.now() < started_at_ + settings_.times.start; }
  /// True while the drive has a target.
  bool is_moving() const { return phase_ == LiftPhase::driving; }
  /// True if hall calls are left to other trips.
  bool is_full() const { return load_.full || load_.overload; }
  /// Refuses during a trip, or with open doors: a controller changes to another lift (6001h) only
  /// at rest.
  AbortCode refuses_lift_number();
  /// True if the lift takes calls of a group.
  bool takes_hall_calls() const;

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void expired(Time) { update(); }
  void wake_at(Time at);

  // Reads the inputs.
  void look();
  void watch_position();
  LiftFault find_fault() const;
  void change_fault(LiftFault fault);
  void change_service(LiftService service);
  void show();
  SpecialIndications special_indications() const;

  // Acts on them, by phase.
  void step();
  void act();
  void enter(LiftPhase phase);
  void idle();
  void drive();
  void break_off();
  void await_open();
  void keep_open();
  void await_closed();
  void drive_by_hand();
  void stand();

  // Movement of the car.
  void begin_trip(std::uint8_t floor);
  void leave_for_a_door(std::uint8_t floor);
  void park(std::uint8_t floor);
  void go_to(std::uint8_t floor);
  void follow_calls();
  void arrive();
  NextStop promised_stop() const;
  NextStop wanted_stop(std::uint8_t floor, bool moving) const;
  CollectiveCar car_at(std::uint8_t floor, bool moving) const;

  // Movement of its doors.
  void stop_at(std::uint8_t floor, DoorMask doors);
  void report_stop(std::uint8_t floor, DoorMask doors);
  void open_doors(DoorMask doors);
  void close_doors();
  void let_out();
  void ask_while_it_waits();
  bool relevel();
  bool answer_here();
  bool should_open();
  DoorClosing wanted_closing() const;
  Duration dwell_for(CallKinds kinds) const;

  bool is_levelling_in_zone() const;
  bool is_locked() const { return (settings_.doors & ~doors_.locked) == 0; }
  bool is_barred() const {
    return (doors_.obstructed & settings_.doors) != 0 && !service_.distrusts_barriers();
  }
  bool is_open_wanted() {
    return dwell_.obeys_button(calls_.is_on(SpecialFunction::door_open)) &&
           service_.has_door_button();
  }
  LiftFloors floors() const { return {settings_.floors, settings_.floor_tolerance_micrometre}; }
  /// The floor at which the car stands; 0: none.
  std::uint8_t floor_here() const { return floors().at(motion_); }
  bool is_at_fire_floor() const { return floor_here() == settings_.fire_floor; }
  /// The doors of the car that open there.
  DoorMask doors_at(std::uint8_t floor) const { return calls_.doors_at(floor) & settings_.doors; }
  std::uint8_t nearest_served_floor(std::uint8_t floor) const;
  std::uint8_t next_served_floor(std::uint8_t floor) const;

  Node& node_;
  CallController& calls_;
  LiftParts parts_;
  LiftControllerSettings settings_;
  Callback<void()> changed_;
  Callback<void(const Landing&, DoorMask)> stopped_;
  static const ServiceHandlers service_calls;
  HandlerBinding link_{&service_calls, this};
  Timer timer_;

  MotionStatus motion_;
  DoorsStatus doors_;
  LiftLoad load_;

  LiftFaults faults_;
  DoorDwell dwell_;
  Levelling levelling_;
  LiftServiceState service_;
  HandDrive hand_;
  LiftPhase phase_ = LiftPhase::idle;
  std::uint8_t floor_ = 1;
  std::uint8_t target_ = 0;
  std::uint8_t departed_ = 0;  ///< the floor at which a trip has started; 0: none
  Direction direction_ = Direction::none;
  DoorMask open_doors_ = 0;
  DoorMask let_out_ = 0;  ///< doors that have been opened since the fault came
  DoorClosing closing_ = DoorClosing::normal;
  NextStop promised_{};     ///< while it comes to a stop: the floor, and the direction afterwards
  bool is_errand_ = false;  ///< it goes to its target without a call
  bool is_updating_ = false;
  bool again_ = false;
  std::int32_t steady_micrometre_ = 0;
  Time steady_since_{};
  Time deadline_ = never;
  Time idle_since_{};
  Time resume_at_{};
  Time ask_at_{};  ///< during a fault
  Time started_at_{};
};

}  // namespace canvoy::cia417
