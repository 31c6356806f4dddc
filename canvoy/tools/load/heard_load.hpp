// Traffic of the buses during listening, by identifier.
//
//     HeardLoad load;
//     load.add(time, "can0", frame);
//     std::vector<LoadedBus> buses = load.buses(Duration{});
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/timing/arrivals.hpp"
#include "canvoy/tools/load/loaded_bus.hpp"

namespace canvoy::tools {

/// What is heard in no time at all, since all its frames have the same time.
inline constexpr Duration one_moment{1};

class HeardLoad {
 public:
  static constexpr std::size_t buses_max = 64;

  /// Adds a frame. Times of one bus must not decrease. Throws Failure if there are more than
  /// buses_max buses, or more than messages_max identifiers on one.
  void add(Duration time, std::string_view bus, const Frame& frame);
  /// The buses in order of their names. `listened`: zero means the time from the first frame to the
  /// last.
  std::vector<LoadedBus> buses(Duration listened) const;

 private:
  struct Heard {
    LoadedMessage message{};
    timing::Arrivals arrivals{};
    std::uint64_t bits = 0;
  };
  struct Bus {
    std::map<std::uint32_t, Heard> by_key{};  // in order of priority
    std::uint64_t error_frames = 0;
  };
  static LoadedMessage described(const Heard& heard, Duration listened);

  std::map<std::string, Bus, std::less<>> buses_;
  Duration first_{};
  Duration last_{};
  bool is_empty_ = true;
};

}  // namespace canvoy::tools
