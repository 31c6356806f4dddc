// True data of a bus, in the form of its network, now and a moment ago: a change takes a moment to
// reach its receivers.
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::bus_line {

struct TrueData {
  std::uint32_t stop_point = 0;     ///< 6109h
  std::uint8_t fare_zone = 0;       ///< 6111h
  std::uint16_t route_segment = 0;  ///< 6110h
  std::uint16_t line = 0;           ///< 6192h
  std::uint16_t route = 0;          ///< 6193h
  std::uint32_t block = 0;          ///< 6194h
  std::uint16_t journey = 0;        ///< 6195h
  std::uint32_t destination = 0;    ///< 6191h: number of the last stop
  std::uint32_t driver = 0;         ///< 6190h

  friend bool operator==(const TrueData&, const TrueData&) = default;
};

/// Data of now, and of a moment ago.
class TrueHistory {
 public:
  /// For this time, the data before a change are still accepted.
  static constexpr Duration moment = 1s;

  /// Sets the present data; those before are accepted for a moment.
  void learn(Time now, const TrueData& data) {
    if (data == now_) return;
    std::erase_if(before_, [now](const Past& past) { return now - past.until >= moment; });
    before_.push_back({now, now_});
    now_ = data;
  }
  /// The present data.
  const TrueData& current() const { return now_; }
  /// True if `is_said` holds for the present data, or those of a moment ago.
  template <class Said>
  bool is_true(Time now, const Said& is_said) const {
    if (is_said(now_)) return true;
    for (const Past& past : before_) {
      if (now - past.until < moment && is_said(past.data)) return true;
    }
    return false;
  }

 private:
  struct Past {
    Time until{};
    TrueData data;
  };
  TrueData now_;
  std::vector<Past> before_;
};

}  // namespace canvoy::bus_line
