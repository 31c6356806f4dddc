// The people of a building before its devices: passengers and fire brigades press, turn, step in
// the way and load cars, and see what cars and lamps show. A landing has panels of all lifts:
// people press a button on any of them, and release the same one.
//
//     LiftPeople people(world, description, devices,
//                       {.pressed = ..., .carried = ..., .gave_up = ...});
//     people.car_changed(1);
//     people.lamp_changed(call, true);
//     people.crowd().waiting_count();
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/crowd.hpp"
#include "canvoy/worlds/lift/fire_brigade.hpp"
#include "canvoy/worlds/lift/lift_devices.hpp"
#include "canvoy/worlds/lift/technician.hpp"

namespace canvoy::lift {

/// The technician of each lift of a building, who is called when a safety chain must be closed by
/// hand, by people who are shut in and press the alarm button (EN 81-28), where a controller
/// reports that its lift stays out of order, and where a referee finds that people have reason to
/// complain.
///
///     LiftTechnicians technicians(world, description, devices, crowd, told);
///     technicians.tripped(1);
///     technicians.look();        // each second
class LiftTechnicians {
 public:
  /// Called for each step; no_floor where the technician is at none.
  using Told = std::function<void(LiftNumber, TechnicianStep, FloorNumber)>;

  /// All must outlive this object. No technician comes where the description has none.
  LiftTechnicians(World& world, const LiftNetworkDescription& description, LiftDevices& devices,
                  const Crowd& crowd, Told told);
  LiftTechnicians(const LiftTechnicians&) = delete;
  LiftTechnicians& operator=(const LiftTechnicians&) = delete;

  /// Call it when the safety chain of this lift must be closed by hand.
  void tripped(LiftNumber lift);
  /// Call it when people complain of this lift.
  void complain(LiftNumber lift);
  /// Has each technician look at the lift, each second.
  void look();
  /// True if the technician is called, or at work.
  bool is_called(LiftNumber lift) const {
    return !technicians_.empty() && at(lift).technician->is_called();
  }

 private:
  struct Place {
    std::unique_ptr<Technician> technician;
    Time shut_in_since = never;  ///< people, behind shut doors
    Time out_since = never;      ///< out of order
  };

  TechnicianHands hands(LiftNumber lift);
  TechnicianView view(LiftNumber lift) const;
  void look_at(LiftNumber lift);
  void step(Time now);
  Place& at(LiftNumber lift) { return technicians_[lift - std::size_t{1}]; }
  const Place& at(LiftNumber lift) const { return technicians_[lift - std::size_t{1}]; }

  World* world_;
  const LiftNetworkDescription* description_;
  LiftDevices* devices_;
  const Crowd* crowd_;
  Told told_;
  PlantIndex plant_;
  std::vector<Place> technicians_;
};

/// Functions that receive reports. None may be empty.
struct LiftPeopleHooks {
  /// A button of an existing call, with power, is pressed; or there is none for the call.
  std::function<void(const CallKey&)> pressed{};
  /// A passenger has reached the destination.
  std::function<void(LiftNumber)> carried{};
  /// A person who has waited since `since` takes the stairs.
  std::function<void(Time since)> gave_up{};
  /// A step of a technician.
  LiftTechnicians::Told technician{};
};

class LiftPeople {
 public:
  /// `world`, `description` and `devices` must outlive this object.
  LiftPeople(World& world, const LiftNetworkDescription& description, LiftDevices& devices,
             LiftPeopleHooks hooks);
  LiftPeople(const LiftPeople&) = delete;
  LiftPeople& operator=(const LiftPeople&) = delete;

  /// Adds a person at the present time, beside those of the traffic. False: no lift connects these
  /// floors.
  bool visit(FloorNumber from, FloorNumber to);

  /// People look at the car: call it whenever its shaft reports a change.
  void car_changed(LiftNumber lift);
  /// People see the lamp of a button: call it at changes of CallLamps.
  void lamp_changed(const CallKey& call, bool is_lit);
  /// Answer of the terminal of a landing, beside lift `panel`, for a destination: a lift to take;
  /// 0: wait. People look at the terminal where they made their request.
  void assigned(LiftNumber panel, const DestinationButton& button, LiftNumber lift);

  /// The fire brigade comes to this lift, or leaves it.
  void call_brigade(LiftNumber lift, bool is_there);
  /// Has each present brigade look at its car: from time to time, for example each second.
  void look_for_brigades();

  /// Time for which the brigade in this car has waited to be at a floor.
  Duration brigade_waits(LiftNumber lift) const {
    return brigades_[lift - std::size_t{1}]->waits(world_->now());
  }
  /// Number of times that a brigade gave its keys back at the fire floor.
  unsigned brigade_returns(LiftNumber lift) const {
    return brigades_[lift - std::size_t{1}]->returns();
  }

  /// Calls a technician: the safety chain of this lift must be closed by hand.
  void call_technician(LiftNumber lift) { technicians_.tripped(lift); }
  /// Calls a technician: people complain of this lift.
  void complain(LiftNumber lift) { technicians_.complain(lift); }
  /// Has each technician look at the lift: each second.
  void look_for_technicians() { technicians_.look(); }

  /// Passengers, and where they are.
  const Crowd& crowd() const { return crowd_; }
  /// True if a person rides in the lift, or waits where it should come, and neither a technician
  /// nor the fire brigade has it. The lifts of a group (0) share the waiting people.
  bool is_wanted(LiftNumber lift) const;

 private:
  PassengerHands hands();
  void add_brigades();
  bool has_button(const CallKey& call) const;
  void press(const CallKey& call, bool pressed, FloorNumber to = no_floor);
  LiftNumber next_panel(const CallKey& call, FloorNumber to);
  void run(Time now);
  void wake();

  World* world_;
  const LiftNetworkDescription* description_;
  LiftDevices* devices_;
  LiftPeopleHooks hooks_;
  Crowd crowd_;
  PlantIndex plant_;
  std::vector<std::unique_ptr<FireBrigade>> brigades_;  ///< one for each lift
  LiftTechnicians technicians_;
  /// For each button of a landing, the lift with the panel on which it was last pressed.
  std::map<CallKey, LiftNumber> pressed_on_;
  unsigned presses_ = 0;
};

}  // namespace canvoy::lift
