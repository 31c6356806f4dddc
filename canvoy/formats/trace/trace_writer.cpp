#include "canvoy/formats/trace/trace_writer.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "canvoy/formats/trace/inflater.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_file.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t buffer_size = 64 * 1024;

/// `can0`, the first name in all formats that number their buses.
bool is_numbered_name(std::string_view name) {
  if (name.empty()) return true;
  if (!name.starts_with("can")) return false;
  name.remove_prefix(3);
  return !name.empty() && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

host::Result<TraceWriter> TraceWriter::create(const std::string& path, const TraceFormat& format) {
  if (!format.is_written() || path == "-") return onto(STDOUT_FILENO, path, format);
  const host::Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
  if (!file) return host::Error{path, std::strerror(errno), "choose another file or folder"};
  return onto(file.get(), path, format);
}

host::Result<TraceWriter> TraceWriter::onto(int descriptor, const std::string& path,
                                            const TraceFormat& format, std::optional<Time> begin) {
  if (!format.is_written()) {
    return host::Error{path, std::string(format.name) + " is only read, not written",
                       "these are written: " + trace_format_list(true)};
  }
  host::Descriptor file{::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)};
  if (!file) return host::Error{path, std::strerror(errno), "close other files"};
  TraceWriter writer(path, std::move(file), format, format.encoder(begin));
  const host::Result<void> opened = writer.open_file();
  if (!opened) {
    writer.failed_ = true;
    return opened.error();
  }
  return writer;
}

host::Result<void> TraceWriter::open_file() {
  if (file_encoder_ == nullptr) return {};
  std::optional<std::string> place = path_of(file_.get());
  if (!place || deflater_) {
    host::Result<TemporaryTrace> copy = TemporaryTrace::create();
    if (!copy) return copy.error();
    copy_ = std::make_unique<TemporaryTrace>(*std::move(copy));
    place = copy_->path();
  }
  return file_encoder_->open(*place, path_);
}

TraceWriter::TraceWriter(std::string path, host::Descriptor file, const TraceFormat& format,
                         std::unique_ptr<TraceEncoder> encoder)
    : path_(std::move(path)),
      file_(std::move(file)),
      lacks_(format.lacks),
      encoder_(std::move(encoder)),
      file_encoder_(encoder_->seeks() ? static_cast<TraceFileEncoder*>(encoder_.get()) : nullptr),
      deflater_(names_gzip(path_) ? std::make_unique<Deflater>() : nullptr) {
  buffer_.reserve(buffer_size + buffer_size / 4);
  encoder_->begin(buffer_);
}

TraceWriter::TraceWriter(TraceWriter&&) noexcept = default;

TraceWriter::~TraceWriter() {
  if (file_) static_cast<void>(finish());
}

host::Result<void> TraceWriter::write(const TraceFrame& frame, std::string_view comment) {
  if (failed_) return {};
  if ((lacks_ & ~lost_) != 0) note_lost(frame, comment);
  encoder_->append(buffer_, frame, comment);
  if (file_encoder_ != nullptr) return check_file();
  return buffer_.size() >= buffer_size ? flush() : host::Result<void>{};
}

void TraceWriter::note_lost(const TraceFrame& frame, std::string_view comment) {
  std::uint8_t lost = 0;
  if (frame.direction != TraceDirection::unknown) lost |= trace_lack::direction;
  if (!comment.empty()) lost |= trace_lack::comments;
  if (frame.frame.is_error()) lost |= trace_lack::errors;
  if (!has_bus_ || !same_bytes(frame.channel, latest_bus_)) {
    if (has_bus_) lost |= trace_lack::buses;
    if (!is_numbered_name(frame.channel)) lost |= trace_lack::bus_names;
    latest_bus_ = frame.channel;
    has_bus_ = true;
  }
  lost_ |= lost & lacks_;
}

std::uint64_t TraceWriter::early() const {
  return encoder_->early();
}

std::uint64_t TraceWriter::late() const {
  return encoder_->late();
}

std::string TraceWriter::lost() const {
  return trace_lack_text(lost_);
}

host::Result<void> TraceWriter::flush() {
  if (failed_) return {};
  if (file_encoder_ != nullptr) {
    file_encoder_->flush();
    return check_file();
  }
  host::Result<void> written =
      deflater_ ? write_out(deflater_->run(buffer_, is_finished_)) : write_out(buffer_);
  buffer_.clear();
  return written;
}

host::Result<void> TraceWriter::finish() {
  if (is_finished_ || failed_) return {};
  is_finished_ = true;
  encoder_->end(buffer_);
  if (file_encoder_ != nullptr) return finish_file();
  host::Result<void> written = flush();
  const std::string header = encoder_->final_header();
  if (!written || failed_ || header.empty() || deflater_) return written;
  // The header in a pipe cannot be replaced.
  const ssize_t done = ::pwrite(file_.get(), header.data(), header.size(), 0);
  if (done < 0 && errno != ESPIPE) return fail();
  return {};
}

/// What the encoder could not write.
host::Result<void> TraceWriter::check_file() {
  const std::string_view problem = file_encoder_->problem();
  if (problem.empty()) return {};
  failed_ = true;
  return host::Error{path_, std::string(problem), "is there room on the disk?"};
}

// What was written beside goes where it belongs.
host::Result<void> TraceWriter::finish_file() {
  host::Result<void> checked = check_file();
  if (!checked || !copy_) return checked;
  const host::Result<TraceFile> file = TraceFile::open(copy_->descriptor());
  if (!file) return file.error();
  buffer_.resize(buffer_size);
  for (std::uint64_t at = 0; at < file->size();) {
    const std::size_t got = file->read(at, buffer_);
    if (got == 0) return fail();
    at += got;
    const std::string_view bytes = std::string_view(buffer_).substr(0, got);
    host::Result<void> written =
        write_out(deflater_ ? deflater_->run(bytes, at == file->size()) : bytes);
    if (!written) return written;
  }
  return {};
}

std::uint64_t TraceWriter::size() const {
  return file_encoder_ != nullptr ? file_encoder_->size() : size_;
}

host::Result<void> TraceWriter::write_out(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail();
    bytes.remove_prefix(static_cast<std::size_t>(written));
    size_ += static_cast<std::uint64_t>(written);
  }
  return {};
}

host::Result<void> TraceWriter::fail() {
  failed_ = true;
  buffer_.clear();
  return host::Error{path_, std::strerror(errno), ""};
}

}  // namespace canvoy::formats
