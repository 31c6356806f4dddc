// Which axis, button and light of a Linux input device is which of a seat: a file of TOML, or what
// suits a joystick.
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

#include "canvoy/tools/device/seat_state.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// What an absolute axis of a device makes of a position of 16 bits.
struct AxisCalibration {
  std::optional<double> least{};
  std::optional<double> centre{};
  std::optional<double> most{};
  double dead_band = 0;  ///< about the centre, to either side
  bool is_inverted = false;

  /// What is left out becomes that of the device; of a pedal, the centre is where it rests.
  AxisCalibration completed(double least_of_device, double most_of_device, bool is_pedal) const;
  /// What is wrong with one that is complete; empty: nothing.
  std::string complaint() const;
  /// -32768 at the least, 0 at the centre, 32767 at the most, straight between; beyond the ends,
  /// those. Of one that is complete and has no complaint.
  std::int16_t position(double value) const;
};

/// Of `type` and `code` as Linux numbers them.
struct HandCode {
  unsigned type = 0;
  unsigned code = 0;

  friend bool operator==(const HandCode&, const HandCode&) = default;
};
/// `ABS_X`, or a number where Linux has no name.
std::string code_text(HandCode code);

struct HandAxis {
  HandCode code;
  Control control;
  AxisCalibration calibration{};  ///< of absolute ones
  std::int32_t step = 1;          ///< of relative ones: how much each click turns
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

/// No control is moved by two. Throws UsageError.
void check_hand_mappings(const std::vector<HandMapping>& mappings);

}  // namespace canvoy::tools
