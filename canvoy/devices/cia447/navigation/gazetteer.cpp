#include "canvoy/devices/cia447/navigation/gazetteer.hpp"

namespace canvoy::cia447 {

const NamedPlace* Gazetteer::nearest(const GeoPosition& position) const {
  const NamedPlace* nearest = nullptr;
  double best = reach_;
  for (const NamedPlace& place : places_) {
    if (metres_at_least(place.position, position) > best) continue;
    const double away = metres_between(place.position, position);
    if (away > best || (away == best && nearest != nullptr)) continue;
    best = away;
    nearest = &place;
  }
  return nearest;
}

}  // namespace canvoy::cia447
