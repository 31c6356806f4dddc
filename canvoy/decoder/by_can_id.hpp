// A value for each CAN-ID of 11 bits. A bus uses about a hundred of the 2048 CAN-IDs and a log may
// name many buses, so a value is created when it is first requested.
//
//     ByCanId<Image> images;
//     Image& image = images.at(frame.id);
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/can/frame.hpp"

namespace canvoy::decoder {

template <class Value>
class ByCanId {
 public:
  static constexpr std::size_t can_ids = Frame::id_max + 1;  ///< of 11 bits

  /// Returns the value of `can_id` (11 bits), created if needed. Valid until at() creates another
  /// one.
  Value& at(std::uint32_t can_id) {
    std::uint16_t& place = places_[can_id];
    if (place == 0) {
      values_.emplace_back();
      place = static_cast<std::uint16_t>(values_.size());
    }
    return values_[place - 1U];
  }
  /// Returns the value of `can_id`; null if at() has not created it.
  const Value* find(std::uint32_t can_id) const {
    const bool is_there = can_id < can_ids && places_[can_id] != 0;
    return is_there ? &values_[places_[can_id] - 1U] : nullptr;
  }

 private:
  std::array<std::uint16_t, can_ids> places_{};  ///< position in `values_`, from 1; 0: none
  std::vector<Value> values_;
};

}  // namespace canvoy::decoder
