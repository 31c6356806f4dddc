#include "canvoy/worlds/police/signal_devices.hpp"

#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"

namespace canvoy::police {

void SignalDevices::add_nodes() {
  using namespace cia447;
  Environment& roof = bus_.add_site();
  roof.provide(callback<&SignalDevices::roof_light_hardware>(*this));
  bus_.add(car::units_of<RoofBarLightKind>, roof);
  Environment& sound = bus_.add_site();
  sound.provide(callback<&SignalDevices::sound_hardware>(*this));
  sound.watch(sound_unit_);
  sound.provide(callback<&SignalDevices::control_hardware>(*this));
  sound.provide(callback<&SignalDevices::control_settings>(*this));
  bus_.add(car::units_of<RoofBarSoundKind, SignalControlKind>, sound);
  Environment& blue = bus_.add_site();
  blue.provide(callback<&SignalDevices::blue_light_hardware>(*this));
  blue.watch(blue_light_);
  bus_.add(car::units_of<BlueLightKind>, blue);
}

void SignalDevices::lose_power(NodeId id) {
  if (id == roof_light_id) {
    beacons_.power_off();
    work_lights_ = 0;
  }
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
  return {.became = callback<&SignalDevices::roof_light_became>(*this)};
}
void SignalDevices::roof_light_became(const cia447::FieldPlace& status, std::uint32_t code) {
  const bool is_on = code == static_cast<std::uint32_t>(cia447::Signal::on);
  const auto beacons = Callback<void(unsigned, bool)>::to<&SignalDevices::drive_beacon>(*this);
  if (status == place_of(cia447::roof_bar_light_status<"mlb1">)) drive_blue(beacons, 0, is_on);
  if (status == place_of(cia447::roof_bar_light_status<"mlb2">)) drive_blue(beacons, 1, is_on);
  constexpr cia447::FieldPlace work_lights[] = {place_of(cia447::light_status_roof_bar_search_lamp),
                                                place_of(cia447::roof_bar_light_status<"alr1">),
                                                place_of(cia447::roof_bar_light_status<"all1">)};
  for (unsigned i = 0; i < std::size(work_lights); ++i) {
    if (status != work_lights[i] || sabotage_.cuts_work_lights) continue;
    work_lights_ = (work_lights_ & ~(1U << i)) | (is_on ? 1U : 0U) << i;
  }
}

cia447::SwitchedHardware SignalDevices::blue_light_hardware() {
  return {.became = callback<&SignalDevices::blue_light_became>(*this)};
}
void SignalDevices::blue_light_became(const cia447::FieldPlace& status, std::uint32_t code) {
  if (sabotage_.cuts_flashers) return;
  drive_blue(callback<&SignalDevices::drive_flasher>(*this), status.first_bit / 2U,
             code == static_cast<std::uint32_t>(cia447::Signal::on));
}

void SignalDevices::drive_blue(Callback<void(unsigned, bool)> lamps, unsigned lamp, bool is_on) {
  if (!sabotage_.slow_blue_light) return lamps(lamp, is_on);
  World& world = bus_.world();
  world.at(world.now() + 1s, [lamps, lamp, is_on](Time) { lamps(lamp, is_on); });
}

cia447::RoofBarSoundHardware SignalDevices::sound_hardware() {
  return {.play = callback<&SignalDevices::play>(*this)};
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
