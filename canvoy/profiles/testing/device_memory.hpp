// A dictionary made from a description, with memory from the heap, in its state after power-on; and
// its entries, compared with rows that are typed from a clause.
//
//     DeviceMemory device(layout.tables(), 5);
//     device.dictionary.number(0x1000, 0);
//     constexpr Expected entries[] = {{0x1000, 0, u32, "ro", 0x000001A3, "6.2.1"}};
//     expect_entries(device.dictionary, entries);
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary.hpp"

namespace canvoy {

class DeviceMemory {
 public:
  explicit DeviceMemory(const DictionaryTables& tables, std::uint8_t node_id = 1)
      : tables_(tables),
        bytes_(tables.value_bytes),
        states_(tables.objects.size()),
        dictionary(tables_, bytes_, states_) {
    dictionary.restore_defaults(0, 0xFFFF, node_id);
  }

 private:
  DictionaryTables tables_;
  std::vector<std::uint8_t> bytes_;
  std::vector<ObjectState> states_;

 public:
  Dictionary dictionary;
};

/// "rw TR": the access of SDO, and the PDOs into which an entry may be mapped.
inline std::string access_text(Access access) {
  std::string text = allows(access, Access::const_) ? "const"
                     : allows(access, Access::rw)   ? "rw"
                     : allows(access, Access::ro)   ? "ro"
                     : allows(access, Access::wo)   ? "wo"
                                                    : "none";
  if (allows(access, Access::tpdo)) text += " T";
  if (allows(access, Access::rpdo)) text += allows(access, Access::tpdo) ? "R" : " R";
  return text;
}

namespace entry_rows {

/// Types, as CiA 301 numbers them.
constexpr unsigned i16 = 3, u8 = 5, u16 = 6, u32 = 7, domain = 15, u64 = 0x1B;

/// An entry of a device.
struct Expected {
  unsigned index;
  unsigned sub;
  unsigned type;
  const char* access;     ///< see access_text()
  std::uint64_t initial;  ///< not compared for a domain
  const char* clause = "";
};

inline void expect_entries(const Dictionary& dictionary, std::span<const Expected> entries) {
  for (const Expected& expected : entries) {
    SCOPED_TRACE(testing::Message()
                 << expected.clause << ": " << std::hex << expected.index << "h " << expected.sub);
    const auto entry = dictionary.find(static_cast<std::uint16_t>(expected.index),
                                       static_cast<std::uint8_t>(expected.sub));
    ASSERT_TRUE(entry);
    EXPECT_EQ(static_cast<unsigned>(entry->row->type), expected.type);
    EXPECT_EQ(access_text(entry->row->access), expected.access);
    if (expected.type == domain) continue;
    EXPECT_EQ(load_unsigned(entry->bytes()), expected.initial);
  }
}

}  // namespace entry_rows

}  // namespace canvoy
