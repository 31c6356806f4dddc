// The car around the devices of CiA 447 that `canvoy device` runs: how it drives, as the command
// line or a recorded drive says, its clock, where it is.
//
//     DeviceCar car({.speeds = {"50@10s", "0@40s"}});
//     car.join(site);
//     car.step(now);   // often
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/car/car_driver.hpp"
#include "canvoy/tools/device/device_output.hpp"
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

/// What the car senses as numbers.
enum class CarSense : std::uint8_t {
  speed,     ///< how fast it drives; it can only fail
  distance,  ///< likewise
  engine_revolutions,
  tank_level,
  fuel_consumption,
  steering_wheel_angle,
  outside_temperature,
  inside_temperature,
  light_intensity,
  mirror_dimming
};
inline constexpr std::size_t car_sense_count = 10;

/// Each of its clocks shows what it was set to, else the time of this machine.
enum class CarClock : std::uint8_t { receiver, meter, chip };
inline constexpr std::size_t car_clock_count = 3;

/// The devices of one process are in the same car. Where it has a gateway, somebody sits in it, who
/// starts the engine when it is to drive.
class DeviceCar {
 public:
  static constexpr double kmh_max = 250;

  /// Throws Failure where a file cannot be used, UsageError for what makes no sense. `output` is
  /// told why the car does not drive; it must outlive this.
  DeviceCar(const DeviceCarOptions& options, const DeviceOutput& output);
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

  /// It has this gateway, which must outlive the steps of this.
  void take(cia447::IvnGatewayUnit& gateway) { driver_.take(gateway); }

  // What hands do.

  /// From now on it drives so fast, in km/h up to kmh_max, as soon as all that it takes is there.
  /// False: it drives as was recorded.
  bool drive(double kilometres_per_hour);
  /// What a sensor says from now on, in the unit of CarHardware; nothing: it fails. Of speed and
  /// distance a number says that it works.
  void sense(CarSense sense, std::optional<double> value);
  /// Changes what the receiver says from now on, in place of what this one changed before.
  void sense_gps(const std::string& what, std::function<void(cia447::GpsReading&)> change);
  void set_vin(const std::string& vin) { vin_ = vin; }
  /// Since 1970-01-01 UTC, from now on.
  void set_clock(CarClock clock, Duration since_1970);
  /// That of the meter.
  cia447::LocalTime local_time() const;
  /// Somebody has set a state of the gateway by hand: the driver leaves it so.
  void set_by_hand(const cia447::FieldPlace& status) { driver_.set_by_hand(status); }

 private:
  struct SpeedChange {
    Duration at{};
    double speed = 0;  ///< m/s
  };
  struct Sensed {
    DeviceCar* car = nullptr;
    std::optional<double> value{};
    bool is_by_hand = false;
  };
  void plan(const std::string& text);
  void change_speed(double speed);
  void set_off();
  Duration now_utc(CarClock clock) const;
  std::optional<double> read(const Sensed& sensed, CarSense sense) const;
  std::string_view vin() { return vin_; }
  cia447::GpsReading sensed_reading();
  std::optional<cia447::ChipTime> read_chip();
  void write_chip(const cia447::ChipTime& time);
  template <CarSense sense>
  cia447::Sensor sensor();
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
  CarDriver driver_;
  const DeviceOutput& output_;
  double wanted_ = 0;      ///< m/s
  bool is_going_ = false;  ///< as fast as wanted
  std::string told_missing_;
  std::array<Sensed, car_sense_count> senses_;
  std::map<std::string, std::function<void(cia447::GpsReading&)>> gps_changes_;
  std::string vin_;
  std::array<Duration, car_clock_count> clock_offsets_{};  ///< to the clock of this machine
  bool chip_has_date_ = true;
};

}  // namespace canvoy::tools
