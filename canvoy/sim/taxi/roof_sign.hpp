// The lamps of the sign on the roof of a taxi, as the tariff display drives them (CiA 447-3,
// 4.2.16.4): what people at the road see.
//
//     RoofSign sign(sabotage);
//     site.offer(Callback<cia447::TariffDisplayHardware()>::to<&RoofSign::hardware>(sign));
//     if (sign.is_vacant()) ...
#pragma once

#include <array>

#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/sim/taxi/taxi_options.hpp"

namespace canvoy::taxi {

class RoofSign {
 public:
  using Lamps = std::array<cia447::Lamp, cia447::tariff_lamps_max>;

  /// It must outlive this.
  explicit RoofSign(const Sabotage& sabotage) : sabotage_(sabotage) {}
  RoofSign(const RoofSign&) = delete;
  RoofSign& operator=(const RoofSign&) = delete;

  /// It must not outlive this.
  cia447::TariffDisplayHardware hardware() {
    return {.drive = Callback<void(unsigned, cia447::Lamp)>::to<&RoofSign::drive>(*this)};
  }
  /// The display has no power.
  void darken() {
    lamps_.fill(cia447::Lamp::off);
    is_vacant_ = false;
  }

  const Lamps& lamps() const { return lamps_; }
  /// The light for a vacant taxi is on.
  bool is_vacant() const { return is_vacant_; }

 private:
  void drive(unsigned lamp, cia447::Lamp wanted) {
    constexpr unsigned vacant = 2;
    if (sabotage_.cuts_sign) return;
    if (lamp >= 1 && lamp <= lamps_.size()) lamps_[lamp - 1] = wanted;
    if (lamp == vacant) is_vacant_ = wanted == cia447::Lamp::on;
  }

  const Sabotage& sabotage_;
  Lamps lamps_{};
  bool is_vacant_ = false;
};

}  // namespace canvoy::taxi
