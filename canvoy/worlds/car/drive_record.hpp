// A real drive as a satellite receiver recorded it (NMEA 0183): the speed of the car, and the
// sentences of the receiver.
//
//     const DriveRecord record = read_drive_record(text);
//     if (!record.is_usable()) tell(record.counts);
//     Drive drive(&record);
//
// Times are those of RMC and GGA; speeds those of RMC and VTG, or where a receiver sends none, of
// its positions. Where the fix is lost, as in a tunnel, the speed changes linearly from the last
// one to the next. Broken sentences are counted and skipped.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/gps/nmea.hpp"

namespace canvoy::car {

struct DriveRecord {
  /// m/s: a greater speed is an error of the receiver.
  static constexpr double fastest = 80;
  /// m/s: greatest reading of a receiver in a car that stands.
  static constexpr double standing = 0.3;
  /// Where a recorder was off for longer, the drive goes on a second later.
  static constexpr Duration gap_max = 10min;
  /// A car that stands for this time has arrived; after a red light it drives on earlier.
  static constexpr Duration arrival = 2min;

  /// The speed at a time.
  struct Sample {
    Duration at{};     ///< since the first sample
    double speed = 0;  ///< m/s
  };
  /// All lines of one second, or of one output of the receiver.
  struct Said {
    Duration at{};          ///< since the first sample
    std::size_t begin = 0;  ///< offset in the text
    std::size_t end = 0;    ///< offset of the end in the text
  };
  /// A drive from a departure to an arrival.
  struct Leg {
    Duration begin{};
    Duration end{};
  };
  /// Counts of the lines that were read.
  struct Counts {
    std::uint32_t accepted = 0;      ///< times at which the speed is known
    cia447::NmeaCounts lines{};      ///< by the parser of NMEA 0183
    std::uint32_t out_of_order = 0;  ///< lines that follow later ones
    std::uint32_t impossible = 0;    ///< speeds beyond `fastest`

    /// Number of lines and speeds that were not used.
    std::uint32_t passed_over() const {
      return lines.wrong_checksum + lines.malformed + lines.garbage + out_of_order + impossible;
    }
  };

  std::string text;             ///< the record as it was read
  std::vector<Sample> samples;  ///< by their times, which all differ
  std::vector<Said> said;       ///< by their times
  std::vector<Leg> legs;        ///< by their times
  Counts counts;                ///< of the lines

  /// True if a car moves in it.
  bool is_usable() const { return !legs.empty(); }
};

/// Reads any text.
DriveRecord read_drive_record(std::string text);

}  // namespace canvoy::car
