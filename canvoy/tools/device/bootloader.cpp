#include "canvoy/tools/device/bootloader.hpp"

#include <fmt/format.h>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

Bootloader::Bootloader(const Port& port, NodeId id, const std::string& store, Say say)
    : say_(std::move(say)),
      file_(value_or_throw(
          host::FileFlash::open(store, {.sector_size = sector_size, .sectors = sectors}))),
      device_(port, id),
      programs_(
          device_.node(), file_->flash(), slots_,
          {.control =
               Callback<AbortCode(std::uint8_t, ProgramCommand)>::to<&Bootloader::control>(*this),
           .check = Callback<FlashError(std::uint8_t, const ProgramSlot&)>::to<&Bootloader::check>(
               *this),
           .under_way = Callback<void(bool)>::to<&Bootloader::under_way>(*this)}) {
  say_(slots_[0].valid ? fmt::format("program 1 is valid, {} bytes, {:08X}h", slots_[0].length,
                                     slots_[0].identification)
                       : "there is no valid program");
}

AbortCode Bootloader::control(std::uint8_t number, ProgramCommand command) {
  switch (command) {
    case ProgramCommand::stop:
      say_(fmt::format("program {} stopped", number));
      break;
    case ProgramCommand::start:
      say_(fmt::format("program {} started", number));
      break;
    default:
      say_(fmt::format("program {} reset", number));
      break;
  }
  return AbortCode::none;
}

FlashError Bootloader::check(std::uint8_t number, const ProgramSlot& slot) {
  say_(fmt::format("program {} came, {} bytes, {:08X}h", number, slot.length, slot.identification));
  return FlashError::none;
}

void Bootloader::under_way(bool is_under_way) {
  indicators_.program_under_way(is_under_way);
  if (is_under_way) say_("the flash is written");
}

}  // namespace canvoy::tools
