#include "canvoy/formats/trace/trace.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "canvoy/formats/trace/inflater.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"
#include "canvoy/formats/trace/trace_recognize.hpp"

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
    case TraceFormat::blf:
      return "Vector BLF";
    case TraceFormat::python_can_csv:
      return "python-can CSV";
    case TraceFormat::savvycan_csv:
      return "SavvyCAN CSV";
  }
  return "";
}

namespace {

bool is_gzip(std::string_view head) {
  return head.starts_with("\x1F\x8B\x08");
}

}  // namespace

/// A log that gzip has compressed: what was read of the file, and was not yet inflated.
struct TraceReader::Gzip {
  Inflater inflater{Inflater::Of::gzip};
  std::unique_ptr<char[]> buffer;  ///< none where all is in memory
  std::string_view rest;
  bool is_between = false;  ///< one piece has ended: another may follow
};

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
  if (is_gzip(reader.rest_)) reader.begin_gzip();
  const host::Result<void> recognized = reader.recognize(reader.name_);
  if (!recognized) return recognized.error();
  return reader;
}

host::Result<TraceReader> TraceReader::of(std::string_view content) {
  TraceReader reader(host::Descriptor{}, "");
  reader.rest_ = content;
  reader.file_ended_ = true;
  reader.size_ = content.size();
  if (is_gzip(content)) reader.begin_gzip();
  const host::Result<void> recognized = reader.recognize("the trace");
  if (!recognized) return recognized.error();
  return reader;
}

host::Result<void> TraceReader::recognize(const std::string& name) {
  parser_ = recognize_trace(rest_.substr(0, trace_record_max));
  if (parser_ != nullptr) return {};
  return host::Error{name,
                     "it looks like " + std::string(looks_like(rest_.substr(0, trace_record_max))) +
                         ", not like a log",
                     "candump, Vector ASC and BLF, PEAK TRC, pcapng, pcap, CSV of python-can and "
                     "SavvyCAN are read"};
}

// What was read so far is the beginning of the compressed data.
void TraceReader::begin_gzip() {
  gzip_ = std::make_unique<Gzip>();
  gzip_->rest = rest_;
  if (file_) gzip_->buffer = std::move(buffer_);
  source_ended_ = file_ended_;
  file_ended_ = false;
  buffer_ = std::make_unique_for_overwrite<char[]>(trace_buffer_size);
  rest_ = {};
  while (rest_.size() < trace_record_max && fill()) continue;
}

std::size_t TraceReader::read_file(char* into, std::size_t room) {
  ssize_t count = -1;
  do {
    count = ::read(file_.get(), into, room);
  } while (count < 0 && errno == EINTR);
  read_failed_ = count < 0;
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

// What is not yet parsed moves to the front of the buffer, and what the file has comes behind it.
bool TraceReader::fill() {
  if (file_ended_) return false;
  if (!rest_.empty()) std::memmove(buffer_.get(), rest_.data(), rest_.size());
  char* const into = buffer_.get() + rest_.size();
  const std::size_t room = trace_buffer_size - rest_.size();
  const std::size_t got = gzip_ ? inflate(into, room) : read_file(into, room);
  file_ended_ = got == 0;
  rest_ = {buffer_.get(), rest_.size() + got};
  return got > 0;
}

std::size_t TraceReader::inflate(char* into, std::size_t room) {
  Gzip& gzip = *gzip_;
  while (true) {
    if (gzip.rest.empty() && !source_ended_) {
      const std::size_t got = read_file(gzip.buffer.get(), trace_buffer_size);
      source_ended_ = got == 0;
      gzip.rest = {gzip.buffer.get(), got};
    }
    // Zeros fill up the last block of a tape.
    const bool goes_on = !gzip.rest.empty() && gzip.rest.front() != 0;
    if (gzip.is_between && !goes_on) return 0;
    if (gzip.is_between) gzip.inflater.begin_again();
    gzip.is_between = false;
    const Inflater::Step step = gzip.inflater.run(gzip.rest, {into, room});
    gzip.rest.remove_prefix(step.taken);
    position_ += step.taken;
    gzip.is_between = step.state == Inflater::State::ended;
    if (step.made > 0) return step.made;
    const bool is_cut = gzip.rest.empty() && source_ended_ && !gzip.is_between;
    if (step.state == Inflater::State::damaged || is_cut) {
      read_failed_ = true;
      return 0;
    }
  }
}

void TraceReader::pass(std::uint64_t bytes) {
  const std::uint64_t here = std::min<std::uint64_t>(bytes, rest_.size());
  rest_.remove_prefix(static_cast<std::size_t>(here));
  if (!gzip_) position_ += here;
  record_end_ += here;
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
    record_ = record_end_;
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
