// canvoy record BUS FILE: all frames of a bus into a log of any format, in parts if requested.
#include <fmt/format.h>

#include <charconv>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>

#include "canvoy/formats/trace/trace_writer.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/session/bus_news.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/watch/log_writer.hpp"

namespace canvoy::tools {

namespace {

struct RecordOptions {
  std::string bus;
  std::string file;
  std::string rotate;
  std::string duration;
  unsigned keep = 0;
  std::uint64_t count = 0;
  bool json = false;
};

/// End of a part: by size, or by time.
struct Rotation {
  std::uint64_t bytes = 0;  ///< 0: no end by size
  Duration time = Duration::max();

  bool is_wanted() const { return bytes != 0 || time != Duration::max(); }
};

/// `100MB`, `2GB`, or a time.
Rotation parse_rotation(const std::string& text) {
  Rotation rotation;
  if (text.empty()) return rotation;
  std::uint64_t number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  const std::string_view unit(end, static_cast<std::size_t>(last - end));
  constexpr std::uint64_t kilo = 1000;
  std::uint64_t factor = 0;
  if (unit == "kB" || unit == "KB") factor = kilo;
  if (unit == "MB") factor = kilo * kilo;
  if (unit == "GB") factor = kilo * kilo * kilo;
  constexpr std::uint64_t number_max = 1'000'000;
  if (factor == 0) {
    rotation.time = parse_duration_argument(text);
  } else if (error != std::errc{} || number == 0 || number > number_max) {
    throw UsageError(fmt::format("--rotate: '{}' is no size: 100MB, 2GB, or a time as 1h", text));
  } else {
    rotation.bytes = number * factor;
  }
  return rotation;
}

class Recording {
 public:
  explicit Recording(const RecordOptions& options)
      : options_(options),
        rotation_(parse_rotation(options.rotate)),
        format_(format_to_write(options.file)),
        limit_(options.duration.empty() ? Duration::max()
                                        : parse_duration_argument(options.duration)),
        session_(options.bus) {
    if (options.keep != 0 && !rotation_.is_wanted())
      throw UsageError("--keep is for --rotate: how many parts are kept");
    begin_part();
    for (host::HostBus* bus : session_.buses()) {
      bus->on_frame([this, bus](const host::BusFrame& heard) { take(bus->name(), heard); });
      news_.follow(*bus);
    }
  }

  int run() {
    const Time end = limit_ == Duration::max() ? never : session_.loop().now() + limit_;
    while (!is_over_ && session_.loop().now() < end) {
      const Time until = std::min(end, session_.loop().now() + Duration(1s));
      if (session_.loop().run_until(until) == host::EventLoop::End::stopped) is_over_ = true;
      check(out_->flush());
      news_.look(session_.loop().now());
      if (session_.loop().now() - part_begun_ >= rotation_.time) begin_part();
    }
    check(out_->finish());
    if (failure_) throw Failure(*failure_);
    tell();
    return exit_done;
  }

 private:
  /// `night-003.log.gz` for `night.log.gz`.
  std::string part_name() const {
    if (!rotation_.is_wanted()) return options_.file;
    const std::size_t slash = options_.file.rfind('/');
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    std::size_t dot = options_.file.rfind('.');
    if (formats::names_gzip(options_.file)) dot = options_.file.rfind('.', dot - 1);
    if (dot == std::string::npos || dot < name) dot = options_.file.size();
    return fmt::format("{}-{:03}{}", options_.file.substr(0, dot), part_,
                       options_.file.substr(dot));
  }

  void begin_part() {
    if (out_) check(out_->finish());
    out_.reset();
    ++part_;
    const std::string name = part_name();
    out_.emplace(value_or_throw(formats::TraceWriter::create(name, format_)));
    part_begun_ = session_.loop().now();
    parts_.push_back(name);
    if (options_.keep == 0 || parts_.size() <= options_.keep) return;
    std::error_code none;
    std::filesystem::remove(parts_.front(), none);
    parts_.pop_front();
  }

  void take(std::string_view bus, const host::BusFrame& heard) {
    if (is_over_) return;
    const auto direction = heard.origin == host::Origin::elsewhere
                               ? formats::TraceDirection::received
                               : formats::TraceDirection::sent;
    const Time time = heard.time + session_.loop().epoch();
    check(out_->write({time, heard.frame, bus, direction, {}}));
    if (++frames_ == options_.count) {
      is_over_ = true;
      session_.loop().stop();
    }
    if (rotation_.bytes != 0 && out_->size() >= rotation_.bytes) begin_part();
  }

  /// A write error ends the recording.
  void check(const host::Result<void>& written) {
    if (written || failure_) return;
    failure_ = written.error().line();
    is_over_ = true;
    session_.loop().stop();
  }

  void tell() const {
    if (!options_.json) {
      const std::uint64_t lost = news_.frames_lost();
      fmt::print("{} frames in {}{}{}\n", frames_, parts_.back(),
                 part_ > 1 ? fmt::format(", the last of {} parts", part_) : "",
                 lost == 0 ? "" : fmt::format("; {} more were lost before they were read", lost));
      return;
    }
    JsonEvent event("recorded");
    event->key("file").text(parts_.back());
    event->key("parts").number(part_);
    event->key("frames").number(frames_);
    event->key("frames_lost").number(news_.frames_lost());
    event.print();
  }

  const RecordOptions& options_;
  Rotation rotation_;
  formats::TraceFormat format_;
  Duration limit_;
  Session session_;
  std::optional<formats::TraceWriter> out_;
  std::deque<std::string> parts_;
  std::uint64_t part_ = 0;
  Time part_begun_{};
  std::uint64_t frames_ = 0;
  std::optional<std::string> failure_;
  BusNews news_{[](const std::string& line) { print_message(line); }};
  bool is_over_ = false;
};

}  // namespace

void add_record(Verb& app) {
  const auto options = std::make_shared<RecordOptions>();
  Verb& command = app.add_verb("record", "Write all frames of a bus into a log");
  command.add({
      {"bus", options->bus, "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0; several: can0,can1",
       required},
      {"out", options->file,
       "a file whose end says the format: " + formats::trace_ending_list(true) +
           "; with .gz behind it, it is compressed",
       required},
      {"--rotate", options->rotate,
       "a new file behind each 100MB (kB, MB, GB) or 1h: night-002.log"},
      {"--keep", options->keep, "with --rotate: only so many of the latest files"},
      {"--for", options->duration, "end after this time: 30s, 10min, 8h (default: until ^C)"},
      {"--count", options->count, "end after as many frames", above_zero},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy record can0 heard.log --for 1s\n"
      "  canvoy record can0 heard.blf --count 3\n"
      "  canvoy record can0 heard.log.gz --rotate 100MB --keep 10 --for 1s --json");
  command.runs([options] { return Recording(*options).run(); });
}

}  // namespace canvoy::tools
