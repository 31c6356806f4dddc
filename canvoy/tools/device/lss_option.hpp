// LSS for a device of the command: its serial number, storage of its node-ID, and text of events.
//
//     LssOption lss(output, "battery", device.node(), {.serial_number = 7});
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "canvoy/canopen/lss/bit_timing_switch.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/remote/identity.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/interface_bit_timing.hpp"

namespace canvoy::tools {

class LssOption {
 public:
  struct Settings {
    std::optional<std::uint32_t> serial_number;
    const Flash* flash = nullptr;  ///< storage of the node-ID; null: not stored
    LssStore::Place place = {};
    std::string interface = {};        ///< interface with a bit rate that LSS may set; empty: none
    Indicators* indicators = nullptr;  ///< indicators of its state
    /// Uses the stored bit rate for the interface; false if the bit rate was just found by
    /// listening.
    bool takes_stored_bit_rate = true;
  };

  /// To be called before Node::start(). The node must have a free route.
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
  NodeId told_ = 0;  ///< the pending node-ID that was last reported
  Identity identity_;
  Indicators* indicators_;
  std::optional<LssStore> store_;
  std::optional<InterfaceBitTiming> bit_timing_;
  std::optional<BitTimingSwitch> switch_;
  LssSlave slave_;
  Service service_;
};

}  // namespace canvoy::tools
