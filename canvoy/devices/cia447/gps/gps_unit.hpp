// The GPS virtual device: position of the car and its quality, date and time, speed and direction
// (60B0h to 60B6h; CiA 447-3, 4.2.10). It converts the data of a receiver to the codes of the
// profile.
//
//     GpsUnit gps(network, {.read = Callback<GpsReading()>::to<&NmeaReceiver::reading>(nmea)}, {});
//     gps.hardware_changed();   // there is a new reading
//
// Values that the receiver does not have, and position, height and movement without a fix, are
// "Signal not available". Impossible values (a latitude of 91 degrees) are "Failure", and so are
// all values while the receiver has failed.
#pragma once

#include "canvoy/devices/cia447/gps/gps_reading.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

/// Without a receiver, no value is known.
struct GpsHardware {
  Callback<GpsReading()> read = {};  ///< called once a period
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(GpsHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::read; }, "the class has no member function of GpsHardware: read");
  if constexpr (requires { &Plain::read; }) hardware.read = callback<&Plain::read>(plain);
}
/// Period of readings.
struct GpsSettings {
  /// Period of readings of the receiver; zero: read when the receiver reports new data.
  Duration period = 1s;
};

class GpsUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  GpsUnit(CarNetwork& network, const GpsHardware& hardware, const GpsSettings& settings);

  /// Reads the receiver at the next call of the node.
  void hardware_changed() { network_.node().timers().arm(timer_, network_.node().now()); }
  /// Its last data.
  const GpsReading& reading() const { return reading_; }

 private:
  void reset(ResetScope scope);
  void look(Time now);
  void report_position();
  void report_quality();
  void report_clock();
  void report_movement();
  template <class Handle>
  void tell(const Handle& handle, std::optional<double> value, double low, double high);
  template <class Handle>
  void fail(const Handle& handle);

  CarNetwork& network_;
  GpsHardware hardware_;
  GpsSettings settings_;
  Values values_;
  GpsReading reading_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

/// Catalogue row of the GPS receiver (4.2.10); car_unit makes it a part of a device.
struct GpsKind : CarKind<GpsUnit, GpsHardware, GpsSettings> {
  static constexpr DeviceInfo info = {.name = "gps",
                                      .title = "GPS receiver",
                                      .product = "Canvoy CiA 447 GPS",
                                      .product_code = 44707,
                                      .node_id = 3,
                                      .hardware = "a satellite receiver: position, time, movement"};
  static constexpr const VirtualDeviceInfo& provides = gps_device;
};

}  // namespace canvoy::cia447
