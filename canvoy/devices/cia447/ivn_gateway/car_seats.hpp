// The two front seats (6018h, 6019h; CiA 447-3, 4.2.2.12 and 4.2.2.13): each moves along six ways,
// stores its position in four memories, and returns to a recalled one.
//
//     CarSeats seats(network, {}, {});
//     seats.keep_in(store);                  // what is in the memories, over a loss of power
//     seats.position(1, CarSeats::height);   // of the driver's seat, in steps
//
// A command moves a seat by some steps, since there is no stop command. The status of a seat at
// rest is "signal not available", since there is no other code (errata C1).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

/// The memories of both seats.
struct SeatMemories {
  static constexpr unsigned seats = 2;     ///< driver and front passenger
  static constexpr unsigned memories = 4;  ///< of each seat
  static constexpr unsigned ways = 6;      ///< a seat moves along

  /// A stored position.
  struct Memory {
    bool is_used = false;                       ///< a position was stored
    std::array<std::uint8_t, ways> position{};  ///< in steps

    friend constexpr bool operator==(const Memory&, const Memory&) = default;
  };
  std::array<std::array<Memory, memories>, seats> of_seat{};  ///< driver first

  friend constexpr bool operator==(const SeatMemories&, const SeatMemories&) = default;
};

/// Keeps the memories over a loss of power. Both callbacks are optional.
struct SeatStore {
  Callback<SeatMemories()> load = {};              ///< called once, at the start
  Callback<void(const SeatMemories&)> store = {};  ///< called after each change
};

class CarSeats {
 public:
  /// What a seat moves along.
  enum Way : std::uint8_t { length, height, angle, tight_support, back, headrest };
  static constexpr unsigned ways = SeatMemories::ways;  ///< a seat moves along
  static constexpr int position_max = 100;              ///< at the front, at the top
  static constexpr int steps_of_command = 10;           ///< steps that a command moves a seat
  static constexpr Duration step_time = 50ms;           ///< of a step on the way

  /// Everything to which `hardware` and `settings` refer must outlive this.
  CarSeats(CarNetwork& network, const SwitchedHardware& hardware, const SwitchedSettings& settings);

  /// Loads the memories from `store`, and then stores each change in it. Everything to which
  /// `store` refers must outlive this.
  void keep_in(const SeatStore& store);

  /// For hardware that moves the seats itself: sets a field of 6019h. No effect if there is no such
  /// field.
  void report(const FieldPlace& status, std::uint32_t code);

  /// Position of seat 1 (the driver's) or 2, in steps from 0 to position_max.
  int position(unsigned seat, Way way) const { return seats_[seat - 1].position[way]; }

 private:
  static constexpr unsigned fields = ways + 2;
  using Positions = std::array<std::uint8_t, ways>;
  struct Seat {
    Positions position;
    Positions target;
    SeatMemory recalling = SeatMemory::none;
    SeatMemory recalled = SeatMemory::none;
    SeatMemory stored = SeatMemory::none;
    /// The reported value of each field.
    std::array<std::optional<std::uint32_t>, fields> reported{};
  };

  void reset(ResetScope scope);
  void commanded(const Commanded& wanted);
  void move(Seat& seat, Way way, SeatMotion to);
  void recall(Seat& seat, SeatMemory memory);
  void store(Seat& seat, SeatMemory memory);
  SeatMemories::Memory& memory_of(const Seat& seat, SeatMemory memory);
  void step(Time now);
  void show();

  CarNetwork& network_;
  SwitchedHardware hardware_;
  SeatStore store_;
  std::array<Seat, SeatMemories::seats> seats_{};
  SeatMemories memories_;
  Commands commands_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
