// Who is asked for state information by an event (flag 0 of 6002h; 9.2.5) answers by one: flag 0 of
// 6001h and 16 bits that its maker chooses. It answers for as long as it is asked, so that each
// question is told on the bus.
//
//     StateAnswer state_(device, Callback<std::uint16_t()>::to<&Unit::state>(*this));
#pragma once

#include "canvoy/devices/cia407/virtual_devices.hpp"

namespace canvoy::cia407 {

class StateAnswer {
 public:
  static constexpr std::uint8_t flag = 1;

  /// `information` is asked for each answer; empty: there is nothing to say but that it lives.
  explicit StateAnswer(VirtualDevice& device, Callback<std::uint16_t()> information = {})
      : device_(device), information_(information) {}
  StateAnswer(const StateAnswer&) = delete;
  StateAnswer& operator=(const StateAnswer&) = delete;

  /// `flags` of 6002h.
  void take(std::uint8_t flags) {
    const bool is_asked = (flags & flag) != 0;
    device_.inform(is_asked && information_ ? information_() : std::uint16_t{0});
    device_.signal(flag, is_asked);
  }

 private:
  VirtualDevice& device_;
  Callback<std::uint16_t()> information_;
};

}  // namespace canvoy::cia407
