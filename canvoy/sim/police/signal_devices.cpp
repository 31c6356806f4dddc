#include "canvoy/sim/police/signal_devices.hpp"

#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"

namespace canvoy::police {

void SignalDevices::add_nodes() {
  using namespace cia447;
  Site& roof = bus_.add_site();
  roof.offer(Callback<SwitchedHardware()>::to<&SignalDevices::roof_light_hardware>(*this));
  bus_.add(car::units_of<RoofBarLightKind>, roof);
  Site& sound = bus_.add_site();
  sound.offer(Callback<RoofBarSoundHardware()>::to<&SignalDevices::sound_hardware>(*this));
  sound.watch(Callback<void(RoofBarSoundUnit&, Node&)>::to<&SignalDevices::is_sound>(*this));
  sound.offer(Callback<SignalControlHardware()>::to<&SignalDevices::control_hardware>(*this));
  sound.offer(Callback<SignalControlSettings()>::to<&SignalDevices::control_settings>(*this));
  bus_.add(car::units_of<RoofBarSoundKind, SignalControlKind>, sound);
  Site& blue = bus_.add_site();
  blue.offer(Callback<SwitchedHardware()>::to<&SignalDevices::blue_light_hardware>(*this));
  blue.watch(Callback<void(BlueLightUnit&, Node&)>::to<&SignalDevices::is_blue_light>(*this));
  bus_.add(car::units_of<BlueLightKind>, blue);
}

void SignalDevices::lose_power(NodeId id) {
  if (id == roof_light_id) beacons_.power_off();
  if (id == roof_sound_id) sound_ = {};
  if (id == blue_light_id) flashers_.power_off();
}

void SignalDevices::sense(NodeId id) {
  if (id == blue_light_id) burn_lamp(lamp_is_burnt_);
}

void SignalDevices::burn_lamp(bool is_burnt) {
  constexpr auto status = cia447::place_of(cia447::blue_light_flasher_status_front_left);
  lamp_is_burnt_ = is_burnt;
  flashers_.burn_out(status.first_bit / 2U, is_burnt);
  if (!bus_.has_power(blue_light_id)) return;
  blue_light_->switching().sense(status,
                                 is_burnt ? cia447::Sensing::failure : cia447::Sensing::working);
  bus_.touched(blue_light_id);
}

void SignalDevices::step(Time now) {
  beacons_.step(now);
  flashers_.step(now);
}

cia447::SwitchedHardware SignalDevices::roof_light_hardware() {
  return {.became = Callback<void(const cia447::FieldPlace&,
                                  std::uint32_t)>::to<&SignalDevices::roof_light_became>(*this)};
}
void SignalDevices::roof_light_became(const cia447::FieldPlace& status, std::uint32_t code) {
  const bool is_on = code == static_cast<std::uint32_t>(cia447::Signal::on);
  if (status == place_of(cia447::roof_bar_light_status<"mlb1">)) beacons_.drive(0, is_on);
  if (status == place_of(cia447::roof_bar_light_status<"mlb2">)) beacons_.drive(1, is_on);
}

cia447::SwitchedHardware SignalDevices::blue_light_hardware() {
  return {.became = Callback<void(const cia447::FieldPlace&,
                                  std::uint32_t)>::to<&SignalDevices::blue_light_became>(*this)};
}
void SignalDevices::blue_light_became(const cia447::FieldPlace& status, std::uint32_t code) {
  if (sabotage_.cuts_flashers) return;
  flashers_.drive(status.first_bit / 2U, code == static_cast<std::uint32_t>(cia447::Signal::on));
}

cia447::RoofBarSoundHardware SignalDevices::sound_hardware() {
  return {.play = Callback<void(const cia447::RoofBarSound&)>::to<&SignalDevices::play>(*this)};
}
void SignalDevices::play(const cia447::RoofBarSound& sound) {
  if (!sabotage_.cuts_siren) sound_ = sound;
}

SignalControlHardware SignalDevices::control_hardware() {
  return {.sound = sound_unit_, .acted = acted_};
}
SignalControlSettings SignalDevices::control_settings() {
  return {.terminal = terminal_id,
          .roof_light = roof_light_id,
          .blue_light = blue_light_id,
          .gateway = cia447::gateway_node_id,
          .hogs_terminal = sabotage_.hogging_signals};
}

}  // namespace canvoy::police
