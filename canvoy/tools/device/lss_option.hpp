// LSS for a device of the command: its serial number, where its node-ID is kept, and words for what
// happens.
//
//     LssOption lss(output, "battery", device.node(), {.serial_number = 7});
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "canvoy/canopen/identity.hpp"
#include "canvoy/canopen/lss/bit_timing_switch.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/tools/device/device_output.hpp"
#include "canvoy/tools/device/interface_bit_timing.hpp"

namespace canvoy::tools {

class LssOption {
 public:
  struct Settings {
    std::optional<std::uint32_t> serial_number;
    const Flash* flash = nullptr;  ///< that keeps the node-ID; null: it is not kept
    LssStore::Place place = {};
    std::string interface = {};        ///< of which LSS may set the bit rate; empty: of none
    Indicators* indicators = nullptr;  ///< that show its state
    /// The interface gets the bit rate that is kept: not, where it was just found by listening.
    bool takes_stored_bit_rate = true;
  };

  /// Before Node::start(). The node has a route left for it.
  LssOption(const DeviceOutput& output, std::string who, Node& node, const Settings& settings);
  LssOption(const LssOption&) = delete;
  LssOption& operator=(const LssOption&) = delete;

 private:
  void reset(ResetScope scope);
  void entered(LssState state);
  void switch_to(std::uint8_t bit_timing) {
    if (bit_timing_) bit_timing_->switch_to(bit_timing);
  }
  LssSlaveHooks hooks(const Settings& settings);

  const DeviceOutput& output_;
  std::string who_;
  Node& node_;
  NodeId told_ = 0;  ///< the pending node-ID that was spoken of
  Identity identity_;
  Indicators* indicators_;
  std::optional<LssStore> store_;
  std::optional<InterfaceBitTiming> bit_timing_;
  std::optional<BitTimingSwitch> switch_;
  LssSlave slave_;
  Service service_;
};

}  // namespace canvoy::tools
