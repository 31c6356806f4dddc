// The file in which a device of `canvoy device` stores a downloaded program (CiA 302-3), and text
// about it.
//
//     ProgramStore store("boot.store", say);
//     ProgramServer programs(node, store.flash(), slots, store.hooks());
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/devices/kit/program_place.hpp"

namespace canvoy::tools {

class ProgramStore {
 public:
  using Say = std::function<void(const std::string&)>;

  /// Throws Failure if the file cannot be used. `say` gets lines for the user.
  ProgramStore(const std::string& path, Say say);
  ProgramStore(const ProgramStore&) = delete;
  ProgramStore& operator=(const ProgramStore&) = delete;

  const Flash& flash() const { return file_->flash(); }
  ProgramHooks hooks();
  ProgramPlace place() { return {.flash = &flash(), .size = size, .hooks = hooks()}; }
  /// Sets the function called when writing of the flash begins and ends, for indicators.
  void on_under_way(std::function<void(bool)> told) { under_way_told_ = std::move(told); }
  /// Reports the stored program, after the start.
  void say_what_is_there(const ProgramSlot& slot) const;

  static constexpr std::uint32_t sector_size = 4096;
  static constexpr std::uint32_t sectors = 257;  ///< one megabyte, and one for the head
  static constexpr std::uint32_t size = sectors * sector_size;

 private:
  AbortCode control(std::uint8_t number, ProgramCommand command);
  FlashError check(std::uint8_t number, const ProgramSlot& slot);
  void under_way(bool is_under_way);

  Say say_;
  std::unique_ptr<host::FileFlash> file_;
  std::function<void(bool)> under_way_told_;
};

}  // namespace canvoy::tools
