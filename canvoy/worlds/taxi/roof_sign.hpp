// The lamps of the sign on the roof of a taxi, as the tariff display drives them: what people at
// the road see (CiA 447-3, 4.2.16.4).
//
//     RoofSign sign(sabotage);
//     environment.provide(Callback<cia447::TariffDisplayHardware()>::to<&RoofSign::hardware>(sign));
//     if (sign.is_vacant()) ...
#pragma once

#include <array>

#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"

namespace canvoy::taxi {

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
    return {.drive = Callback<void(unsigned, cia447::Lamp)>::to<&RoofSign::drive>(*this)};
  }
  /// Switches all off: call it when the display has no power.
  void darken() {
    lamps_.fill(cia447::Lamp::off);
    is_vacant_ = false;
    has_alarm_ = false;
  }

  /// What people see.
  const Lamps& lamps() const { return lamps_; }
  /// True while the light for a vacant taxi is on.
  bool is_vacant() const { return is_vacant_; }
  /// True while the emergency light blinks.
  bool has_alarm() const { return has_alarm_; }

 private:
  void drive(unsigned lamp, cia447::Lamp wanted) {
    constexpr unsigned vacant = 2;
    constexpr unsigned emergency = 3;
    if (sabotage_.cuts_sign) return;
    if (lamp >= 1 && lamp <= lamps_.size()) lamps_[lamp - 1] = wanted;
    if (lamp == vacant) is_vacant_ = wanted == cia447::Lamp::on;
    if (lamp == emergency) has_alarm_ = wanted == cia447::Lamp::blinking;
  }

  const Sabotage& sabotage_;
  Lamps lamps_{};
  bool is_vacant_ = false;
  bool has_alarm_ = false;
};

}  // namespace canvoy::taxi
