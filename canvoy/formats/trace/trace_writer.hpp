// Writes frames to the log of a CAN tool, in any format that trace_format.hpp says is written.
//
//     Result<TraceWriter> out = TraceWriter::create("bus.pcapng", TraceFormat::pcapng);
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
class Deflater;

/// Writes through a buffer of 64 KiB. The first failure is returned once; after it everything is
/// ignored.
class TraceWriter {
 public:
  static constexpr std::size_t comment_length_max = 32 * 1024;

  /// Replaces the file; `-` is the standard output. What ends in `.gz` is compressed by gzip.
  static host::Result<TraceWriter> create(const std::string& path, const TraceFormat& format);
  /// Writes to a copy of an open descriptor; `path` is how errors call it, and says whether it is
  /// compressed. `begin`: the time of the earliest frame, where it is not the first.
  static host::Result<TraceWriter> onto(int descriptor, const std::string& path,
                                        const TraceFormat& format, std::optional<Time> begin = {});
  TraceWriter(TraceWriter&&) noexcept;
  TraceWriter& operator=(TraceWriter&&) = delete;
  /// As finish(), without an answer.
  ~TraceWriter();

  /// Of a comment, comment_length_max bytes are kept. ASC, TRC and BLF count from the second in
  /// which the first frame was heard, or from `begin`, and number their buses: canN is N + 1, as
  /// for log2asc. What the format does not keep of the frame, lost() says.
  host::Result<void> write(const TraceFrame& frame, std::string_view comment = {});
  /// What was written so far reaches the file; a container of BLF only when it is full.
  host::Result<void> flush();
  /// The end of the log; nothing is written behind it.
  host::Result<void> finish();
  /// Frames that are earlier than the beginning of the file, or than 1970: they have its time.
  std::uint64_t early() const;
  /// Frames that are later than what the format can say (pcap: 2106; BLF: 584 years behind its
  /// beginning; all but candump's: trace_time_max): they have the latest time that it can.
  std::uint64_t late() const;
  /// What was said of the frames so far and is not in the log: "comments, names of buses".
  std::string lost() const;
  /// Bytes in the file.
  std::uint64_t size() const { return size_; }

 private:
  TraceWriter(std::string path, host::Descriptor file, const TraceFormat& format,
              std::unique_ptr<TraceEncoder> encoder);
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
  std::unique_ptr<Deflater> deflater_;  ///< null where it is not compressed
  std::string buffer_;
  std::uint64_t size_ = 0;
  bool failed_ = false;
  bool is_finished_ = false;
};

}  // namespace canvoy::formats
