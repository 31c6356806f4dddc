// All kinds of devices, by the names that users type.
//
//     const DeviceKind* kind = find_device_kind("lift-load");
//     Environment environment;
//     CatalogueDevice device(*kind, port, kind->node_id(environment), environment);
//     device.node().start(now);
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy {

/// In the order of --list.
std::span<const DeviceKind* const> device_catalogue();
/// Null if there is no kind of this name.
const DeviceKind* find_device_kind(std::string_view name);

/// A device of the catalogue, in memory from the heap.
class CatalogueDevice {
 public:
  /// The context of `port`, `environment` and its offers must outlive this.
  CatalogueDevice(const DeviceKind& kind, const Port& port, NodeId node_id,
                  const Environment& environment)
      : form_(kind.form(environment)),
        memory_(std::make_unique<std::byte[]>(form_.bytes)),
        made_(form_.make(memory_.get(), port, node_id, environment)) {}
  ~CatalogueDevice() { form_.end(memory_.get()); }

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return *made_.node; }
  /// Sends errors of the device; for indicators and tests.
  EmergencyProducer& emergency_producer() { return *made_.emergencies; }

 private:
  const DeviceForm& form_;
  std::unique_ptr<std::byte[]> memory_;
  MadeDevice made_;
};

}  // namespace canvoy
