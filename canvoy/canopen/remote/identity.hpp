// The data that distinguish a device from others of its kind: identity 1018h and the names 1008h to
// 100Ah, as the device reads them at run time from its flash or its label (CiA 301, 7.5.2.8 to
// 7.5.2.10 and 7.5.2.21).
//
//     Identity identity(node, {.serial_number = read_serial_number(), .hardware_version = "C2"});
//     node.start(now);
//
// Data common to all devices of a kind belong to the description of the device: cia301::identity()
// and cia301::names().
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Values to replace; missing ones stay as in the description.
struct IdentityValues {
  std::optional<std::uint32_t> vendor_id = {};      ///< 1018h:01h
  std::optional<std::uint32_t> product_code = {};   ///< 1018h:02h
  std::optional<std::uint32_t> revision = {};       ///< 1018h:03h
  std::optional<std::uint32_t> serial_number = {};  ///< 1018h:04h
  // The texts must outlive the Identity; a text that is too long for its entry is cut.
  std::string_view device_name = {};       ///< 1008h; empty: as described
  std::string_view hardware_version = {};  ///< 1009h; empty: as described
  std::string_view software_version = {};  ///< 100Ah; empty: as described
};

/// Sets the values at power-on and at every NMT reset.
class Identity {
 public:
  /// To be constructed before Node::start().
  Identity(Node& node, const IdentityValues& values);
  Identity(const Identity&) = delete;
  Identity& operator=(const Identity&) = delete;

 private:
  void reset(ResetScope scope);
  void set_number(std::uint8_t sub, const std::optional<std::uint32_t>& number);
  void set_text(std::uint16_t index, std::string_view text);

  Node& node_;
  IdentityValues values_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
