// A device that does nothing but take a program, for canvoy device bootloader: the place of the
// program is a file.
//
//     Bootloader bootloader(port, 20, "boot.store", say);
//     bootloader.node().start(now);
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/indicators.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302_program.hpp"
#include "canvoy/profiles/layout.hpp"

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
  using Say = std::function<void(const std::string&)>;

  /// Throws Failure where the file cannot be used. What is said is a line for the user.
  Bootloader(const Port& port, NodeId id, const std::string& store, Say say);

  Node& node() { return device_.node(); }
  Indicators& indicators() { return indicators_; }

 private:
  static constexpr std::uint32_t sector_size = 4096;
  static constexpr std::uint32_t sectors = 257;  ///< a megabyte, and one for the head

  AbortCode control(std::uint8_t number, ProgramCommand command);
  FlashError check(std::uint8_t number, const ProgramSlot& slot);
  void under_way(bool is_under_way);

  Say say_;
  std::unique_ptr<host::FileFlash> file_;
  DeviceNode<bootloader_layout> device_;
  Indicators indicators_{device_.node(), &device_.emergency_producer()};
  std::array<ProgramSlot, 1> slots_{{{.address = 0, .size = sectors * sector_size}}};
  ProgramServer programs_;
};

}  // namespace canvoy::tools
