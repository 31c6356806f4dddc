// A dictionary with one object of each kind that SDO treats differently, and a domain in memory.
//
//     WireNode wire(sdo_objects(), 5);
//     MemoryDomain domain(wire.node, 0x2030);
//
// For tests only.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

namespace detail {

inline constexpr auto sdo_objects_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                      {.index = 0x1201, .count = 2, .entry_count = 3},
                                      {.index = 0x1280, .count = 2, .entry_count = 3},
                                      {.index = 0x2001, .entry_count = 1},
                                      {.index = 0x2002, .entry_count = 1},
                                      {.index = 0x2003, .entry_count = 1},
                                      {.index = 0x2004, .entry_count = 1},
                                      {.index = 0x2005, .entry_count = 1},
                                      {.index = 0x2006, .entry_count = 1},
                                      {.index = 0x2007, .entry_count = 1},
                                      {.index = 0x2008, .entry_count = 1},
                                      {.index = 0x2009, .entry_count = 2},
                                      {.index = 0x2010, .entry_count = 1},
                                      {.index = 0x2011, .entry_count = 1},
                                      {.index = 0x2012, .entry_count = 1},
                                      {.index = 0x2013, .entry_count = 1},
                                      {.index = 0x2020, .entry_count = 1},
                                      {.index = 0x2021, .entry_count = 1},
                                      {.index = 0x2030, .entry_count = 1},
                                      {.index = 0x2031, .entry_count = 1},
                                      {.index = 0x2032, .entry_count = 1},
                                      {.index = 0x2033, .entry_count = 1}}),
            std::to_array<EntryRow>({
                {.type = DataType::unsigned32, .initial = 0x0002'01A2},
                // 1201h and 1202h: SDO servers; 1280h and 1281h: SDO clients
                {.type = DataType::unsigned8, .initial = 3},
                {.sub_first = 1,
                 .sub_last = 2,
                 .type = DataType::unsigned32,
                 .access = Access::rw,
                 .initial = 0x8000'0000},
                {.sub_first = 3, .sub_last = 3, .type = DataType::unsigned8, .access = Access::rw},
                {.type = DataType::unsigned8, .initial = 3},
                {.sub_first = 1,
                 .sub_last = 2,
                 .type = DataType::unsigned32,
                 .access = Access::rw,
                 .initial = 0x8000'0000},
                {.sub_first = 3, .sub_last = 3, .type = DataType::unsigned8, .access = Access::rw},
                // 2001h to 2008h: number of bytes as in the last digit
                {.type = DataType::unsigned8, .access = Access::rw},
                {.type = DataType::unsigned16, .access = Access::rw},
                {.type = DataType::unsigned24, .access = Access::rw},
                {.type = DataType::unsigned32, .access = Access::rw},
                {.type = DataType::unsigned40, .access = Access::rw},
                {.type = DataType::unsigned48, .access = Access::rw},
                {.type = DataType::unsigned56, .access = Access::rw},
                {.type = DataType::unsigned64, .access = Access::rw},
                // 2009h: an array
                {.type = DataType::unsigned8, .initial = 3},
                {.sub_first = 1, .sub_last = 3, .type = DataType::integer16, .access = Access::rw},
                // 2010h: -10 to 20
                {.type = DataType::integer8,
                 .access = Access::rw,
                 .traits = EntryTraits::limited,
                 .low = -10,
                 .high = 20},
                // 2011h: write only; 2012h: read only; 2013h: constant
                {.type = DataType::unsigned16, .access = Access::wo},
                {.type = DataType::unsigned16, .access = Access::ro, .initial = 0x1234},
                {.type = DataType::visible_string,
                 .access = Access::const_,
                 .capacity = 16,
                 .initial_text = "Canvoy node"},
                // 2020h and 2021h: strings
                {.type = DataType::visible_string, .access = Access::rw, .capacity = 3},
                {.type = DataType::octet_string, .access = Access::rw, .capacity = 5000},
                // 2030h to 2033h: domains: rw, ro, wo, and one without callbacks
                {.type = DataType::domain, .access = Access::rw},
                {.type = DataType::domain, .access = Access::ro},
                {.type = DataType::domain, .access = Access::wo},
                {.type = DataType::domain, .access = Access::rw},
            }));

}  // namespace detail

inline DictionaryTables sdo_objects() {
  return detail::sdo_objects_layout.tables();
}

/// A domain object that is a vector, and records its calls.
class MemoryDomain {
 public:
  MemoryDomain(Node& node, std::uint16_t index) {
    hook_.first = hook_.last = index;
    hook_.domain = &domain_;
    domain_.open_read = decltype(Domain::open_read)::to<&MemoryDomain::open_read>(*this);
    domain_.read = decltype(Domain::read)::to<&MemoryDomain::read>(*this);
    domain_.open_write = decltype(Domain::open_write)::to<&MemoryDomain::open_write>(*this);
    domain_.write = decltype(Domain::write)::to<&MemoryDomain::write>(*this);
    domain_.close_write = decltype(Domain::close_write)::to<&MemoryDomain::close_write>(*this);
    node.dictionary().attach(hook_);
  }
  MemoryDomain(const MemoryDomain&) = delete;
  MemoryDomain& operator=(const MemoryDomain&) = delete;

  std::vector<std::uint8_t> content;
  std::vector<std::uint8_t> arriving;
  std::uint32_t announced = 0xFFFF'FFFF;  ///< by the last open_write
  bool open = false;                      ///< a download is under way
  int opened = 0;                         ///< number of uploads begun
  int dropped = 0;                        ///< number of downloads without success
  AbortCode open_answer = AbortCode::none;
  AbortCode close_answer = AbortCode::none;
  std::size_t refused_from = SIZE_MAX;  ///< offset from which reading and writing fail
  std::size_t longest_piece = 0;
  bool tells_size = true;  ///< at the beginning of an upload

 private:
  Result<std::uint32_t> open_read(const Entry&) {
    if (open_answer != AbortCode::none) return open_answer;
    ++opened;
    return tells_size ? static_cast<std::uint32_t>(content.size()) : Domain::size_unknown;
  }
  Result<std::size_t> read(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    longest_piece = std::max(longest_piece, bytes.size());
    if (offset + bytes.size() > refused_from) return AbortCode::hardware;
    const std::size_t left = content.size() - std::min<std::size_t>(offset, content.size());
    const std::size_t size = std::min(bytes.size(), left);
    std::copy_n(content.begin() + static_cast<long>(content.size() - left), size, bytes.begin());
    return size;
  }
  AbortCode open_write(const Entry&, std::uint32_t size) {
    if (open_answer != AbortCode::none) return open_answer;
    announced = size;
    arriving.clear();
    open = true;
    return AbortCode::none;
  }
  AbortCode write(const Entry&, std::span<const std::uint8_t> bytes) {
    longest_piece = std::max(longest_piece, bytes.size());
    if (arriving.size() + bytes.size() > refused_from) return AbortCode::hardware;
    arriving.insert(arriving.end(), bytes.begin(), bytes.end());
    return AbortCode::none;
  }
  AbortCode close_write(const Entry&, bool complete) {
    open = false;
    if (!complete) ++dropped;
    if (!complete || close_answer != AbortCode::none) return close_answer;
    content = arriving;
    return AbortCode::none;
  }

  Domain domain_;
  Hook hook_;
};

/// Value of an entry inside the device.
inline std::vector<std::uint8_t> value_of(Node& node, std::uint16_t index, std::uint8_t sub = 0) {
  const auto bytes = node.dictionary().find(index, sub)->bytes();
  return {bytes.begin(), bytes.end()};
}

inline void set_value(Node& node, std::uint16_t index, std::span<const std::uint8_t> bytes) {
  node.dictionary().set(*node.dictionary().find(index, 0), bytes);
}

/// Bytes in which no two neighbouring segments are equal.
inline std::vector<std::uint8_t> pattern(std::size_t size, std::uint8_t seed = 1) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::uint8_t>(i * 31 + i / 7 + seed);
  }
  return bytes;
}

}  // namespace canvoy
