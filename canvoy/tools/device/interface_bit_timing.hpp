// The bit rate of a CAN interface of this machine, set by LSS (CiA 305).
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

/// All users lose the interface while it is restarted.
class InterfaceBitTiming {
 public:
  using Say = std::function<void(const std::string& line)>;

  InterfaceBitTiming(std::string interface, Say say)
      : interface_(std::move(interface)), say_(std::move(say)) {}

  /// Index of the bit rate in the table of CiA 305; unknown if it has none.
  std::uint8_t present() const;
  /// Checks whether the interface can have this bit rate: out_of_range, and a line, for interfaces
  /// without a bit rate and for invalid indices.
  LssError configure(std::uint8_t index) const;
  /// Restarts the interface, unless it has the bit rate already.
  void switch_to(std::uint8_t index) const;

 private:
  std::string interface_;
  Say say_;
};

}  // namespace canvoy::tools
