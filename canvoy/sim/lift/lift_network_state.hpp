// What a LiftNetwork is made of. For its own sources.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/lift/crowd.hpp"
#include "canvoy/sim/lift/fault_referee.hpp"
#include "canvoy/sim/lift/fire_brigade.hpp"
#include "canvoy/sim/lift/lift_group.hpp"
#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/lift_shaft.hpp"
#include "canvoy/sim/lift/referee.hpp"

namespace canvoy::lift {

/// What needs no better time is looked at so often.
inline constexpr Duration look_period = 1s;

struct LiftNetwork::State {
  explicit State(LiftNetworkDescription wanted);

  // lift_network.cpp: putting it together, and time
  void add_buses();
  void add_shafts();
  void add_group();
  void add_configurations();
  /// Null where it is not simulated here.
  Node* node_of(const NodeDescription& node);
  std::vector<NodeSnapshot> look_at_nodes();
  void add_crowd();
  void add_brigades();
  PassengerHands hands();
  void run_crowd(Time now);
  void wake_crowd();

  // lift_network_people.cpp: between people, lamps and cars
  void press(const CallKey& call, bool pressed, FloorNumber to = no_floor);
  LiftNumber next_panel(const CallKey& call, FloorNumber to);
  void shaft_changed(LiftNumber lift);
  void note_car(LiftNumber lift, const LiftFacts& facts);
  void lamp_changed(LiftNumber lift, const CallKey& call, bool lit);
  CallEnd end_of(const CallKey& call) const;
  bool was_opened_for(const CallKey& call) const;
  bool is_car_at(LiftNumber lift, FloorNumber floor) const;
  void look(Time now);
  void look_for_brigades(Time now);
  void assigned(LiftNumber panel, const DestinationButton& button, LiftNumber lift);

  // lift_network_faults.cpp
  void plan_faults();
  void set_fault(std::size_t fault, bool present);
  void make_fault(ScheduledFault fault, bool present);
  bool is_there(const ScheduledFault& fault) const;
  bool is_silenced(const ScheduledFault& fault) const;
  bool is_behind(NodeId node, const ScheduledFault& cut) const;
  void expect(std::size_t fault);
  void set_group_fault(const ScheduledFault& fault, bool present);
  std::optional<SlotIndex> group_slot(NodeId node) const;
  enum class Loss : std::uint8_t { none, bearable, needed };
  Loss loss_of(const ScheduledFault& fault) const;
  bool has_no_current(const ScheduledFault& fault) const;
  Duration serves_most(LiftNumber lift) const;
  FaultExpectation expectation_of(const ScheduledFault& fault) const;
  void expect_of_motion(FaultExpectation& expected, const ScheduledFault& fault) const;
  FaultPlace place_of(const ScheduledFault& fault) const;
  FaultExpectation group_expectation_of(const ScheduledFault& fault) const;
  bool serves_as_group() const;
  bool is_wanted(LiftNumber lift) const;
  void look_at_people(Time now, bool hindered);
  void gave_up(Time since);
  void heard(Time now, const BusEvent& event);
  LiftNumber lift_of(std::size_t bus) const;
  /// 0: the group.
  bool is_hindered(LiftNumber lift) const;
  bool is_faulty(LiftNumber lift) const { return fault_referee.is_faulty(world.now(), lift); }
  bool is_anything_hindered() const;
  void note(Time at, const Invariant& broken);

  LiftShaft& shaft(LiftNumber lift) { return *shafts[lift - std::size_t{1}]; }
  const LiftShaft& shaft(LiftNumber lift) const { return *shafts[lift - std::size_t{1}]; }

  /// What a car did when it was looked at last.
  struct CarNote {
    bool moves = false;
    bool is_open = false;
    double position_m = 0;
    std::uint32_t starts = 0;
  };

  struct Configuration {
    const NodeDescription* node = nullptr;
    std::unique_ptr<NodeConfiguration> values{};
  };

  LiftNetworkDescription description;
  World world;
  std::vector<BusIndex> buses;
  std::vector<std::unique_ptr<BusWatch>> watches;
  std::vector<std::unique_ptr<LiftShaft>> shafts;
  std::unique_ptr<LiftGroup> group;  ///< where there is one
  std::vector<Configuration> configurations;
  std::unique_ptr<Crowd> crowd;
  PlantIndex crowd_plant = 0;
  std::vector<std::unique_ptr<FireBrigade>> brigades;  ///< one for each lift
  Referee referee;
  FaultReferee fault_referee;
  std::vector<std::size_t> present_faults;  ///< their places in the plan
  std::vector<LiftEvent> events;
  std::vector<CarNote> cars;
  /// Lifts on whose panels a lamp is lit, bit 0 is lift 1.
  std::map<CallKey, unsigned> lit;
  std::map<CallKey, Time> lit_since;
  /// Each lift at each floor, the last time.
  std::vector<std::vector<Time>> opened_at;
  /// On which lift's panel a landing button was pressed, so that it is let go there.
  std::map<CallKey, LiftNumber> pressed_on;
  unsigned presses = 0;
  Time not_crowded_last{};  ///< or hindered
  bool is_saturated = false;
  double formula_interval_s(double persons) const;
  Time hindered_last{};  ///< by a fault, or what is left of one
};

}  // namespace canvoy::lift
