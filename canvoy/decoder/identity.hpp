// Identity of a node, as far as a listener knows it: 1018h, or the LSS address (CiA 301, 7.5.2.19;
// CiA 305).
//
//     Identity identity;
//     identity.set(LssAddress::vendor, 0x2F0);
//     identity.is_product();  // false: the product code is not known
#pragma once

#include <cstddef>
#include <cstdint>

#include "canvoy/canopen/lss/lss.hpp"

namespace canvoy::decoder {

class Identity {
 public:
  static constexpr std::size_t count = 4;  ///< parts: see LssAddress

  /// True if a part (LssAddress::vendor and so on) is known.
  bool has(std::size_t part) const { return (known_ & 1U << part) != 0; }
  /// A part; 0 while it is not known.
  std::uint32_t part(std::size_t part) const { return address_.parts.at(part); }
  bool empty() const { return known_ == 0; }
  /// True if vendor-ID and product code are known.
  bool is_product() const { return has(LssAddress::vendor) && has(LssAddress::product); }

  /// Sets a part, also if it was known.
  void set(std::size_t part, std::uint32_t value) {
    address_.parts.at(part) = value;
    known_ = static_cast<std::uint8_t>(known_ | 1U << part);
  }
  /// Makes a part unknown.
  void forget(std::size_t part) {
    address_.parts.at(part) = 0;
    known_ = static_cast<std::uint8_t>(known_ & ~(1U << part));
  }
  /// Adds the parts that the other identity has.
  void add(const Identity& other) {
    for (std::size_t i = 0; i < count; ++i) {
      if (other.has(i)) set(i, other.part(i));
    }
  }
  /// True if a part that both have differs: they belong to two devices.
  bool contradicts(const Identity& other) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (has(i) && other.has(i) && part(i) != other.part(i)) return true;
    }
    return false;
  }

  friend bool operator==(const Identity&, const Identity&) = default;

 private:
  LssAddress address_;
  std::uint8_t known_ = 0;  ///< one bit for each part
};

}  // namespace canvoy::decoder
