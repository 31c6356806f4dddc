// The destination calls of a lift: who names his destination before he gets in, or in the car, what
// became of him, and what his panel was told of it (CiA 417-4, 4.3.1: basic functions 08h to 0Dh).
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

/// Each question looks at each slot that was used since the reset once: at none, where nobody says
/// where he wants to go.
class DestinationCalls {
 public:
  /// A passenger who said where he wants to go, or a car that is sent somewhere. The owner provides
  /// the memory.
  struct Slot {
    VirtualInput input{};
    std::uint8_t lifts = 0;  ///< that the panel shows
    bool active = false;     ///< the car has not been at its source floor yet
    bool told = false;       ///< the panel shows it
    bool wants_answer = false;
    bool was_told = false;  ///< a panel may still show it

    bool is_used() const { return active || told || wants_answer; }
    bool is_in_car() const { return input.floor == floor_of_car; }
    /// It waits no longer, which the panel is told where it shows it.
    void end() {
      wants_answer = wants_answer || told;
      active = told = false;
    }
  };
  /// What became of an answer: `kept` is told by next(), `others` is what the passengers of another
  /// lift are shown, which stays.
  enum class Answer : std::uint8_t { kept, others, no_room };

  explicit DestinationCalls(std::span<Slot> slots) : slots_(slots) {}

  void begin_anew();
  std::span<const Slot> used() const { return slots_.first(used_); }

  /// Waits at its source floor. False: there is no room.
  bool add(const VirtualInput& input);
  /// Knows it, without waiting: a car call. False: there is no room.
  bool keep(const VirtualInput& input) { return find_or_make(input) != nullptr; }
  /// It waits for another lift. False: it is not known.
  bool withdraw(const VirtualInput& input);
  /// One of them waits that way at its source floor; of `source` all doors.
  bool has_source(const Call& source) const;

  /// `on`: the panel of the input is to show `lifts`.
  Answer tell(const VirtualInput& input, bool on, std::uint8_t lifts);
  /// What the panel shows is to be told again. False: it shows nothing of it.
  bool tell_again(const VirtualInput& input);
  /// Panels have come that may not have heard it: all that is shown, and what has ended and whose
  /// memory is not in use again. One that was asked for again since is shown as that.
  void tell_all_again();

  /// Calls of these kinds are taken back.
  void cancel(CallKinds kinds);
  /// The car stands at `floor`, and `done` are the kinds of calls that it answers there: who is in
  /// the car has arrived; who waited there has boarded, and `board` is called with his input.
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

  bool waits() const;
  /// The next answer, which is told with that; asked only while one waits.
  VirtualOutput next();

 private:
  static constexpr DoorMask all_doors = 0x0F;

  Slot* find(const VirtualInput& input);
  Slot* find_or_make(const VirtualInput& input);

  std::span<Slot> slots_;
  std::size_t used_ = 0;  ///< since the reset
};

}  // namespace canvoy::cia417
