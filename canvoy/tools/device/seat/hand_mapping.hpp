// Mapping of axes, buttons and lights of a Linux input device to those of a seat: a TOML file, or a
// default for joysticks.
//
//     TomlFile file("stick.toml");
//     HandMapping stick = read_hand_mapping(file, elements);
//     seat.set(axis.control, axis.calibration.position(value));
//
//     device = "/dev/input/by-id/usb-Logitech_Extreme_3D-event-joystick"
//     [[axis]]
//     code = "ABS_X"            # as Linux names it
//     moves = "joystick1.x"
//     least = 0                 # these three: what the device says itself, where they are left out
//     centre = 512
//     most = 1023
//     dead-band = 20
//     inverted = true
//     [[button]]
//     code = "BTN_TRIGGER"
//     presses = "joystick1.b1"
//     [[light]]
//     code = "LED_MUTE"
//     shows = "indicator-cluster1.i1"
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/device/seat/seat_state.hpp"

namespace canvoy::tools {

/// Conversion of an absolute axis of a device to a position of 16 bits.
struct AxisCalibration {
  std::optional<double> least{};
  std::optional<double> centre{};
  std::optional<double> most{};
  double dead_band = 0;  ///< on either side of the centre
  bool is_inverted = false;

  /// Fills in missing values from the device; for a pedal, the centre is its rest position.
  AxisCalibration completed(double least_of_device, double most_of_device, bool is_pedal) const;
  /// The fault of a complete calibration; empty: none.
  std::string complaint() const;
  /// Converts linearly to -32768 at the minimum, 0 at the centre and 32767 at the maximum, limited
  /// to this range. For a complete calibration without a complaint.
  std::int16_t position(double value) const;
};

/// Linux `type` and `code`.
struct HandCode {
  unsigned type = 0;
  unsigned code = 0;

  friend bool operator==(const HandCode&, const HandCode&) = default;
};
/// `ABS_X`, or a number if Linux has no name.
std::string code_text(HandCode code);

struct HandAxis {
  HandCode code;
  Control control;
  AxisCalibration calibration{};  ///< for absolute axes
  std::int32_t step = 1;          ///< for relative axes: steps per click
};
struct HandButton {
  HandCode code;
  Control control;
};
struct HandLight {
  HandCode code;
  unsigned cluster = 1;
  unsigned indicator = 1;  ///< 1 to 64
};

struct HandMapping {
  std::string device{};
  std::vector<HandAxis> axes{};
  std::vector<HandButton> buttons{};
  std::vector<HandLight> lights{};
};

/// Throws Failure with file and line.
HandMapping read_hand_mapping(TomlFile& file, const cia852::OperatorEnvironment& elements);

/// Throws UsageError if two mappings move the same control.
void check_hand_mappings(const std::vector<HandMapping>& mappings);

}  // namespace canvoy::tools
