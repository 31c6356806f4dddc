// The trace formats, in one table that all code that reads, writes or names a log uses. A format is
// a source file (trace_asc.cpp), which defines its row, and two lines: the name of the row in
// TraceFormat, and its position in the table (trace_format.cpp).
//
//     const std::optional<TraceFormat> format = trace_format_of("night.asc.gz");
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"

namespace canvoy::formats {

class TraceEncoder;
class TraceParser;

/// The start of a file, at one of its first lines.
struct TraceHead {
  std::string_view line = {};  ///< without its end
  std::string_view rest = {};  ///< from this line on, up to 64 KiB
  bool is_first = false;       ///< this is the first line of the file
};

/// Bits for what a format does not keep.
namespace trace_lack {
inline constexpr std::uint8_t direction = 0x01;  ///< received or sent
inline constexpr std::uint8_t bus_names = 0x02;  ///< buses are numbered
inline constexpr std::uint8_t buses = 0x04;      ///< all frames are of one bus
inline constexpr std::uint8_t comments = 0x08;   ///< beside the frames
inline constexpr std::uint8_t errors = 0x10;     ///< error frames have no details
}  // namespace trace_lack

/// Text for these bits: "the direction of frames, comments"; empty for 0.
std::string trace_lack_text(std::uint8_t lacks);

/// A row of the table. Rows with the same name are equal.
struct TraceFormat {
  std::string_view name;     ///< for users: "Vector ASC"
  std::string_view endings;  ///< of file names, separated by blanks: ".pcapng .ntar"
  std::uint8_t lacks = 0;    ///< what the format does not keep when written
  /// Returns a parser if the file is of this format, else null.
  std::unique_ptr<TraceParser> (*recognize)(const TraceHead& head) = nullptr;
  /// Makes an encoder. `begin`: time of the earliest frame, if it is not the first. Null: the
  /// format is read-only.
  std::unique_ptr<TraceEncoder> (*encoder)(std::optional<Time> begin) = nullptr;

  /// True if frames can be written in the format.
  bool is_written() const { return encoder != nullptr; }
  friend bool operator==(const TraceFormat& a, const TraceFormat& b) { return a.name == b.name; }

  static const TraceFormat candump;         ///< .log
  static const TraceFormat asc;             ///< .asc, text
  static const TraceFormat blf;             ///< .blf, binary
  static const TraceFormat trc;             ///< .trc, text
  static const TraceFormat pcapng;          ///< .pcapng, for Wireshark
  static const TraceFormat pcap;            ///< .pcap, for Wireshark
  static const TraceFormat python_can_csv;  ///< .csv
  static const TraceFormat savvycan_csv;    ///< .csv
  static const TraceFormat mf4;             ///< .mf4
  static const TraceFormat sqlite;          ///< python-can's table of messages
};

/// All formats. If several match a file, the first is used.
std::span<const TraceFormat* const> trace_formats();

/// The format for the ending of a file name, with or without `.gz`; for CSV that of python-can.
std::optional<TraceFormat> trace_format_of(std::string_view path);
/// True if the file name has the ending of a format, with or without `.gz`.
inline bool names_trace(std::string_view path) {
  return trace_format_of(path).has_value();
}
/// True if a file of that name is to be compressed with gzip.
bool names_gzip(std::string_view path);

/// "candump log (.log), Vector ASC (.asc), ...": all formats, or those that can be written.
std::string trace_format_list(bool written_only = false);

/// ".log, .asc, ...": the first of each, once.
std::string trace_ending_list(bool written_only = false);

/// A parser for a file that begins with `head`; null where no format is known.
std::unique_ptr<TraceParser> recognize_trace(std::string_view head);

/// Probable content of a file of unknown format that begins with `head`: "a JPEG picture".
std::string_view looks_like(std::string_view head);

}  // namespace canvoy::formats
