// Assigns hall calls to lifts of a group: to the lift with the least estimated time to arrive,
// including the delay of the passengers in it.
//
//     std::array<HallDispatcher::Slot, 64> slots;
//     HallDispatcher dispatcher(lifts, slots);
//     dispatcher.on_assigned(Callback<void(const HallCall&, unsigned)>::to<&Group::tell>(group));
//     dispatcher.add({.floor = 5, .direction = Direction::up});
//     dispatcher.answered(2, {.floor = 5, .direction = Direction::up}, 0b1111);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/devices/cia417/lift/group_lift.hpp"

namespace canvoy::cia417 {

/// The request of a passenger on a landing.
struct HallCall {
  std::uint8_t floor = 0;                          ///< from 1
  Direction direction = Direction::none;           ///< none: the button gives no direction
  DoorMask doors = 1;                              ///< at which the passenger waits
  CallPriority priority = CallPriority::standard;  ///< of the call
  LiftMask lifts = 0xFF;                           ///< lifts that may answer it

  friend constexpr bool operator==(const HallCall&, const HallCall&) = default;
};

/// Outcome of a call.
enum class DispatchAnswer : std::uint8_t {
  assigned,  ///< to a lift, at present or before
  waits,     ///< for a lift that could answer it, and is out of service
  refused,   ///< no lift of the group could ever answer it
  no_room,
};

/// Weights of the assignment.
struct DispatchSettings {
  /// Weight of the delay of others: 0 to 100 %.
  unsigned courtesy_percent = 30;
  /// A call changes its lift only if another one is sooner by this time.
  Duration gain_min = 15s;
};

/// A call stays with its lift until a stop answers it, the lift leaves service, or reconsider()
/// finds a lift that is much sooner. The result depends neither on time nor on chance: the same
/// calls and lifts give the same assignments. Each step visits each slot at most once for each
/// lift.
class HallDispatcher {
 public:
  /// A call at one door. The owner provides the memory.
  struct Slot {
    HallCall call{};        ///< with one door
    std::uint8_t lift = 0;  ///< 1 to 8; 0: none
  };

  /// `lifts` are lift 1 and up, and are read at each decision. Both must outlive the dispatcher.
  HallDispatcher(std::span<const GroupLift> lifts, std::span<Slot> slots,
                 const DispatchSettings& settings = {});

  /// Called for each assignment; lift 0: taken from its lift, and no other can answer it.
  void on_assigned(Callback<void(const HallCall&, unsigned lift)> assigned) {
    assigned_ = assigned;
  }

  /// Sets the other plans for the lifts.
  void plan_with(const OtherPlans& others) { others_ = others; }
  /// The plans of this dispatcher, for others.
  OtherPlans plans() {
    return {.add_stops = callback<&HallDispatcher::add_stops>(*this),
            .delayed = callback<&HallDispatcher::delayed>(*this),
            .is_full = {}};
  }

  /// Adds a call. A call with several doors is one at each of them; the worst answer is returned.
  DispatchAnswer add(const HallCall& call);
  /// A lift opened these doors there, and leaves in this direction (none: not known): the calls
  /// that it answers by that are done, even if they were assigned to another lift.
  void answered(unsigned lift, const Landing& landing, DoorMask doors);
  /// Cancels the call.
  void remove(const HallCall& call);
  /// Discards all calls, after a reset.
  void remove_all() { count_ = 0; }

  /// Call it after lifts have left service or returned.
  void service_changed();
  /// Call it from time to time: assigns calls to lifts that have become much sooner.
  void reconsider();

  /// Calls that wait, with their lifts.
  std::span<const Slot> calls() const { return slots_.first(count_); }
  /// All of the lift's stops: of passengers in the car, of the calls assigned to it, and of other
  /// plans.
  Route route(unsigned lift) const;

 private:
  DispatchAnswer add_at_door(const HallCall& call);
  bool could_ever(const HallCall& call, unsigned lift) const;
  bool can(const HallCall& call, unsigned lift) const;
  Duration cost(const HallCall& call, unsigned lift) const;
  void add_stops(unsigned lift, Route& route) const;
  void add_stops_without(unsigned lift, const HallCall* excepted, Route& route) const;
  unsigned delayed(unsigned lift, const Landing& landing) const;
  Route route_without(unsigned lift, const HallCall* excepted) const;
  unsigned best(const HallCall& call) const;
  void assign(Slot& slot, unsigned lift);
  void erase(std::size_t position);

  std::span<const GroupLift> lifts_;
  std::span<Slot> slots_;
  DispatchSettings settings_;
  std::size_t count_ = 0;
  Callback<void(const HallCall&, unsigned)> assigned_;
  OtherPlans others_;
};

}  // namespace canvoy::cia417
