// Input of a fuzzer, as numbers for decisions.
//
//     Input input(data, size);
//     while (!input.empty()) step(input.byte());
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace canvoy::fuzz {

/// The input, byte by byte; zeros after its end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}
  bool empty() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  std::uint16_t word() { return static_cast<std::uint16_t>(byte() | byte() << 8); }
  void fill(std::span<std::uint8_t> bytes) {
    for (std::uint8_t& place : bytes) place = byte();
  }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace canvoy::fuzz
