#include "canvoy/canopen/pdo_parameter.hpp"

#include <algorithm>

namespace canvoy {

std::uint32_t load_number(std::span<const std::uint8_t> bytes) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof number));
  return number;
}

std::uint32_t read_parameter(const Dictionary& dictionary, std::uint16_t index, std::uint8_t sub,
                             std::uint32_t absent) {
  const Result<Entry> entry = dictionary.find(index, sub);
  return entry ? load_number(entry->bytes()) : absent;
}

}  // namespace canvoy
