// A real drive as a satellite receiver recorded it (NMEA 0183): how fast the car was, and what the
// receiver said.
//
//     const DriveRecord record = read_drive_record(text);
//     if (!record.is_usable()) tell(record.counts);
//     Drive drive(&record);
//
// Times are those of RMC and GGA; speeds those of RMC and VTG, or where a receiver tells none, of
// its positions. Where the fix is lost, as in a tunnel, the speed goes evenly from the last one to
// the next. Sentences that are broken are counted and passed over.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/gps/nmea.hpp"

namespace canvoy::car {

struct DriveRecord {
  /// m/s: faster, and the receiver is wrong.
  static constexpr double fastest = 80;
  /// m/s: what a receiver says of a car that stands.
  static constexpr double standing = 0.3;
  /// Where a recorder was off for longer, the drive goes on a second later.
  static constexpr Duration gap_max = 10min;
  /// A car that stands for so long has arrived: one drives on after a red light.
  static constexpr Duration arrival = 2min;

  struct Sample {
    Duration at{};     ///< since the first
    double speed = 0;  ///< m/s
  };
  /// All lines of one second, or how often the receiver speaks.
  struct Said {
    Duration at{};
    std::size_t begin = 0;  ///< in the text
    std::size_t end = 0;
  };
  /// From a departure to an arrival.
  struct Leg {
    Duration begin{};
    Duration end{};
  };
  struct Counts {
    std::uint32_t accepted = 0;  ///< times at which the speed is known
    cia447::NmeaCounts lines{};
    std::uint32_t out_of_order = 0;  ///< lines that come after later ones
    std::uint32_t impossible = 0;    ///< speeds beyond the fastest

    std::uint32_t passed_over() const {
      return lines.wrong_checksum + lines.malformed + lines.garbage + out_of_order + impossible;
    }
  };

  std::string text;
  std::vector<Sample> samples;  ///< by their times, each at another one
  std::vector<Said> said;
  std::vector<Leg> legs;
  Counts counts;

  /// A car moves in it.
  bool is_usable() const { return !legs.empty(); }
};

/// Of any text.
DriveRecord read_drive_record(std::string text);

}  // namespace canvoy::car
