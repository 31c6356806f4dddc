#include "canvoy/tools/live/live_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/live/live_network.hpp"
#include "canvoy/tools/log/trace_complaints.hpp"

namespace canvoy::tools {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto log_work_most = std::chrono::milliseconds(35);
constexpr std::size_t frames_at_once = 2000;

}  // namespace

LiveLog::LiveLog(const std::string& path, const FramePrinterOptions& options)
    : LiveSource(options), path_(path) {
  read(path);
  playback_ = std::make_unique<Playback>(lines_.back().time - begin(), 1);
  begin_again();
  playback_->set_paused(true);
  playback_->seek(playback_->end());
}

LiveLog::~LiveLog() = default;

void LiveLog::read(const std::string& path) {
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(path));
  formats::TraceFrame heard;
  for (formats::TraceRead read{}; (read = trace.next(heard)) != formats::TraceRead::end;) {
    if (read == formats::TraceRead::bad) continue;
    if (lines_.size() == frames_max) {
      is_cut_ = true;
      break;
    }
    auto bus = std::ranges::find(buses_, heard.channel);
    if (bus == buses_.end() && buses_.size() == FrameFeed::buses_max) continue;
    if (bus == buses_.end()) bus = buses_.emplace(bus, heard.channel);
    lines_.push_back({heard.time, heard.frame, static_cast<std::uint8_t>(bus - buses_.begin())});
  }
  refuse_log_without_frames(path, trace);
  std::ranges::stable_sort(lines_, {}, &Line::time);
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
          {"frames", lines_.size()},
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
  const auto is_due = [&] {
    return next_ < lines_.size() && lines_[next_].time - begin() <= wanted - Time{};
  };
  const auto begun = Clock::now();
  while (is_due() && Clock::now() - begun < log_work_most) {
    for (std::size_t i = 0; i < frames_at_once && is_due(); ++i) hear(lines_[next_++]);
  }
  playback_->reached(is_due() ? Time{} + (lines_[next_].time - begin()) : wanted);
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
    playback_->set_speed(not_negative(arguments, "speed"));
    playback_->set_paused(false);
  } else if (what == "step" || what == "seek") {
    const bool is_step = what == "step";
    const double seconds = not_negative(arguments, is_step ? "step_s" : "time");
    if (!(std::abs(seconds) <= 1e9)) throw UsageError("give a time in seconds");
    const Time to = (is_step ? playback_->now() : Time{}) + Duration(std::llround(seconds * 1e6));
    if (is_step) playback_->set_paused(true);
    if (to < playback_->now()) {
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
    throw UsageError(fmt::format("'{}' cannot be done to a log", what));
  }
  done({{"done", true}});
}

int LiveLog::finish() {
  return exit_done;
}

}  // namespace canvoy::tools
