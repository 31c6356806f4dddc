// The controller of a lift: answers the calls of its CallController with the doors and the drive of
// its car, one trip after the other, in every service that keys can ask for, and stands safely when
// something is wrong.
//
//     LiftController lift(node, calls, {.motion = drive.interface(), .doors = doors.interface()},
//                         {.floors = positions, .doors = 0b01});
//     // each of calls, drive and doors tells lift.update() of its changes
//
// A trip: doors close and lock; the car drives, stops for what its collective control collects,
// stands within 10 mm of the floor; doors open, wait, and close again. A car that sinks by those
// who get in is brought back to its floor with open doors. What a service does is in
// docs/decisions.md: the profile names them and leaves the rest to the maker.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/controller/collective_control.hpp"
#include "canvoy/devices/cia417/controller/lift_interfaces.hpp"

namespace canvoy::cia417 {

struct LiftTimes {
  Duration dwell_car = 3s;    ///< doors stay open for who gets out
  Duration dwell_hall = 4s;   ///< and for who gets in
  Duration dwell_again = 2s;  ///< after a button or something in the door
  Duration dwell_long = 15s;  ///< load time, bed passenger service
  Duration nudging = 20s;     ///< then doors close whatever stands in them, gently
  Duration door_opens_max = 10s;
  Duration door_closes_max = 10s;  ///< then they open again, for another try
  Duration travel_max = 45s;       ///< without a floor on the way (EN 81-20, 5.9.2.7)
  Duration parking = 60s;          ///< without a call, until it goes to the parking floor
  Duration start = 3s;             ///< for drive and doors to be heard after power-on
  Duration retry = 5s;             ///< after a fault has gone, and of what did not work
  Duration steady = 500ms;         ///< of a car's position, before people are let out in a fault
};

struct LiftControllerSettings {
  /// Of floor 1 and up, rising, at most 254: micrometres as LiftMotion counts them. Must outlive
  /// the controller.
  std::span<const std::int32_t> floors{};
  DoorMask doors = 0b0001;  ///< of the car
  std::int32_t floor_tolerance_micrometre = 10'000;
  /// To both sides of a floor, where the car may move with open doors.
  std::int32_t door_zone_micrometre = 200'000;
  std::uint8_t fire_floor = 1;                                 ///< where everybody gets out
  std::uint8_t parking_floor = 0;                              ///< 0: it stays where it is
  std::int32_t service_speed_micrometre_per_second = 630'000;  ///< EN 81-20: inspection
  std::int32_t dogging_speed_micrometre_per_second = 300'000;
  LiftTimes times{};
};

struct LiftLoad {
  bool known = true;
  bool zero = false;
  bool full = false;
  bool overload = false;

  friend constexpr bool operator==(const LiftLoad&, const LiftLoad&) = default;
};

/// What a lift controller works with; each calls update() when it has changed.
struct LiftParts {
  LiftMotion motion;
  LiftDoors doors;
  Callback<LiftLoad()> load;  ///< without one the car is neither empty nor full
};

/// In the order of what goes before what.
enum class LiftService : std::uint8_t {
  normal,
  attendant,  ///< doors close when the attendant says so
  vip,        ///< car calls only, and so for the next two
  bed_passenger,
  special,
  dogging,       ///< by two buttons, slowly
  service_run,   ///< the same for who maintains it
  fire_brigade,  ///< car calls only, doors by their buttons alone
  fire_recall,   ///< to the fire floor, and out
  out_of_order,
};

enum class LiftPhase : std::uint8_t {
  idle,     ///< stands with closed doors
  driving,  ///< to target()
  opening,
  open,
  closing,
  manual,   ///< driven by buttons
  stopped,  ///< by a fault
};

/// Each is an application error FF04h with this as instance.
enum class LiftFault : std::uint8_t {
  none,
  motion,       ///< drive or position unit
  unlocked,     ///< a door is not locked while the car moves
  door,         ///< a door is not heard or tells an error
  load,         ///< the load is not known
  travel_time,  ///< the car does not arrive
  position,     ///< the car does not stand where it should: no floor, or short of its target
};

class LiftController {
 public:
  static constexpr std::uint16_t error_code = 0xFF04;
  /// Instances of the errors that doors did not open, or not close, in time.
  static constexpr std::uint16_t opens_late = 0x10;
  static constexpr std::uint16_t closes_late = 0x11;

  /// All must outlive the controller.
  LiftController(Node& node, CallController& calls, const LiftParts& parts,
                 const LiftControllerSettings& settings);
  LiftController(const LiftController&) = delete;
  LiftController& operator=(const LiftController&) = delete;

  /// Something has changed: looks at all, and acts. From outside of a callback of the node, call
  /// Node::advance() before and after.
  void update();
  /// Called when phase, service, fault, floor or direction have changed.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// Called when it answers the hall calls of a floor, for a group: where it goes on to (none: it
  /// takes whoever comes), and the doors that open.
  void on_stop(Callback<void(const Landing&, DoorMask)> stopped) { stopped_ = stopped; }

  LiftPhase phase() const { return phase_; }
  LiftService service() const { return service_; }
  LiftFault fault() const { return fault_; }
  /// The next one that it comes to, or stands at.
  std::uint8_t floor() const { return floor_; }
  std::uint8_t target() const { return target_; }
  Direction direction() const { return direction_; }
  /// It has just been started: drive and doors may not have been heard, and panels show what was
  /// before.
  bool is_starting() const { return node_.now() < started_at_ + settings_.times.start; }
  bool is_moving() const { return phase_ == LiftPhase::driving; }
  bool is_full() const { return load_.full || load_.overload; }
  /// Not with a trip under way, or its doors open: it goes to another lift (6001h) from rest alone.
  AbortCode refuses_lift_number();
  /// Takes calls of a group.
  bool takes_hall_calls() const;

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void expired(Time) { update(); }
  void look();
  void watch_position();
  void step();
  void act();

  // lift_controller.cpp: what is the case
  LiftFault find_fault() const;
  void change_fault(LiftFault fault);
  LiftService wanted_service() const;
  void change_service(LiftService service);
  CallKinds accepted() const;
  bool is_exclusive() const;
  void show();
  void wake_at(Time at);
  void tell_error(std::uint16_t instance, bool present);

  // lift_trip.cpp: where the car goes
  void idle();
  void begin_trip(std::uint8_t floor);
  void leave_for_a_door(std::uint8_t floor);
  void park(std::uint8_t floor);
  void drive();
  void follow_calls();
  NextStop promised_stop() const;
  void arrive();
  void go_to(std::uint8_t floor);
  void stand();
  void let_out();
  void drive_by_hand();
  void enter(LiftPhase phase);
  NextStop wanted_stop(std::uint8_t floor, bool moving) const;
  CollectiveCar car_at(std::uint8_t floor, bool moving) const;

  // lift_stop.cpp: what its doors do
  void stop_at(std::uint8_t floor, DoorMask doors);
  void open_doors(DoorMask doors);
  bool relevel();
  void await_open();
  void keep_open();
  void close_doors();
  DoorClosing wanted_closing() const;
  void await_closed();
  void opened(bool in_time) { tell_late(opens_late, late_opening_, !in_time); }
  void closed(bool in_time) { tell_late(closes_late, late_closing_, !in_time); }
  void tell_late(std::uint16_t instance, bool& told, bool late);
  bool answer_here();
  void tell_stop(std::uint8_t floor, DoorMask doors);
  bool must_stay_open() const;
  bool should_open();
  bool is_obstructed() const { return (doors_.obstructed & settings_.doors) != 0; }
  /// Light barriers and motion detectors see smoke as well as people (EN 81-73, 5.3; EN 81-72).
  bool distrusts_barriers() const {
    return service_ == LiftService::fire_recall || service_ == LiftService::fire_brigade;
  }
  bool is_levelling_in_zone() const;
  bool is_open_wanted();
  Duration dwell_for(CallKinds kinds) const;

  bool is_locked() const { return (settings_.doors & ~doors_.locked) == 0; }
  std::int32_t position_of(std::uint8_t floor) const { return settings_.floors[floor - 1U]; }
  /// The floor at which the car stands; 0: none.
  std::uint8_t floor_here() const;
  std::uint8_t nearest_floor(std::int32_t position) const;
  std::uint8_t reachable_floor() const;
  std::uint8_t nearest_served_floor(std::uint8_t floor) const;
  std::uint8_t next_served_floor(std::uint8_t floor) const;

  Node& node_;
  CallController& calls_;
  LiftParts parts_;
  LiftControllerSettings settings_;
  Callback<void()> changed_;
  Callback<void(const Landing&, DoorMask)> stopped_;
  Service link_;
  Timer timer_;

  MotionStatus motion_;
  DoorsStatus doors_;
  LiftLoad load_;

  LiftPhase phase_ = LiftPhase::idle;
  LiftService service_ = LiftService::normal;
  LiftFault fault_ = LiftFault::none;
  LiftFault latched_ = LiftFault::none;  ///< a fault of the trip, which ends when the car stands
  std::uint8_t floor_ = 1;
  std::uint8_t target_ = 0;
  std::uint8_t departed_ = 0;  ///< the floor that a trip has begun at; 0: none
  Direction direction_ = Direction::none;
  DoorMask open_doors_ = 0;
  std::int8_t by_hand_ = 0;    ///< up, down, or standing
  std::int8_t end_ = 0;        ///< of its travel, reached by the button that is still held
  NextStop promised_{};        ///< while it comes to a stop: where, and where it goes on to
  std::uint8_t tries_ = 0;     ///< of closing
  bool is_errand_ = false;     ///< it goes to its target without a call
  bool is_levelling_ = false;  ///< on its way back to its floor, with open doors
  bool is_cleared_ = false;    ///< in recall or out of order: everybody could get out
  bool is_held_ = false;       ///< the doors have to stay open
  bool nudging_ = false;
  DoorClosing closing_ = DoorClosing::normal;
  bool ignores_button_ = false;  ///< door open was held for too long
  bool late_opening_ = false;
  bool late_closing_ = false;
  bool is_updating_ = false;
  bool again_ = false;
  Duration dwell_{};
  Time dwell_until_{};
  Time opened_at_{};
  Time deadline_ = never;
  Time idle_since_{};
  Time resume_at_{};
  Time level_at_{};
  Time steady_since_{};
  std::int32_t steady_micrometre_ = 0;
  Time started_at_{};
};

}  // namespace canvoy::cia417
