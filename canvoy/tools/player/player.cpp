#include "canvoy/tools/player/player.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/interruption.hpp"
#include "canvoy/tools/player/actor.hpp"
#include "canvoy/tools/player/real_buses.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"
#include "canvoy/tools/watch/log_writer.hpp"

namespace canvoy::tools {

namespace {

/// Interval of the picture.
constexpr auto picture_period = std::chrono::milliseconds(100);

/// The log of all frames. Its times count from zero, so that the same seed gives the same bytes.
class FrameLog {
 public:
  FrameLog(const std::string& path, PlayedNetwork& network)
      : writer_(value_or_throw(LogWriter::create(path))) {
    BusIndex bus = 0;
    for (std::string& name : network.bus_names()) {
      const BusLog& log = buses_.emplace_back(BusLog{*this, std::move(name)});
      network.world().bus(bus++).observe(
          {.context = const_cast<BusLog*>(&log),
           .on_frame = [](void* self, Time now, ControllerId, const Frame& frame) {
             static_cast<BusLog*>(self)->write(now, frame);
           }});
    }
  }
  void check() const {
    if (failure_) throw Failure(*failure_);
  }
  /// By the clock of the machine: by the time of a run, a day would need as many writes as it has
  /// seconds.
  void flush_each_second() {
    const auto clock = std::chrono::steady_clock::now().time_since_epoch();
    ok_or_throw(writer_.flush_each_second(Time(std::chrono::duration_cast<Duration>(clock))));
  }
  void finish() {
    check();
    ok_or_throw(writer_.finish());
  }

 private:
  struct BusLog {
    void write(Time now, const Frame& frame) const {
      const host::Result<void> written = log.writer_.write(now, name, frame);
      if (!written) log.failure_ = written.error().line();
    }
    FrameLog& log;
    std::string name;
  };

  LogWriter writer_;
  std::deque<BusLog> buses_;  // addresses are kept by the taps
  std::optional<std::string> failure_;
};

class Player {
 public:
  Player(PlayedNetwork& network, const PlayOptions& options)
      : network_(network),
        actor_(network, options.acts),
        options_(options),
        is_live_(!options.json && isatty(STDOUT_FILENO) != 0),
        speed_(options.speed >= 0 ? options.speed
               : is_live_         ? options.terminal_speed
                                  : 0) {
    if (!options.real.empty()) {
      speed_ = 1;
      loop_ = value_or_throw(host::EventLoop::create());
      real_ = std::make_unique<RealBuses>(network.world(), options.real, *loop_);
    }
    // Last, since an existing file is replaced.
    if (!options.log.empty()) log_ = std::make_unique<FrameLog>(options.log, network);
  }

  int run() {
    heed_interruption();
    if (is_live_) screen_.emplace();
    const Time end = Time{} + options_.duration;
    next_picture_ = std::chrono::steady_clock::now();
    while (network_.world().now() < end && !is_interrupted() && take_keys()) {
      if (is_paused_) {
        std::this_thread::sleep_for(picture_period);
        next_picture_ = std::chrono::steady_clock::now();
      } else {
        run_until(std::min(end, next_stop()));
      }
      if (log_) {
        log_->check();
        log_->flush_each_second();
      }
      tell();
      if (screen_) draw();
    }
    screen_.reset();
    if (log_) log_->finish();
    fmt::print("{}", options_.json ? summary_json() : terminal_text(summary_text(), STDOUT_FILENO));
    return verdict_status(network_.summary_json(), options_.require_decided);
  }

 private:
  /// Virtual time up to which to run now.
  Time next_stop() {
    if (speed_ == 0) return network_.world().now() + options_.snapshot_period;
    const std::chrono::duration<double, std::micro> passed = picture_period * speed_;
    virtual_us_ += passed.count();
    return Time(Duration(static_cast<Duration::rep>(virtual_us_)));
  }

  void run_until(Time until) {
    if (real_) return run_beside_real_buses(until);
    if (speed_ != 0) {
      next_picture_ += picture_period;
      std::this_thread::sleep_until(next_picture_);
    }
    actor_.run_until(until);
    // If the machine is too slow, the clock does not run ahead.
    next_picture_ = std::max(next_picture_, std::chrono::steady_clock::now() - picture_period);
  }

  void run_beside_real_buses(Time until) {
    while (network_.world().now() < until && !is_interrupted()) {
      loop_->run_until(loop_->now() + RealBuses::period);
      actor_.run_until(std::min(until, real_->reach(loop_->now())));
    }
  }

  /// False: the user quits.
  bool take_keys() {
    while (screen_) {
      const std::optional<Key> key = screen_->key();
      if (!key) break;
      if (*key == Key{'q'}) return false;
      // Real buses require the speed of the clock.
      if (!real_) change_pace(*key);
    }
    return true;
  }

  void change_pace(Key key) {
    constexpr double speed_max = 1e6;
    constexpr double speed_min = 0.125;
    if (key == Key{' '}) is_paused_ = !is_paused_;
    if (speed_ == 0) return;
    if (key == Key{'+'}) speed_ = std::min(speed_ * 2, speed_max);
    if (key == Key{'-'}) speed_ = std::max(speed_ / 2, speed_min);
  }

  std::string summary_json() {
    nlohmann::ordered_json summary = network_.summary_json();
    if (real_) {
      summary["left_out"] = in_seconds(real_->left_out());
      summary["frames_lost"] = real_->frames_lost();
    }
    return summary.dump() + "\n";
  }

  /// Text with events of a bus, for a reader.
  std::string summary_text() {
    constexpr Duration told_from = 100ms;
    std::string text = network_.summary_text();
    if (!real_) return text;
    if (real_->left_out() >= told_from) {
      text += fmt::format(
          "this machine was too slow for {:.1f} s of the clock: the network stood still\n",
          in_seconds(real_->left_out()));
    }
    if (const std::uint64_t lost = real_->frames_lost(); lost != 0)
      text += fmt::format("{} frames were lost between the network and the real bus\n", lost);
    return text;
  }

  void tell() {
    std::string events;
    for (; told_ < network_.event_count(); ++told_) {
      const ReportedEvent event = network_.event(told_);
      events += options_.json ? event.json + "\n" : event.line();
    }
    if (is_live_) {
      keep(events);
    } else {
      fmt::print("{}", options_.json ? events : terminal_text(events, STDOUT_FILENO));
    }
    const Time now = network_.world().now();
    if (options_.json && (now >= next_snapshot_ || now == Time{} + options_.duration)) {
      fmt::print("{}\n", network_.snapshot().dump());
      next_snapshot_ += options_.snapshot_period;
    }
    std::fflush(stdout);
  }

  /// Keeps the last events.
  void keep(const std::string& events) {
    constexpr std::size_t kept_max = 200;
    for (std::string& line : lines_of(events)) events_.push_back(std::move(line));
    while (events_.size() > kept_max) events_.pop_front();
  }

  static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      lines.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    return lines;
  }

  /// Most pictures include the last events.
  bool has_events(const std::vector<std::string>& lines) const {
    return events_.empty() || std::ranges::find(lines, events_.back()) != lines.end();
  }

  /// The text after the last blank line may be too long: the latest part is kept.
  static void drop_old_events(std::vector<std::string>& lines, std::size_t room) {
    const auto blank = std::find(lines.rbegin(), lines.rend(), std::string());
    if (lines.size() <= room || blank == lines.rend()) return;
    const auto first = blank.base();
    const auto many = static_cast<std::ptrdiff_t>(lines.size() - room);
    lines.erase(first, first + std::min(many, lines.end() - first));
  }

  /// The picture, the last events, and the keys in the last row.
  void draw() {
    const std::size_t rows = Screen::size().rows;
    std::vector<std::string> lines = lines_of(network_.picture(speed_));
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    if (!has_events(lines) && lines.size() + 2 < rows) {
      lines.emplace_back();
      const std::size_t count = std::min(rows - 1 - lines.size(), events_.size());
      lines.insert(lines.end(), events_.end() - static_cast<std::ptrdiff_t>(count), events_.end());
    }
    drop_old_events(lines, std::max<std::size_t>(rows, 1) - 1);
    lines.resize(std::max<std::size_t>(rows, 1) - 1);
    const std::string trouble = real_ ? real_->trouble() : std::string();
    lines.push_back(!trouble.empty() ? fmt::format("  q ends  \x1b[1m{}\x1b[22m", trouble)
                    : real_          ? "  q ends"
                                     : fmt::format("  q ends  space {}  + and - change the speed",
                                          is_paused_ ? "goes on (PAUSED)" : "pauses"));
    if (screen_) screen_->draw(lines);
  }

  PlayedNetwork& network_;
  Actor actor_;
  const PlayOptions& options_;
  bool is_live_;
  double speed_;
  std::unique_ptr<FrameLog> log_;
  std::unique_ptr<host::EventLoop> loop_;  ///< of the real buses
  std::unique_ptr<RealBuses> real_;
  std::optional<Screen> screen_;
  std::deque<std::string> events_;
  std::chrono::steady_clock::time_point next_picture_;
  std::size_t told_ = 0;   ///< number of events of the network
  double virtual_us_ = 0;  ///< virtual time to be reached
  bool is_paused_ = false;
  Time next_snapshot_ = Time{} + options_.snapshot_period;
};

}  // namespace

int verdict_status(const nlohmann::ordered_json& summary, bool require_decided) {
  if (!summary.at("all_held").get<bool>()) return exit_failed;
  if (!require_decided || summary.at("all_decided").get<bool>()) return exit_done;
  std::vector<std::string> names;
  for (const auto& invariant : summary.at("invariants")) {
    const auto name = invariant.at("invariant").get<std::string>();
    const bool is_new = names.empty() || names.back() != name;
    if (!invariant.at("decided").get<bool>() && is_new) names.push_back(name);
  }
  print_message(fmt::format(
      "canvoy: not decided, as nothing was there to judge: {}; run longer, or with more in it",
      fmt::join(names, ", ")));
  return exit_undecided;
}

int play(PlayedNetwork& network, const PlayOptions& options) {
  return Player(network, options).run();
}

}  // namespace canvoy::tools
