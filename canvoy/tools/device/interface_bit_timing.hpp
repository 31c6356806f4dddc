// The bit rate of a CAN interface of this machine, as LSS asks for it (CiA 305).
//
//     InterfaceBitTiming timing("can0", [](const std::string& line) { ... });
//     LssSlaveHooks hooks;
//     hooks.configure_bit_timing = Callback<LssError(std::uint8_t)>::to<...>(timing);
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "canvoy/can/host/can_link.hpp"
#include "canvoy/canopen/lss/lss.hpp"

namespace canvoy::tools {

/// The interface is taken from all who use it while it is restarted.
class InterfaceBitTiming {
 public:
  using Say = std::function<void(const std::string& line)>;

  InterfaceBitTiming(std::string interface, Say say)
      : interface_(std::move(interface)), say_(std::move(say)) {}

  /// Its bit rate by its index in the table of CiA 305; unknown where it has none.
  std::uint8_t present() const;
  /// Whether it can have another one: out_of_range, and a line, for interfaces without a bit rate
  /// and for what is none.
  LssError configure(std::uint8_t index) const;
  /// Restarts it; one that has the bit rate already is left alone.
  void switch_to(std::uint8_t index) const;

 private:
  std::string interface_;
  Say say_;
};

}  // namespace canvoy::tools
