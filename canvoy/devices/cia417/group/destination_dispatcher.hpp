// Assigns passengers who name their destination on the landing to lifts of a group: to the lift
// that brings a passenger there soonest, including the delay of others.
//
//     std::array<DestinationDispatcher::Slot, 200> slots;
//     DestinationDispatcher dispatcher(lifts, slots);
//     const auto answer = dispatcher.add({.source = 1, .target = 17});
//     display(answer.lift);                                  // "lift C"
//     dispatcher.departed(3, {.floor = 1, .direction = Direction::up}, 0b0001);
//
// Passengers for one floor share a car, which therefore stops less often. This makes it better than
// collective control when many passengers travel in the same direction (see Barney and Al-Sharif,
// Elevator Traffic Handbook).
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"
#include "canvoy/devices/cia417/lift/group_lift.hpp"

namespace canvoy::cia417 {

/// A passenger who names a destination on a landing.
struct DestinationCall {
  std::uint8_t source = 0;                         ///< floor, from 1
  std::uint8_t target = 0;                         ///< floor, from 1
  DoorMask source_doors = 1;                       ///< doors at which the passenger waits
  DoorMask target_doors = 0;                       ///< 0: any door of the car there
  CallPriority priority = CallPriority::standard;  ///< of the call
  LiftMask lifts = 0xFF;                           ///< lifts that may answer it
  bool to_floor = false;                           ///< call to a destination floor: 0Bh to 0Dh

  /// Direction of the travel.
  Direction direction() const { return target > source ? Direction::up : Direction::down; }
  friend constexpr bool operator==(const DestinationCall&, const DestinationCall&) = default;
};

/// Weights of the assignment.
struct DestinationSettings {
  /// Weight of the delay of another passenger against the passenger's own time, in percent. With a
  /// higher value, a passenger who comes to a car with open doors is sent to a later one to spare
  /// the passengers in it.
  unsigned courtesy_percent = 50;
  /// Weight of the time by which a car returns later, for each passenger that a lift serves on
  /// average, in percent. It makes stops expensive when many passengers travel.
  unsigned demand_percent = 30;
  /// Share of its persons at which a car counts as full for planning, in percent.
  unsigned load_percent = 80;
};

/// Each add() is one more passenger. A call stays with its lift, as the panel has shown the lift to
/// the passenger, until the car has left with the passenger or the lift leaves service. While all
/// cars are planned to be full, calls wait; passengers for the same floor then get one lift
/// together, in the order of the longest wait. The result depends neither on time nor on chance.
/// Each step visits each slot at most a few times for each lift.
class DestinationDispatcher {
 public:
  /// The passengers from one floor to another in one car. The owner provides the memory.
  struct Slot {
    DestinationCall call{};    ///< the same for all of them
    std::uint8_t lift = 0;     ///< 1 to 8; 0: none yet
    std::uint8_t persons = 0;  ///< 1 to 255
  };
  /// Outcome of add().
  struct Answer {
    DispatchAnswer answer = DispatchAnswer::refused;  ///< whether a lift takes it
    std::uint8_t lift = 0;                            ///< 1 to 8; 0: none
    friend constexpr bool operator==(const Answer&, const Answer&) = default;
  };

  /// `lifts` are lift 1 and up, and are read at each decision. Both must outlive the dispatcher.
  DestinationDispatcher(std::span<const GroupLift> lifts, std::span<Slot> slots,
                        const DestinationSettings& settings = {});

  /// Called when passengers are assigned, by add() or later; lift 0: their lift has left service,
  /// and no lift can take them at present. Passengers with the same call may be assigned to several
  /// lifts.
  void on_assigned(Callback<void(const DestinationCall&, unsigned lift)> assigned) {
    assigned_ = assigned;
  }
  /// Called before passengers are taken from a lift that has left service.
  void on_withdrawn(Callback<void(const DestinationCall&, unsigned lift)> withdrawn) {
    withdrawn_ = withdrawn;
  }
  /// Sets the other plans for the lifts.
  void plan_with(const OtherPlans& others) { others_ = others; }
  /// The plans of this dispatcher, for others.
  OtherPlans plans();

  /// Adds one passenger, and assigns a lift if one has room.
  Answer add(const DestinationCall& call);
  /// A lift leaves a floor in this direction, where it has opened these doors: passengers who
  /// waited for it there are in it, and those who wanted to go there are out. `boarded` is called
  /// for each call.
  void departed(unsigned lift, const Landing& landing, DoorMask doors,
                Callback<void(const DestinationCall&)> boarded = {});
  /// The car call of that floor is done or cancelled.
  void alighted(unsigned lift, std::uint8_t floor);
  /// Discards all passengers, after a reset.
  void remove_all() { count_ = riding_ = 0; }
  /// Call it after lifts have left service or returned.
  void service_changed();
  /// Call it after cars have moved: assigns lifts to waiting passengers.
  void assign_waiting();

  /// Passengers who are not in a car.
  std::span<const Slot> calls() const { return slots_.first(count_); }
  /// Passengers in a car, according to the reported stops; discarded when the memory is needed.
  std::span<const Slot> riders() const { return slots_.last(riding_); }
  /// All of the lift's stops: of passengers in the car, of those assigned to it, and of other
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
