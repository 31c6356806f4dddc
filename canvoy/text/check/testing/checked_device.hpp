// A device of the catalogue on the line of a conformance test.
//
//     CheckedDevice device(*find_device_kind("charger"));
//     device.from_device = [](Frame& frame) { return frame.id != 0x581; };
//     Check check(device.line(), device.node(), {});
#pragma once

#include <functional>
#include <optional>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/testing/every_device.hpp"
#include "canvoy/text/check/testing/node_on_line.hpp"

namespace canvoy::conformance {

class CheckedDevice : public NodeOnLine {
 public:
  explicit CheckedDevice(const DeviceKind& kind) : CheckedDevice(kind, four_floors()) {}
  /// Makes the device. What `environment` offers must outlive it. `prepare` is called before the
  /// node starts.
  CheckedDevice(const DeviceKind& kind, const Environment& environment,
                const std::function<void(Node&)>& prepare = {})
      : device_(kind, port(), kind.node_id(environment), environment) {
    if (prepare) prepare(device_.node());
    // Only a listed device has room to receive it.
    const bool is_listed = find_device_kind(kind.info.name) == &kind;
    if (is_listed && kind.answers_lss) lss_.emplace(device_.node());
    start(device_.node());
  }

 private:
  static const Environment& four_floors() {
    struct FourFloors : Environment {
      FourFloors() { floors = 4; }
    };
    static const FourFloors environment;
    return environment;
  }
  CatalogueDevice device_;
  std::optional<LssSlave> lss_;
};

}  // namespace canvoy::conformance
