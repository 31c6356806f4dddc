// Writes frames to the log of a CAN tool: candump -l, Vector ASC or pcapng.
//
//     Result<TraceWriter> out = TraceWriter::create("bus.pcapng", TraceFormat::pcapng);
//     out->write(frame, "node 5 battery voltage 48.5 V");     // tshark shows the comment
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

/// The format that the end of the name says: .log, .asc, .trc, .pcapng or .pcap.
std::optional<TraceFormat> trace_format_of(std::string_view path);

class TraceEncoder;

/// Writes through a buffer of 64 KiB. The first failure is returned once; after it everything is
/// ignored.
class TraceWriter {
 public:
  static constexpr std::size_t comment_length_max = 32 * 1024;

  /// Replaces the file; `-` is the standard output. PEAK TRC and pcap are not written.
  static host::Result<TraceWriter> create(const std::string& path, TraceFormat format);
  /// Writes to a copy of an open descriptor; `path` is how errors call it. `begin`: the time of the
  /// earliest frame, where it is not the first.
  static host::Result<TraceWriter> onto(int descriptor, const std::string& path, TraceFormat format,
                                        std::optional<Time> begin = {});
  TraceWriter(TraceWriter&&) noexcept;
  TraceWriter& operator=(TraceWriter&&) = delete;
  ~TraceWriter();

  /// `comment` is kept in pcapng only, at most comment_length_max bytes of it. An ASC file counts
  /// from the second in which its first frame was heard, or from `begin`, and numbers its channels:
  /// canN is N + 1, as for log2asc; a candump log does not have the direction.
  host::Result<void> write(const TraceFrame& frame, std::string_view comment = {});
  host::Result<void> flush();
  /// Frames that are earlier than the beginning of an ASC file, or than 1970: they have its time.
  std::uint64_t early() const;

 private:
  TraceWriter(std::string path, host::Descriptor file, std::unique_ptr<TraceEncoder> encoder);

  std::string path_;
  host::Descriptor file_;
  std::unique_ptr<TraceEncoder> encoder_;
  std::string buffer_;
  bool failed_ = false;
};

}  // namespace canvoy::formats
