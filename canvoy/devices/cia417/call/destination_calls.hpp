// The destination calls of a lift: passengers who name a destination before they get in, or in the
// car, the state of each, and the answers to their panels (CiA 417-4, 4.3.1: basic functions 08h to
// 0Dh).
//
//     std::array<DestinationCalls::Slot, 20> slots;
//     DestinationCalls destinations(slots);
//     if (destinations.add(input)) destinations.tell(input, true, lift_bit(1));
//     while (destinations.waits()) send(destinations.next());
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/call/call_records.hpp"

namespace canvoy::cia417 {

/// Each look-up visits each slot that was used since the reset: none in a lift without destination
/// calls.
class DestinationCalls {
 public:
  /// A passenger with a destination, or a car that is sent to a floor. The owner provides the
  /// memory.
  struct Slot {
    VirtualInput input{};       ///< as the panel sent it
    std::uint8_t lifts = 0;     ///< shown by the panel
    bool active = false;        ///< the car has not yet been at its source floor
    bool told = false;          ///< the panel shows it
    bool wants_answer = false;  ///< next() sends its answer
    bool was_told = false;      ///< a panel may still show it

    /// False if the memory can be used for another call.
    bool is_used() const { return active || told || wants_answer; }
    /// True for a car call: its source is the car.
    bool is_in_car() const { return input.floor == floor_of_car; }
    /// Ends the call. The panel is notified if it shows the call.
    void end() {
      wants_answer = wants_answer || told;
      active = told = false;
    }
  };
  /// Result of tell(): with `kept`, next() sends the answer; `others` is the lift shown to the
  /// passengers of another lift, which stays.
  enum class Answer : std::uint8_t { kept, others, no_room };

  /// Makes an empty list; `slots` must outlive it.
  explicit DestinationCalls(std::span<Slot> slots) : slots_(slots) {}

  /// Discards all calls, after a reset.
  void begin_anew();
  /// Slots in use since the reset, ended calls included.
  std::span<const Slot> used() const { return slots_.first(used_); }

  /// Adds a call that waits at its source floor. False if there is no room.
  bool add(const VirtualInput& input);
  /// Adds a call that does not wait: a car call. False if there is no room.
  bool keep(const VirtualInput& input) { return find_or_make(input) != nullptr; }
  /// Removes a call that another lift takes over. False if it is not known.
  bool withdraw(const VirtualInput& input);
  /// True if a call waits like this at its source floor; all doors of `source` count.
  bool has_source(const Call& source) const;

  /// `on`: the panel of the input has to show `lifts`.
  Answer tell(const VirtualInput& input, bool on, std::uint8_t lifts);
  /// Repeats the answer to the panel. False if the panel shows nothing of the call.
  bool report_again(const VirtualInput& input);
  /// Repeats all answers, for panels that may not have received them: all that is shown, and ended
  /// calls with memory that has not been reused. A call that was requested again is sent as
  /// requested.
  void report_all_again();

  /// Cancels calls of these kinds.
  void cancel(CallKinds kinds);
  /// Ends the calls of kinds `done` that the car answers at `floor`: passengers in the car have
  /// arrived; those who waited there have boarded, and `board` is called with the input of each.
  template <class Board>
  void answered(std::uint8_t floor, CallKinds done, Board board) {
    for (Slot& slot : slots_.first(used_)) {
      const bool has_arrived = slot.is_in_car() && slot.input.sub_function == floor;
      if (has_arrived && (done & car_calls) != 0) slot.end();
      if (!slot.active || slot.input.floor != floor) continue;
      if ((done & kinds_of(source_call_of(slot.input, all_doors).kind)) == 0) continue;
      slot.end();
      board(slot.input);
    }
  }

  /// True if an answer has to be sent.
  bool waits() const;
  /// Returns the next answer, and marks it as sent. Call it only while one is waiting.
  VirtualOutput next();

 private:
  static constexpr DoorMask all_doors = 0x0F;

  Slot* find(const VirtualInput& input);
  Slot* find_or_make(const VirtualInput& input);

  std::span<Slot> slots_;
  std::size_t used_ = 0;  ///< since the reset
};

}  // namespace canvoy::cia417
