// Counts the frames that are sent while all devices of a car sleep. A frame that was under way when
// the last device fell asleep is not counted, nor is the one by which the first device wakes the
// others.
//
//     SilenceReferee silence(bus);
//     silence.look(now);                       // each step
//     silence.frame_sent(now, is_excused);     // each frame
#pragma once

#include <cstdint>
#include <utility>

#include "canvoy/worlds/car/car_bus.hpp"

namespace canvoy::car {

class SilenceReferee {
 public:
  /// `under_way` is the time after the last device fell asleep in which a frame may come. The bus
  /// must outlive this object.
  explicit SilenceReferee(const CarBus& bus, Duration under_way = {})
      : bus_(bus), under_way_(under_way) {}

  /// Looks whether all devices sleep; call it in each step.
  void look(Time now) {
    const bool was_asleep = std::exchange(is_asleep_, bus_.any_sleeps() && bus_.all_sleep());
    if (is_asleep_ && !was_asleep) asleep_at_ = now;
  }
  /// True if the frame is counted.
  bool frame_sent(Time now, bool is_excused) {
    if (!is_asleep_ || !bus_.all_sleep() || now < asleep_at_ + under_way_ || is_excused) {
      return false;
    }
    ++frames_;
    return true;
  }
  /// True if they slept at the last look.
  bool is_asleep() const { return is_asleep_; }
  /// Number of frames that were counted.
  std::uint64_t frames() const { return frames_; }

 private:
  const CarBus& bus_;
  Duration under_way_;
  bool is_asleep_ = false;
  Time asleep_at_{};
  std::uint64_t frames_ = 0;
};

}  // namespace canvoy::car
