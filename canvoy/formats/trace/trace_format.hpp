// The formats of logs: one table, which everything that reads, writes or names a log asks. A format
// is a file of its own (trace_asc.cpp), which defines its row, and two lines: the row's name in
// TraceFormat, and its place in the table (trace_format.cpp).
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

/// How a file begins, at one of its first lines.
struct TraceHead {
  std::string_view line = {};  ///< without its end
  std::string_view rest = {};  ///< from the line on, up to 64 KiB
  bool is_first = false;       ///< the file begins with it
};

/// What a log of some format does not keep, as bits.
namespace trace_lack {
inline constexpr std::uint8_t direction = 0x01;
inline constexpr std::uint8_t bus_names = 0x02;  ///< buses are numbered
inline constexpr std::uint8_t buses = 0x04;      ///< all frames are of one bus
inline constexpr std::uint8_t comments = 0x08;
inline constexpr std::uint8_t errors = 0x10;  ///< of error frames, more than that they are one
}  // namespace trace_lack

/// "the direction of frames, comments"; empty for 0.
std::string trace_lack_text(std::uint8_t lacks);

/// A row of the table. Rows are equal where their names are.
struct TraceFormat {
  std::string_view name;     ///< as its users call it: "Vector ASC"
  std::string_view endings;  ///< of file names, with blanks between them: ".pcapng .ntar"
  std::uint8_t lacks = 0;    ///< what is written does not keep it
  /// A parser where a file that begins so is of this format, else null.
  std::unique_ptr<TraceParser> (*recognize)(const TraceHead& head) = nullptr;
  /// `begin`: the time of the earliest frame, where it is not the first. Null: it is only read.
  std::unique_ptr<TraceEncoder> (*encoder)(std::optional<Time> begin) = nullptr;

  bool is_written() const { return encoder != nullptr; }
  friend bool operator==(const TraceFormat& a, const TraceFormat& b) { return a.name == b.name; }

  static const TraceFormat candump;
  static const TraceFormat asc;
  static const TraceFormat blf;
  static const TraceFormat trc;
  static const TraceFormat pcapng;
  static const TraceFormat pcap;
  static const TraceFormat python_can_csv;
  static const TraceFormat savvycan_csv;
};

/// All of them. Where several know a file, the first is taken.
std::span<const TraceFormat* const> trace_formats();

/// The format that the end of a name says, with or without `.gz` behind it; of CSV, python-can's.
std::optional<TraceFormat> trace_format_of(std::string_view path);
/// Whether what is written to a file of that name is to be compressed by gzip.
bool names_gzip(std::string_view path);

/// "candump log (.log), Vector ASC (.asc), ...": of all formats, or of those that are written.
std::string trace_format_list(bool written_only = false);

/// A parser for a file that begins with `head`; null where no format is known.
std::unique_ptr<TraceParser> recognize_trace(std::string_view head);

/// What a file of no known format that begins with `head` may be: "a JPEG picture".
std::string_view looks_like(std::string_view head);

}  // namespace canvoy::formats
