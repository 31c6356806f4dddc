// All judgements in a building: the referees receive what cars, lamps, people and nodes do, and
// what excuses each of them.
//
//     LiftReferees referees(description, devices, events);
//     referees.car_changed(now, 1, persons);
//     if (referees.lamp_changed(now, 1, call, true) == CallLamps::Change::lit) ...
//     referees.look(now, people, referees.is_anything_hindered(now));   // each look_period
//     for (const Invariant& invariant : referees.invariants(now)) ok = ok && invariant.held;
#pragma once

#include <utility>
#include <vector>

#include "canvoy/worlds/lift/call_lamps.hpp"
#include "canvoy/worlds/lift/car_watch.hpp"
#include "canvoy/worlds/lift/crowd_watch.hpp"
#include "canvoy/worlds/lift/fault_referee.hpp"
#include "canvoy/worlds/lift/lift_devices.hpp"
#include "canvoy/worlds/lift/lift_people.hpp"
#include "canvoy/worlds/lift/referee.hpp"
#include "canvoy/worlds/lift/service_watch.hpp"

namespace canvoy::lift {

class LiftReferees {
 public:
  /// Period of look(), for all that needs no better time.
  static constexpr Duration look_period = 1s;

  /// All must outlive this object; changes are noted in `events`.
  LiftReferees(const LiftNetworkDescription& description, const LiftDevices& devices,
               std::vector<LiftEvent>& events);
  LiftReferees(const LiftReferees&) = delete;
  LiftReferees& operator=(const LiftReferees&) = delete;

  /// The state of a car has changed; `persons` is the number of people in it.
  void car_changed(Time now, LiftNumber lift, unsigned persons);
  /// Takes a change on the panel of this lift, and returns the change for people.
  CallLamps::Change lamp_changed(Time now, LiftNumber lift, const CallKey& call, bool is_lit);
  /// Takes the display of a destination terminal, which is its acknowledgement.
  void assigned(Time now, LiftNumber panel, const DestinationButton& button, LiftNumber lift);
  /// A person presses a button.
  void pressed(Time now, const CallKey& call);
  /// A passenger has reached the destination.
  void carried(Time now, LiftNumber lift);
  /// A person who has waited since `since` takes the stairs.
  void gave_up(Time now, Time since);
  /// An emergency was heard on a bus.
  void emergency_seen(Time now, const EmergencySeen& told);
  /// Judges how long people wait; `is_hindered` is is_anything_hindered() of just before.
  void look(Time now, const LiftPeople& people, bool is_hindered);
  /// Takes the lifts of which a rule was found broken since the last call.
  std::vector<LiftNumber> take_complaints() { return std::exchange(complaints_, {}); }
  /// Notes that a technician works at the lift, which then serves no passenger, or has left it.
  void set_technician(Time now, LiftNumber lift, bool is_there) {
    has_technician_[lift - std::size_t{1}] = is_there;
    if (!is_there) fault_referee_.handed_back(now, lift);
  }
  /// True if the lift is hindered by a fault, or its effects, or a technician is there.
  bool is_out_of_use(Time now, LiftNumber lift) const;
  /// True if a lift, or the group, is hindered by a fault, or its effects.
  bool is_anything_hindered(Time now) const;

  /// Referee of the faults.
  FaultReferee& faults() { return fault_referee_; }
  /// Lamps as people see them.
  const CallLamps& lamps() const { return lamps_; }
  /// Starts, stops and opened doors of the cars.
  const CarWatch& cars() const { return cars_; }
  /// See CrowdWatch::is_saturated().
  bool is_saturated() const { return crowd_.is_saturated(); }
  /// Verdicts of all referees.
  std::vector<Invariant> invariants(Time now) const;

 private:
  LiftFacts facts(Time now, LiftNumber lift) const { return devices_->shaft(lift).facts(now); }
  /// True if its real position unit reports another position of the car, or has done so just
  /// before: the reaction of its controller is then due to that unit.
  bool is_misled(Time now, LiftNumber lift, const LiftFacts& facts);
  CallEnd end_of(Time now, const CallKey& call) const;
  bool was_opened_for(const CallKey& call) const;
  bool is_at(Time now, LiftNumber lift, FloorNumber floor) const;
  bool is_hindered(Time now, LiftNumber lift) const;
  void look_at_service(Time now, const Crowd& crowd);
  void look_at_brigades(Time now, const LiftPeople& people);

  const LiftNetworkDescription* description_;
  const LiftDevices* devices_;
  std::vector<LiftEvent>* events_;
  Referee referee_;
  FaultReferee fault_referee_;
  CallLamps lamps_;
  CarWatch cars_;
  CrowdWatch crowd_;
  ServiceWatch service_;
  std::vector<Time> misled_until_;
  std::vector<bool> has_technician_;
  std::vector<Time> brigade_excused_at_;
  std::vector<LiftNumber> complaints_;
};

}  // namespace canvoy::lift
