// The bit rates of the controllers of a bus, as bit times. On a healthy bus they are all equal; a
// controller with another rate receives no frame and destroys those of the others.
//
//     BitTimes bit_times(bit_time_ns(125'000));
//     bit_times.set(node, 250'000);
//     if (bit_times.are_mixed()) deaf = bit_times.other_than(wire_bit_ns, hearing);
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/wire_time.hpp"

namespace canvoy {

class BitTimes {
 public:
  /// Makes the table for a bus with bits of `usual_ns`, except for controllers with a different
  /// rate.
  constexpr explicit BitTimes(std::int64_t usual_ns) : usual_ns_(usual_ns) {}

  /// Sets the bit rate of a controller in bit/s, 1000 to 1'000'000; 0: that of the bus. Controllers
  /// without a setting are ignored.
  constexpr void set(ControllerId id, std::uint32_t bit_rate) {
    bit_ns_[id] = bit_rate == 0 ? usual_ns_ : bit_time_ns(bit_rate);
    count_ = std::max(count_, id + std::size_t{1});
    const std::span<const std::int64_t> known(bit_ns_.data(), count_);
    are_mixed_ = std::any_of(known.begin(), known.end(),
                             [&](std::int64_t bit_ns) { return bit_ns != bit_ns_[id]; });
  }

  /// Bit time of a controller in nanoseconds; 0 for one that was never set.
  constexpr std::int64_t of(ControllerId id) const { return bit_ns_[id]; }
  /// True if not all controllers have the same bit time.
  constexpr bool are_mixed() const { return are_mixed_; }

  /// Members of `some` with a rate other than that of bits of `bit_ns`.
  constexpr ControllerSet other_than(std::int64_t bit_ns, const ControllerSet& some) const {
    ControllerSet others;
    some.for_each([&](ControllerId id) { others.assign(id, bit_ns_[id] != bit_ns); });
    return others;
  }
  /// Bit time of the slowest of `some`; at least `least_ns`.
  constexpr std::int64_t longest(const ControllerSet& some, std::int64_t least_ns) const {
    std::int64_t longest_ns = least_ns;
    some.for_each([&](ControllerId id) { longest_ns = std::max(longest_ns, bit_ns_[id]); });
    return longest_ns;
  }

 private:
  std::array<std::int64_t, ControllerSet::capacity> bit_ns_{};
  std::int64_t usual_ns_ = 0;
  std::size_t count_ = 0;
  bool are_mixed_ = false;
};

}  // namespace canvoy
