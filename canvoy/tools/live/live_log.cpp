#include "canvoy/tools/live/live_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/live/refusal.hpp"
#include "canvoy/tools/log/trace_complaints.hpp"

namespace canvoy::tools {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto log_work_most = std::chrono::milliseconds(35);
constexpr std::size_t frames_at_once = 2000;

}  // namespace

LiveLog::LiveLog(const std::string& path, const FramePrinterOptions& options, bool once)
    : LiveSource(options), path_(path) {
  if (once && survey()) {
    stream_.emplace(value_or_throw(formats::TraceReader::open(path)));
  } else {
    read(path);
  }
  playback_ = std::make_unique<Playback>(end_ - begin(), 1);
  begin_again();
  playback_->set_paused(true);
  playback_->seek(playback_->end());
}

LiveLog::~LiveLog() = default;

/// Nothing: more buses than are shown.
std::optional<std::uint8_t> LiveLog::bus_of(std::string_view channel) {
  auto bus = std::ranges::find(buses_, channel);
  if (bus == buses_.end() && buses_.size() == FrameFeed::buses_max) return std::nullopt;
  if (bus == buses_.end()) bus = buses_.emplace(bus, channel);
  return static_cast<std::uint8_t>(bus - buses_.begin());
}

/// Begin and end of the log; false where it cannot be read again, or its times jump back.
bool LiveLog::survey() {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path_, none)) return false;
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(path_));
  formats::TraceFrame heard;
  for (formats::TraceRead read{}; (read = trace.next(heard)) != formats::TraceRead::end;) {
    if (read != formats::TraceRead::frame) continue;
    if (frames_++ == 0) begin_ = end_ = heard.time;
    static_cast<void>(bus_of(heard.channel));
    if (heard.time < end_) {
      frames_ = 0;
      buses_.clear();
      return false;
    }
    end_ = heard.time;
  }
  refuse_log_without_frames(path_, trace);
  return true;
}

void LiveLog::read(const std::string& path) {
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(path));
  formats::TraceFrame heard;
  for (formats::TraceRead read{}; (read = trace.next(heard)) != formats::TraceRead::end;) {
    if (read != formats::TraceRead::frame) continue;
    if (lines_.size() == frames_max) {
      is_cut_ = true;
      break;
    }
    const std::optional<std::uint8_t> bus = bus_of(heard.channel);
    if (bus) lines_.push_back({heard.time, heard.frame, *bus});
  }
  refuse_log_without_frames(path, trace);
  std::ranges::stable_sort(lines_, {}, &Line::time);
  frames_ = lines_.size();
  begin_ = lines_.front().time;
  end_ = lines_.back().time;
}

/// Null: there is none any more.
const LiveLog::Line* LiveLog::next_line() {
  if (!stream_) return next_ < lines_.size() ? &lines_[next_] : nullptr;
  return streamed_ || read_next() ? &*streamed_ : nullptr;
}

bool LiveLog::read_next() {
  formats::TraceFrame heard;
  for (formats::TraceRead read{}; (read = stream_->next(heard)) != formats::TraceRead::end;) {
    if (read != formats::TraceRead::frame) continue;
    const std::optional<std::uint8_t> bus = bus_of(heard.channel);
    if (!bus) continue;
    streamed_ = Line{heard.time, heard.frame, *bus};
    return true;
  }
  return false;
}

void LiveLog::begin_again() {
  begin_anew();
  next_ = 0;
  nodes_ = std::make_unique<HeardNodes>(feed_,
                                        [this](ToldEvent event) { events_.add(std::move(event)); });
}

LiveSource::Json LiveLog::description() {
  return {{"kind", "log"},
          {"time_is", "log"},
          {"command", fmt::format("canvoy view {}", path_)},
          {"begin", in_seconds(begin() - Time{})},
          {"end", in_seconds(playback_->end() - Time{})},
          {"frames", frames_},
          {"is_cut", is_cut_},
          {"buses", buses_},
          {"can",
           {{"play", true},
            {"replay", true},
            {"visit", false},
            {"read", false},
            {"record", false},
            {"write", ""},
            {"nmt", false}}}};
}

void LiveLog::hear(const Line& line) {
  const Duration time = line.time - Time{};
  feed_.add(time, buses_[line.bus], line.frame);
  nodes_->hear(time, buses_[line.bus], line.frame);
}

void LiveLog::advance(Time clock) {
  const Time wanted = playback_->wanted(clock);
  const auto due = [&]() -> const Line* {
    const Line* const line = next_line();
    return line != nullptr && line->time - begin() <= wanted - Time{} ? line : nullptr;
  };
  const auto begun = Clock::now();
  const Line* line = due();
  while (line != nullptr && Clock::now() - begun < log_work_most) {
    for (std::size_t i = 0; i < frames_at_once && line != nullptr; ++i, line = due()) {
      hear(*line);
      ++next_;
      streamed_.reset();
    }
  }
  playback_->reached(line != nullptr ? Time{} + (line->time - begin()) : wanted);
}

LiveSource::Json LiveLog::state() {
  return {{"time", in_seconds(begin() - Time{}) + in_seconds(playback_->now() - Time{})},
          {"play",
           {{"speed", playback_->speed()},
            {"paused", playback_->is_paused()},
            {"seeking", playback_->is_seeking()},
            {"over", playback_->is_over()}}},
          {"snapshot",
           {{"nodes", nodes_->nodes_json((begin() - Time{}) + (playback_->now() - Time{}))}}},
          {"counts", counts()}};
}

void LiveLog::act(std::string_view what, const Json& arguments, const Done& done) {
  if (what == "pause") {
    playback_->set_paused(arguments.value("paused", true));
  } else if (what == "speed") {
    playback_->set_speed(arguments.at("speed").get<double>());
    playback_->set_paused(false);
  } else if (what == "step" || what == "seek") {
    const bool is_step = what == "step";
    const double seconds = arguments.at(is_step ? "step_s" : "time").get<double>();
    const Time to = (is_step ? playback_->now() : Time{}) + Duration(std::llround(seconds * 1e6));
    if (is_step) playback_->set_paused(true);
    if (to < playback_->now()) {
      if (stream_) throw NotNow("this log is played once, from its beginning to its end");
      begin_again();
      playback_->restart(std::max(to, Time{}));
    } else {
      playback_->seek(to);
    }
  } else if (what == "objects") {
    return done(objects(arguments));
  } else if (what == "restart") {
    begin_again();
    playback_->restart(Time{});
  } else {
    throw NotNow(fmt::format("'{}' cannot be done to a log", what));
  }
  done({{"done", true}});
}

int LiveLog::finish() {
  return exit_done;
}

}  // namespace canvoy::tools
