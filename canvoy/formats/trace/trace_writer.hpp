// Writes frames to the log of a CAN tool, in any writable format of trace_format.hpp.
//
//     host::Result<TraceWriter> out = TraceWriter::create("bus.pcapng", TraceFormat::pcapng);
//     out->write(frame, "node 5 battery voltage 48.5 V");     // tshark shows the comment
//     out->finish();
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats {

class TraceEncoder;
class TraceFileEncoder;
class TemporaryTrace;
class Deflater;

/// Writes through a buffer of 64 KiB. The first failure is returned once; all later calls have no
/// effect.
class TraceWriter {
 public:
  static constexpr std::size_t comment_length_max = 32 * 1024;  ///< bytes; longer ones are cut

  /// Replaces the file; `-` is the standard output. If the name ends in `.gz`, compresses with
  /// gzip.
  static host::Result<TraceWriter> create(const std::string& path, const TraceFormat& format);
  /// Writes to a copy of an open descriptor; `path` is its name in errors, and its ending
  /// determines the compression. `begin`: time of the earliest frame, if it is not the first.
  static host::Result<TraceWriter> onto(int descriptor, const std::string& path,
                                        const TraceFormat& format, std::optional<Time> begin = {});
  TraceWriter(TraceWriter&&) noexcept;
  TraceWriter& operator=(TraceWriter&&) = delete;
  /// Like finish(), but ignores errors.
  ~TraceWriter();

  /// Writes a frame. At most comment_length_max bytes of the comment are kept. ASC, TRC and BLF
  /// count from the second of the first frame, or from `begin`, and number their buses: canN is N +
  /// 1, as in log2asc. lost() gives what the format does not keep.
  host::Result<void> write(const TraceFrame& frame, std::string_view comment = {});
  /// Writes buffered data to the file; a container of BLF only if it is full.
  host::Result<void> flush();
  /// Ends the log; nothing can be written after it.
  host::Result<void> finish();
  /// Number of frames earlier than the start of the file or than 1970; written with that time.
  std::uint64_t early() const;
  /// Number of frames later than the format can represent (pcap: 2106; BLF: 584 years after its
  /// start; all but candump: trace_time_max); written with the latest time.
  std::uint64_t late() const;
  /// Properties of the frames so far that the log does not keep: "comments, names of buses".
  std::string lost() const;
  /// Bytes in the file.
  std::uint64_t size() const;

 private:
  TraceWriter(std::string path, host::Descriptor file, const TraceFormat& format,
              std::unique_ptr<TraceEncoder> encoder);
  host::Result<void> open_file();
  host::Result<void> check_file();
  host::Result<void> finish_file();
  void note_lost(const TraceFrame& frame, std::string_view comment);
  host::Result<void> write_out(std::string_view bytes);
  host::Result<void> fail();

  std::string path_;
  host::Descriptor file_;
  std::uint8_t lacks_;
  std::uint8_t lost_ = 0;
  std::string latest_bus_;
  bool has_bus_ = false;
  std::unique_ptr<TraceEncoder> encoder_;
  TraceFileEncoder* file_encoder_;        ///< the same, if it writes a file by itself; else null
  std::unique_ptr<Deflater> deflater_;    ///< null where it is not compressed
  std::unique_ptr<TemporaryTrace> copy_;  ///< of a format that seeks, where the file cannot
  std::string buffer_;
  std::uint64_t size_ = 0;
  bool failed_ = false;
  bool is_finished_ = false;
};

}  // namespace canvoy::formats
