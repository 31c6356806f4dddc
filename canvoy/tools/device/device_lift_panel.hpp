// What is at a panel of a lift (CiA 417-4) that `canvoy device` runs: its lamps and displays are
// told, and its buttons are pressed at given times.
//
//     LiftPanel panel("lift-landing-panel", {.presses = {"up@2s"}}, site, output);
//     panel.step(now);   // often
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia417/panel/input_panel_unit.hpp"
#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace canvoy::tools {

/// One button: what it is for, and when.
struct PanelPress {
  cia417::BasicFunction function = cia417::BasicFunction::none;
  std::uint8_t sub_function = 0;
  Duration at{};
  bool pressed = false;
  bool done = false;
};

class LiftPanel {
 public:
  /// `presses` are such as `up@2s`. Throws UsageError where a panel of this kind has no such button
  /// at `site`. It joins the site, and must outlive the device that is made there; `output` must
  /// outlive this.
  LiftPanel(std::string kind, const std::vector<std::string>& presses, Site& site,
            const DeviceOutput& output);
  LiftPanel(const LiftPanel&) = delete;
  LiftPanel& operator=(const LiftPanel&) = delete;

  /// A button and a time, as `presses` are. Throws UsageError.
  void take(std::string_view press);
  /// Presses what is due, and lets it go again. Times count from the first call.
  void step(Time now);

 private:
  cia417::OutputHardware hardware();
  void show(std::uint32_t number, const cia417::OutputView& view);
  void has_inputs(cia417::InputPanelUnit& unit, Node& /*node*/) { inputs_ = &unit; }
  void has_outputs(cia417::OutputPanelUnit& unit, Node& /*node*/) { outputs_ = &unit; }

  std::string kind_;
  const Site& site_;
  const DeviceOutput& output_;
  std::vector<PanelPress> presses_;
  std::vector<cia417::OutputView> views_;
  std::optional<Time> begin_;
  cia417::InputPanelUnit* inputs_ = nullptr;    ///< null: it has none
  cia417::OutputPanelUnit* outputs_ = nullptr;  ///< null: while it is made nothing is on
};

}  // namespace canvoy::tools
