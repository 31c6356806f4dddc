// Joysticks of which each axis has two sensors: both are compared, and a position on which they do
// not agree is none. CiA 852 has one value for an axis (9.2): that is the reading nearer to rest,
// or no_position.
//
//     TwoChannelAxes axes(first, second, {.deviation_most = 1600, .deviates_most = 100ms});
//     OperatorDevice<elements> seat(port, 10, {.joystick_axis = axes.checked()});
//     axes.connect(seat.node(), seat.unit());
//
// Readings that differ by more than the bound for longer than the time make the axis invalid, which
// is emergency 5000h (Table 37) with the joystick and the axis as its instance, until both agree
// for that time again. A host that receives no_position must not move anything, and waits until the
// stick was released.
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"

namespace canvoy::cia852 {

/// Bounds of the comparison.
struct TwoChannelSettings {
  std::int16_t deviation_most = 1'600;  ///< digits of 16 bits: 5 % of the travel to one side
  /// Longest deviation that leaves the axis valid.
  Duration deviates_most = std::chrono::milliseconds(100);
};

class TwoChannelAxes {
 public:
  /// A reading of one sensor; no_position where its wire is broken.
  using Sense = Callback<std::int16_t(unsigned joystick, unsigned axis)>;
  /// Value of an axis without a position.
  static constexpr std::int16_t no_position = INT16_MIN;

  /// What both refer to must outlive this. Both have the same direction and scale.
  TwoChannelAxes(Sense first, Sense second, const TwoChannelSettings& settings)
      : first_(first), second_(second), settings_(settings) {}

  /// For OperatorHardware::joystick_axis.
  Sense checked() { return Sense::to<&TwoChannelAxes::look>(*this); }
  /// Gives it the node that has the clock and reports errors, and the unit that reads the axes.
  /// Without it, deviations count as lasting at once.
  void connect(Node& node, OperatorUnit& unit);
  /// Joysticks count from 1 to 16, axes from 1 to 3.
  bool is_valid(unsigned joystick, unsigned axis) const {
    return !states_[place_of(joystick, axis)].is_invalid;
  }

 private:
  struct State {
    Time since{};             ///< of is_odd
    bool is_odd = false;      ///< both differ, or one is broken
    bool is_invalid = false;  ///< for longer than allowed
  };
  static constexpr unsigned axes_of_joystick = 3;
  static constexpr unsigned joysticks_max = 16;
  static constexpr std::size_t place_of(unsigned joystick, unsigned axis) {
    return axes_of_joystick * (joystick - std::size_t{1}) + axis - 1;
  }

  std::int16_t look(unsigned joystick, unsigned axis);
  void watch(std::size_t place, bool is_odd);
  void expired(Time) { unit_->hardware_changed(); }

  Sense first_;
  Sense second_;
  TwoChannelSettings settings_;
  Node* node_ = nullptr;
  OperatorUnit* unit_ = nullptr;
  std::array<State, axes_of_joystick * joysticks_max> states_{};
  Timer timer_{callback<&TwoChannelAxes::expired>(*this)};
};

}  // namespace canvoy::cia852
