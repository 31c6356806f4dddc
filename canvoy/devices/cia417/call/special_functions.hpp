// The special functions of a lift: turned keys and held buttons, and the acknowledgements that the
// panels have received (CiA 417-4, 4.3.1 and 4.4.1: basic function 0Eh).
//
//     SpecialFunctions specials;
//     specials.take(input);
//     if (specials.is_on(SpecialFunction::fire_service)) ...
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

/// Fans and load times from a button without a locking function go on with one press and off with
/// the next. All others are on while at least one of their inputs requests them: turning one key
/// back does not end a function that another key requests. A function that becomes defective or is
/// not installed is off, except for out of order and fire service, which stay as they are: a broken
/// wire must neither end nor start them.
class SpecialFunctions {
 public:
  static constexpr unsigned count = 0x17;  ///< sub-functions of basic function 0Eh, from 0 on
  /// Maximum number of keys and buttons that are remembered while they are on. Beyond it, the next
  /// end of the function by another input ends it.
  static constexpr unsigned inputs_max = 32;

  /// Takes an input as a panel sends it. False if the sub-function is reserved, or nothing changes.
  bool take(const VirtualInput& input);
  /// Takes an input as read from a panel, which may be unchanged for a long time: it says nothing
  /// for a button with counted presses. False if nothing has changed.
  bool take_reading(const VirtualInput& input);
  /// Switches a function on or off, like a turned key.
  void set(SpecialFunction function, bool on);
  /// Switches all off and forgets what was sent, after a reset.
  void clear();
  /// Sends all that is on, and all that was on before and has ended, since panels have come that
  /// may not have received it.
  void report_again();

  /// True while the function is on.
  bool is_on(SpecialFunction function) const { return at(function).on; }
  /// True if the button is on at each place at which the key is on; where the key is on at one
  /// place alone, the button may be anywhere.
  bool is_on_wherever(SpecialFunction key, SpecialFunction button) const;
  /// Doors at which it is held, for door open and door close.
  DoorMask doors(SpecialFunction function) const {
    return is_on(function) ? source_doors(at(function).doors) : DoorMask{0};
  }

  /// True if an acknowledgement has to be sent.
  bool waits() const;
  /// Returns the next acknowledgement of lift `lifts`, and marks it as sent.
  VirtualOutput next(std::uint8_t lifts);

 private:
  struct Function {
    bool on = false;
    bool told = false;
    bool wants_answer = false;
    bool was_on = false;  ///< at some time: a panel may still show it
    bool is_set = false;  ///< from inside, by counted presses, or by an input without room
    std::uint8_t floor = floor_of_car;
    std::uint8_t doors = 0;
  };
  /// An input that requests its function; function 0: none.
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
