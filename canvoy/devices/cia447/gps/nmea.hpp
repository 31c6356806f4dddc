// Parses NMEA 0183 data of a satellite receiver, byte by byte: sentences RMC, GGA, GSA, GSV, VTG
// and ZDA of the talkers GP, GN, GL and GA. The stream may be split anywhere; invalid data are
// counted and skipped. The parser allocates nothing and uses no clock: its owner detects a silent
// receiver from `counts().accepted`.
//
//     NmeaReceiver receiver;
//     receiver.receive("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,,*11\r\n");
//     receiver.reading().latitude;  // 48.1173
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/devices/cia447/gps/gps_reading.hpp"
#include "canvoy/devices/cia447/gps/nmea_fields.hpp"

namespace canvoy::cia447 {

/// Results of the lines.
struct NmeaCounts {
  std::uint32_t accepted = 0;        ///< taken into the reading
  std::uint32_t not_wanted = 0;      ///< valid, but another sentence or another talker
  std::uint32_t wrong_checksum = 0;  ///< or none
  std::uint32_t malformed = 0;       ///< valid checksum, but a field is invalid or out of range
  std::uint32_t garbage = 0;         ///< lines that are no sentence: cut, too long, noise

  friend constexpr bool operator==(const NmeaCounts&, const NmeaCounts&) = default;
};

/// Parser of one stream.
class NmeaReceiver {
 public:
  /// NMEA 0183 has 82; some receivers send longer lines.
  static constexpr std::size_t line_max = 128;

  /// Takes a piece of the stream, of any length.
  void receive(std::string_view bytes) {
    for (const char byte : bytes) receive(byte);
  }
  /// Takes a byte of the stream; constant time.
  void receive(char byte);

  /// The latest data. An empty field in a sentence makes its value unknown. Without a fix, position
  /// and movement are empty.
  GpsReading reading() const;
  /// What became of the lines so far.
  const NmeaCounts& counts() const { return counts_; }
  /// Discards all data, for a receiver that has become silent. The counts stay.
  void forget();

 private:
  /// Each satellite system reports its satellites in view separately.
  static constexpr std::size_t talkers = 4;
  struct Said {
    GpsReading reading;
    std::optional<bool> is_valid;      ///< RMC and GGA
    std::optional<GpsFix> dimensions;  ///< GSA
    std::array<std::optional<unsigned>, talkers> visible;
  };

  void end_line();
  bool has_right_checksum(std::string_view line) const;
  void take(std::string_view sentence);
  static bool take_rmc(NmeaFields& fields, Said& said);
  static bool take_gga(NmeaFields& fields, Said& said);
  static bool take_gsa(NmeaFields& fields, Said& said);
  static bool take_gsv(NmeaFields& fields, Said& said, std::size_t talker);
  static bool take_vtg(NmeaFields& fields, Said& said);
  static bool take_zda(NmeaFields& fields, Said& said);

  Said said_;
  NmeaCounts counts_;
  std::array<char, line_max> line_{};
  std::size_t length_ = 0;
  bool is_broken_ = false;  ///< the line contains characters that no sentence has
};

}  // namespace canvoy::cia447
