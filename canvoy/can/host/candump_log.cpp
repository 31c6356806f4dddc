#include "canvoy/can/host/candump_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::host {

namespace {

constexpr std::size_t buffer_size = 64 * 1024;
constexpr std::size_t line_length_max = 512;
constexpr std::size_t second_digits_max = 12;  // limit for microseconds in 63 bits
constexpr std::size_t fraction_digits_max = 9;
constexpr int microsecond_digits = 6;

LogLine malformed(std::string_view problem) {
  LogLine line;
  line.problem = problem;
  return line;
}

LogLine note() {
  LogLine line;
  line.kind = LogLineKind::note;
  return line;
}

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
}

std::string_view take_word(std::string_view& text) {
  skip_blanks(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t"));
  text.remove_prefix(word.size());
  return word;
}

// Parses all of `text`: 1 to `digits_max` decimal digits.
bool parse_digits(std::string_view text, std::size_t digits_max, std::int64_t& value) {
  if (text.empty() || text.size() > digits_max) return false;
  if (!std::ranges::all_of(text, [](char digit) { return digit >= '0' && digit <= '9'; }))
    return false;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return true;
}

// Parses `seconds.fraction`; digits below a microsecond are dropped.
bool parse_time(std::string_view text, Time& time) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return false;
  std::string_view fraction = text.substr(point + 1);
  if (fraction.empty() || fraction.size() > fraction_digits_max) return false;
  std::int64_t seconds = 0;
  std::int64_t nanoseconds = 0;
  if (!parse_digits(text.substr(0, point), second_digits_max, seconds)) return false;
  if (!parse_digits(fraction, fraction_digits_max, nanoseconds)) return false;
  for (std::size_t digits = fraction.size(); digits < fraction_digits_max; ++digits)
    nanoseconds *= 10;
  time = Time{std::chrono::seconds{seconds} + Duration{nanoseconds / 1000}};
  return true;
}

void append_padded(std::string& text, std::int64_t value, int digits) {
  std::array<char, 20> characters{};
  const auto end =
      std::to_chars(characters.data(), characters.data() + characters.size(), value).ptr;
  const auto length = static_cast<std::size_t>(end - characters.data());
  const auto width = static_cast<std::size_t>(digits);
  text.append(width > length ? width - length : 0, '0');
  text.append(characters.data(), length);
}

Error file_error(const std::string& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT;
  std::string remedy = full ? "make room, or write the log elsewhere" : "";
  if (error == EACCES || error == EROFS || error == EPERM) remedy = "choose another file or folder";
  if (error == ENOENT) remedy = "check the path";
  return {path, std::strerror(error), remedy};
}

}  // namespace

void append_log_line(std::string& text, Duration since_1970, std::string_view interface,
                     const Frame& frame) {
  const std::int64_t microseconds = std::max<std::int64_t>(since_1970.count(), 0);
  text += '(';
  append_padded(text, microseconds / 1'000'000, 10);
  text += '.';
  append_padded(text, microseconds % 1'000'000, microsecond_digits);
  text += ") ";
  text += interface;
  text += ' ';
  text += FrameText(frame).view();
  text += '\n';
}

Result<CandumpWriter> CandumpWriter::create(const std::string& path, Duration epoch) {
  Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
  if (!file) return file_error(path, errno);
  return CandumpWriter(path, epoch, std::move(file));
}

CandumpWriter::CandumpWriter(std::string path, Duration epoch, Descriptor file)
    : path_(std::move(path)), epoch_(epoch), file_(std::move(file)) {
  buffer_.reserve(buffer_size + line_length_max);
}

CandumpWriter::~CandumpWriter() {
  if (file_) static_cast<void>(flush());
}

Result<void> CandumpWriter::write(Time time, std::string_view interface, const Frame& frame) {
  if (failed_) return {};
  append_log_line(buffer_, epoch_ + time.time_since_epoch(), interface, frame);
  ++lines_;
  return buffer_.size() >= buffer_size ? flush() : Result<void>{};
}

Result<void> CandumpWriter::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty() && !failed_) {
    const ssize_t written = ::write(file_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  whole_ += static_cast<std::int64_t>(buffer_.size());
  buffer_.clear();
  return {};
}

Result<void> CandumpWriter::flush_each_second(Time clock) {
  if (clock < next_flush_) return {};
  next_flush_ = clock + Duration(1s);
  return flush();
}

// Part of the buffer may have been written: finds the last complete line in it.
Result<void> CandumpWriter::fail(int error) {
  failed_ = true;
  const off_t written = ::lseek(file_.get(), 0, SEEK_CUR);
  if (written > whole_) {
    const auto part = static_cast<std::size_t>(written - whole_);
    const std::size_t line_end = std::string_view(buffer_).substr(0, part).rfind('\n');
    if (line_end != std::string_view::npos) whole_ += static_cast<std::int64_t>(line_end) + 1;
    [[maybe_unused]] const int cut = ::ftruncate(file_.get(), whole_);
  }
  buffer_.clear();
  return file_error(path_, error);
}

LogLine parse_log_line(std::string_view text) {
  if (text.ends_with('\r')) text.remove_suffix(1);
  skip_blanks(text);
  if (text.empty() || text[0] == '#' || text.starts_with("DROPCOUNT")) return note();
  const std::size_t close = text.find(')');
  if (text[0] != '(' || close == std::string_view::npos)
    return malformed("it does not begin with (<seconds>)");
  LogLine line;
  if (!parse_time(text.substr(1, close - 1), line.time)) {
    return malformed("the time is not written (<seconds>.<fraction>)");
  }
  text.remove_prefix(close + 1);
  line.interface = take_word(text);
  const std::string_view frame_text = take_word(text);
  if (frame_text.empty()) return malformed("behind the time, interface and frame are expected");
  const ParsedFrame parsed = parse_frame(frame_text);
  if (!parsed && parsed.error != FrameTextError::fd) return malformed(describe(parsed.error));
  line.kind = parsed ? LogLineKind::frame : LogLineKind::fd;
  line.frame = parsed.frame;
  return line;
}

Result<CandumpReader> CandumpReader::open(const std::string& path) {
  File file{std::fopen(path.c_str(), "re")};
  if (!file) return file_error(path, errno);
  return CandumpReader(path, std::move(file));
}

// Cuts lines longer than any of a log, so that a file without line feeds does not fill the memory.
bool CandumpReader::read_line() {
  line_.clear();
  too_long_ = false;
  int character = std::fgetc(file_.get());
  if (character == EOF) return false;
  for (; character != EOF && character != '\n'; character = std::fgetc(file_.get())) {
    too_long_ = line_.size() >= line_length_max;
    if (!too_long_) line_ += static_cast<char>(character);
  }
  ++line_number_;
  return true;
}

Result<std::optional<LogEntry>> CandumpReader::next() {
  while (read_line()) {
    const LogLine line =
        too_long_ ? malformed("it is longer than 512 characters") : parse_log_line(line_);
    switch (line.kind) {
      case LogLineKind::frame:
        return std::optional<LogEntry>({line.time, std::string(line.interface), line.frame});
      case LogLineKind::note:
        ++notes_skipped_;
        break;
      case LogLineKind::fd:
        ++fd_skipped_;
        break;
      case LogLineKind::malformed:
        return Error{path_ + " line " + std::to_string(line_number_), std::string(line.problem),
                     "a line is written (1700000000.000125) can0 185#1E2F"};
    }
  }
  if (std::ferror(file_.get()) != 0) return file_error(path_, errno);
  return std::optional<LogEntry>{};
}

}  // namespace canvoy::host
