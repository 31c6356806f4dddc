// Identification: driver, line, block and journey of the day (CiA 407, 6.3, 9.2.7).
//
//     IdentificationUnit identification(device, {}, {});
//     identification.log_in({.driver_id = 1234, .line_id = 23});
#pragma once

#include <string_view>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The work of a driver.
struct Assignment {
  std::uint32_t driver_id = 0;           ///< 0: no driver
  std::uint32_t destination_number = 0;  ///< of the journey
  std::uint16_t line_id = 0;             ///< of the journey
  std::uint16_t route_number = 0;        ///< of the journey
  std::uint32_t block_id = 0;            ///< work of the vehicle for the day
  std::uint16_t journey_number = 0;      ///< 0: not in service
  // If this device provides them (BusSegment::identification_provides_texts).
  std::string_view line_text = {};    ///< of the line
  std::string_view block_text = {};   ///< of the block
  std::string_view driver_text = {};  ///< of the driver

  friend constexpr bool operator==(const Assignment&, const Assignment&) = default;
};

/// The terminal of the driver.
struct IdentificationHardware {
  /// The values after power-on, from a memory. Empty: no driver has logged in.
  Callback<Assignment()> remembered = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(IdentificationHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::remembered; },
      "the class has no member function of IdentificationHardware: remembered");
  if constexpr (requires { &Plain::remembered; })
    hardware.remembered = callback<&Plain::remembered>(plain);
}

class IdentificationUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  IdentificationUnit(VirtualDevice& device, const IdentificationHardware& hardware,
                     const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware) {
    device.on_reset = callback<&IdentificationUnit::reset>(*this);
  }
  IdentificationUnit(const IdentificationUnit&) = delete;
  IdentificationUnit& operator=(const IdentificationUnit&) = delete;

  /// Reports the driver and the journey; also a change of the journey.
  void log_in(const Assignment& assignment) {
    device_.tell(driver_id, assignment.driver_id);
    device_.tell(destination_number, assignment.destination_number);
    device_.tell(line_id, assignment.line_id);
    device_.tell(route_number, assignment.route_number);
    device_.tell(block_id, assignment.block_id);
    device_.tell(journey_number, assignment.journey_number);
    tell_text(line_id_text, assignment.line_text);
    tell_text(block_id_text, assignment.block_text);
    tell_text(driver_id_text, assignment.driver_text);
  }
  /// Reports that no driver is on duty.
  void log_out() { log_in({}); }

 private:
  void reset(ResetScope scope) {
    if (scope == ResetScope::node && hardware_.remembered) log_in(hardware_.remembered());
  }
  /// Does not replace a value that another device has sent.
  template <class Handle>
  void tell_text(const Handle& handle, std::string_view text) {
    const auto reference = device_[handle];
    if (reference.exists() && !allows(reference.entry().row->access, Access::sdo_write)) {
      device_.tell(handle, text);
    }
  }

  VirtualDevice& device_;
  IdentificationHardware hardware_;
};

/// Catalogue row of the identification device (6.3); bus_unit makes it a part of a device.
struct IdentificationKind : BusKind<IdentificationUnit, IdentificationHardware> {
  static constexpr DeviceInfo info = {.name = "identification",
                                      .title = "identification of driver, line and journey",
                                      .product = "Canvoy CiA 407 identification",
                                      .product_code = 40702,
                                      .node_id = 2,
                                      .hardware = "a driver who logs in"};
  static constexpr const VirtualDeviceInfo& provides = identification;
};

}  // namespace canvoy::cia407
