// What `canvoy device lift-car-panel` and `lift-landing-panel` run: panels of a lift (CiA 417-4).
// What their lamps and displays show is said, and their buttons are pressed at given times.
//
//     LiftPanel panel("lift-landing-panel", port, 21, {.floor = 3, .presses = {"up@2s"}}, output);
//     panel.step(now);   // often
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "canvoy/canopen/emergency_producer.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/tools/device_output.hpp"

namespace canvoy::tools {

struct LiftPanelOptions {
  unsigned lift = 1;
  unsigned floor = 1;  ///< of a landing panel
  unsigned floors = 10;
  std::vector<std::string> presses{};  ///< `up@2s`
};

/// `lift-landing-panel` or `lift-car-panel`.
bool is_lift_panel(const std::string& kind);
NodeId node_id_of_panel(const std::string& kind);
/// Throws UsageError where the options make no sense for a panel of this kind.
void check_lift_panel(const std::string& kind, const LiftPanelOptions& options);

class LiftPanel {
 public:
  /// `options` were checked; `output` must outlive this.
  LiftPanel(std::string kind, const Port& port, NodeId id, const LiftPanelOptions& options,
            const DeviceOutput& output);
  ~LiftPanel();
  LiftPanel(const LiftPanel&) = delete;
  LiftPanel& operator=(const LiftPanel&) = delete;

  Node& node();
  EmergencyProducer& emergency_producer();
  /// Presses what is due, and lets it go again. Times count from the first call.
  void step(Time now);

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace canvoy::tools
