#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"

#include <algorithm>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr double kmh_of_metre_per_minute = 60.0 / 1000;

}  // namespace

constexpr AccessHandlers RoofBarSoundUnit::hook_calls[] = {
    after_write<&RoofBarSoundUnit::speed_written, wheel_rpm_object>};
constexpr ServiceHandlers RoofBarSoundUnit::service_calls = {.hooks = hook_calls};

RoofBarSoundUnit::RoofBarSoundUnit(CarNetwork& network, const RoofBarSoundHardware& hardware,
                                   const RoofBarSoundSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      unit_(
          network,
          {.drive = hardware.switched.drive, .became = callback<&RoofBarSoundUnit::became>(*this)},
          settings.switched),
      speed_(network, {.pdo_number = wheel_pdo_number,
                       .lost = callback<&RoofBarSoundUnit::speed_lost>(*this)}) {
  network.node().attach(service_);
}

void RoofBarSoundUnit::became(const FieldPlace& status, std::uint32_t code) {
  play();
  if (hardware_.switched.became) hardware_.switched.became(status, code);
}

void RoofBarSoundUnit::speed_written(Source source) {
  speed_.came(source);
  play();
}

void RoofBarSoundUnit::speed_lost() {
  Values(network_.node().dictionary())[wheel_rpm] = std::nullopt;
  play();
}

void RoofBarSoundUnit::play() {
  const Switching& is = unit_.switching();
  const auto code = [&is](const auto& status) { return is.actual(place_of(status)); };
  const auto sound = static_cast<AdditionalSound>(code(sound_status_roof_bar_additional_sound));
  const auto country = static_cast<CountrySound>(code(country_specific_sound_status));
  const RoofBarSound wanted = {
      .sound = sound,
      .country = sound == AdditionalSound::country_specific ? country : CountrySound::none,
      .is_fast = is.is(sound_status_roof_bar_speed, SoundSpeed::double_speed),
      .is_city = is.is(sound_status_roof_bar_city_land, SoundPlace::city),
      .is_test = is.is(sound_status_roof_bar_acoustic_test_operation, Signal::on),
      .volume = volume()};
  if (wanted == output_) return;
  output_ = wanted;
  if (hardware_.play) hardware_.play(output_);
}

/// Raw 0 is step 1 (errata Z09).
unsigned RoofBarSoundUnit::volume() const {
  const Switching& is = unit_.switching();
  double step = 1.0 + is.actual(place_of(sound_status_roof_bar_volume));
  const bool is_night = is.is(sound_status_roof_bar_volume_day_night, DayNight::night);
  if (is_night) step = std::min<double>(step, settings_.night_volume_max);
  if (is.is(sound_status_roof_bar_velocity_dependent_volume_adjustment, Signal::on)) {
    const std::optional<double> rpm = Values(network_.node().dictionary())[wheel_rpm].value();
    const double kmh = rpm.value_or(0) * settings_.wheel_circumference_m * kmh_of_metre_per_minute;
    step += kmh * settings_.step_per_kmh;
  }
  return static_cast<unsigned>(std::clamp<double>(step, 1, volume_max));
}

}  // namespace canvoy::cia447
