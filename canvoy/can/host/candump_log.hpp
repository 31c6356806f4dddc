// Writes and reads the log of `candump -l`: one line for each frame, `(1700000000.000125) can0
// 185#1E2F`.
//
//     Result<CandumpWriter> log = CandumpWriter::create("bus.log", loop.epoch());
//     bus.on_frame(
//         [&](const BusFrame& heard) { log->write(heard.time, bus.name(), heard.frame); });
//     Result<CandumpReader> reader = CandumpReader::open("bus.log");
//     while (Result<std::optional<LogEntry>> entry = reader->next()) {
//       if (!*entry) break;
//       ...
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::host {

/// Writes through a buffer of 64 KiB. The first failure is returned once; afterwards all calls are
/// ignored, and the file ends with its last complete line.
class CandumpWriter {
 public:
  /// Makes the file, replacing an existing one. `epoch` is added to all times: the wall clock at
  /// Time{}, since 1970.
  static Result<CandumpWriter> create(const std::string& path, Duration epoch = {});
  CandumpWriter(CandumpWriter&&) noexcept = default;
  CandumpWriter& operator=(CandumpWriter&&) = delete;
  ~CandumpWriter();

  /// Writes a frame. `interface` must not contain blanks. Times are expected in order, but written
  /// as passed.
  Result<void> write(Time time, std::string_view interface, const Frame& frame);
  /// Passes the buffer to the operating system, for programs that read the file meanwhile.
  Result<void> flush();
  /// Like flush(), but only after a second since the last time, by any steady clock: call it
  /// regularly, so that the file grows for programs that follow it.
  Result<void> flush_each_second(Time clock);
  /// Number of lines written.
  std::uint64_t lines() const { return lines_; }

 private:
  CandumpWriter(std::string path, Duration epoch, Descriptor file);
  Result<void> fail(int error);

  std::string path_;
  Duration epoch_;
  Descriptor file_;
  std::string buffer_;
  std::int64_t whole_ = 0;  // bytes of complete lines in the file
  std::uint64_t lines_ = 0;
  bool failed_ = false;
  Time next_flush_{};
};

/// A frame of a log; its time counts from 1970, or from the origin of the log.
struct LogEntry {
  Time time;              ///< microsecond resolution
  std::string interface;  ///< name of the bus, as in the log
  Frame frame;            ///< of any kind
};

/// What a line holds.
enum class LogLineKind : std::uint8_t {
  frame,
  note,  ///< blank, a comment (#), or DROPCOUNT of candump
  fd,    ///< a CAN FD frame
  malformed,
};

/// A line of a log, referring to its text.
struct LogLine {
  LogLineKind kind = LogLineKind::malformed;  ///< which of the members below counts
  Time time{};                                ///< since 1970, or since the origin of the log
  std::string_view interface;                 ///< within the line
  Frame frame;                                ///< if it is one
  std::string_view problem;                   ///< reason if it is malformed
};

/// Parses one line without its end. Additions of newer tools (a direction R or T, flags) are
/// ignored.
LogLine parse_log_line(std::string_view line);

/// Appends a line with its line feed in the format of candump: at most 2 + 20 + 7 characters and
/// interface and frame.
void append_log_line(std::string& text, Duration since_1970, std::string_view interface,
                     const Frame& frame);

/// Reads a log of any length line by line.
class CandumpReader {
 public:
  /// Opens a log. Errors: those of the system.
  static Result<CandumpReader> open(const std::string& path);

  /// Next frame, or nothing at the end. A malformed line is an error with its number; the next call
  /// continues after that line.
  Result<std::optional<LogEntry>> next();
  /// Number of the last line read, from 1.
  std::uint64_t line_number() const { return line_number_; }
  /// Lines with CAN FD frames so far, which next() passes over.
  std::uint64_t fd_skipped() const { return fd_skipped_; }
  /// Blank lines, comments and drop counts so far, which next() passes over.
  std::uint64_t notes_skipped() const { return notes_skipped_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  CandumpReader(std::string path, File file) : path_(std::move(path)), file_(std::move(file)) {}
  bool read_line();

  std::string path_;
  File file_;
  std::string line_;
  bool too_long_ = false;
  std::uint64_t line_number_ = 0;
  std::uint64_t fd_skipped_ = 0;
  std::uint64_t notes_skipped_ = 0;
};

}  // namespace canvoy::host
