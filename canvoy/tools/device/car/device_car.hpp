// The car around the devices of CiA 447 that `canvoy device` runs: its motion from the command line
// or a recorded drive, its clock, its position.
//
//     DeviceCar car({.speeds = {"50@10s", "0@40s"}});
//     car.join(environment);
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
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/cli/place_file.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/worlds/car/drive.hpp"

namespace canvoy::tools {

// The driver of the car of an IVN gateway that `canvoy device` runs: sets ignition, engine, lever,
// brakes and locks as needed when the car drives (CiA 447-3, 4.2.2 to 4.2.4).
//
//     driver.take(gateway);
//     driver.get_ready();              // it is to drive
//     if (driver.missing().empty()) ...
//     driver.follow(13.9, false);      // it drives, and does not brake
//
// The driver does not change what was set by hand; the car may then be unable to drive.

class CarDriver {
 public:
  /// Sets the gateway, which must outlive the calls of this. Without a gateway, nothing is needed.
  void take(cia447::IvnGatewayUnit& gateway) { gateway_ = &gateway; }
  void set_by_hand(const cia447::FieldPlace& status);

  /// Sets key, engine, belt, locks, lever and parking brake, as far as needed.
  void get_ready();
  /// Reason why the car cannot drive; empty: it can.
  std::string missing() const;
  /// Sets gear, brake light and engine for this speed (m/s), and for braking or not.
  void follow(double speed, bool is_braking);

  double engine_revolutions() const { return revolutions_; }
  /// In litres per second.
  double fuel_consumption() const;

 private:
  template <class Handle, class State>
  void say(const Handle& status, State state);
  bool is_by_hand(const cia447::FieldPlace& status) const;
  bool runs() const;

  cia447::IvnGatewayUnit* gateway_ = nullptr;
  std::vector<cia447::FieldPlace> by_hand_;
  bool is_ready_ = false;
  double speed_ = 0;
  double revolutions_ = 0;
};

struct DeviceCarOptions {
  std::vector<std::string> speeds{};  ///< `50@10s`: km/h and start time
  std::string nmea{};                 ///< file of a recorded drive
  std::string places{};               ///< file of a gazetteer
};

void add_device_car_options(Verb& command, DeviceCarOptions& options);

/// The clock of this machine, as UTC.
cia447::LocalTime host_local_time();

/// Sensors of the car with a number.
enum class CarSense : std::uint8_t {
  speed,     ///< speed of the car; can only fail
  distance,  ///< distance; can only fail
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

/// Clocks of the car. Each shows the time that was set, else that of this machine.
enum class CarClock : std::uint8_t { receiver, meter, chip };
inline constexpr std::size_t car_clock_count = 3;

/// The car that all devices of one process share. With a gateway, it has a driver who starts the
/// engine when the car is to drive.
class DeviceCar {
 public:
  static constexpr double kmh_max = 250;

  /// Throws Failure if a file cannot be used, UsageError for an invalid option. `output` reports
  /// why the car does not drive; it must outlive this.
  DeviceCar(const DeviceCarOptions& options, const DeviceOutput& output);
  DeviceCar(const DeviceCar&) = delete;
  DeviceCar& operator=(const DeviceCar&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Advances the car. Times count from the first call.
  void step(Time now);

  double speed() const { return drive_.speed(); }    ///< m/s
  double metres() const { return drive_.metres(); }  ///< since the start
  /// The satellite receiver; without a recorded drive, at the present date.
  cia447::GpsReading receiver() const;

  /// Sets the gateway, which must outlive the steps of this.
  void take(cia447::IvnGatewayUnit& gateway) { driver_.take(gateway); }

  // Actions of hands.

  /// Sets the speed in km/h, up to kmh_max; the car starts as soon as it can. False: it follows a
  /// recorded drive.
  bool drive(double kilometres_per_hour);
  /// Sets the value of a sensor, in the unit of CarHardware; nothing: it fails. For speed and
  /// distance, a number means that it works.
  void sense(CarSense sense, std::optional<double> value);
  /// Sets a change of the receiver data; replaces the previous change with the same `what`.
  void sense_gps(const std::string& what, std::function<void(cia447::GpsReading&)> change);
  void set_vin(const std::string& vin) { vin_ = vin; }
  /// Sets a clock to a time since 1970-01-01 UTC.
  void set_clock(CarClock clock, Duration since_1970);
  /// Time of the clock of the taximeter.
  cia447::LocalTime local_time() const;
  /// Marks a state of the gateway as set by hand: the driver does not change it.
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
  bool is_going_ = false;  ///< at the wanted speed
  std::string told_missing_;
  std::array<Sensed, car_sense_count> senses_;
  std::map<std::string, std::function<void(cia447::GpsReading&)>> gps_changes_;
  std::string vin_;
  std::array<Duration, car_clock_count> clock_offsets_{};  ///< offset to the clock of this machine
  bool chip_has_date_ = true;
};

}  // namespace canvoy::tools
