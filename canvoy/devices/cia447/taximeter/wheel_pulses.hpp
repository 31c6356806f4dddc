// Pulses of the wheels out of the counter that the IVN gateway sends (6055h, overrun value 6056h;
// CiA 447-3, 4.2.4.6 and 4.2.4.7), each of them once.
//
// Values that are lost or sent twice on the way change nothing: each counts from the last one that
// was believed. One that cannot be, because the car would have to be faster than it is, is put
// aside; where the next ones go on from it, the counter was set to something else, and it is
// followed from there, without what lies between: no distance is ever made up.
//
//     WheelPulses wheel;
//     wheel.set_fastest(2000);  // pulses a second
//     distance += wheel.count(counter, Signal::yes, now);
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

class WheelPulses {
 public:
  /// What was not counted, and why.
  struct Counters {
    std::uint32_t not_valid = 0;     ///< values that said so themselves
    std::uint32_t out_of_range = 0;  ///< values above the overrun value
    std::uint32_t implausible = 0;   ///< values that were put aside
    std::uint32_t restarts = 0;      ///< the counter began anew, or jumped
    std::uint32_t gaps = 0;          ///< too long to know how often the counter overran
  };

  /// No car has more than so many pulses a second.
  void set_fastest(std::uint32_t pulses_a_second) { fastest_ = pulses_a_second; }
  /// The highest value that the counter has: it goes on with 0. While it is not known (6056h is not
  /// valid) it is FFFFh, the highest that 6055h can tell.
  void set_overrun_value(std::uint16_t highest);

  /// A value of 6055h: the pulses since the last one. "Signal not available" is what a source says
  /// that begins anew: what comes next is only where to count from. Of one that says "no" or
  /// "failure" the counter may go on meanwhile: it is believed again where it fits.
  std::uint32_t count(std::uint16_t value, Signal valid, Time now);
  /// Another counter from here on.
  void forget() { has_base_ = false; }
  const Counters& counters() const { return counters_; }

 private:
  std::uint32_t modulus() const { return highest_ + 1U; }
  /// How far the counter is ahead of `base`.
  std::uint32_t ahead(std::uint16_t value, std::uint16_t base) const;
  /// As far as that it is believed; behind that it is rather going back.
  std::uint32_t believed() const { return modulus() - modulus() / 4; }
  std::uint64_t possible(Duration time) const;
  std::uint32_t doubt(std::uint16_t value, Time now);
  void set_base(std::uint16_t value, Time now);

  std::uint32_t fastest_ = 0xFFFF'FFFF;
  std::uint16_t highest_ = 0xFFFF;
  std::uint16_t base_ = 0;
  bool has_base_ = false;
  Time base_time_{};
  std::uint16_t doubted_ = 0;  ///< the last value that was put aside
  Time doubted_time_{};
  std::uint8_t doubts_ = 0;           ///< values that go on from each other
  std::uint32_t doubted_pulses_ = 0;  ///< among them
  Counters counters_;
};

}  // namespace canvoy::cia447
