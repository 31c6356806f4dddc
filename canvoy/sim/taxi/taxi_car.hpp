// A taxi with its devices and what they find there: the wheels and the satellites, the driver's
// card and the clocks, the paper of the printer, and the lamps, displays and keys that people see
// and touch.
//
//     TaxiCar car(bus, options, sabotage, events);
//     for (const auto& node : bus.nodes()) car.power(*node, true);
//     car.drive().step(100ms);
//     car.sign().is_vacant()
#pragma once

#include <optional>

#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/sim/taxi/paper_text.hpp"
#include "canvoy/sim/taxi/roof_sign.hpp"
#include "canvoy/sim/taxi/route_guidance.hpp"
#include "canvoy/sim/taxi/taxi_meter.hpp"
#include "canvoy/sim/taxi/terminal_screens.hpp"

namespace canvoy::taxi {

/// Seconds since 1970-01-01 that a clock of this time of day shows.
std::int64_t local_seconds(CivilTime time);

class TaxiCar {
 public:
  /// Who asks a real meter through one of our devices: is told of each time that the device is made
  /// anew, and before it ends.
  struct MeterReader {
    Callback<void(cia447::CarNetwork&, Node&)> device_is_made;
    Callback<void()> device_ends;
  };

  /// All must outlive this. The devices are put on the bus.
  TaxiCar(car::CarBus& bus, const TaxiOptions& options, const Sabotage& sabotage,
          EventLog<TaxiEvent>& events);
  TaxiCar(const TaxiCar&) = delete;
  TaxiCar& operator=(const TaxiCar&) = delete;

  /// A device gets its power or loses it; one that gets it is made anew.
  void power(car::CarNode& node, bool is_on);
  car::CarBus& bus() { return bus_; }
  /// The device by which a real meter is asked: the gateway, where that is played.
  NodeId meter_reader_id() const;
  /// Once, before the device gets its power.
  void attach(const MeterReader& reader);

  // What people see and touch.
  car::Drive& drive() { return drive_; }
  const car::Drive& drive() const { return drive_; }
  TaxiMeter& meter() { return meter_; }
  const TaxiMeter& meter() const { return meter_; }
  const RoofSign& sign() const { return sign_; }
  const TerminalScreens& screens() const { return screens_; }
  RouteGuidance& guidance() { return guidance_; }
  const RouteGuidance& guidance() const { return guidance_; }
  PaperText& paper() { return paper_; }
  const PaperText& paper() const { return paper_; }
  cia447::IvnGatewayUnit& gateway() { return *gateway_; }
  void log_driver_in();
  void log_driver_out();
  /// A silent alarm, which the driver ends by himself a minute later. False: it has no power.
  bool press_alarm();

  // What faults take from the devices.
  /// What the wheels turn meanwhile is not lost to them.
  void lose_wheels(bool is_lost) { wheel_is_lost_ = is_lost; }
  void lose_satellites(bool is_lost) { fix_is_lost_ = is_lost; }
  bool has_satellites() const { return !fix_is_lost_; }

  // What somebody does who cheats.
  /// Pulses of a metre a second beside those of the wheels.
  void add_pulses(bool are_added);
  /// To smaller wheels, or back.
  void change_wheels(bool are_smaller);
  /// The clock on the bus gains from now on, a minute in ten; what it has gained stays.
  void let_clock_drift(bool drifts);

  /// A line that was begun stays on the old roll.
  void take_paper(bool is_out);
  /// The wheels of a real car have turned.
  void roll(std::uint32_t pulses);

 private:
  void add_nodes();
  Site& add_site();
  void add_gateway();
  void add_meter();
  void offer_to_others(Site& site);
  void add_navigation();
  void car_event(const cia447::CarEvent& event);
  Time now() const { return bus_.world().now(); }

  cia447::CarNetworkSettings network_settings() { return options_.car_network.nodes; }
  cia447::CarMasterSettings master_settings() { return options_.car_network.master; }
  cia447::CarSleepSettings sleep_settings() { return options_.car_network.sleep; }
  cia447::CarSettings car_settings() { return options_.car; }
  cia447::CarHardware car_hardware();
  std::optional<double> speed();
  std::optional<double> distance();
  void is_gateway(cia447::IvnGatewayUnit& unit, Node& /*node*/) { gateway_ = &unit; }
  cia447::PrinterHardware printer_hardware() { return {.paper = paper_.paper()}; }
  void is_printer(cia447::PrinterUnit& unit, Node& node);
  cia447::DriverIdentificationHardware reader_hardware();
  void is_driver_reader(cia447::DriverIdentificationUnit& unit, Node& /*node*/) {
    driver_reader_ = &unit;
  }
  cia447::RealTimeClockHardware clock_hardware();
  std::optional<cia447::ChipTime> chip_time();
  cia447::LocalTime local_time(Duration ahead) const;
  std::optional<cia447::LocalTime> meter_clock() { return local_time(options_.meter_clock_ahead); }
  std::optional<cia447::LocalTime> reader_clock() { return local_time({}); }
  cia447::GpsHardware gps_hardware();
  cia447::GpsReading gps_reading();
  void is_alarm(cia447::TaxiAlarmUnit& unit, Node& /*node*/) { alarm_ = &unit; }

  car::CarBus& bus_;
  const TaxiOptions& options_;
  const Sabotage& sabotage_;
  EventLog<TaxiEvent>& events_;
  car::Drive drive_;
  TaxiMeter meter_;
  RoofSign sign_;
  TerminalScreens screens_;
  RouteGuidance guidance_;
  PaperText paper_;
  Site* gateway_site_ = nullptr;
  Site* navigation_site_ = nullptr;
  MeterReader meter_reader_;
  cia447::IvnGatewayUnit* gateway_ = nullptr;
  cia447::PrinterUnit* printer_ = nullptr;
  cia447::DriverIdentificationUnit* driver_reader_ = nullptr;
  cia447::TaxiAlarmUnit* alarm_ = nullptr;
  double turned_metres() const;
  Duration clock_gain() const;

  /// How long something was there in all.
  struct Presence {
    std::optional<Time> since = {};  ///< it is there
    Duration before{};               ///< of earlier times

    /// Up to now.
    Duration total(Time now) const { return before + (since ? now - *since : Duration{}); }
    /// It comes or goes.
    void set(bool is_there, Time now) {
      before = total(now);
      since.reset();
      if (is_there) since = now;
    }
  };

  Presence extra_pulses_;
  Presence clock_drift_;
  double wheels_ = 1;         ///< turns of these wheels for one of the right ones
  double turned_before_ = 0;  ///< m that the wheels say, up to their change
  double metres_at_change_ = 0;
  bool wheel_is_lost_ = false;
  bool fix_is_lost_ = false;
  bool paper_is_out_ = false;
  Time rolled_{};  ///< when the wheels of a real car were heard last
};

}  // namespace canvoy::taxi
