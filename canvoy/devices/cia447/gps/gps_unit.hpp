// The GPS virtual device: where the car is, how well that is known, date and time, how fast it goes
// where (60B0h to 60B6h; CiA 447-3, 4.2.10). It writes what a receiver knows into the codes of the
// profile.
//
//     GpsUnit gps(network, {.read = Callback<GpsReading()>::to<&NmeaReceiver::reading>(nmea)}, {});
//     gps.hardware_changed();   // there is a new reading
//
// What the receiver does not know, and without a fix position, height and movement, are "Signal not
// available"; what cannot be (a latitude of 91 degrees) is "Failure", as all is while the receiver
// has failed.
#pragma once

#include "canvoy/devices/cia447/car_kind.hpp"
#include "canvoy/devices/cia447/gps/gps_reading.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

/// Without a receiver nothing is known.
struct GpsHardware {
  Callback<GpsReading()> read = {};
};
struct GpsSettings {
  /// How often the receiver is looked at; zero: when it says that it has something new.
  Duration period = 1s;
};

class GpsUnit {
 public:
  /// What `hardware` refers to must outlive this.
  GpsUnit(CarNetwork& network, const GpsHardware& hardware, const GpsSettings& settings);
  GpsUnit(const GpsUnit&) = delete;
  GpsUnit& operator=(const GpsUnit&) = delete;

  /// Has the receiver looked at when the node is called next.
  void hardware_changed() { network_.node().timers().arm(timer_, network_.node().now()); }
  /// What it said last.
  const GpsReading& reading() const { return reading_; }

 private:
  void reset(ResetScope scope);
  void look(Time now);
  void tell_position();
  void tell_quality();
  void tell_clock();
  void tell_movement();
  template <class Handle>
  void tell(const Handle& handle, std::optional<double> value, double low, double high);
  template <class Handle>
  void fail(const Handle& handle);

  CarNetwork& network_;
  GpsHardware hardware_;
  GpsSettings settings_;
  Values values_;
  GpsReading reading_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

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
