#include "canvoy/formats/trace.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "canvoy/formats/trace_parser.hpp"

namespace canvoy::formats {

std::string_view name_of(TraceFormat format) {
  switch (format) {
    case TraceFormat::candump:
      return "candump log";
    case TraceFormat::asc:
      return "Vector ASC";
    case TraceFormat::trc:
      return "PEAK TRC";
    case TraceFormat::pcapng:
      return "pcapng";
    case TraceFormat::pcap:
      return "pcap";
  }
  return "";
}

TraceReader::TraceReader(host::Descriptor file, std::string name)
    : file_(std::move(file)), name_(std::move(name)) {}
TraceReader::TraceReader(TraceReader&&) noexcept = default;
TraceReader::~TraceReader() = default;

host::Result<TraceReader> TraceReader::open(const std::string& path) {
  const bool standard_input = path == "-";
  host::Descriptor file{standard_input ? ::dup(STDIN_FILENO)
                                       : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (!file) {
    return host::Error{path, std::strerror(errno), errno == ENOENT ? "check the path" : ""};
  }
  struct stat status {};
  const bool known = ::fstat(file.get(), &status) == 0;
  if (known && S_ISDIR(status.st_mode))
    return host::Error{path, "it is a folder", "name a log file"};
  TraceReader reader(std::move(file), standard_input ? "standard input" : path);
  if (known && S_ISREG(status.st_mode)) reader.size_ = static_cast<std::uint64_t>(status.st_size);
  reader.buffer_ = std::make_unique_for_overwrite<char[]>(trace_buffer_size);
  while (reader.rest_.size() < trace_record_max && reader.fill()) continue;
  const host::Result<void> recognized = reader.recognize(reader.name_);
  if (!recognized) return recognized.error();
  return reader;
}

host::Result<TraceReader> TraceReader::of(std::string_view content) {
  TraceReader reader(host::Descriptor{}, "");
  reader.rest_ = content;
  reader.file_ended_ = true;
  reader.size_ = content.size();
  const host::Result<void> recognized = reader.recognize("the trace");
  if (!recognized) return recognized.error();
  return reader;
}

host::Result<void> TraceReader::recognize(const std::string& name) {
  parser_ = recognize_trace(rest_.substr(0, trace_record_max));
  if (parser_ != nullptr) return {};
  return host::Error{name, "it is no log that is known here",
                     "candump -l, Vector ASC, PEAK TRC, pcapng and pcap are"};
}

// What is not yet parsed moves to the front of the buffer, and what the file has comes behind it.
bool TraceReader::fill() {
  if (file_ended_) return false;
  if (!rest_.empty()) std::memmove(buffer_.get(), rest_.data(), rest_.size());
  ssize_t count = -1;
  do {
    count = ::read(file_.get(), buffer_.get() + rest_.size(), trace_buffer_size - rest_.size());
  } while (count < 0 && errno == EINTR);
  file_ended_ = count <= 0;
  read_failed_ = count < 0;
  const std::size_t got = count > 0 ? static_cast<std::size_t>(count) : 0;
  rest_ = {buffer_.get(), rest_.size() + got};
  return got > 0;
}

void TraceReader::pass(std::uint64_t bytes) {
  const std::uint64_t here = std::min<std::uint64_t>(bytes, rest_.size());
  rest_.remove_prefix(static_cast<std::size_t>(here));
  position_ += here;
  passing_ = bytes - here;
}

TraceRead TraceReader::next(TraceFrame& frame) {
  while (true) {
    if (passing_ > 0) pass(passing_);
    if (rest_.empty()) {
      if (fill()) continue;
      if (!std::exchange(read_failed_, false)) return TraceRead::end;
      return found_bad("the file cannot be read any further");
    }
    const TraceStep step = parser_->step(rest_, file_ended_, frame);
    if (step.item == TraceItem::more) {
      fill();
      continue;
    }
    record_ = position_;
    if (step.item != TraceItem::remainder) ++line_;
    pass(step.taken);
    switch (step.item) {
      case TraceItem::frame:
        ++frames_;
        return TraceRead::frame;
      case TraceItem::bad:
        return found_bad(step.problem);
      case TraceItem::fd:
        ++fd_skipped_;
        break;
      case TraceItem::note:
        ++notes_skipped_;
        break;
      case TraceItem::remainder:
      case TraceItem::more:
        break;
    }
  }
}

TraceRead TraceReader::found_bad(std::string_view problem) {
  ++bad_;
  problem_ = problem;
  return TraceRead::bad;
}

TraceFormat TraceReader::format() const {
  return parser_->format();
}

std::string TraceReader::where() const {
  return parser_->has_lines() ? "line " + std::to_string(line_) : "byte " + std::to_string(record_);
}

}  // namespace canvoy::formats
