#include "canvoy/formats/trace/trace.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "canvoy/formats/encoding.hpp"
#include "canvoy/formats/trace/inflater.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

bool is_gzip(std::string_view head) {
  return head.starts_with("\x1F\x8B\x08");
}

/// Text with lone carriage returns as line ends, as on old Macs.
bool ends_lines_with_returns(std::string_view head) {
  const auto is_text = [](char c) { return c >= ' ' || c < 0 || c == '\r' || c == '\t'; };
  return head.find('\r') != std::string_view::npos && std::ranges::all_of(head, is_text);
}

}  // namespace

/// A gzip log: data read from the file and not yet inflated.
struct TraceReader::Gzip {
  Inflater inflater{Inflater::Of::gzip};
  std::unique_ptr<char[]> buffer;  ///< null if all is in memory
  std::string_view rest;
  bool is_between = false;  ///< one piece has ended; another may follow
};

/// Text to be converted: data read and not yet UTF-8 in lines.
struct TraceReader::Recoding {
  enum class Of : std::uint8_t { utf16_little, utf16_big, returns };

  RecodeStep run(bool last, std::span<char> into) const {
    if (of != Of::returns) return recode_utf16(rest, of == Of::utf16_big, last, into);
    const std::size_t count = std::min(rest.size(), into.size());
    std::ranges::replace_copy(rest.substr(0, count), into.data(), '\r', '\n');
    return {count, count};
  }

  Of of = Of::returns;
  std::unique_ptr<char[]> buffer;  ///< null if all is in memory
  std::string_view rest;
  bool is_ended = false;
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
  reader.begin_recoding();
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
  reader.begin_recoding();
  const host::Result<void> recognized = reader.recognize("the trace");
  if (!recognized) return recognized.error();
  return reader;
}

host::Result<void> TraceReader::recognize(const std::string& name) {
  parser_ = recognize_trace(rest_.substr(0, trace_record_max));
  seeks_ = parser_ != nullptr && parser_->seeks();
  if (seeks_) return open_anywhere(name);
  if (parser_ != nullptr) return {};
  return host::Error{name,
                     "it looks like " + std::string(looks_like(rest_.substr(0, trace_record_max))) +
                         ", not like a log",
                     "these are read: " + trace_format_list() + ", each also by gzip (.gz)"};
}

host::Result<void> TraceReader::open_anywhere(const std::string& name) {
  host::Result<TraceFile> file = whole_file();
  if (!file) return file.error();
  return file_parser().open(*std::move(file), name);
}

// What is no plain file, or compressed, is copied into one.
host::Result<TraceFile> TraceReader::whole_file() {
  const bool is_as_it_stands = !gzip_ && !recoding_;
  if (is_as_it_stands && !file_) return TraceFile(rest_);
  if (is_as_it_stands && size_ != 0) return TraceFile::open(file_.get());
  host::Result<TemporaryTrace> copy = TemporaryTrace::create();
  if (!copy) return copy.error();
  do {
    const host::Result<void> appended = copy->append(rest_);
    if (!appended) return appended.error();
    rest_ = {};
  } while (fill());
  return TraceFile::of(*std::move(copy));
}

TraceFileParser& TraceReader::file_parser() const {
  return static_cast<TraceFileParser&>(*parser_);
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

// Like begin_gzip(), but for the decompressed data.
void TraceReader::begin_recoding() {
  const std::optional<TextEncoding> marked = marked_encoding(rest_);
  if (marked == TextEncoding::utf8_with_mark) return pass(3);
  if (!marked && !ends_lines_with_returns(rest_.substr(0, trace_record_max))) return;
  if (marked) pass(2);
  recoding_ = std::make_unique<Recoding>();
  if (marked) {
    const bool is_big = marked == TextEncoding::utf16_big;
    recoding_->of = is_big ? Recoding::Of::utf16_big : Recoding::Of::utf16_little;
  }
  recoding_->rest = rest_;
  recoding_->is_ended = file_ended_;
  if (buffer_) recoding_->buffer = std::move(buffer_);
  file_ended_ = false;
  buffer_ = std::make_unique_for_overwrite<char[]>(trace_buffer_size);
  rest_ = {};
  while (rest_.size() < trace_record_max && fill()) continue;
}

// If less than a character is left, the next data is appended to it.
std::size_t TraceReader::recode(char* into, std::size_t room) {
  Recoding& text = *recoding_;
  while (true) {
    const RecodeStep step = text.run(text.is_ended, {into, room});
    text.rest.remove_prefix(step.taken);
    if (!gzip_) position_ += step.taken;
    if (step.made > 0 || text.is_ended) return step.made;
    std::memmove(text.buffer.get(), text.rest.data(), text.rest.size());
    const std::size_t kept = text.rest.size();
    const std::size_t got = read_bytes(text.buffer.get() + kept, trace_buffer_size - kept);
    text.is_ended = got == 0;
    text.rest = {text.buffer.get(), kept + got};
  }
}

std::size_t TraceReader::read_file(char* into, std::size_t room) {
  ssize_t count = -1;
  do {
    count = ::read(file_.get(), into, room);
  } while (count < 0 && errno == EINTR);
  read_failed_ = count < 0;
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

// Moves unparsed data to the front of the buffer, and reads more from the file after it.
bool TraceReader::fill() {
  if (file_ended_) return false;
  if (!rest_.empty()) std::memmove(buffer_.get(), rest_.data(), rest_.size());
  char* const into = buffer_.get() + rest_.size();
  const std::size_t room = trace_buffer_size - rest_.size();
  const std::size_t got = recoding_ ? recode(into, room) : read_bytes(into, room);
  file_ended_ = got == 0;
  rest_ = {buffer_.get(), rest_.size() + got};
  return got > 0;
}

std::size_t TraceReader::read_bytes(char* into, std::size_t room) {
  return gzip_ ? inflate(into, room) : read_file(into, room);
}

std::size_t TraceReader::inflate(char* into, std::size_t room) {
  Gzip& gzip = *gzip_;
  while (true) {
    if (gzip.rest.empty() && !source_ended_) {
      const std::size_t got = read_file(gzip.buffer.get(), trace_buffer_size);
      source_ended_ = got == 0;
      gzip.rest = {gzip.buffer.get(), got};
    }
    // Zeros pad the last block of a tape.
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
  if (!gzip_ && !recoding_) position_ += here;
  record_end_ += here;
  passing_ = bytes - here;
}

TraceRead TraceReader::next_anywhere(TraceFrame& frame) {
  while (true) {
    const TraceStep step = parser_->step({}, true, frame);
    const bool is_copy = gzip_ || recoding_;
    if (!is_copy) position_ = file_parser().position();
    switch (step.item) {
      case TraceItem::frame:
        if (frame.time > trace_time_max) return found_bad("its time is behind the year 3999");
        ++frames_;
        return TraceRead::frame;
      case TraceItem::bad:
        return found_bad(step.problem);
      case TraceItem::fd:
        ++fd_frames_;
        return TraceRead::fd;
      case TraceItem::note:
        ++notes_skipped_;
        break;
      case TraceItem::end:
        if (!is_copy) position_ = std::max(position_, size_);
        // What was compressed and is cut.
        if (!std::exchange(read_failed_, false)) return TraceRead::end;
        return found_bad("the file cannot be read any further");
      case TraceItem::remainder:
      case TraceItem::more:
        break;
    }
  }
}

TraceRead TraceReader::next(TraceFrame& frame) {
  if (seeks_) return next_anywhere(frame);
  const bool is_copy = gzip_ || recoding_;
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
    if (step.taken > rest_.size() || is_copy) {
      pass(step.taken);
    } else {  // most records
      rest_.remove_prefix(static_cast<std::size_t>(step.taken));
      position_ += step.taken;
      record_end_ += step.taken;
    }
    switch (step.item) {
      case TraceItem::frame:
        if (frame.time > trace_time_max) return found_bad("its time is behind the year 3999");
        ++frames_;
        return TraceRead::frame;
      case TraceItem::bad:
        return found_bad(step.problem);
      case TraceItem::fd:
        ++fd_frames_;
        return TraceRead::fd;
      case TraceItem::note:
        ++notes_skipped_;
        break;
      case TraceItem::remainder:
      case TraceItem::more:
      case TraceItem::end:
        break;
    }
  }
}

TraceRead TraceReader::found_bad(std::string_view problem) {
  ++bad_;
  problem_ = problem;
  return TraceRead::bad;
}

const TraceFormat& TraceReader::format() const {
  return parser_->format();
}

std::string TraceReader::where() const {
  if (seeks_) return file_parser().where();
  return parser_->has_lines() ? "line " + std::to_string(line_) : "byte " + std::to_string(record_);
}

}  // namespace canvoy::formats
