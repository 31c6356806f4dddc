// The log of `candump -l`: a line a frame, `(1700000000.000125) can0 185#1E2F`, written and read.
//
//     Result<CandumpWriter> log = CandumpWriter::create("bus.log", loop.epoch());
//     bus.on_frame([&](const BusFrame& heard) { log->write(heard.time, bus.name(), heard.frame);
//     }); Result<CandumpReader> reader = CandumpReader::open("bus.log"); while
//     (Result<std::optional<LogEntry>> entry = reader->next()) { if (!*entry) break; ... }
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

/// Writes through a buffer of 64 KiB. The first failure is returned once; after it everything is
/// ignored, and the file ends with its last whole line.
class CandumpWriter {
 public:
  /// Replaces the file. `epoch` is added to all times: the wall clock at Time{}, since 1970.
  static Result<CandumpWriter> create(const std::string& path, Duration epoch = {});
  CandumpWriter(CandumpWriter&&) noexcept = default;
  CandumpWriter& operator=(CandumpWriter&&) = delete;
  ~CandumpWriter();

  /// `interface` without blanks. Times are expected in order, but written as they come.
  Result<void> write(Time time, std::string_view interface, const Frame& frame);
  /// To the operating system, for those who read along.
  Result<void> flush();
  /// The same where a second has passed since the last time, by any steady clock: to be called now
  /// and then, so that who follows the file sees it grow.
  Result<void> flush_each_second(Time clock);
  std::uint64_t lines() const { return lines_; }

 private:
  CandumpWriter(std::string path, Duration epoch, Descriptor file);
  Result<void> fail(int error);

  std::string path_;
  Duration epoch_;
  Descriptor file_;
  std::string buffer_;
  std::int64_t whole_ = 0;  // bytes in the file, all of whole lines
  std::uint64_t lines_ = 0;
  bool failed_ = false;
  Time next_flush_{};
};

/// A frame of a log; its time counts from 1970, or from whatever the log counts from.
struct LogEntry {
  Time time;
  std::string interface;
  Frame frame;
};

enum class LogLineKind : std::uint8_t {
  frame,
  note,  ///< blank, a comment (#), or candump's DROPCOUNT
  fd,    ///< a CAN FD frame
  malformed,
};

/// A line of a log, pointing into its text.
struct LogLine {
  LogLineKind kind = LogLineKind::malformed;
  Time time{};
  std::string_view interface;
  Frame frame;
  std::string_view problem;  ///< why it is malformed
};

/// Reads one line without its end. What newer tools append (a direction R or T, flags) is ignored.
LogLine parse_log_line(std::string_view line);

/// The text of a line with its line feed, as candump writes it: at most 2 + 20 + 7 characters and
/// interface and frame.
void append_log_line(std::string& text, Duration since_1970, std::string_view interface,
                     const Frame& frame);

/// Reads a log of any length line by line.
class CandumpReader {
 public:
  static Result<CandumpReader> open(const std::string& path);

  /// The next frame, or nothing at the end. A malformed line is an error with its number; the call
  /// after it goes on behind that line.
  Result<std::optional<LogEntry>> next();
  std::uint64_t line_number() const { return line_number_; }
  std::uint64_t fd_skipped() const { return fd_skipped_; }
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
