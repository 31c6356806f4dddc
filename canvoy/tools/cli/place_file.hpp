// Place files for navigation systems: one place per line, `lat lon | street | city | country`
// (canvoy/devices/cia447/navigation/place_line.hpp).
//
//     PlaceFile places("munich.places");
//     NavigationHardware hardware{.gazetteer = cia447::Gazetteer(places.places())};
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/navigation/gazetteer.hpp"

namespace canvoy::tools {

/// Must outlive all users of its places.
class PlaceFile {
 public:
  /// Throws Failure if the file cannot be read, has an error (with the line), or has no places.
  explicit PlaceFile(const std::string& path);
  PlaceFile(const PlaceFile&) = delete;
  PlaceFile& operator=(const PlaceFile&) = delete;

  const std::vector<cia447::NamedPlace>& places() const { return places_; }

 private:
  std::string text_;
  std::vector<cia447::NamedPlace> places_;
};

}  // namespace canvoy::tools
