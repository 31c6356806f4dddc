#include "canvoy/tools/run/player.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/interruption.hpp"
#include "canvoy/tools/run/bus_bridge.hpp"
#include "canvoy/tools/terminal_text.hpp"

namespace canvoy::tools {

namespace {

/// How often the picture is drawn.
constexpr auto picture_period = std::chrono::milliseconds(100);
/// How far a network with real buses runs between two looks at them.
constexpr Duration bridge_period = 1ms;

/// The log of all frames. Its times count from zero, so that the same seed gives the same bytes.
class FrameLog {
 public:
  FrameLog(const std::string& path, PlayedNetwork& network)
      : writer_(value_or_throw(host::CandumpWriter::create(path))) {
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
  void finish() {
    check();
    ok_or_throw(writer_.flush());
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

  host::CandumpWriter writer_;
  std::deque<BusLog> buses_;  // addresses are kept by the taps
  std::optional<std::string> failure_;
};

/// The real buses that are parts of a network.
class RealBuses {
 public:
  RealBuses(PlayedNetwork& network, const std::vector<RealBus>& real)
      : network_(network), loop_(value_or_throw(host::EventLoop::create())) {
    for (const RealBus& each : real) {
      BusBridge& bridge = bridges_.emplace_back(network.world(), each.bus, *loop_, each.address);
      bridge.real().on_trouble(
          [](const host::Error& error) { fmt::print(stderr, "canvoy: {}\n", error.line()); });
      network.world().start(bridge.slot());
    }
  }

  /// Runs both until this time of the clock; false where there was a signal.
  void run_until(Time until) {
    while (network_.world().now() < until && !is_interrupted()) {
      loop_->run_until(std::min(until, loop_->now() + bridge_period));
      network_.run_until(std::min(until, loop_->now()));
    }
  }

 private:
  PlayedNetwork& network_;
  std::unique_ptr<host::EventLoop> loop_;
  std::deque<BusBridge> bridges_;
};

class Player {
 public:
  Player(PlayedNetwork& network, const PlayOptions& options)
      : network_(network),
        options_(options),
        is_live_(!options.json && isatty(STDOUT_FILENO) != 0),
        speed_(options.speed >= 0 ? options.speed
               : is_live_         ? options.terminal_speed
                                  : 0) {
    if (!options.log.empty()) log_ = std::make_unique<FrameLog>(options.log, network);
    if (!options.real.empty()) {
      speed_ = 1;
      real_ = std::make_unique<RealBuses>(network, options.real);
    }
  }

  int run() {
    heed_interruption();
    if (is_live_) fmt::print("\x1b[2J");  // an empty screen
    const Time end = Time{} + options_.duration;
    const auto begun = std::chrono::steady_clock::now();
    while (network_.world().now() < end && !is_interrupted()) {
      run_until(std::min(end, next_stop()), begun);
      if (log_) log_->check();
      tell();
      if (is_live_) draw();
    }
    if (log_) log_->finish();
    fmt::print("{}", options_.json ? network_.summary_json().dump() + "\n"
                                   : terminal_text(network_.summary_text(), STDOUT_FILENO));
    return network_.all_hold() ? exit_done : exit_failed;
  }

 private:
  /// Up to which virtual time to run now.
  Time next_stop() {
    if (speed_ == 0) return network_.world().now() + options_.snapshot_period;
    const std::chrono::duration<double, std::micro> passed = picture_period * ++pictures_ * speed_;
    return Time(Duration(static_cast<Duration::rep>(passed.count())));
  }

  void run_until(Time until, std::chrono::steady_clock::time_point begun) {
    if (real_) return real_->run_until(until);
    if (speed_ != 0) std::this_thread::sleep_until(begun + picture_period * pictures_);
    network_.run_until(until);
  }

  void tell() {
    const std::string events = network_.take_events(options_.json);
    if (!is_live_) {
      fmt::print("{}", options_.json ? events : terminal_text(events, STDOUT_FILENO));
    }
    const Time now = network_.world().now();
    if (options_.json && (now >= next_snapshot_ || now == Time{} + options_.duration)) {
      fmt::print("{}\n", network_.snapshot().dump());
      next_snapshot_ += options_.snapshot_period;
    }
    std::fflush(stdout);
  }

  /// Over the last picture: cursor home, clear to the end of each line and of the screen.
  void draw() {
    std::string picture = network_.picture(speed_);
    for (std::size_t at = 0; (at = picture.find('\n', at)) != std::string::npos; at += 4) {
      picture.replace(at, 1, "\x1b[K\n");
    }
    fmt::print("\x1b[H{}\x1b[J", picture);
    std::fflush(stdout);
  }

  PlayedNetwork& network_;
  const PlayOptions& options_;
  bool is_live_;
  double speed_;
  std::unique_ptr<FrameLog> log_;
  std::unique_ptr<RealBuses> real_;
  std::int64_t pictures_ = 0;
  Time next_snapshot_ = Time{} + options_.snapshot_period;
};

}  // namespace

int play(PlayedNetwork& network, const PlayOptions& options) {
  return Player(network, options).run();
}

}  // namespace canvoy::tools
