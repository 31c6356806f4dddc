// A flash memory of a simulated device, which keeps its contents while the device has no power.
//
//     KeptFlash flash(2, 512);
//     hardware.flash = &flash.flash();
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/storage/flash.hpp"

namespace canvoy::taxi {

class KeptFlash {
 public:
  /// An erased memory; `sector_size` in bytes.
  KeptFlash(std::size_t sectors, std::uint32_t sector_size) : bytes_(sectors * sector_size, 0xFF) {
    flash_.sector_size = sector_size;
    flash_.unit = 8;
    flash_.erase = decltype(Flash::erase)::to<&KeptFlash::erase>(*this);
    flash_.program = decltype(Flash::program)::to<&KeptFlash::program>(*this);
    flash_.read = decltype(Flash::read)::to<&KeptFlash::read>(*this);
  }
  KeptFlash(const KeptFlash&) = delete;
  KeptFlash& operator=(const KeptFlash&) = delete;

  /// Functions for the device; valid as long as this object.
  const Flash& flash() const { return flash_; }

 private:
  FlashState erase(std::uint32_t address) {
    std::fill_n(at(address), flash_.sector_size, std::uint8_t{0xFF});
    return FlashState::done;
  }
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    std::ranges::copy(bytes, at(address));
    return FlashState::done;
  }
  bool read(std::uint32_t address, std::span<std::uint8_t> bytes) {
    std::copy_n(at(address), bytes.size(), bytes.begin());
    return true;
  }
  std::vector<std::uint8_t>::iterator at(std::uint32_t address) {
    return bytes_.begin() + static_cast<std::ptrdiff_t>(address);
  }

  std::vector<std::uint8_t> bytes_;
  Flash flash_;
};

}  // namespace canvoy::taxi
