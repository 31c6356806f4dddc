#include "canvoy/worlds/police/police_car.hpp"

#include <cmath>
#include <cstdio>

#include "canvoy/devices/cia447/emergency_fresh_air/emergency_fresh_air_unit.hpp"
#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::police {

namespace {

using namespace cia447;

constexpr std::size_t digits_max = 3;

}  // namespace

constexpr ServiceHandlers NavigationControl::service_calls = {
    .reset = method<&NavigationControl::reset>};
constexpr AccessHandlers NavigationControl::greedy_hooks[] = {
    after_write<&NavigationControl::key_written, number_pad_user_interaction_object>};
constexpr ServiceHandlers NavigationControl::greedy_calls = {.hooks = greedy_hooks};

NavigationControl::NavigationControl(CarNetwork& network, const NavigationControlHardware& hardware,
                                     const NavigationControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      terminal_(network, {.terminal = settings.terminal}),
      menu_(network, terminal_, title_of(Client::navigation)) {
  terminal_.on_number_key(callback<&NavigationControl::number_pressed>(*this));
  network.node().attach(service_);
  if (settings.is_greedy) network.node().attach(greed_);
}

void NavigationControl::reset(ResetScope) {
  menu_.close();
  typed_.clear();
}

void NavigationControl::press_button() {
  if (menu_.is_open()) return;
  typed_.clear();
  menu_.open("to ?");
}

void NavigationControl::number_pressed(NumberPadKey key) {
  if (hardware_.acted) {
    hardware_.acted({.client = Client::navigation, .key = static_cast<std::uint8_t>(key)});
  }
  if (!menu_.is_open()) return;
  const int digit = digit_of(key);
  if (key == NumberPadKey::star) {
    typed_.clear();
  } else if (digit >= 0 && typed_.size() < digits_max) {
    typed_ += static_cast<char>('0' + digit);
  } else if (key == NumberPadKey::hash && !typed_.empty()) {
    const auto destination = static_cast<unsigned>(std::stoul(typed_));
    const double metres = hardware_.guide ? hardware_.guide(destination) : 0;
    char distance[16];
    std::snprintf(distance, sizeof distance, "%.1f km", metres / 1000);
    return menu_.finish("to " + typed_ + ": " + distance, 3s);
  }
  menu_.show("to " + (typed_.empty() ? "?" : typed_));
}

void NavigationControl::key_written(const Entry&, Source) {
  const auto key = static_cast<NumberPadKey>(
      read_field(network_.node().dictionary(), place_of(number_pad_user_interaction)));
  if (key != NumberPadKey::none && !menu_.is_open()) number_pressed(key);
}

namespace {

constexpr double metres_a_degree = 111'200;
constexpr cia447::GeoPosition station = {48.137, 11.575};

}  // namespace

void NavigationDevice::add_node() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.provide(callback<&NavigationDevice::gps_hardware>(*this));
  environment.provide(callback<&NavigationDevice::hardware>(*this));
  environment.watch(unit_);
  environment.provide(callback<&NavigationDevice::control_hardware>(*this));
  environment.provide(callback<&NavigationDevice::control_settings>(*this));
  environment.watch(control_);
  bus_.add(car::units_of<GpsKind, NavigationKind, NavigationControlKind>, environment);
}

void NavigationDevice::press_button() {
  if (bus_.has_power(navigation_id)) control_->press_button();
  bus_.touched(navigation_id);
}

cia447::GpsHardware NavigationDevice::gps_hardware() {
  return {.read = callback<&NavigationDevice::gps_reading>(*this)};
}
cia447::GpsReading NavigationDevice::gps_reading() {
  return {.fix = cia447::GpsFix::fix_3d,
          .latitude = here().latitude,
          .longitude = station.longitude,
          .altitude = 519,
          .velocity = drive_.speed(),
          .heading = 0,
          .visible_satellites = 11,
          .tracked_satellites = 9};
}

cia447::GeoPosition NavigationDevice::here() const {
  return {station.latitude + drive_.metres() / metres_a_degree, station.longitude};
}
double NavigationDevice::road(const cia447::GeoPosition& from, const cia447::GeoPosition& to) {
  return std::abs(to.latitude - from.latitude) * metres_a_degree;
}

cia447::NavigationHardware NavigationDevice::hardware() {
  using cia447::GeoPosition;
  cia447::NavigationHardware hardware;
  hardware.position = callback<&NavigationDevice::position>(*this);
  hardware.road = callback<&NavigationDevice::road>(*this);
  return hardware;
}

NavigationControlHardware NavigationDevice::control_hardware() {
  return {.acted = acted_, .guide = callback<&NavigationDevice::guide>(*this)};
}
NavigationControlSettings NavigationDevice::control_settings() {
  return {.terminal = terminal_id, .is_greedy = sabotage_.greedy_navigation};
}

double NavigationDevice::guide(unsigned destination) {
  if (destination_ != destination) return 0;
  const cia447::GeoPosition scene = {station.latitude + scene_at_ / metres_a_degree,
                                     station.longitude};
  unit_->select(scene);
  return road(here(), scene);
}

void TerminalDevice::add_node() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.provide(callback<&TerminalDevice::hardware>(*this));
  environment.watch(unit_);
  bus_.add(car::units_of<TerminalKind>, environment);
}

void TerminalDevice::lose_power(NodeId id) {
  if (id != terminal_id) return;
  title_.clear();
  text_1_.clear();
  text_2_.clear();
}

void TerminalDevice::press_emergency_key() {
  if (sabotage_.cuts_emergency_key) return;
  const auto set = [this](bool is_pressed) {
    unit_->press_emergency_key(is_pressed);
    bus_.touched(terminal_id);
  };
  set(true);
  bus_.world().at(bus_.world().now() + key_time, [set](Time) { set(false); });
}

std::optional<Client> TerminalDevice::client() const {
  for (unsigned i = 0; i < client_count; ++i) {
    if (title_ == title_of(Client(i))) return Client(i);
  }
  return std::nullopt;
}

cia447::TerminalHardware TerminalDevice::hardware() {
  cia447::TerminalHardware hardware;
  hardware.show = callback<&TerminalDevice::show>(*this);
  return hardware;
}

void TerminalDevice::show(const cia447::DisplayContent& content) {
  if (content.display == cia447::TerminalDisplay::display_2) {
    if (!sabotage_.cuts_display) text_2_ = content.is_on ? content.text : "";
    return;
  }
  title_ = content.is_on ? content.title : "";
  text_1_ = content.is_on ? content.text : "";
}

PoliceCar::PoliceCar(car::CarBus& bus, const PoliceOptions& options, const Acted& acted,
                     EventLog<PoliceEvent>& events)
    : bus_(bus),
      options_(options),
      supply_(bus, options, events),
      terminal_(bus, options.sabotage),
      signals_(bus, options.sabotage, acted),
      radio_(bus, options.sabotage, supply_, acted, events),
      navigation_(bus, drive_, options.sabotage, acted) {
  add_nodes();
}

void PoliceCar::add_nodes() {
  using namespace cia447;
  Environment& car = bus_.add_site();
  car.provide(callback<&PoliceCar::hardware>(*this));
  car.provide(callback<&car::CarBus::memory>(bus_));
  car.provide(callback<&car::CarBus::master_settings>(bus_));
  car.watch(gateway_);
  bus_.add(car::units_of<IvnGatewayKind>, car);
  terminal_.add_node();
  signals_.add_nodes();
  radio_.add_nodes();
  supply_.add_node();
  radio_.add_inputs();
  navigation_.add_node();
  if (options_.is_armoured) {
    Environment& armour = bus_.add_site();
    bus_.add(car::units_of<FireExtinguishingKind>, armour);
    bus_.add(car::units_of<EmergencyFreshAirKind>, armour);
  }
  bus_.complete();
}

void PoliceCar::power(car::CarNode& node, bool is_on) {
  const NodeId id = node.place().id;
  terminal_.lose_power(id);
  signals_.lose_power(id);
  radio_.lose_power(id);
  supply_.lose_power(id);
  is_making_gateway_ = id == cia447::gateway_node_id;
  node.power(is_on);
  is_making_gateway_ = false;
  if (cia447::CarMaster* master = node.device().master()) master->on_event(told_);
  if (!node.is_powered()) return;
  if (id == cia447::gateway_node_id) report_car();
  signals_.sense(id);
  radio_.sense(id);
  supply_.sense(id);
}

/// Reports the state of the car to the gateway.
void PoliceCar::report_car() {
  const cia447::Signal ignited = is_ignited_ ? cia447::Signal::yes : cia447::Signal::no;
  gateway_->report(cia447::ignition_switch_status_accessory, ignited);
  gateway_->report(cia447::ignition_switch_status_on, ignited);
  gateway_->report(cia447::central_locking_system_status,
                   is_locked_ ? cia447::Locking::external : cia447::Locking::unlocked);
  bus_.touched(cia447::gateway_node_id);
}

void PoliceCar::turn_ignition(bool is_on) {
  World& world = bus_.world();
  is_ignited_ = is_on;
  if (!is_on) ignition_off_at_ = world.now();
  world.at(world.now(), [this](Time) {
    if (bus_.has_power(cia447::gateway_node_id)) report_car();
  });
}

void PoliceCar::turn_key(bool is_locked) {
  is_locked_ = is_locked;
  if (bus_.has_power(cia447::gateway_node_id)) report_car();
}

cia447::CarHardware PoliceCar::hardware() {
  cia447::CarHardware car = cia447::parked_car();
  car.speed = cia447::Sensor::to<&PoliceCar::speed>(*this);
  car.distance = cia447::Sensor::to<&PoliceCar::distance>(*this);
  car.switched.became = callback<&PoliceCar::car_became>(*this);
  return car;
}

void PoliceCar::car_became(const cia447::FieldPlace& status, std::uint32_t code) {
  const bool is_lock = status == place_of(cia447::central_locking_system_status);
  if (!is_lock || is_making_gateway_ || options_.sabotage.cuts_locks) return;
  is_locked_ = code != static_cast<std::uint32_t>(cia447::Locking::unlocked);
}

Surroundings PoliceCar::around() const {
  return {.sound = signals_.sound(),
          .radio_has_power = supply_.radio_has_power(),
          .periphery_has_power = supply_.periphery_has_power(),
          .radio_is_on = radio_.is_on(),
          .radio_transmits = radio_.transmits(),
          .title = terminal_.title(),
          .text_1 = terminal_.text_1(),
          .text_2 = terminal_.text_2(),
          .is_locked = is_locked_};
}

}  // namespace canvoy::police
