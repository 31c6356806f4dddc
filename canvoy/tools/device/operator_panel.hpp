// The seat of an operator environment that `canvoy device operator` runs: what is moved and pressed
// there, as the command line says, and what is seen of indicators and displays.
//
//     OperatorPanel panel({.moves = {"joystick1.x=12000@2s"}}, site, output);
//     panel.step(now);   // often
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

struct OperatorPanelOptions {
  std::string elements{};            ///< as operator_elements.hpp has them
  std::vector<std::string> moves{};  ///< `joystick1.x=12000@2s`
};

void add_operator_panel_options(CLI::App& command, OperatorPanelOptions& options);

/// Something that an operator moves or presses: `joystick1.x`, `joystick1.b3`, `joystick1.hold-x`,
/// `foot-pedal1`, `foot-pedal1.hold`, `encoder1`, `wheel1`, `push-button-cluster1.b13`.
struct Control {
  enum class Kind : std::uint8_t {
    axis,
    joystick_button,
    joystick_hold,
    foot_pedal,
    foot_pedal_hold,
    encoder,
    wheel,
    push_button
  };
  Kind kind = Kind::axis;
  unsigned element = 1;
  unsigned part = 1;  ///< axis, button or direction, from 1 on

  friend bool operator==(const Control&, const Control&) = default;
};
/// Throws UsageError where there is no such control on a device with these elements.
Control parse_control(const std::string& text, const cia852::OperatorEnvironment& elements);

/// Where all of it stands.
class SeatState {
 public:
  /// Positions are cut to 16 bits; of what is pressed, 0 is off.
  void set(const Control& control, std::int64_t value);
  cia852::OperatorHardware inputs();

 private:
  std::int16_t axis(unsigned joystick, unsigned axis) const {
    return axes_[cia852::joystick_axis_sub(joystick, axis) - 1];
  }
  std::uint8_t buttons(unsigned joystick) const { return buttons_[joystick - 1]; }
  std::uint8_t holds(unsigned joystick) const { return holds_[joystick - 1]; }
  std::int16_t foot_pedal(unsigned pedal) const { return foot_pedals_[pedal - 1]; }
  bool foot_pedal_holds(unsigned pedal) const { return foot_pedal_holds_[pedal - 1]; }
  std::uint32_t encoder(unsigned encoder) const { return encoders_[encoder - 1]; }
  std::int16_t wheel(unsigned wheel) const { return wheels_[wheel - 1]; }
  std::uint8_t push_buttons(unsigned cluster, unsigned group) const {
    return push_buttons_[cia852::indicators_sub(cluster, group) - 1];
  }

  static constexpr std::size_t groups =
      std::size_t{cia852::push_button_clusters_max} * cia852::groups_of_cluster;
  std::array<std::int16_t, std::size_t{cia852::joysticks_max} * cia852::joystick_axes> axes_{};
  std::array<std::uint8_t, cia852::joysticks_max> buttons_{};
  std::array<std::uint8_t, cia852::joysticks_max> holds_{};
  std::array<std::int16_t, cia852::foot_pedals_max> foot_pedals_{};
  std::array<bool, cia852::foot_pedals_max> foot_pedal_holds_{};
  std::array<std::uint32_t, cia852::encoders_max> encoders_{};
  std::array<std::int16_t, cia852::wheels_max> wheels_{};
  std::array<std::uint8_t, groups> push_buttons_{};
};

class OperatorPanel {
 public:
  /// `output` must outlive this, and this the devices at `site`. Throws UsageError for what makes
  /// no sense.
  OperatorPanel(const OperatorPanelOptions& options, Site& site, const DeviceOutput& output);
  OperatorPanel(const OperatorPanel&) = delete;
  OperatorPanel& operator=(const OperatorPanel&) = delete;

  /// Times count from the first call.
  void step(Time now);

 private:
  struct Move {
    Duration at{};
    Control control;
    std::int64_t value = 0;
  };
  Move parse_move(const std::string& text) const;
  cia852::OperatorEnvironment elements() { return elements_; }
  cia852::OperatorHardware hardware();
  void show_indicators(unsigned cluster, unsigned group, std::uint8_t lit);
  void show_parameter(unsigned display, unsigned parameter, std::int16_t value);

  const DeviceOutput& output_;
  cia852::OperatorEnvironment elements_;
  std::vector<Move> moves_;
  std::size_t done_ = 0;
  std::optional<Time> begin_;
  SeatState seat_;
  std::array<std::uint8_t, std::size_t{cia852::indicator_clusters_max} * cia852::groups_of_cluster>
      lit_{};
  std::array<std::int16_t, std::size_t{cia852::displays_max} * cia852::parameters_of_display>
      shown_{};
};

}  // namespace canvoy::tools
