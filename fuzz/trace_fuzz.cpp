// Arbitrary bytes as the log of a CAN tool: it is read to its end, every frame is valid, and what
// is written of it is read as the same frames.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "fuzz/require.hpp"

namespace {

using namespace canvoy::formats;
using canvoy::fuzz::require;

void check_frame(const canvoy::Frame& frame) {
  require(frame.length <= canvoy::Frame::length_max);
  require(frame.id <= canvoy::Frame::extended_id_max);
  require(!frame.is_plain() || frame.id <= canvoy::Frame::id_max);
  for (std::size_t at = frame.payload().size(); at < frame.data.size(); ++at)
    require(frame.data[at] == 0);
}

// Details of an error frame that ASC does not keep are equal for all of them.
void check_same(const canvoy::Frame& frame, const canvoy::Frame& again) {
  require(frame.is_error() ? again.is_error() : frame == again);
}

void check_written(std::string_view content, const TraceFormat& format) {
  canvoy::host::Result<TraceReader> reader = TraceReader::of(content);
  const std::unique_ptr<TraceEncoder> encoder = format.encoder(std::nullopt);
  if (encoder->seeks()) return;  // into a file, by a library of others
  std::string written;
  encoder->begin(written);
  TraceFrame frame;
  for (TraceRead read; (read = reader->next(frame)) != TraceRead::end;) {
    if (read == TraceRead::frame) encoder->append(written, frame, "a comment");
  }
  encoder->end(written);
  if (written.empty()) return;
  canvoy::host::Result<TraceReader> again = TraceReader::of(written);
  require(static_cast<bool>(again));
  canvoy::host::Result<TraceReader> first = TraceReader::of(content);
  TraceFrame other;
  for (TraceRead read; (read = first->next(frame)) != TraceRead::end;) {
    if (read != TraceRead::frame) continue;
    require(again->next(other) == TraceRead::frame);
    check_same(frame.frame, other.frame);
  }
  require(again->next(other) == TraceRead::end);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  canvoy::host::Result<TraceReader> reader = TraceReader::of(content);
  if (!reader) return 0;
  TraceFrame frame;
  for (TraceRead read; (read = reader->next(frame)) != TraceRead::end;) {
    if (read == TraceRead::frame) check_frame(frame.frame);
    if (read == TraceRead::bad) require(!reader->problem().empty());
    if (read == TraceRead::fd) require(frame.fd.length <= frame.fd.data.size());
  }
  const bool is_gzip = content.starts_with("\x1F\x8B\x08");
  require(is_gzip || reader->position() == size);
  for (const TraceFormat* format : trace_formats()) {
    if (format->is_written()) check_written(content, *format);
  }
  return 0;
}
