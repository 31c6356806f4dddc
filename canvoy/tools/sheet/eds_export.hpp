// Data sheets of devices that the project can build, and of a selection from a profile.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::tools {

struct ExportOptions {
  std::string what;    ///< a profile, or a kind of device
  std::string device;  ///< a virtual device: its code or name
  std::optional<unsigned> device_class;
  std::optional<unsigned> subclass;
  std::vector<std::string> objects;  ///< `6010`, `6100-611F`, names
  bool optional = false;             ///< all that the virtual device may have
  std::string elements;              ///< for an operator environment: see operator_elements.hpp
  std::string reading;               ///< of the profile; empty: the usual one
  unsigned node_id = 0;              ///< 0: an EDS
  std::string file_name;
};

/// Throws UsageError if there is no such profile, device or object.
formats::DataSheet export_sheet(const ExportOptions& options);

}  // namespace canvoy::tools
