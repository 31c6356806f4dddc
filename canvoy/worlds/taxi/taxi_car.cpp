#include "canvoy/worlds/taxi/taxi_car.hpp"

#include <chrono>

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/worlds/car/network_changed.hpp"

namespace canvoy::taxi {

namespace {

using cia447::Lamp;

/// Value of 6106h; Fh leaves each of the other lamps unchanged.
constexpr std::uint32_t emergency_light(Lamp lamp) {
  constexpr auto place = cia447::place_of(cia447::tariff_display_lamps_command_1_emcy_light);
  constexpr std::uint32_t mask = ((1U << place.bits) - 1) << place.first_bit;
  return ~mask | static_cast<std::uint32_t>(lamp) << place.first_bit;
}

}  // namespace

AlarmControl::AlarmControl(cia447::CarNetwork& network, const AlarmControlHardware& hardware,
                           const AlarmControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      sign_(network, {.server = settings.sign}),
      call_(callback<&AlarmControl::called>(*this)) {
  alarm(false);
}

void AlarmControl::alarm(bool is_on) {
  constexpr std::uint16_t index = cia447::tariff_display_lamps_command_1_object.index;
  sign_.want(0, {index, 0, emergency_light(is_on ? Lamp::blinking : Lamp::off), 4});
  if (is_on && !is_on_) {
    network_.node().timers().arm(call_, network_.node().now() + settings_.call_takes);
  } else if (!is_on) {
    network_.node().timers().disarm(call_);
  }
  is_on_ = is_on;
}

void AlarmControl::called(Time /*now*/) {
  hardware_.has_called();
}

std::int64_t local_seconds(CivilTime time) {
  return std::chrono::floor<std::chrono::seconds>(time.time_since_epoch()).count();
}

TaxiCar::TaxiCar(car::CarBus& bus, const TaxiOptions& options, const Sabotage& sabotage,
                 EventLog<TaxiEvent>& events)
    : bus_(bus),
      options_(options),
      sabotage_(sabotage),
      events_(events),
      drive_(options.record.get()),
      clock_(local_seconds(options.begin), options.zone),
      meter_(bus, options, sabotage, clock_, TaxiMeter::Clock::to<&TaxiCar::meter_clock>(*this),
             events),
      sign_(sabotage),
      screens_(sabotage),
      guidance_(bus, options.places) {
  add_nodes();
}

/// Surroundings that all devices of a car have.
Environment& TaxiCar::add_site() {
  Environment& environment = bus_.add_site();
  environment.provide(callback<&TaxiCar::network_settings>(*this));
  environment.provide(callback<&TaxiCar::master_settings>(*this));
  environment.provide(callback<&TaxiCar::sleep_settings>(*this));
  return environment;
}

void TaxiCar::add_nodes() {
  add_gateway();
  add_meter();
  Environment& others = add_site();
  provide_to_others(others);
  bus_.add(car::units_of<cia447::PrinterKind>, others);
  bus_.add(
      car::units_of<cia447::DriverIdentificationKind, cia447::RealTimeClockKind, RouteDisplayKind>,
      others);
  bus_.add(car::units_of<cia447::TariffDisplayKind>, others);
  bus_.add(car::units_of<cia447::TerminalKind>, others);
  add_navigation();
  bus_.add(car::units_of<cia447::TaxiAlarmKind, AlarmControlKind>, others);
  bus_.complete();
}

void TaxiCar::add_gateway() {
  Environment& car = add_site();
  gateway_site_ = &car;
  car.provide(callback<&TaxiCar::car_hardware>(*this));
  car.provide(callback<&TaxiCar::car_settings>(*this));
  car.provide(callback<&car::CarBus::memory>(bus_));
  car.watch(gateway_);
  bus_.add(car::units_of<cia447::IvnGatewayKind>, car);
}

void TaxiCar::add_meter() {
  Environment& environment = add_site();
  meter_.provide(environment);
  bus_.add(car::units_of<cia447::TaximeterKind, FareDisplayKind>, environment);
  meter_.provide_outputs(environment);
}

void TaxiCar::provide_to_others(Environment& environment) {
  environment.provide(callback<&TaxiCar::printer_hardware>(*this));
  environment.watch(callback<&TaxiCar::is_printer>(*this));
  environment.provide(callback<&TaxiCar::reader_hardware>(*this));
  environment.watch(driver_reader_);
  environment.provide(callback<&TaxiCar::clock_hardware>(*this));
  environment.provide(callback<&TaxiCar::clock_settings>(*this));
  environment.provide(callback<&RoofSign::hardware>(sign_));
  environment.provide(callback<&TerminalScreens::hardware>(screens_));
  environment.provide(callback<&TerminalScreens::settings>(screens_));
  environment.watch(alarm_);
  environment.provide(callback<&TaxiCar::alarm_hardware>(*this));
  environment.provide(callback<&TaxiCar::alarm_control_hardware>(*this));
  environment.provide(callback<&TaxiCar::alarm_control_settings>(*this));
  environment.watch(alarm_control_);
  guidance_.provide_display(environment);
}

void TaxiCar::add_navigation() {
  Environment& environment = add_site();
  navigation_site_ = &environment;
  environment.provide(callback<&TaxiCar::gps_hardware>(*this));
  guidance_.provide_navigation(environment);
  bus_.add(car::units_of<cia447::GpsKind, cia447::NavigationKind>, environment);
}

NodeId TaxiCar::meter_reader_id() const {
  return bus_.is_played(cia447::gateway_node_id) ? NodeId{cia447::gateway_node_id} : navigation_id;
}

void TaxiCar::attach(const MeterReader& reader) {
  meter_reader_ = reader;
  Environment* environment = meter_reader_id() == navigation_id ? navigation_site_ : gateway_site_;
  environment->watch(reader.device_is_made);
}

void TaxiCar::power(car::CarNode& node, bool is_on) {
  const NodeId id = node.place().id;
  if (id == taximeter_id) meter_.power_changes(is_on);
  if (id == driver_id) guidance_.lose_display();
  if (id == meter_reader_id()) meter_reader_.device_ends();
  if (!is_on && id == sign_id) sign_.darken();
  if (!is_on && id == terminal_id) screens_.darken();
  node.power(is_on);
  if (id == driver_id) guidance_.type_again();
  if (cia447::CarMaster* master = node.device().master()) {
    master->on_event(callback<&TaxiCar::car_event>(*this));
  }
}

void TaxiCar::car_event(const cia447::CarEvent& event) {
  events_.note(now(), car::NetworkChanged{event});
}

cia447::CarHardware TaxiCar::car_hardware() {
  cia447::CarHardware car = cia447::parked_car();
  car.speed = cia447::Sensor::to<&TaxiCar::speed>(*this);
  car.distance = cia447::Sensor::to<&TaxiCar::distance>(*this);
  return car;
}

/// Distance by the wheels.
std::optional<double> TaxiCar::distance() {
  if (wheel_is_lost_) return std::nullopt;
  return turned_metres();
}

std::optional<double> TaxiCar::speed() {
  return drive_.speed() * wheels_;
}

/// Distance by the count of the right wheels; extra pulses add a metre per second.
double TaxiCar::turned_metres() const {
  return turned_before_ + (drive_.metres() - metres_at_change_) * wheels_ +
         std::chrono::duration<double>(extra_pulses_.total(now())).count();
}

void TaxiCar::add_pulses(bool are_added) {
  extra_pulses_.set(are_added, now());
}

void TaxiCar::change_wheels(bool are_smaller) {
  constexpr double more_turns = 1.1;
  turned_before_ += (drive_.metres() - metres_at_change_) * wheels_;
  metres_at_change_ = drive_.metres();
  wheels_ = are_smaller ? more_turns : 1;
}

/// Affects the device and its chip, with which it is compared from time to time.
void TaxiCar::let_clock_drift(bool drifts) {
  constexpr std::int32_t drift_ppm = 100'000;
  bus_.world().set_clock_drift(bus_.node(driver_id).slot(), drifts ? drift_ppm : 0);
  clock_drift_.set(drifts, now());
}

Duration TaxiCar::clock_gain() const {
  constexpr int share = 10;
  return clock_drift_.total(now()) / share;
}

void TaxiCar::roll(std::uint32_t pulses) {
  drive_.roll(pulses * options_.car.wheel_circumference_m / options_.car.pulses_per_rotation,
              now() - rolled_);
  rolled_ = now();
}

cia447::LocalTime TaxiCar::local_time(Duration ahead) const {
  const Time shown = now() + ahead;
  return {.seconds = clock_.local(shown),
          .utc_offset = static_cast<std::int32_t>(clock_.ahead(clock_.utc(shown)))};
}

/// Its chip has a battery.
cia447::RealTimeClockHardware TaxiCar::clock_hardware() {
  return {.read = callback<&TaxiCar::chip_time>(*this), .write = {}};
}
std::optional<cia447::ChipTime> TaxiCar::chip_time() {
  return cia447::ChipTime{.since_1970 = std::chrono::seconds(clock_.utc(Time{})) +
                                        (now() - Time{}) + options_.clock_ahead + clock_gain()};
}

cia447::DriverIdentificationHardware TaxiCar::reader_hardware() {
  return {.clock = callback<&TaxiCar::reader_clock>(*this), .knows = {}};
}

cia447::GpsHardware TaxiCar::gps_hardware() {
  return {.read = callback<&TaxiCar::gps_reading>(*this)};
}

cia447::GpsReading TaxiCar::gps_reading() {
  cia447::GpsReading reading = drive_.receiver();
  if (!sabotage_.blinds_receiver) {
    return fix_is_lost_ ? cia447::GpsReading{.fix = cia447::GpsFix::none} : reading;
  }
  const cia447::GeoPosition start = car::Drive::town_position(0);
  reading.latitude = start.latitude;
  reading.longitude = start.longitude;
  return reading;
}

void TaxiCar::log_driver_in() {
  if (bus_.has_power(driver_id))
    driver_reader_->log_in({.id = 4711, .name = options_.business.driver});
  bus_.touched(driver_id);
}

void TaxiCar::log_driver_out() {
  if (!bus_.has_power(driver_id)) return;
  driver_reader_->log_out();
  bus_.touched(driver_id);
}

bool TaxiCar::press_alarm() {
  if (!bus_.has_power(alarm_id)) return false;
  alarm_until_ = now() + alarm_lasts;
  alarm_is_heard_ = false;
  alarm_->press_key(true);
  alarm_->press_key(false);
  bus_.touched(alarm_id);
  bus_.world().at(alarm_until_, [this](Time) {
    if (!bus_.has_power(alarm_id)) return;
    alarm_->reset_alarm();
    bus_.touched(alarm_id);
  });
  return true;
}

cia447::TaxiAlarmHardware TaxiCar::alarm_hardware() {
  return {.alarm = callback<&TaxiCar::alarm_changed>(*this)};
}

AlarmControlHardware TaxiCar::alarm_control_hardware() {
  return {.has_called = callback<&TaxiCar::alarm_has_called>(*this)};
}

void TaxiCar::alarm_has_called() {
  alarm_->radio_has_called();
  if (sabotage_.mutes_alarm) return;
  alarm_is_heard_ = true;
  events_.note(now(), CallHeard{});
}

void TaxiCar::take_paper(bool is_out) {
  paper_is_out_ = is_out;
  if (!is_out) paper_.new_roll();
  if (bus_.has_power(printer_id)) printer_->sense_paper(!is_out);
  bus_.touched(printer_id);
}

/// A printer that starts checks whether it has paper.
void TaxiCar::is_printer(cia447::PrinterUnit& unit, Node& /*node*/) {
  printer_ = &unit;
  unit.sense_paper(!paper_is_out_);
}

}  // namespace canvoy::taxi
