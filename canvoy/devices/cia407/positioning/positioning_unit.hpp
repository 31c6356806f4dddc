// Geographical positioning by satellites: position, speed and direction of the vehicle, and its
// mileage (CiA 407, 6.17, 9.2.21). Without a position, all values are invalid, and "no signal" is
// an error (FF02h).
//
//     PositioningUnit position(device, {.read = Callback<cia447::GpsReading()>::to<
//                                           &cia447::NmeaReceiver::reading>(nmea)}, {});
//
// The mileage is the speed integrated over time while there is a position. Its precision is not
// known.
#pragma once

#include <optional>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia447/gps/gps_reading.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The receiver.
struct PositioningHardware {
  Callback<cia447::GpsReading()> read = {};  ///< once a period
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(PositioningHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::read; }, "the class has no member function of PositioningHardware: read");
  if constexpr (requires { &Plain::read; }) hardware.read = callback<&Plain::read>(plain);
}
/// Period and precision.
struct PositioningSettings {
  Duration period = 1s;        ///< of readings
  double metres_per_hdop = 5;  ///< precision of a position with a dilution of precision of 1
};

class PositioningUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  PositioningUnit(VirtualDevice& device, const PositioningHardware& hardware,
                  const PositioningSettings& settings);

 private:
  void reset(ResetScope /*scope*/) { look(device_.node().now()); }
  void look(Time now);

  VirtualDevice& device_;
  PositioningHardware hardware_;
  PositioningSettings settings_;
  double mileage_metres_ = 0;
  std::optional<Time> looked_;
  Timer timer_;
};

/// Catalogue row of the geographical positioning (6.17); bus_unit makes it a part of a device.
struct PositioningKind : BusKind<PositioningUnit, PositioningHardware, PositioningSettings> {
  static constexpr DeviceInfo info = {.name = "geographical-positioning",
                                      .title = "geographical positioning of a bus",
                                      .product = "Canvoy CiA 407 positioning",
                                      .product_code = 40716,
                                      .node_id = 16,
                                      .hardware = "a satellite receiver: position, movement"};
  static constexpr const VirtualDeviceInfo& provides = geographical_positioning;
  static constexpr std::array pdos = {own_pdo<position_tpdo>, own_pdo<movement_tpdo>};
};

}  // namespace canvoy::cia407
