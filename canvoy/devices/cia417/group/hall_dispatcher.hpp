// Which lift of a group answers which hall call: the one with the least estimated time to come,
// with what its stop costs those who ride already.
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
#include "canvoy/devices/cia417/group/group_lift.hpp"

namespace canvoy::cia417 {

/// What somebody on a landing asks for.
struct HallCall {
  std::uint8_t floor = 0;
  Direction direction = Direction::none;  ///< none: the button says no direction
  DoorMask doors = 1;
  CallPriority priority = CallPriority::standard;
  LiftMask lifts = 0xFF;  ///< that may answer it

  friend constexpr bool operator==(const HallCall&, const HallCall&) = default;
};

enum class DispatchAnswer : std::uint8_t {
  assigned,  ///< to a lift, now or before
  waits,     ///< for a lift that could, and is out of service
  refused,   ///< no lift of the group ever could
  no_room,
};

struct DispatchSettings {
  /// How much of the delay of others counts: 0 to 100 %.
  unsigned courtesy_percent = 30;
  /// A call goes to another lift only when that is as much sooner.
  Duration gain_min = 15s;
};

/// A call stays with its lift until a stop answers it, the lift leaves service, or reconsider()
/// finds one that is much sooner. It knows nothing of time or chance: the same calls and lifts give
/// the same assignments. Each step looks at each slot once for each lift at most.
class HallDispatcher {
 public:
  /// A call at one door. The owner provides the memory.
  struct Slot {
    HallCall call{};
    std::uint8_t lift = 0;  ///< 1 to 8; 0: none
  };

  /// `lifts` are lift 1 and up, and are looked at whenever something is to be decided. Both must
  /// outlive the dispatcher.
  HallDispatcher(std::span<const GroupLift> lifts, std::span<Slot> slots,
                 const DispatchSettings& settings = {});

  /// Called for each assignment; lift 0: taken from its lift, and nobody else can.
  void on_assigned(Callback<void(const HallCall&, unsigned lift)> assigned) {
    assigned_ = assigned;
  }

  /// What else is planned for the lifts.
  void plan_with(const OtherPlans& others) { others_ = others; }
  /// The same for others.
  OtherPlans plans() {
    return {.add_stops = Callback<void(unsigned, Route&)>::to<&HallDispatcher::add_stops>(*this),
            .delayed =
                Callback<unsigned(unsigned, const Landing&)>::to<&HallDispatcher::delayed>(*this),
            .is_full = {}};
  }

  /// A call with several doors is one at each of them; the worst answer is given.
  DispatchAnswer add(const HallCall& call);
  /// A lift opened these doors there, and leaves in this direction (none: it says nothing): the
  /// calls that it answers by that are done, whosesoever they were.
  void answered(unsigned lift, const Landing& landing, DoorMask doors);
  /// The call is taken back.
  void remove(const HallCall& call);
  void remove_all() { count_ = 0; }

  /// After lifts left service or came back.
  void service_changed();
  /// Now and then: gives calls to lifts that have become much sooner.
  void reconsider();

  std::span<const Slot> calls() const { return slots_.first(count_); }
  /// All of the lift's stops: of those in the car, of the calls that are assigned to it, and of
  /// other plans.
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
