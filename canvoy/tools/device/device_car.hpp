// The car around the devices of CiA 447 that `canvoy device` runs: how it drives, as the command
// line or a recorded drive says, its clock, where it is.
//
//     DeviceCar car({.speeds = {"50@10s", "0@40s"}});
//     car.join(site);
//     car.step(now);   // often
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/place_file.hpp"

namespace canvoy::tools {

struct DeviceCarOptions {
  std::vector<std::string> speeds{};  ///< `50@10s`: km/h, and from when on
  std::string nmea{};                 ///< the file of a drive
  std::string places{};               ///< that of a gazetteer
};

void add_device_car_options(Verb& command, DeviceCarOptions& options);

/// The clock of this machine, as UTC.
cia447::LocalTime host_local_time();

/// The devices of one process are in the same car.
class DeviceCar {
 public:
  /// Throws Failure where a file cannot be used, UsageError for what makes no sense.
  explicit DeviceCar(const DeviceCarOptions& options);
  DeviceCar(const DeviceCar&) = delete;
  DeviceCar& operator=(const DeviceCar&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// Times count from the first call.
  void step(Time now);

  double speed() const { return drive_.speed(); }    ///< m/s
  double metres() const { return drive_.metres(); }  ///< since the start
  /// Where no drive was recorded, that of today.
  cia447::GpsReading receiver() const;

 private:
  struct SpeedChange {
    Duration at{};
    double speed = 0;  ///< m/s
  };
  void plan(const std::string& text);
  void change_speed(double speed);
  cia447::CarHardware car();
  cia447::GpsHardware gps();
  cia447::NavigationHardware navigation();
  cia447::RealTimeClockHardware clock();
  cia447::DriverIdentificationHardware reader();

  std::shared_ptr<const car::DriveRecord> record_;
  car::Drive drive_;
  std::optional<PlaceFile> places_;
  std::vector<SpeedChange> plan_;
  std::size_t done_ = 0;
  std::optional<Time> begin_;
  Time driven_until_{};
};

}  // namespace canvoy::tools
