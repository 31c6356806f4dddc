#include "canvoy/canopen/protocol/little_endian.hpp"

#include <algorithm>

namespace canvoy {

std::uint32_t load_word_by_bytes(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t number = 0;
  for (std::size_t i = std::min(size, sizeof number); i-- != 0;) {
    number = number << 8 | bytes[i];
  }
  return number;
}

}  // namespace canvoy
