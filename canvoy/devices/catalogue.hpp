// All kinds of devices that there are, by the names that users type.
//
//     const DeviceKind* kind = find_device_kind("lift-load");
//     Site site;
//     CatalogueDevice device(*kind, port, kind->node_id(site), site);
//     device.node().start(now);
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "canvoy/devices/device_kind.hpp"

namespace canvoy {

/// As --list shows them.
std::span<const DeviceKind* const> device_catalogue();
/// Null where there is none of this name.
const DeviceKind* find_device_kind(std::string_view name);

/// A device of the catalogue, in memory from the heap.
class CatalogueDevice {
 public:
  /// `port`'s context, `site` and what it offers must outlive this.
  CatalogueDevice(const DeviceKind& kind, const Port& port, NodeId node_id, const Site& site)
      : form_(kind.form(site)),
        memory_(std::make_unique<std::byte[]>(form_.bytes)),
        made_(form_.make(memory_.get(), port, node_id, site)) {}
  ~CatalogueDevice() { form_.end(memory_.get()); }
  CatalogueDevice(const CatalogueDevice&) = delete;
  CatalogueDevice& operator=(const CatalogueDevice&) = delete;

  Node& node() { return *made_.node; }
  EmergencyProducer& emergency_producer() { return *made_.emergencies; }

 private:
  const DeviceForm& form_;
  std::unique_ptr<std::byte[]> memory_;
  MadeDevice made_;
};

}  // namespace canvoy
