#include "canvoy/tools/page/live_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/frame_sort.hpp"
#include "canvoy/tools/page/log_view.hpp"
#include "canvoy/tools/page/refusal.hpp"
#include "canvoy/tools/page/trend.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"
#include "canvoy/tools/watch/trace_progress.hpp"

namespace canvoy::tools {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto log_work_most = std::chrono::milliseconds(35);
constexpr std::uint64_t frames_at_once = 2000;

}  // namespace

LiveLog::LiveLog(const std::string& path, const FramePrinterOptions& options)
    : LiveSource(options), path_(path) {
  read(path);
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

void LiveLog::read(const std::string& path) {
  LogReader trace(value_or_throw(formats::TraceReader::open(path)));
  TraceProgress progress(trace);
  formats::TraceFrame heard;
  bool is_in_order = true;
  for (formats::TraceRead read{}; (read = trace.next(heard)) != formats::TraceRead::end;) {
    progress.show(trace);
    if (read == formats::TraceRead::bad) {
      show_bad(path, trace);
      if (unreadable_++ == 0)
        unreadable_at_ = fmt::format("{}: {}", trace.where(), trace.problem());
    }
    if (read != formats::TraceRead::frame) continue;
    const std::optional<std::uint8_t> bus = bus_of(heard.channel);
    if (!bus) {
      ++of_other_buses_;
      continue;
    }
    is_in_order = is_in_order && (frames_.size() == 0 || heard.time >= end_);
    end_ = heard.time;
    frames_.add({heard.time, heard.frame, *bus});
  }
  refuse_log_without_frames(path, trace);
  if (!is_in_order) sort_by_time(frames_);
  begin_ = cursor_.at(0).time;
  end_ = cursor_.at(frames_.size() - 1).time;
}

std::unique_ptr<FrameWalk> LiveLog::walk(const std::string& filter, bool /*is_anew*/) const {
  return std::make_unique<LogView>(frames_, buses_, feed_.options(), filter,
                                   [this] { return begin() + (playback_->aim() - Time{}); });
}

void LiveLog::begin_again() {
  begin_anew();
  next_ = 0;
  nodes_ = std::make_unique<HeardNodes>(
      feed_, [this](ReportedEvent event) { events_.add(std::move(event)); });
}

LiveSource::Json LiveLog::description() {
  return {{"kind", "log"},
          {"time_is", "log"},
          {"source", path_},
          {"command", feed_.options().view_line(path_)},
          {"begin", in_seconds(begin() - Time{})},
          {"end", in_seconds(playback_->end() - Time{})},
          {"frames", frames_.size()},
          {"unreadable", unreadable_},
          {"unreadable_at", unreadable_at_},
          {"of_other_buses", of_other_buses_},
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

void LiveLog::hear(const StoredFrame& heard) {
  const Duration time = heard.time - Time{};
  const Frame frame = heard.plain();
  feed_.add(time, buses_[heard.bus()], frame);
  nodes_->hear(time, buses_[heard.bus()], frame);
}

void LiveLog::advance(Time clock) {
  const Time wanted = playback_->wanted(clock);
  const std::uint64_t due = frames_.first_after(begin() + (wanted - Time{}));
  const auto begun = Clock::now();
  while (next_ < due && Clock::now() - begun < log_work_most) {
    const std::uint64_t part = std::min(due, next_ + frames_at_once);
    for (; next_ < part; ++next_) hear(cursor_.at(next_));
  }
  playback_->reached(next_ < due ? Time{} + (cursor_.at(next_).time - begin()) : wanted);
}

std::uint64_t LiveLog::frames_between(Time from, Time to) const {
  return frames_.first_after(to) - frames_.first_after(from);
}

/// A log without a viewer does not need them, and of a long one they take a moment.
void LiveLog::count_rates() {
  constexpr std::int64_t samples_max = 300;
  const std::int64_t samples = std::clamp<std::int64_t>((end_ - begin_) / 1s, 2, samples_max);
  const Duration part = (end_ - begin_) / samples;
  for (std::int64_t i = 0; i < samples; ++i) {
    // The first frame is at the very beginning.
    const Time from = begin_ + i * part - (i == 0 ? Duration{1} : Duration{});
    const Time to = i + 1 == samples ? end_ : begin_ + (i + 1) * part;
    const auto count = static_cast<double>(frames_between(from, to));
    const bool is_moment = to - from <= Duration{1};
    rates_.emplace_back(in_seconds(to - Time{}), is_moment ? count : count / in_seconds(to - from));
  }
}

LiveSource::Json LiveLog::trend(const std::vector<std::string>& names) {
  if (rates_.empty()) count_rates();
  Json times = Json::array();
  Json rates = Json::array();
  for (const auto& [time, rate] : rates_) {
    times.push_back(time);
    rates.push_back(rate);
  }
  Json values = Json::object();
  if (std::ranges::find(names, "frames_per_second") != names.end()) {
    values["frames_per_second"] = std::move(rates);
  }
  return {{"times", std::move(times)}, {"values", std::move(values)}};
}

LiveSource::Json LiveLog::state() {
  const Time now = begin() + (playback_->now() - Time{});
  if (std::exchange(counted_at_, now) != now) last_second_ = frames_between(now - 1s, now);
  return {{"time", in_seconds(begin() - Time{}) + in_seconds(playback_->now() - Time{})},
          {"play",
           {{"speed", playback_->speed()},
            {"paused", playback_->is_paused()},
            {"seeking", playback_->is_seeking()},
            {"over", playback_->is_over()}}},
          {"snapshot",
           {{"frames_per_second", last_second_},
            {"unknown_pdos", feed_.unknown_pdos({.is_counted = false})},
            {"nodes", nodes_->nodes_json((begin() - Time{}) + (playback_->now() - Time{}))}}}};
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
      begin_again();
      playback_->restart(std::max(to, Time{}));
    } else {
      playback_->seek(to);
    }
  } else if (what == "objects") {
    return done(objects(arguments));
  } else if (what == "history") {
    return done(history(arguments));
  } else if (what == "trend") {
    return done(trend(listed_names(arguments.at("names").get<std::string>())));
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
