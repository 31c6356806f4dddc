// A device that only takes a program, for `canvoy device bootloader`: the program is stored in a
// file.
//
//     Bootloader bootloader(port, 20, "boot.store", say);
//     bootloader.node().start(now);
#pragma once

#include <array>
#include <string>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/device/indicators.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/program.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/tools/device/store/program_store.hpp"

namespace canvoy::tools {

inline constexpr auto bootloader_description = describe(
    cia301::device_type(0), cia301::error_register_object, cia301::identity({.product_code = 302}),
    cia301::names({.device = "Canvoy bootloader",
                   .hardware_version = "simulated",
                   .software_version = "0.1.0"}),
    cia301::heartbeat_producer(1000), cia301::emergency(), cia302::programs(1));
inline constexpr auto bootloader_layout = lay_out_device<bootloader_description>();

class Bootloader {
 public:
  /// Throws Failure if the file cannot be used. `say` gets lines for the user.
  Bootloader(const Port& port, NodeId id, const std::string& store, ProgramStore::Say say);

  Node& node() { return device_.node(); }
  Indicators& indicators() { return indicators_; }

 private:
  ProgramStore store_;
  DeviceNode<bootloader_layout> device_;
  Indicators indicators_{device_.node(), &device_.emergency_producer()};
  std::array<ProgramSlot, 1> slots_{{{.address = 0, .size = ProgramStore::size}}};
  ProgramServer programs_;
};

}  // namespace canvoy::tools
