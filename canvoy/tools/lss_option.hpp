// LSS for a device of the command: its serial number, where its node-ID is kept, and words for what
// happens.
//
//     LssOption lss("battery", device.node(), {.serial_number = 7});
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "canvoy/canopen/identity.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"

namespace canvoy::tools {

class LssOption {
 public:
  struct Settings {
    std::optional<std::uint32_t> serial_number;
    const Flash* flash = nullptr;  ///< that keeps the node-ID; null: it is not kept
    LssStore::Place place;
  };

  /// Before Node::start(). The node has a route left for it.
  LssOption(std::string who, Node& node, const Settings& settings);
  LssOption(const LssOption&) = delete;
  LssOption& operator=(const LssOption&) = delete;

 private:
  void reset(ResetScope scope);
  void entered(LssState state);

  std::string who_;
  Node& node_;
  NodeId told_ = 0;  ///< the pending node-ID that was spoken of
  Identity identity_;
  std::optional<LssStore> store_;
  LssSlave slave_;
  Service service_;
};

}  // namespace canvoy::tools
