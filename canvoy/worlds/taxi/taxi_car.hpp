// A taxi with its devices and their surroundings: the wheels and the satellites, the driver's card
// and the clocks, the paper of the printer, and the lamps, displays and keys that people see and
// touch.
//
//     TaxiCar car(bus, options, sabotage, events);
//     for (const auto& node : bus.nodes()) car.power(*node, true);
//     car.drive().step(100ms);
//     car.sign().is_vacant()
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/command_keeper.hpp"
#include "canvoy/devices/cia447/printer/printer_paper.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/car/drive.hpp"
#include "canvoy/worlds/taxi/route_guidance.hpp"
#include "canvoy/worlds/taxi/taxi_meter.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"
#include "canvoy/worlds/taxi/terminal_screens.hpp"
#include "canvoy/worlds/taxi/town_clock.hpp"

namespace canvoy::taxi {

// Application of the alarm of a taxi, beside its virtual device: it has the emergency light on the
// roof blink (6106h; CiA 447-3, 4.2.16.4), and calls the control room by a radio of its own while
// 6110h requests a call (CiA 447-3, 4.2.17.1).
//
//     AlarmControl control(network, {.has_called = ...}, {.sign = 5});
//     control.alarm(true);    // TaxiAlarmHardware::alarm

/// Outputs of the control.
struct AlarmControlHardware {
  /// The call has been sent and heard.
  Callback<void()> has_called = {};
};
/// Node with the sign, and the time of a call.
struct AlarmControlSettings {
  NodeId sign = 0;           ///< 1 to 16
  Duration call_takes = 2s;  ///< from the alarm to the end of the call
};

/// The application of the alarm of a taxi, beside its virtual device.
class AlarmControl {
 public:
  /// What these refer to must outlive this object.
  AlarmControl(cia447::CarNetwork& network, const AlarmControlHardware& hardware,
               const AlarmControlSettings& settings);
  AlarmControl(const AlarmControl&) = delete;
  AlarmControl& operator=(const AlarmControl&) = delete;

  /// An alarm begins, or is over.
  void alarm(bool is_on);

 private:
  void called(Time now);

  cia447::CarNetwork& network_;
  AlarmControlHardware hardware_;
  AlarmControlSettings settings_;
  cia447::CommandKeeper sign_;
  bool is_on_ = false;
  Timer call_;
};

/// Stands beside a taxi alarm.
struct AlarmControlKind
    : cia447::CarKind<AlarmControl, AlarmControlHardware, AlarmControlSettings> {
  static constexpr DeviceInfo info = {.name = "alarm-control", .title = "control of an alarm"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
};

/// The lamps of the sign on the roof of a taxi, as the tariff display drives them: what people at
/// the road see (CiA 447-3, 4.2.16.4).
///
///     RoofSign sign(sabotage);
///     environment.provide(Callback<cia447::TariffDisplayHardware()>::to<&RoofSign::hardware>(sign));
///     if (sign.is_vacant()) ...
class RoofSign {
 public:
  /// State of each lamp, from lamp 1 on.
  using Lamps = std::array<cia447::Lamp, cia447::tariff_lamps_max>;

  /// `sabotage` must outlive this object.
  explicit RoofSign(const Sabotage& sabotage) : sabotage_(sabotage) {}
  RoofSign(const RoofSign&) = delete;
  RoofSign& operator=(const RoofSign&) = delete;

  /// The result must not outlive this object.
  cia447::TariffDisplayHardware hardware() {
    return {.drive = callback<&RoofSign::drive>(*this),
            .show_level = callback<&RoofSign::show_level>(*this)};
  }
  /// Switches all off: call it when the display has no power.
  void darken() {
    lamps_.fill(cia447::Lamp::off);
    level_ = {};
    is_vacant_ = false;
    has_alarm_ = false;
  }

  /// What people see.
  const Lamps& lamps() const { return lamps_; }
  /// True while the light for a vacant taxi is on.
  bool is_vacant() const { return is_vacant_; }
  /// True while the taxi light is on.
  bool is_lit() const { return lamps_[0] == cia447::Lamp::on; }
  /// Characters of the tariff level; 0: none.
  const std::array<char, 2>& level() const { return level_; }
  /// True while the emergency light blinks.
  bool has_alarm() const { return has_alarm_; }

 private:
  void drive(unsigned lamp, cia447::Lamp wanted) {
    constexpr unsigned vacant = 2;
    constexpr unsigned emergency = 3;
    if (sabotage_.cuts_sign || (sabotage_.cuts_taxi_light && lamp == 1)) return;
    if (lamp >= 1 && lamp <= lamps_.size()) lamps_[lamp - 1] = wanted;
    if (lamp == vacant) is_vacant_ = wanted == cia447::Lamp::on;
    if (lamp == emergency) has_alarm_ = wanted == cia447::Lamp::blinking;
  }

  void show_level(const std::array<std::uint8_t, 2>& level) {
    if (sabotage_.cuts_sign || sabotage_.cuts_level) return;
    const auto shown = [](std::uint8_t one) {
      return one > ' ' && one < 0x7F ? static_cast<char>(one) : '\0';
    };
    level_ = {shown(level[0]), shown(level[1])};
  }

  const Sabotage& sabotage_;
  Lamps lamps_{};
  std::array<char, 2> level_{};
  bool is_vacant_ = false;
  bool has_alarm_ = false;
};

/// Text on the paper of a printer: characters in the order of printing, line by line.
///
///     PaperText paper;
///     hardware.paper = paper.paper();
///     for (const std::string& line : paper.lines()) ...
///     paper.copy_to(picture.paper());    // it is drawn as well
class PaperText {
 public:
  /// The result must not outlive this object.
  cia447::PrinterPaper paper() {
    cia447::PrinterPaper made;
    made.put = callback<&PaperText::put>(*this);
    made.feed = callback<&PaperText::feed>(*this);
    made.cut = callback<&PaperText::cut>(*this);
    return made;
  }
  /// Forwards all further output to this paper. The object that it refers to must outlive this one.
  void copy_to(const cia447::PrinterPaper& other) { other_ = other; }
  /// Discards the line that was begun.
  void new_roll() { line_.clear(); }
  /// The last lines, at most `count`, in their order.
  std::vector<std::string> last_lines(std::size_t count) const {
    return {lines_.end() - static_cast<std::ptrdiff_t>(std::min(count, lines_.size())),
            lines_.end()};
  }
  /// Lines without the empty ones, in ASCII; other characters are question marks.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  void put(const cia447::PrintedCharacter& printed) {
    constexpr char32_t last_ascii = 0x7E;
    line_ += printed.character <= last_ascii ? static_cast<char>(printed.character) : '?';
    other_.put(printed);
  }
  void feed(unsigned dots) {
    if (!line_.empty()) lines_.push_back(line_);
    line_.clear();
    other_.feed(dots);
  }
  void cut() { other_.cut(); }

  cia447::PrinterPaper other_;
  std::string line_;
  std::vector<std::string> lines_;
};

/// Seconds since 1970-01-01 on a clock with this time.
std::int64_t local_seconds(CivilTime time);

class TaxiCar {
 public:
  /// Functions for requests to a real meter through a simulated device: called each time that the
  /// device is made again, and before it is destroyed.
  struct MeterReader {
    Callback<void(cia447::CarNetwork&, Node&)> device_is_made;  ///< with its network and node
    Callback<void()> device_ends;                               ///< drop the references to both
  };

  /// All must outlive this object, which puts the devices on the bus.
  TaxiCar(car::CarBus& bus, const TaxiOptions& options, const Sabotage& sabotage,
          EventLog<TaxiEvent>& events);
  TaxiCar(const TaxiCar&) = delete;
  TaxiCar& operator=(const TaxiCar&) = delete;

  /// Switches power of a device; one that gets power starts from its initial state.
  void power(car::CarNode& node, bool is_on);
  /// The bus with its nodes.
  car::CarBus& bus() { return bus_; }
  /// Node-ID of the device that requests values of a real meter: the gateway, where that is
  /// simulated here.
  NodeId meter_reader_id() const;
  /// Call it once, before the device gets its power.
  void attach(const MeterReader& reader);

  // Parts that people see and touch.
  /// Motion of the car.
  car::Drive& drive() { return drive_; }
  /// Motion of the car.
  const car::Drive& drive() const { return drive_; }
  /// The taximeter as the driver uses it.
  TaxiMeter& meter() { return meter_; }
  /// The taximeter as the driver uses it.
  const TaxiMeter& meter() const { return meter_; }
  /// The sign on the roof.
  const RoofSign& sign() const { return sign_; }
  /// The displays of the terminal.
  const TerminalScreens& screens() const { return screens_; }
  /// Destination and navigation.
  RouteGuidance& guidance() { return guidance_; }
  /// Destination and navigation.
  const RouteGuidance& guidance() const { return guidance_; }
  /// What the printer has printed.
  PaperText& paper() { return paper_; }
  /// What the printer has printed.
  const PaperText& paper() const { return paper_; }
  /// The gateway; made again when it gets power, so keep no reference.
  cia447::IvnGatewayUnit& gateway() { return *gateway_; }
  /// The driver puts the card in.
  void log_driver_in();
  /// The driver takes the card out.
  void log_driver_out();
  /// Starts a silent alarm, which the driver ends a minute later. False: there is no power.
  bool press_alarm();
  /// True from the key until the driver ends the alarm.
  bool has_alarm() const { return now() < alarm_until_; }
  /// True if the control room has heard the call of the last alarm.
  bool alarm_is_heard() const { return alarm_is_heard_; }

  // Effects of faults on the devices.
  /// Pulses of the wheels meanwhile are not lost.
  void lose_wheels(bool is_lost) { wheel_is_lost_ = is_lost; }
  /// Takes away the signal of satellites, or returns it.
  void lose_satellites(bool is_lost) { fix_is_lost_ = is_lost; }
  /// True while the receiver has a signal.
  bool has_satellites() const { return !fix_is_lost_; }

  // Acts of tampering.
  /// Pulses of a metre per second in addition to those of the wheels.
  void add_pulses(bool are_added);
  /// Mounts smaller wheels, or the right ones.
  void change_wheels(bool are_smaller);
  /// Makes the clock on the bus gain a minute in ten, or stops it; what it has gained stays.
  void let_clock_drift(bool drifts);

  /// Takes or replaces the paper. A line that was begun stays on the old roll.
  void take_paper(bool is_out);
  /// Pulses of the wheels of a real car.
  void roll(std::uint32_t pulses);

 private:
  void add_nodes();
  Environment& add_site();
  void add_gateway();
  void add_meter();
  void provide_to_others(Environment& environment);
  void add_navigation();
  void car_event(const cia447::CarEvent& event);
  Time now() const { return bus_.world().now(); }

  cia447::CarNetworkSettings network_settings() { return options_.car_network.nodes; }
  cia447::CarMasterSettings master_settings() { return bus_.master_settings(); }
  cia447::CarSleepSettings sleep_settings() { return options_.car_network.sleep; }
  cia447::CarSettings car_settings() { return options_.car; }
  cia447::CarHardware car_hardware();
  std::optional<double> speed();
  std::optional<double> distance();
  cia447::PrinterHardware printer_hardware() { return {.paper = paper_.paper()}; }
  void is_printer(cia447::PrinterUnit& unit, Node& node);
  cia447::DriverIdentificationHardware reader_hardware();
  cia447::RealTimeClockHardware clock_hardware();
  std::optional<cia447::ChipTime> chip_time();
  cia447::RealTimeClockSettings clock_settings() { return {.zone = options_.zone}; }
  cia447::LocalTime local_time(Duration ahead) const;
  std::optional<cia447::LocalTime> meter_clock() { return local_time(options_.meter_clock_ahead); }
  std::optional<cia447::LocalTime> reader_clock() { return local_time({}); }
  cia447::GpsHardware gps_hardware();
  cia447::GpsReading gps_reading();
  cia447::TaxiAlarmHardware alarm_hardware();
  AlarmControlHardware alarm_control_hardware();
  AlarmControlSettings alarm_control_settings() { return {.sign = sign_id}; }
  void alarm_changed(bool silent, bool full) { alarm_control_->alarm(silent || full); }
  void alarm_has_called();

  car::CarBus& bus_;
  const TaxiOptions& options_;
  const Sabotage& sabotage_;
  EventLog<TaxiEvent>& events_;
  car::Drive drive_;
  TownClock clock_;
  TaxiMeter meter_;
  RoofSign sign_;
  TerminalScreens screens_;
  RouteGuidance guidance_;
  PaperText paper_;
  Environment* gateway_site_ = nullptr;
  Environment* navigation_site_ = nullptr;
  MeterReader meter_reader_;
  cia447::IvnGatewayUnit* gateway_ = nullptr;
  cia447::PrinterUnit* printer_ = nullptr;
  cia447::DriverIdentificationUnit* driver_reader_ = nullptr;
  cia447::TaxiAlarmUnit* alarm_ = nullptr;
  AlarmControl* alarm_control_ = nullptr;
  Time alarm_until_{};
  bool alarm_is_heard_ = false;
  double turned_metres() const;
  Duration clock_gain() const;

  /// Total time for which something was present.
  struct Presence {
    std::optional<Time> since = {};  ///< beginning of the present time
    Duration before{};               ///< sum of the earlier times

    /// Total up to `now`.
    Duration total(Time now) const { return before + (since ? now - *since : Duration{}); }
    /// Begins or ends a time.
    void set(bool is_there, Time now) {
      before = total(now);
      since.reset();
      if (is_there) since = now;
    }
  };

  Presence extra_pulses_;
  Presence clock_drift_;
  double wheels_ = 1;         ///< turns of these wheels for one turn of the right ones
  double turned_before_ = 0;  ///< m by the wheels, up to their change
  double metres_at_change_ = 0;
  bool wheel_is_lost_ = false;
  bool fix_is_lost_ = false;
  bool paper_is_out_ = false;
  Time rolled_{};  ///< last pulses of the wheels of a real car
};

}  // namespace canvoy::taxi
