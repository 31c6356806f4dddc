// Data of a satellite receiver, in SI units and degrees: the hardware side of the GPS virtual
// device (CiA 447-3, 4.2.10). Unknown values are empty.
//
//     GpsReading reading{.fix = GpsFix::fix_3d, .latitude = 48.137, .longitude = 11.575};
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

/// A date, UTC.
struct GpsDate {
  unsigned year = 0;   ///< with its century
  unsigned month = 1;  ///< 1 to 12
  unsigned day = 1;    ///< 1 to 31

  friend constexpr bool operator==(const GpsDate&, const GpsDate&) = default;
};
/// UTC.
struct GpsTime {
  unsigned hour = 0;    ///< 0 to 23
  unsigned minute = 0;  ///< 0 to 59
  double second = 0;    ///< below 60, or 61 with a leap second

  friend constexpr bool operator==(const GpsTime&, const GpsTime&) = default;
};

struct GpsReading {
  bool has_failed = false;               ///< the receiver is faulty, and its data are invalid
  GpsFix fix = GpsFix::not_available;    ///< kind of the position
  std::optional<double> latitude = {};   ///< degrees, south below 0
  std::optional<double> longitude = {};  ///< degrees, west below 0
  std::optional<double> altitude = {};   ///< metres above the sea
  std::optional<double> velocity = {};   ///< metres per second
  std::optional<double> heading = {};    ///< degrees from north, clockwise
  std::optional<unsigned> visible_satellites = {};  ///< satellites above the horizon
  std::optional<unsigned> tracked_satellites = {};  ///< satellites used for the position
  std::optional<double> vdop =
      {};  ///< dilutions of precision: vertical, horizontal, of the position
  std::optional<double> hdop = {};   ///< horizontal dilution of precision
  std::optional<double> pdop = {};   ///< dilution of precision of the position
  std::optional<GpsDate> date = {};  ///< nothing: not known
  std::optional<GpsTime> time = {};  ///< nothing: not known

  friend constexpr bool operator==(const GpsReading&, const GpsReading&) = default;
};

}  // namespace canvoy::cia447
