#include "canvoy/formats/trace/trace_writer.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_pcapng_encoder.hpp"
#include "canvoy/formats/trace/trace_text_encoder.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t buffer_size = 64 * 1024;

std::unique_ptr<TraceEncoder> encoder_of(TraceFormat format, std::optional<Time> begin = {}) {
  switch (format) {
    case TraceFormat::candump:
      return make_candump_encoder();
    case TraceFormat::asc:
      return make_asc_encoder(begin);
    case TraceFormat::pcapng:
      return make_pcapng_encoder();
    case TraceFormat::trc:
    case TraceFormat::pcap:
    case TraceFormat::blf:
    case TraceFormat::python_can_csv:
    case TraceFormat::savvycan_csv:
      break;
  }
  return nullptr;
}

}  // namespace

std::optional<TraceFormat> trace_format_of(std::string_view path) {
  if (path.ends_with(".log")) return TraceFormat::candump;
  if (path.ends_with(".asc")) return TraceFormat::asc;
  if (path.ends_with(".trc")) return TraceFormat::trc;
  if (path.ends_with(".pcapng")) return TraceFormat::pcapng;
  if (path.ends_with(".pcap")) return TraceFormat::pcap;
  return std::nullopt;
}

host::Result<TraceWriter> TraceWriter::create(const std::string& path, TraceFormat format) {
  if (encoder_of(format) == nullptr || path == "-") return onto(STDOUT_FILENO, path, format);
  const host::Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
  if (!file) return host::Error{path, std::strerror(errno), "choose another file or folder"};
  return onto(file.get(), path, format);
}

host::Result<TraceWriter> TraceWriter::onto(int descriptor, const std::string& path,
                                            TraceFormat format, std::optional<Time> begin) {
  std::unique_ptr<TraceEncoder> encoder = encoder_of(format, begin);
  if (encoder == nullptr) {
    return host::Error{path, std::string(name_of(format)) + " is only read, not written",
                       "write a .log (candump), .asc or .pcapng"};
  }
  host::Descriptor file{::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)};
  if (!file) return host::Error{path, std::strerror(errno), "close other files"};
  return TraceWriter(path, std::move(file), std::move(encoder));
}

TraceWriter::TraceWriter(std::string path, host::Descriptor file,
                         std::unique_ptr<TraceEncoder> encoder)
    : path_(std::move(path)), file_(std::move(file)), encoder_(std::move(encoder)) {
  encoder_->begin(buffer_);
}

TraceWriter::TraceWriter(TraceWriter&&) noexcept = default;

TraceWriter::~TraceWriter() {
  if (file_) static_cast<void>(flush());
}

host::Result<void> TraceWriter::write(const TraceFrame& frame, std::string_view comment) {
  if (failed_) return {};
  encoder_->append(buffer_, frame, comment);
  return buffer_.size() >= buffer_size ? flush() : host::Result<void>{};
}

std::uint64_t TraceWriter::early() const {
  return encoder_->early();
}

host::Result<void> TraceWriter::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty() && !failed_) {
    const ssize_t written = ::write(file_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      failed_ = true;
      buffer_.clear();
      return host::Error{path_, std::strerror(errno), ""};
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
  return {};
}

}  // namespace canvoy::formats
