// canvoy monitor --table: the latest values, on a terminal that is redrawn, or once at the end.
#pragma once

#include <optional>
#include <string>

#include "canvoy/can/bus_load.hpp"
#include "canvoy/tools/session/unknown_nodes.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/tools/watch/live_table.hpp"

namespace canvoy::tools {

/// Traffic of a bus, for the head of the table.
class BusTraffic {
 public:
  /// 0: the bit rate is unknown.
  explicit BusTraffic(unsigned bit_rate) : bit_rate_(bit_rate) {}

  void add(Duration time, const Frame& frame);
  /// `842 frames/s, bus load 2.3 % of 125 kbit/s, 1 error frame`
  std::string text(Duration now) const;

 private:
  unsigned bit_rate_;
  std::optional<Duration> first_;
  BusLoad load_{1'000'000'000};
  BusLoad frames_{1'000'000'000};  ///< one microsecond for each frame
  std::int64_t busy_until_ns_ = 0;
  std::int64_t counted_until_ns_ = 0;
  std::uint64_t errors_ = 0;
};

class TableScreen {
 public:
  TableScreen(std::string source, LiveTable& table) : source_(std::move(source)), table_(table) {}

  /// Processes all pressed keys; false: the user quits.
  bool take_keys();
  /// `alarm`: what is wrong with the bus, also of a picture that was stopped.
  void draw(Duration now, const std::string& traffic, const std::string& alarm,
            const std::string& note);

 private:
  bool take(Key key);
  void take_search(Key key);

  std::string source_;
  LiveTable& table_;
  std::optional<LiveTable> frozen_;
  Duration frozen_at_{};
  Duration now_{};
  LiveTable::View view_;
  std::string typed_;
  bool is_searching_ = false;
  Screen screen_;
};

}  // namespace canvoy::tools
