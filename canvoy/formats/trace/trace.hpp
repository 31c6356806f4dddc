// The logs of CAN tools (candump, Vector ASC and BLF, PEAK TRC, pcapng, pcap, CSV, ASAM MDF,
// SQLite), read as one sequence of frames: in one pass, in flat memory, whatever the size of the
// file; what it is shows its content.
//
//     host::Result<TraceReader> trace = TraceReader::open("bus.asc");
//     TraceFrame heard;
//     for (TraceRead read; (read = trace->next(heard)) != TraceRead::end;) {
//       if (read == TraceRead::frame) decode(heard.time, heard.frame);
//       if (read == TraceRead::bad) print(trace->where(), trace->problem());
//     }
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/formats/trace/trace_format.hpp"

namespace canvoy::formats {

/// Seen from the program that wrote the log; many logs do not give it.
enum class TraceDirection : std::uint8_t { unknown, received, sent };

/// Content of a CAN FD frame beside its identifier: up to 64 bytes (ISO 11898-1).
struct TraceFdContent {
  static constexpr std::uint8_t bit_rate_switch = 1;  ///< BRS: the data has the second bit rate
  static constexpr std::uint8_t error_state = 2;      ///< ESI: the sender is error-passive

  std::uint8_t flags = 0;               ///< as candump writes them after `##`
  std::uint8_t length = 0;              ///< number of bytes in `data`; also 0 if the log gives none
  std::array<std::uint8_t, 64> data{};  ///< zeros behind `length`
};

/// A frame of a trace. `time` counts from 1970 if the trace has a start date (without a time zone:
/// UTC), else from the start of the trace. `channel` is valid until the next frame is read; in a
/// format with numbered channels, the first is can0. Of a CAN FD frame, `frame` has only the
/// identifier, and `fd` the rest.
struct TraceFrame {
  Time time{};                                         ///< microseconds
  Frame frame;                                         ///< data, remote or error frame
  std::string_view channel;                            ///< name of the bus
  TraceDirection direction = TraceDirection::unknown;  ///< of this frame
  TraceFdContent fd = {};                              ///< of a CAN FD frame
};

/// What next() has read.
enum class TraceRead : std::uint8_t {
  frame,  ///< a frame was read
  fd,     ///< a CAN FD frame, which CANopen does not use; reported with its bytes
  bad,    ///< an unreadable line or block was skipped: where() and problem() give details
  end,    ///< end of the trace
};

class TraceFile;
class TraceFileParser;
class TraceParser;

/// The end of the year 3999. A frame with a later time is unreadable: only text formats could hold
/// it.
inline constexpr Time trace_time_max =
    Time{std::chrono::sys_days{std::chrono::year{4000} / 1 / 1}.time_since_epoch()} - Duration{1};

/// Reads a trace from a file, a pipe or memory. No content is a fatal error. Text may be UTF-16
/// with a byte order mark, and its lines may end with a lone carriage return.
class TraceReader {
 public:
  /// Opens a trace; `-` is the standard input. The first 64 KiB determine the format. Decompresses
  /// gzip. Also reads text in UTF-16 or with a byte order mark.
  static host::Result<TraceReader> open(const std::string& path);
  /// Reads `content`, which must outlive the reader.
  static host::Result<TraceReader> of(std::string_view content);
  TraceReader(TraceReader&&) noexcept;
  TraceReader& operator=(TraceReader&&) = delete;
  ~TraceReader();

  /// Reads the next item into `frame`; after `end`, `end` again.
  TraceRead next(TraceFrame& frame);

  /// Format of the trace; valid as long as the program.
  const TraceFormat& format() const;
  /// Where the latest was read: "line 12", "byte 4096" in a file of blocks, "row 7" of a table.
  std::string where() const;
  /// Reason why the last item is bad; static text.
  std::string_view problem() const { return problem_; }

  /// Frames so far, without CAN FD.
  std::uint64_t frames() const { return frames_; }
  /// Unreadable lines and blocks so far.
  std::uint64_t bad() const { return bad_; }
  /// CAN FD frames so far.
  std::uint64_t fd_frames() const { return fd_frames_; }
  /// Number of comments, headers and events that are not frames.
  std::uint64_t notes_skipped() const { return notes_skipped_; }

  /// For a progress bar: number of bytes read, and of the whole file (0 for a pipe).
  std::uint64_t position() const { return position_; }
  /// Bytes of the whole file; 0 for a pipe.
  std::uint64_t size() const { return size_; }

 private:
  TraceReader(host::Descriptor file, std::string name);
  struct Gzip;
  struct Recoding;
  bool fill();
  std::size_t read_bytes(char* into, std::size_t room);
  std::size_t recode(char* into, std::size_t room);
  void begin_recoding();
  std::size_t read_file(char* into, std::size_t room);
  std::size_t inflate(char* into, std::size_t room);
  void begin_gzip();
  void pass(std::uint64_t bytes);
  TraceRead found_bad(std::string_view problem);
  host::Result<void> recognize(const std::string& name);
  host::Result<void> open_anywhere(const std::string& name);
  host::Result<TraceFile> whole_file();
  TraceFileParser& file_parser() const;
  TraceRead next_anywhere(TraceFrame& frame);

  host::Descriptor file_;
  std::string name_;
  std::unique_ptr<char[]> buffer_;
  std::string_view rest_;  // read from the file, not yet parsed
  bool file_ended_ = false;
  bool read_failed_ = false;
  std::unique_ptr<Gzip> gzip_;          // null if the file is not compressed
  bool source_ended_ = false;           // of the compressed data
  std::unique_ptr<Recoding> recoding_;  // null if the text needs no conversion
  std::unique_ptr<TraceParser> parser_;
  bool seeks_ = false;         // the parser is a TraceFileParser
  std::uint64_t passing_ = 0;  // bytes to be passed over that were not yet read from the file
  std::string_view problem_;
  std::uint64_t line_ = 0;
  std::uint64_t record_ = 0;
  std::uint64_t record_end_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t bad_ = 0;
  std::uint64_t fd_frames_ = 0;
  std::uint64_t notes_skipped_ = 0;
};

}  // namespace canvoy::formats
