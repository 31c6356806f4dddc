// Answers a request for state information (flag 0 of 6002h; 9.2.5) with an event: flag 0 of 6001h
// and 16 bits that the maker defines. The answer lasts as long as the request, so that each request
// causes a message.
//
//     StateAnswer state_(device, Callback<std::uint16_t()>::to<&Counter::state>(*this));
#pragma once

#include "canvoy/devices/cia407/kit/virtual_devices.hpp"

namespace canvoy::cia407 {

class StateAnswer {
 public:
  static constexpr std::uint8_t flag = 1;  ///< of the event flags

  /// `information` is called for each answer; empty: the answer only shows that the device is
  /// alive.
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
