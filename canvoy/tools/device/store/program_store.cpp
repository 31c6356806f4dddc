#include "canvoy/tools/device/store/program_store.hpp"

#include <fmt/format.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

ProgramStore::ProgramStore(const std::string& path, Say say)
    : say_(std::move(say)),
      file_(value_or_throw(
          host::FileFlash::open(path, {.sector_size = sector_size, .sectors = sectors}))) {}

ProgramHooks ProgramStore::hooks() {
  return {.control = callback<&ProgramStore::control>(*this),
          .check = callback<&ProgramStore::check>(*this),
          .under_way = callback<&ProgramStore::under_way>(*this)};
}

void ProgramStore::say_what_is_there(const ProgramSlot& slot) const {
  say_(slot.valid
           ? fmt::format("program 1 is valid, {} bytes, {:08X}h", slot.length, slot.identification)
           : "there is no valid program");
}

AbortCode ProgramStore::control(std::uint8_t number, ProgramCommand command) {
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

FlashError ProgramStore::check(std::uint8_t number, const ProgramSlot& slot) {
  say_(fmt::format("program {} came, {} bytes, {:08X}h", number, slot.length, slot.identification));
  return FlashError::none;
}

void ProgramStore::under_way(bool is_under_way) {
  if (under_way_told_) under_way_told_(is_under_way);
  if (is_under_way) say_("the flash is written");
}

}  // namespace canvoy::tools
