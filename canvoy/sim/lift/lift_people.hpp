// The people of a building before its devices: passengers and fire brigades press, turn, step in
// the way and weigh, and see what cars and lamps show. A landing has panels of all lifts: who
// presses there takes the one or the other, and lets go of the same.
//
//     LiftPeople people(world, description, devices, {.pressed = ..., .carried = ..., .gave_up =
//     ...}); people.car_changed(1); people.lamp_changed(call, true);
//     people.crowd().waiting_count();
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "canvoy/sim/lift/crowd.hpp"
#include "canvoy/sim/lift/fire_brigade.hpp"
#include "canvoy/sim/lift/lift_devices.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

/// Whom they tell. All have to be there.
struct LiftPeopleHooks {
  /// A button of a call that is there, and has power.
  std::function<void(const CallKey&)> pressed{};
  /// Somebody has got to where he wanted.
  std::function<void(LiftNumber)> carried{};
  /// Somebody takes the stairs who has waited since then.
  std::function<void(Time since)> gave_up{};
};

class LiftPeople {
 public:
  /// `world`, `description` and `devices` must outlive this.
  LiftPeople(World& world, const LiftNetworkDescription& description, LiftDevices& devices,
             LiftPeopleHooks hooks);
  LiftPeople(const LiftPeople&) = delete;
  LiftPeople& operator=(const LiftPeople&) = delete;

  /// Somebody comes now, beside those of the traffic. False: no lift goes from there to there.
  bool visit(FloorNumber from, FloorNumber to);

  void car_changed(LiftNumber lift);
  void lamp_changed(const CallKey& call, bool is_lit);
  /// What the terminal of a landing that stands at lift `panel` shows for a destination: a lift to
  /// take; 0: wait. People look at the one where they asked.
  void assigned(LiftNumber panel, const DestinationButton& button, LiftNumber lift);

  /// The fire brigade comes to this lift, or has gone.
  void call_brigade(LiftNumber lift, bool is_there);
  /// Each that is there looks at its car: from time to time, a second say.
  void look_for_brigades();

  const Crowd& crowd() const { return crowd_; }
  /// Somebody rides in it, or waits where it should come. The lifts of a group (0) share who waits.
  bool is_wanted(LiftNumber lift) const;

 private:
  PassengerHands hands();
  void add_brigades();
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
  /// On which lift's panel a button of a landing was pressed the last time.
  std::map<CallKey, LiftNumber> pressed_on_;
  unsigned presses_ = 0;
};

}  // namespace canvoy::lift
