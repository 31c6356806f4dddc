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
#include "canvoy/devices/cia417/group_lift.hpp"
#include "canvoy/devices/cia417/hall_dispatcher.hpp"

namespace canvoy::cia417 {

struct DestinationCall {
  std::uint8_t source = 0;
  std::uint8_t target = 0;
  DoorMask source_doors = 1;
  DoorMask target_doors = 0;  ///< 0: whichever the car has there
  CallPriority priority = CallPriority::standard;
  LiftMask lifts = 0xFF;  ///< that may answer it

  Direction direction() const { return target > source ? Direction::up : Direction::down; }
  friend constexpr bool operator==(const DestinationCall&, const DestinationCall&) = default;
};

struct DestinationSettings {
  /// How much the delay of another passenger counts beside one's own time: percent.
  unsigned courtesy_percent = 100;
  /// A car counts as full for planning with as much of its persons: percent.
  unsigned load_percent = 80;
};

/// Each add() is a passenger more. A call stays with its lift, since it was shown to him, until the
/// car left with him or the lift leaves service. Knows nothing of time or chance.
class DestinationDispatcher {
 public:
  /// The passengers from one floor to another in one car. The owner provides the memory.
  struct Slot {
    DestinationCall call{};
    std::uint8_t lift = 0;  ///< 1 to 8; 0: none
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

  /// Called where passengers are assigned, by add() or because their lift left service; lift 0:
  /// nobody can take them now.
  void on_assigned(Callback<void(const DestinationCall&, unsigned lift)> assigned) {
    assigned_ = assigned;
  }

  Answer add(const DestinationCall& call);
  /// A lift left a floor in this direction, where it had opened these doors: those who waited there
  /// for it are in it. `boarded` is called for each call.
  void departed(unsigned lift, const Landing& landing, DoorMask doors,
                Callback<void(const DestinationCall&)> boarded = {});
  void remove_all() { count_ = 0; }
  /// After lifts left service or came back.
  void service_changed();

  std::span<const Slot> calls() const { return slots_.first(count_); }
  /// The lift's stops, with the passengers who are assigned to it.
  Route route(unsigned lift) const;

 private:
  bool could_ever(const DestinationCall& call, unsigned lift) const;
  bool can(const DestinationCall& call, unsigned lift) const;
  Duration cost(const DestinationCall& call, unsigned lift) const;
  Duration delay_of_others(const DestinationCall& call, unsigned lift, const Route& route) const;
  unsigned waiting(const DestinationCall& call, unsigned lift) const;
  unsigned best(const DestinationCall& call) const;
  bool put(const DestinationCall& call, unsigned lift, unsigned persons);
  void erase(std::size_t position);

  std::span<const GroupLift> lifts_;
  std::span<Slot> slots_;
  DestinationSettings settings_;
  std::size_t count_ = 0;
  Callback<void(const DestinationCall&, unsigned)> assigned_;
};

}  // namespace canvoy::cia417
