// The file that a device of `canvoy device` keeps a downloaded program in (CiA 302-3), and words
// for what becomes of it.
//
//     ProgramStore store("boot.store", say);
//     ProgramServer programs(node, store.flash(), slots, store.hooks());
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/devices/program_place.hpp"

namespace canvoy::tools {

class ProgramStore {
 public:
  using Say = std::function<void(const std::string&)>;

  /// Throws Failure where the file cannot be used. What is said is a line for the user.
  ProgramStore(const std::string& path, Say say);
  ProgramStore(const ProgramStore&) = delete;
  ProgramStore& operator=(const ProgramStore&) = delete;

  const Flash& flash() const { return file_->flash(); }
  ProgramHooks hooks();
  ProgramPlace place() { return {.flash = &flash(), .size = size, .hooks = hooks()}; }
  /// For indicators: the flash begins to be written, or that is over.
  void on_under_way(std::function<void(bool)> told) { under_way_told_ = std::move(told); }
  /// What there is, after the start.
  void say_what_is_there(const ProgramSlot& slot) const;

  static constexpr std::uint32_t sector_size = 4096;
  static constexpr std::uint32_t sectors = 257;  ///< a megabyte, and one for the head
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
