#include "canvoy/tools/device/car/device_car.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <initializer_list>
#include <utility>

#include "canvoy/can/real_text.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/drive_file.hpp"

namespace canvoy::tools {

namespace {

constexpr double idle_revolutions = 800;
/// Revolutions per minute for each m/s in first gear; each higher gear takes its fraction of that.
constexpr double first_gear_revolutions = 450;
constexpr double shift_revolutions = 2800;
constexpr unsigned gear_max = 6;
constexpr double idle_consumption = 0.0005;   ///< l/s: about 1.8 l per hour
constexpr double driving_consumption = 7e-5;  ///< l/m: 7 l per 100 km

double revolutions_in(unsigned gear, double speed) {
  return std::max(idle_revolutions, speed * first_gear_revolutions / gear);
}
/// The lowest gear with a permitted engine speed.
unsigned gear_for(double speed) {
  unsigned gear = 1;
  while (gear < gear_max && revolutions_in(gear, speed) > shift_revolutions) ++gear;
  return gear;
}

bool is_any_of(cia447::SelectorLever lever, std::initializer_list<cia447::SelectorLever> levers) {
  return std::ranges::find(levers, lever) != levers.end();
}

}  // namespace

void CarDriver::set_by_hand(const cia447::FieldPlace& status) {
  if (!is_by_hand(status)) by_hand_.push_back(status);
}

bool CarDriver::is_by_hand(const cia447::FieldPlace& status) const {
  return std::ranges::find(by_hand_, status) != by_hand_.end();
}

template <class Handle, class State>
void CarDriver::say(const Handle& status, State state) {
  if (!is_by_hand(cia447::place_of(status))) gateway_->report(status, state);
}

void CarDriver::get_ready() {
  using namespace cia447;
  if (gateway_ == nullptr || is_ready_) return;
  is_ready_ = true;
  say(occupant_classification_status_driver, Signal::yes);
  say(buckle_switch_status_driver, Signal::yes);
  say(ignition_switch_status_lock, Signal::yes);
  say(ignition_switch_status_accessory, Signal::yes);
  say(ignition_switch_status_on, Signal::yes);
  say(central_locking_system_status, Locking::internal);
  say(engine_status, Engine::running);
  say(transmission_selector_lever_position, SelectorLever::driving);
  say(parking_brake, Signal::no);
}

bool CarDriver::runs() const {
  using namespace cia447;
  return gateway_ != nullptr && gateway_->power_train().is(engine_status, Engine::running);
}

std::string CarDriver::missing() const {
  using namespace cia447;
  if (gateway_ == nullptr) return "";
  const Switching& train = gateway_->power_train();
  std::string text;
  const auto add = [&text](bool is_missing, const char* what) {
    if (is_missing) text += (text.empty() ? "" : ", ") + std::string(what);
  };
  add(!gateway_->body().is(ignition_switch_status_on, Signal::yes), "the ignition is off");
  add(!train.is(engine_status, Engine::running), "the engine does not run");
  const auto lever =
      static_cast<SelectorLever>(train.actual(place_of(transmission_selector_lever_position)));
  add(is_any_of(lever,
                {SelectorLever::parking, SelectorLever::neutral, SelectorLever::intermediate}),
      "the lever is in no driving position");
  add(train.is(parking_brake, Signal::yes), "the parking brake is engaged");
  return text;
}

void CarDriver::follow(double speed, bool is_braking) {
  using namespace cia447;
  speed_ = speed;
  if (gateway_ == nullptr) return;
  const unsigned gear = gear_for(speed);
  revolutions_ = runs() ? revolutions_in(gear, speed) : 0;
  if (!is_ready_) return;
  // A driver who stands with an automatic gear engaged holds the brake.
  say(car_light_status_brake, is_braking || speed <= 0 ? Signal::on : Signal::off);
  say(engaged_gear, static_cast<Gear>(gear));
}

double CarDriver::fuel_consumption() const {
  return runs() ? idle_consumption + driving_consumption * speed_ : 0;
}

namespace {

constexpr double kmh = 1 / 3.6;  ///< m/s
/// Longer than any drive.
constexpr double endless = 1e9;

Duration since_1970() {
  return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch());
}

}  // namespace

void add_device_car_options(Verb& command, DeviceCarOptions& options) {
  command.add({
      {"--speed", options.speeds,
       "km/h of the car or bus of an ivn-gateway, gps, vehicle-gateway, tachograph or "
       "geographical-positioning, and from when on: 50@10s",
       one_each},
      {"--nmea", options.nmea,
       "a recorded drive of that car, as NMEA 0183; stops of 2 min are left out"},
      {"--places", options.places, "the gazetteer of a navigation system"},
  });
}

cia447::LocalTime host_local_time() {
  return {.seconds = std::chrono::floor<std::chrono::seconds>(since_1970()).count()};
}

DeviceCar::DeviceCar(const DeviceCarOptions& options, const DeviceOutput& output)
    : record_(options.nmea.empty() ? nullptr : read_drive_file(options.nmea)),
      drive_(record_.get()),
      output_(output),
      vin_(cia447::parked_car().vin()) {
  for (Sensed& sensed : senses_) sensed.car = this;
  if (!options.nmea.empty() && !options.speeds.empty()) {
    throw UsageError("--speed: a recorded drive has its own; give --nmea alone");
  }
  if (!options.places.empty()) places_.emplace(options.places);
  for (const std::string& text : options.speeds) plan(text);
  std::ranges::stable_sort(plan_, {}, &SpeedChange::at);
}

void DeviceCar::plan(const std::string& text) {
  const std::size_t at = text.find('@');
  double speed = 0;
  const char* const end = text.data() + std::min(at, text.size());
  const auto [stop, error] = real_from_chars(text.data(), end, speed);
  const bool is_speed = error == std::errc{} && stop == end && speed >= 0 && speed <= kmh_max;
  if (at == std::string::npos || !is_speed) {
    throw UsageError(fmt::format(
        "--speed: '{}' is no speed with a time: write 50@10s, in km/h up to {}", text, kmh_max));
  }
  plan_.push_back({parse_moment_argument(text.substr(at + 1)), speed * kmh});
}

void DeviceCar::join(Environment& environment) {
  environment.provide(callback<&DeviceCar::car>(*this));
  environment.provide(callback<&DeviceCar::gps>(*this));
  environment.provide(callback<&DeviceCar::navigation>(*this));
  environment.provide(callback<&DeviceCar::clock>(*this));
  environment.provide(callback<&DeviceCar::reader>(*this));
}

/// Brakes as before a red light.
void DeviceCar::change_speed(double speed) {
  const double to_stand = drive_.speed() * drive_.speed() / (2 * car::Drive::deceleration);
  drive_.go(speed > 0 ? endless : to_stand, speed > 0 ? speed : drive_.speed());
}

void DeviceCar::step(Time now) {
  if (!begin_) begin_ = driven_until_ = now;
  for (; done_ < plan_.size() && now - *begin_ >= plan_[done_].at; ++done_) {
    wanted_ = plan_[done_].speed;
    is_going_ = false;
  }
  set_off();
  if (drive_.is_standing()) drive_.go_on();
  const double before = drive_.speed();
  drive_.step(now - driven_until_);
  driver_.follow(drive_.speed(), drive_.speed() < before);
  driven_until_ = now;
}

bool DeviceCar::drive(double kilometres_per_hour) {
  if (record_) return false;
  wanted_ = kilometres_per_hour * kmh;
  is_going_ = false;
  return true;
}

/// If something is missing, the car stands, or stops, until it is available.
void DeviceCar::set_off() {
  if (record_) {
    if (!drive_.is_standing()) driver_.get_ready();
    return;
  }
  if (wanted_ > 0) driver_.get_ready();
  const std::string missing = wanted_ > 0 ? driver_.missing() : "";
  if (missing != told_missing_ && !missing.empty()) {
    output_.say("ivn-gateway", fmt::format("the car does not drive: {}", missing));
  }
  const bool was_missing = !std::exchange(told_missing_, missing).empty();
  const bool may_go = missing.empty();
  if (may_go && (was_missing || !is_going_)) {
    change_speed(wanted_);
    is_going_ = true;
  } else if (!may_go && is_going_) {
    change_speed(0);
    is_going_ = false;
  }
}

void DeviceCar::sense(CarSense sense, std::optional<double> value) {
  Sensed& sensed = senses_.at(static_cast<std::size_t>(sense));
  sensed.value = value;
  const bool is_driven = sense == CarSense::speed || sense == CarSense::distance;
  sensed.is_by_hand = !is_driven || !value;
}

/// Values not set by hand are those that the driver, or a garage, sets.
std::optional<double> DeviceCar::read(const Sensed& sensed, CarSense sense) const {
  if (sensed.is_by_hand) return sensed.value;
  const cia447::CarHardware parked = cia447::parked_car();
  switch (sense) {
    case CarSense::speed:
      return drive_.speed();
    case CarSense::distance:
      return drive_.metres();
    case CarSense::engine_revolutions:
      return driver_.engine_revolutions();
    case CarSense::tank_level:
      return parked.fuel();
    case CarSense::fuel_consumption:
      return driver_.fuel_consumption();
    case CarSense::outside_temperature:
    case CarSense::inside_temperature:
      return parked.outside_temperature();
    case CarSense::light_intensity:
      return parked.light_intensity();
    default:
      return 0;
  }
}

template <CarSense sense>
cia447::Sensor DeviceCar::sensor() {
  constexpr auto read_it = [](void* self) -> std::optional<double> {
    const auto& sensed = *static_cast<const Sensed*>(self);
    return sensed.car->read(sensed, sense);
  };
  return {read_it, &senses_.at(static_cast<std::size_t>(sense))};
}

cia447::CarHardware DeviceCar::car() {
  return {.speed = sensor<CarSense::speed>(),
          .distance = sensor<CarSense::distance>(),
          .engine_speed = sensor<CarSense::engine_revolutions>(),
          .fuel = sensor<CarSense::tank_level>(),
          .fuel_consumption = sensor<CarSense::fuel_consumption>(),
          .steering_wheel_angle = sensor<CarSense::steering_wheel_angle>(),
          .outside_temperature = sensor<CarSense::outside_temperature>(),
          .inside_temperature = sensor<CarSense::inside_temperature>(),
          .light_intensity = sensor<CarSense::light_intensity>(),
          .mirror_dimming = sensor<CarSense::mirror_dimming>(),
          .vin = callback<&DeviceCar::vin>(*this)};
}

cia447::GpsHardware DeviceCar::gps() {
  return {.read = callback<&DeviceCar::sensed_reading>(*this)};
}

cia447::GpsReading DeviceCar::sensed_reading() {
  cia447::GpsReading reading = receiver();
  for (const auto& [what, change] : gps_changes_) change(reading);
  return reading;
}

void DeviceCar::sense_gps(const std::string& what,
                          std::function<void(cia447::GpsReading&)> change) {
  gps_changes_[what] = std::move(change);
}

void DeviceCar::set_clock(CarClock clock, Duration time) {
  clock_offsets_.at(static_cast<std::size_t>(clock)) = time - since_1970();
}

Duration DeviceCar::now_utc(CarClock clock) const {
  return since_1970() + clock_offsets_.at(static_cast<std::size_t>(clock));
}

cia447::LocalTime DeviceCar::local_time() const {
  return {.seconds = std::chrono::floor<std::chrono::seconds>(now_utc(CarClock::meter)).count()};
}

cia447::GpsReading DeviceCar::receiver() const {
  cia447::GpsReading reading = drive_.receiver();
  if (record_) return reading;
  const CivilTime now(std::chrono::floor<std::chrono::milliseconds>(now_utc(CarClock::receiver)));
  const auto day = std::chrono::floor<std::chrono::days>(now);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(now - day);
  reading.date = {.year = static_cast<unsigned>(static_cast<int>(date.year())),
                  .month = static_cast<unsigned>(date.month()),
                  .day = static_cast<unsigned>(date.day())};
  reading.time = {.hour = static_cast<unsigned>(time.hours().count()),
                  .minute = static_cast<unsigned>(time.minutes().count()),
                  .second = static_cast<double>(time.seconds().count())};
  return reading;
}

cia447::NavigationHardware DeviceCar::navigation() {
  cia447::NavigationHardware hardware;
  if (places_) hardware.gazetteer = cia447::Gazetteer(places_->places());
  return hardware;
}

cia447::RealTimeClockHardware DeviceCar::clock() {
  return {.read = callback<&DeviceCar::read_chip>(*this),
          .write = callback<&DeviceCar::write_chip>(*this)};
}

std::optional<cia447::ChipTime> DeviceCar::read_chip() {
  return cia447::ChipTime{.since_1970 = now_utc(CarClock::chip), .has_date = chip_has_date_};
}

void DeviceCar::write_chip(const cia447::ChipTime& time) {
  set_clock(CarClock::chip, time.since_1970);
  chip_has_date_ = time.has_date;
}

cia447::DriverIdentificationHardware DeviceCar::reader() {
  return {.clock = {[](void*) -> std::optional<cia447::LocalTime> { return host_local_time(); },
                    nullptr},
          .knows = {}};
}

}  // namespace canvoy::tools
