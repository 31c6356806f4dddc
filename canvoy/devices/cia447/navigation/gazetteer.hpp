// Finds the place of a position: the nearest one of a list. A pure function of the list, which the
// caller owns.
//
//     Gazetteer gazetteer(places);
//     const NamedPlace* here = gazetteer.nearest({48.137, 11.575});  // Munich, Marienplatz
#pragma once

#include <span>
#include <string_view>

#include "canvoy/devices/cia447/navigation/geography.hpp"

namespace canvoy::cia447 {

/// A place with its names.
struct NamedPlace {
  GeoPosition position{};      ///< where it is
  std::string_view city{};     ///< name
  std::string_view street{};   ///< name
  std::string_view country{};  ///< name

  friend constexpr bool operator==(const NamedPlace&, const NamedPlace&) = default;
};

class Gazetteer {
 public:
  /// Distance in metres from a place beyond which a position is not at it.
  static constexpr double usual_reach = 2'000;

  constexpr Gazetteer() = default;
  /// `places` must outlive this.
  constexpr explicit Gazetteer(std::span<const NamedPlace> places, double reach = usual_reach)
      : places_(places), reach_(reach) {}

  /// Null if there is none within reach. Of equally near ones, the first. Linear in the number of
  /// places.
  const NamedPlace* nearest(const GeoPosition& position) const;

 private:
  std::span<const NamedPlace> places_;
  double reach_ = usual_reach;
};

}  // namespace canvoy::cia447
