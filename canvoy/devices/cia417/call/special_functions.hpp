// The special functions of a lift: which keys are turned and which buttons are held, and what the
// panels have been told of it (CiA 417-4, 4.3.1 and 4.4.1: basic function 0Eh).
//
//     SpecialFunctions specials;
//     specials.take(input);
//     if (specials.is_on(SpecialFunction::fire_service)) ...
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia417/controller/lift_interfaces.hpp"
#include "canvoy/devices/cia417/panel/virtual_io.hpp"

namespace canvoy::cia417 {

/// Fans and load times that come from a button without a locking function go on with one press and
/// off with the next; all others are on while one of their inputs requests them: who turns his key
/// back ends nothing that another key asks for. A function that becomes defective or is not
/// installed is off, but for out of order and fire service, which stay as they are: a broken wire
/// must neither end them nor begin them.
class SpecialFunctions {
 public:
  static constexpr unsigned count = 0x17;
  /// Keys and buttons that are remembered while they are on. Without room, the next end of the
  /// function by an input that is not among them ends it.
  static constexpr unsigned inputs_max = 32;

  /// As a panel tells it. False where the sub-function is reserved, or nothing is to be done.
  bool take(const VirtualInput& input);
  /// As it was read from a panel, which may not have changed for long: a button whose presses count
  /// says nothing by that. False where nothing has changed.
  bool take_reading(const VirtualInput& input);
  void set(SpecialFunction function, bool on);
  void clear();
  /// Panels have come that may not have heard what is on, and what is not any more.
  void tell_again();

  bool is_on(SpecialFunction function) const { return at(function).on; }
  /// Where it is held: of door open and door close.
  DoorMask doors(SpecialFunction function) const {
    return is_on(function) ? source_doors(at(function).doors) : DoorMask{0};
  }

  bool waits() const;
  /// The next acknowledgement of lift `lifts`, which is told with that.
  VirtualOutput next(std::uint8_t lifts);

 private:
  struct Function {
    bool on = false;
    bool told = false;
    bool wants_answer = false;
    bool was_on = false;  ///< once: a panel may still show it
    bool is_set = false;  ///< from inside, by presses that count, or by an input without room
    std::uint8_t floor = floor_of_car;
    std::uint8_t doors = 0;
  };
  /// An input that requests its function; of function 0: none.
  struct Input {
    std::uint8_t function = 0;
    std::uint8_t floor = 0;
    std::uint8_t doors = 0;
    friend constexpr bool operator==(const Input&, const Input&) = default;
  };

  void request(const Input& input, bool on);
  bool is_requested(std::uint8_t function) const;

  Function& at(SpecialFunction function) { return functions_[static_cast<std::size_t>(function)]; }
  const Function& at(SpecialFunction function) const {
    return functions_[static_cast<std::size_t>(function)];
  }

  std::array<Function, count> functions_{};
  std::array<Input, inputs_max> inputs_{};
};

}  // namespace canvoy::cia417
