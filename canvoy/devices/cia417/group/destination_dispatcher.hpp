// Which lift of a group takes a passenger who says on the landing where he wants to go: the one
// that brings him there soonest, with what that costs the others.
//
//     std::array<DestinationDispatcher::Slot, 200> slots;
//     DestinationDispatcher dispatcher(lifts, slots);
//     const auto answer = dispatcher.add({.source = 1, .target = 17});
//     display(answer.lift);                                  // "lift C"
//     dispatcher.departed(3, {.floor = 1, .direction = Direction::up}, 0b0001);
//
// Passengers for one floor come together in one car, which therefore stops less often: that is what
// makes it better than collective control while many want the same way (see Barney and Al-Sharif,
// Elevator Traffic Handbook).
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/devices/cia417/group/group_lift.hpp"
#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"

namespace canvoy::cia417 {

struct DestinationCall {
  std::uint8_t source = 0;
  std::uint8_t target = 0;
  DoorMask source_doors = 1;
  DoorMask target_doors = 0;  ///< 0: whichever the car has there
  CallPriority priority = CallPriority::standard;
  LiftMask lifts = 0xFF;  ///< that may answer it
  bool to_floor = false;  ///< made as a call to a destination floor: 0Bh to 0Dh

  Direction direction() const { return target > source ? Direction::up : Direction::down; }
  friend constexpr bool operator==(const DestinationCall&, const DestinationCall&) = default;
};

struct DestinationSettings {
  /// How much the delay of another passenger counts beside one's own time: percent. With more, who
  /// comes to a car that stands open is sent to a later one for the sake of those who are in it.
  unsigned courtesy_percent = 50;
  /// How much the time counts by which a car comes back later, for each of those who are served by
  /// a lift on the average: percent. It is what makes stops dear when many want to travel.
  unsigned demand_percent = 30;
  /// A car counts as full for planning with as much of its persons: percent.
  unsigned load_percent = 80;
};

/// Each add() is a passenger more. A call stays with its lift, since it was shown to him, until the
/// car left with him or the lift leaves service. While all cars are full as they are planned, calls
/// wait; who wants to the same floor then gets one lift, in the order of who waits longest. Knows
/// nothing of time or chance. Each step looks at each slot a few times for each lift at most.
class DestinationDispatcher {
 public:
  /// The passengers from one floor to another in one car. The owner provides the memory.
  struct Slot {
    DestinationCall call{};
    std::uint8_t lift = 0;  ///< 1 to 8; 0: none yet
    std::uint8_t persons = 0;
  };
  struct Answer {
    DispatchAnswer answer = DispatchAnswer::refused;
    std::uint8_t lift = 0;
    friend constexpr bool operator==(const Answer&, const Answer&) = default;
  };

  /// `lifts` are lift 1 and up, and are looked at whenever something is to be decided. Both must
  /// outlive the dispatcher.
  DestinationDispatcher(std::span<const GroupLift> lifts, std::span<Slot> slots,
                        const DestinationSettings& settings = {});

  /// Called where passengers are assigned, by add() or later; lift 0: their lift has left service,
  /// and nobody can take them now. Passengers with the same call may be with several lifts.
  void on_assigned(Callback<void(const DestinationCall&, unsigned lift)> assigned) {
    assigned_ = assigned;
  }
  /// Called before, where passengers are taken from a lift that has left service.
  void on_withdrawn(Callback<void(const DestinationCall&, unsigned lift)> withdrawn) {
    withdrawn_ = withdrawn;
  }
  /// What else is planned for the lifts.
  void plan_with(const OtherPlans& others) { others_ = others; }
  /// The same for others.
  OtherPlans plans();

  Answer add(const DestinationCall& call);
  /// A lift leaves a floor in this direction, where it has opened these doors: those who waited
  /// there for it are in it, and those who wanted there are out. `boarded` is called for each call.
  void departed(unsigned lift, const Landing& landing, DoorMask doors,
                Callback<void(const DestinationCall&)> boarded = {});
  /// The car call of that floor is done, or taken back.
  void alighted(unsigned lift, std::uint8_t floor);
  void remove_all() { count_ = riding_ = 0; }
  /// After lifts left service or came back.
  void service_changed();
  /// After cars have moved on: gives lifts to those who wait for one.
  void assign_waiting();

  /// Those who are not in a car.
  std::span<const Slot> calls() const { return slots_.first(count_); }
  /// Those who are, by what was told of stops; forgotten when the memory is needed.
  std::span<const Slot> riders() const { return slots_.last(riding_); }
  /// All of the lift's stops: of those in the car, of those who are assigned to it, and of other
  /// plans.
  Route route(unsigned lift) const;

 private:
  bool could_ever(const DestinationCall& call, unsigned lift) const;
  bool can(const DestinationCall& call, unsigned lift) const;
  void add_stops(unsigned lift, Route& route) const;
  unsigned delayed(unsigned lift, const Landing& landing) const;
  unsigned riding_past(unsigned lift, const Landing& landing) const;
  bool is_full(unsigned lift, const Landing& landing) const;
  unsigned capacity(unsigned lift) const;
  unsigned load_at(unsigned lift, const Landing& landing, const Landing& start) const;
  bool fits(const DestinationCall& call, unsigned persons, unsigned lift) const;
  Duration cost(const DestinationCall& call, unsigned lift) const;
  Duration delay_of_others(const DestinationCall& call, unsigned lift, const Route& route) const;
  Duration delay_of_next(const Route& before, const Route& with, unsigned lift) const;
  unsigned best(const DestinationCall& call, unsigned persons) const;
  bool waits_already(const DestinationCall& call) const;
  bool put(const Slot& added);
  void ride(const Slot& boarded);
  void erase(std::size_t position);
  void erase_rider(std::size_t position);

  std::span<const GroupLift> lifts_;
  std::span<Slot> slots_;
  DestinationSettings settings_;
  std::size_t count_ = 0;   ///< at the front
  std::size_t riding_ = 0;  ///< at the back
  Callback<void(const DestinationCall&, unsigned)> assigned_;
  Callback<void(const DestinationCall&, unsigned)> withdrawn_;
  OtherPlans others_;
};

}  // namespace canvoy::cia417
