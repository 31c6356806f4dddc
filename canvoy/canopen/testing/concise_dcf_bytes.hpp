// Concise DCFs for tests, written as entries.
//
//     Bytes dcf = concise_dcf({{0x1017, 0, {0xF4, 0x01}}});
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/manager/concise_dcf.hpp"

namespace canvoy {

struct DcfEntry {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::vector<std::uint8_t> value;
};

inline std::vector<std::uint8_t> concise_dcf(const std::vector<DcfEntry>& entries) {
  std::vector<std::uint8_t> bytes;
  const auto append = [&bytes](std::size_t number, int length) {
    for (int i = 0; i < length; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
  };
  append(entries.size(), 4);
  for (const DcfEntry& entry : entries) {
    append(entry.index, 2);
    append(entry.sub, 1);
    append(entry.value.size(), 4);
    bytes.insert(bytes.end(), entry.value.begin(), entry.value.end());
  }
  return bytes;
}

/// A source of bytes in memory, which must outlive it.
class BytesSource {
 public:
  explicit BytesSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  ByteSource source() {
    return {static_cast<std::uint32_t>(bytes_.size()), callback<&BytesSource::read>(*this)};
  }

 private:
  AbortCode read(std::uint32_t offset, std::span<std::uint8_t> to) {
    if (offset + to.size() > bytes_.size()) return AbortCode::internal_incompatible;
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = bytes_[offset + i];
    return AbortCode::none;
  }
  std::span<const std::uint8_t> bytes_;
};

}  // namespace canvoy
