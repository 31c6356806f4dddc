// The devices of a police car, what they find there, and what the crew's hands do with them.
#include <cmath>

#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/sim/police/police_network.hpp"

namespace canvoy::police {

namespace {

using namespace cia447;

constexpr NodeId gateway_id = gateway_node_id;
constexpr double metres_a_degree = 111'200;
constexpr GeoPosition station = {48.137, 11.575};
constexpr Duration key_time = 200ms;

}  // namespace

void PoliceNetwork::add(std::span<const CarUnit* const> units) {
  const auto id = static_cast<NodeId>(nodes_.size() + 1);
  const car::CarNode::Place place = {.name = device_names.at(nodes_.size()),
                                     .id = id,
                                     .serial_number = 2000U + id,
                                     // Whom a real gateway calls how, nobody knows.
                                     .is_named_by_lss = id != gateway_id && is_played(gateway_id),
                                     .is_played = is_played(id)};
  nodes_.push_back(std::make_unique<car::CarNode>(world_, bus_, units, place, sites_.back()));
}

/// The gateway knows its devices from before: so they have the same node-IDs in each run.
void PoliceNetwork::add_nodes() {
  Site& car = add_site();
  car.offer(Callback<CarHardware()>::to<&PoliceNetwork::car_hardware>(*this));
  car.offer(Callback<CarMemory()>::to<&PoliceNetwork::memory>(*this));
  car.watch(Callback<void(IvnGatewayUnit&, Node&)>::to<&PoliceNetwork::is_gateway>(*this));
  add(car::units_of<IvnGatewayKind>);
  add_terminal();
  add_lights();
  add_radio();
  add_others();
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    known_.addresses.at(i - 1) = nodes_[i]->address();
    known_.is_known.at(i - 1) = true;
  }
  for (const auto& node : nodes_) bus_watch_.name(node->controller(), node->place().id);
}

void PoliceNetwork::add_terminal() {
  Site& site = add_site();
  site.offer(Callback<TerminalHardware()>::to<&PoliceNetwork::terminal_hardware>(*this));
  site.watch(Callback<void(TerminalUnit&, Node&)>::to<&PoliceNetwork::is_terminal>(*this));
  add(car::units_of<TerminalKind>);
}

void PoliceNetwork::add_lights() {
  Site& roof = add_site();
  roof.offer(Callback<SwitchedHardware()>::to<&PoliceNetwork::roof_light_hardware>(*this));
  add(car::units_of<RoofBarLightKind>);
  Site& sound = add_site();
  sound.offer(Callback<RoofBarSoundHardware()>::to<&PoliceNetwork::sound_hardware>(*this));
  sound.watch(Callback<void(RoofBarSoundUnit&, Node&)>::to<&PoliceNetwork::is_sound>(*this));
  sound.offer(Callback<SignalControlHardware()>::to<&PoliceNetwork::signal_hardware>(*this));
  sound.offer(Callback<SignalControlSettings()>::to<&PoliceNetwork::signal_settings>(*this));
  add(car::units_of<RoofBarSoundKind, SignalControlKind>);
  Site& blue = add_site();
  blue.offer(Callback<SwitchedHardware()>::to<&PoliceNetwork::blue_light_hardware>(*this));
  blue.watch(Callback<void(BlueLightUnit&, Node&)>::to<&PoliceNetwork::is_blue_light>(*this));
  add(car::units_of<BlueLightKind>);
}

void PoliceNetwork::add_radio() {
  Site& radio = add_site();
  radio.offer(Callback<SwitchedHardware()>::to<&PoliceNetwork::radio_hardware>(*this));
  radio.watch(Callback<void(RadioUnit&, Node&)>::to<&PoliceNetwork::is_radio>(*this));
  radio.offer(Callback<RadioControlHardware()>::to<&PoliceNetwork::radio_control_hardware>(*this));
  radio.offer(Callback<RadioControlSettings()>::to<&PoliceNetwork::radio_control_settings>(*this));
  radio.watch(Callback<void(RadioControl&, Node&)>::to<&PoliceNetwork::is_radio_control>(*this));
  add(car::units_of<RadioKind, RadioControlKind>);
  Site& audio = add_site();
  audio.offer(Callback<AudioSwitchHardware()>::to<&PoliceNetwork::audio_hardware>(*this));
  add(car::units_of<AudioSwitchKind>);
  Site& hands_free = add_site();
  hands_free.offer(Callback<HandsFreeHardware()>::to<&PoliceNetwork::hands_free_hardware>(*this));
  hands_free.watch(Callback<void(HandsFreeUnit&, Node&)>::to<&PoliceNetwork::is_hands_free>(*this));
  add(car::units_of<HandsFreeKind>);
}

void PoliceNetwork::add_others() {
  Site& supply = add_site();
  supply.offer(Callback<PowerSupplyHardware()>::to<&PoliceNetwork::supply_hardware>(*this));
  supply.offer(Callback<PowerSupplySettings()>::to<&PoliceNetwork::supply_settings>(*this));
  supply.watch(Callback<void(PowerSupplyUnit&, Node&)>::to<&PoliceNetwork::is_supply>(*this));
  add(car::units_of<PowerSupplyKind>);
  Site& inputs = add_site();
  inputs.watch(Callback<void(DiscreteInputsUnit&, Node&)>::to<&PoliceNetwork::is_inputs>(*this));
  add(car::units_of<DiscreteInputsKind>);
  Site& navigation = add_site();
  navigation.offer(Callback<GpsHardware()>::to<&PoliceNetwork::gps_hardware>(*this));
  navigation.offer(Callback<NavigationHardware()>::to<&PoliceNetwork::navigation_hardware>(*this));
  navigation.watch(
      Callback<void(NavigationUnit&, Node&)>::to<&PoliceNetwork::is_navigation>(*this));
  navigation.offer(
      Callback<NavigationControlHardware()>::to<&PoliceNetwork::navigation_control_hardware>(
          *this));
  navigation.offer(
      Callback<NavigationControlSettings()>::to<&PoliceNetwork::navigation_control_settings>(
          *this));
  navigation.watch(
      Callback<void(NavigationControl&, Node&)>::to<&PoliceNetwork::is_navigation_control>(*this));
  add(car::units_of<GpsKind, NavigationKind, NavigationControlKind>);
}

// Power.

void PoliceNetwork::power(car::CarNode& node, bool is_on) {
  const NodeId id = node.place().id;
  lost_power(id);
  is_making_gateway_ = id == gateway_id;
  node.power(is_on);
  is_making_gateway_ = false;
  if (CarMaster* master = node.device().master()) {
    master->on_event(Callback<void(const CarEvent&)>::to<&PoliceNetwork::car_event>(*this));
  }
  if (!node.is_powered()) return;
  // What a device senses when it gets power.
  if (id == gateway_id) report_car();
  if (id == blue_light_id) burn_lamp(is_present(FaultKind::burnt_lamp));
  if (id == inputs_id && around_.handset_is_pressed) press_handset(true);
  if (id == power_supply_id && is_present(FaultKind::overload)) {
    supply_->report_overload(Supply::radio, true);
  }
}

/// What a device does that has no power.
void PoliceNetwork::lost_power(NodeId id) {
  switch (id) {
    case terminal_id:
      around_.title.clear();
      around_.text_1.clear();
      around_.text_2.clear();
      break;
    case roof_light_id:
      around_.beacons.power_off();
      break;
    case roof_sound_id:
      around_.sound = {};
      break;
    case blue_light_id:
      around_.flashers.power_off();
      break;
    case radio_id:
      around_.radio_is_on = around_.radio_transmits = false;
      break;
    case audio_switch_id:
      around_.wires = {};
      break;
    case hands_free_id:
      around_.led_is_lit = false;
      break;
    case power_supply_id:
      switch_power(Supply::radio, false);
      switch_power(Supply::periphery, false);
      break;
    default:
      break;
  }
}

/// The gateway hears from the car how it is.
void PoliceNetwork::report_car() {
  const Signal ignited = crew_.is_ignited() ? Signal::yes : Signal::no;
  gateway_->report(ignition_switch_status_accessory, ignited);
  gateway_->report(ignition_switch_status_on, ignited);
  gateway_->report(central_locking_system_status,
                   around_.is_locked ? Locking::external : Locking::unlocked);
  touched(gateway_id);
}

// The crew's hands.

CrewHands PoliceNetwork::crew_hands() {
  return {.press = [this](FunctionKey key) { press(key); },
          .press_handset = [this](bool is_pressed) { lift_handset(is_pressed); },
          .press_hands_free = [this] { press_hands_free(); },
          .sees_led =
              [this] {
                return talks_are_played() ? around_.led_is_lit
                                          : crew_.activity() == Activity::conversing;
              },
          .turn_ignition = [this](bool is_on) { turn_ignition(is_on); },
          .turn_key = [this](bool is_locked) { turn_key(is_locked); },
          .look = [this] { return look(); }};
}

TerminalHands PoliceNetwork::terminal_hands() {
  return {.open = [this](Client client) { open(client); },
          .press = [this](Client client, NumberPadKey key) { press(client, key); },
          .title = [this] { return around_.title; },
          .text = [this] { return around_.text_1; }};
}

void PoliceNetwork::open(Client client) {
  switch (client) {
    case Client::signals:
      return press(SignalControl::sound_key);
    case Client::radio:
      if (has_power(radio_id)) radio_control_->press_button();
      return touched(radio_id);
    case Client::navigation:
      if (has_power(navigation_id)) navigation_control_->press_button();
      return touched(navigation_id);
  }
}

void PoliceNetwork::press(Client client, NumberPadKey key) {
  if (!has_power(terminal_id)) return;
  ++counted_.keys;
  referee_.pressed({.client = client, .key = static_cast<std::uint8_t>(key)}, is_excused(now()));
  terminal_->press(key);
  touched(terminal_id);
  world_.at(now() + key_time, [this, key](Time) {
    terminal_->release(key);
    touched(terminal_id);
  });
}

void PoliceNetwork::press(FunctionKey key) {
  if (!has_power(terminal_id)) return;
  ++counted_.keys;
  referee_.pressed({Client::signals, true, static_cast<std::uint8_t>(key)}, is_excused(now()));
  terminal_->press(key);
  touched(terminal_id);
  world_.at(now() + key_time, [this, key](Time) {
    terminal_->release(key);
    touched(terminal_id);
  });
}

void PoliceNetwork::lift_handset(bool is_pressed) {
  around_.handset_is_pressed = is_pressed;
  const Duration late = options_.sabotage.slow_handset && is_pressed ? 4s : 0s;
  world_.at(now() + late, [this](Time) { press_handset(around_.handset_is_pressed); });
}

/// The contact.
void PoliceNetwork::press_handset(bool is_pressed) {
  if (!has_power(inputs_id)) return;
  inputs_->switching().report(discrete_inputs_status_ptt_di, is_pressed ? Signal::on : Signal::off);
  touched(inputs_id);
}

void PoliceNetwork::press_hands_free() {
  if (!has_power(hands_free_id)) return;
  hands_free_->press_key(true);
  touched(hands_free_id);
  world_.at(now() + key_time, [this](Time) {
    hands_free_->press_key(false);
    touched(hands_free_id);
  });
}

void PoliceNetwork::turn_ignition(bool is_on) {
  if (!is_on) ignition_off_at_ = now();
  // The crew knows already that it turns the key; the gateway hears it of the car.
  world_.at(now(), [this](Time) {
    if (has_power(gateway_id)) report_car();
  });
}

void PoliceNetwork::turn_key(bool is_locked) {
  around_.is_locked = is_locked;
  if (has_power(gateway_id)) report_car();
}

// What the devices find.

CarHardware PoliceNetwork::car_hardware() {
  CarHardware car = parked_car();
  car.speed = Sensor::to<&PoliceNetwork::speed>(*this);
  car.distance = Sensor::to<&PoliceNetwork::distance>(*this);
  car.switched.became =
      Callback<void(const FieldPlace&, std::uint32_t)>::to<&PoliceNetwork::car_became>(*this);
  return car;
}

void PoliceNetwork::car_became(const FieldPlace& status, std::uint32_t code) {
  const bool is_lock = status == place_of(central_locking_system_status);
  if (!is_lock || is_making_gateway_ || options_.sabotage.cuts_locks) return;
  around_.is_locked = code != static_cast<std::uint32_t>(Locking::unlocked);
}

CarMemory PoliceNetwork::memory() {
  return {.load = Callback<KnownDevices()>::to<&PoliceNetwork::known>(*this),
          .store = Callback<void(const KnownDevices&)>::to<&PoliceNetwork::keep>(*this)};
}

TerminalHardware PoliceNetwork::terminal_hardware() {
  TerminalHardware hardware;
  hardware.show = Callback<void(const DisplayContent&)>::to<&PoliceNetwork::show>(*this);
  return hardware;
}

void PoliceNetwork::show(const DisplayContent& content) {
  if (content.display == TerminalDisplay::display_2) {
    if (!options_.sabotage.cuts_display) around_.text_2 = content.is_on ? content.text : "";
    return;
  }
  around_.title = content.is_on ? content.title : "";
  around_.text_1 = content.is_on ? content.text : "";
}

SwitchedHardware PoliceNetwork::roof_light_hardware() {
  return {
      .became =
          Callback<void(const FieldPlace&, std::uint32_t)>::to<&PoliceNetwork::roof_light_became>(
              *this)};
}
void PoliceNetwork::roof_light_became(const FieldPlace& status, std::uint32_t code) {
  const bool is_on = code == static_cast<std::uint32_t>(Signal::on);
  if (status == place_of(roof_bar_light_status<"mlb1">)) around_.beacons.drive(0, is_on);
  if (status == place_of(roof_bar_light_status<"mlb2">)) around_.beacons.drive(1, is_on);
}

SwitchedHardware PoliceNetwork::blue_light_hardware() {
  return {
      .became =
          Callback<void(const FieldPlace&, std::uint32_t)>::to<&PoliceNetwork::blue_light_became>(
              *this)};
}
void PoliceNetwork::blue_light_became(const FieldPlace& status, std::uint32_t code) {
  if (options_.sabotage.cuts_flashers) return;
  around_.flashers.drive(status.first_bit / 2U, code == static_cast<std::uint32_t>(Signal::on));
}

RoofBarSoundHardware PoliceNetwork::sound_hardware() {
  return {.play = Callback<void(const RoofBarSound&)>::to<&PoliceNetwork::play>(*this)};
}
void PoliceNetwork::play(const RoofBarSound& sound) {
  if (!options_.sabotage.cuts_siren) around_.sound = sound;
}

SignalControlHardware PoliceNetwork::signal_hardware() {
  return {.sound = sound_, .acted = Acted::to<&PoliceNetwork::acted>(*this)};
}
SignalControlSettings PoliceNetwork::signal_settings() {
  return {.terminal = terminal_id,
          .roof_light = roof_light_id,
          .blue_light = blue_light_id,
          .gateway = gateway_id,
          .hogs_terminal = options_.sabotage.hogging_signals};
}

SwitchedHardware PoliceNetwork::radio_hardware() {
  return {.became =
              Callback<void(const FieldPlace&, std::uint32_t)>::to<&PoliceNetwork::radio_became>(
                  *this)};
}
void PoliceNetwork::radio_became(const FieldPlace& status, std::uint32_t code) {
  const bool is_on = code == static_cast<std::uint32_t>(Signal::on);
  if (status == place_of(radio_device_status_power)) around_.radio_is_on = is_on;
  if (status != place_of(radio_device_status_transmit_push_to_talk)) return;
  around_.radio_transmits = is_on || (around_.radio_transmits && options_.sabotage.sticking_relay);
}

RadioControlHardware PoliceNetwork::radio_control_hardware() {
  return {.radio = radio_,
          .acted = Acted::to<&PoliceNetwork::acted>(*this),
          .send_status = Callback<void(int)>::to<&PoliceNetwork::send_status>(*this)};
}
RadioControlSettings PoliceNetwork::radio_control_settings() {
  return {.terminal = terminal_id,
          .audio_switch = audio_switch_id,
          .hands_free = hands_free_id,
          .handset = inputs_id};
}
void PoliceNetwork::send_status(int status) {
  if (!around_.radio_has_power || !around_.radio_is_on) return;
  ++counted_.statuses;
  note(now(), StatusSent{status});
}

AudioSwitchHardware PoliceNetwork::audio_hardware() {
  return {.connect =
              Callback<void(unsigned, unsigned, std::uint8_t)>::to<&PoliceNetwork::connect>(*this)};
}
void PoliceNetwork::connect(unsigned input, unsigned output, std::uint8_t gain) {
  around_.wires.at(input).at(output) = gain != 0;
}

HandsFreeHardware PoliceNetwork::hands_free_hardware() {
  return {.show_led = Callback<void(bool)>::to<&PoliceNetwork::show_led>(*this), .mute = {}};
}

PowerSupplyHardware PoliceNetwork::supply_hardware() {
  return {.switch_power = Callback<void(Supply, bool)>::to<&PoliceNetwork::switch_power>(*this)};
}
void PoliceNetwork::switch_power(Supply supply, bool is_on) {
  const bool is_radio = supply == Supply::radio;
  bool& has_power = is_radio ? around_.radio_has_power : around_.periphery_has_power;
  if (has_power == is_on || (!is_on && is_radio && options_.sabotage.welded_supply)) return;
  has_power = is_on;
  note(now(), PowerSwitched{is_radio, is_on});
}

GpsHardware PoliceNetwork::gps_hardware() {
  return {.read = Callback<GpsReading()>::to<&PoliceNetwork::gps_reading>(*this)};
}
GpsReading PoliceNetwork::gps_reading() {
  return {.fix = GpsFix::fix_3d,
          .latitude = here().latitude,
          .longitude = station.longitude,
          .altitude = 519,
          .velocity = drive_.speed(),
          .heading = 0,
          .visible_satellites = 11,
          .tracked_satellites = 9};
}

GeoPosition PoliceNetwork::here() const {
  return {station.latitude + drive_.metres() / metres_a_degree, station.longitude};
}
double PoliceNetwork::road(const GeoPosition& from, const GeoPosition& to) {
  return std::abs(to.latitude - from.latitude) * metres_a_degree;
}
NavigationHardware PoliceNetwork::navigation_hardware() {
  NavigationHardware hardware;
  hardware.position = Callback<std::optional<GeoPosition>()>::to<&PoliceNetwork::position>(*this);
  hardware.road =
      Callback<double(const GeoPosition&, const GeoPosition&)>::to<&PoliceNetwork::road>(*this);
  return hardware;
}
NavigationControlHardware PoliceNetwork::navigation_control_hardware() {
  return {.acted = Acted::to<&PoliceNetwork::acted>(*this),
          .guide = Callback<double(unsigned)>::to<&PoliceNetwork::guide>(*this)};
}
NavigationControlSettings PoliceNetwork::navigation_control_settings() {
  return {.terminal = terminal_id, .is_greedy = options_.sabotage.greedy_navigation};
}

/// The number of a call leads to its scene; of others the navigation knows nothing.
double PoliceNetwork::guide(unsigned destination) {
  const auto& calls = crew_.calls();
  if (calls.empty() || calls.back().destination != destination) return 0;
  const GeoPosition scene = {station.latitude + scene_at_ / metres_a_degree, station.longitude};
  navigation_->select(scene);
  return road(here(), scene);
}

}  // namespace canvoy::police
