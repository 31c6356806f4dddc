#include "canvoy/canopen/little_endian.hpp"

#include <algorithm>

namespace canvoy {

std::uint32_t load_word(std::span<const std::uint8_t> bytes) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof number));
  return number;
}

}  // namespace canvoy
