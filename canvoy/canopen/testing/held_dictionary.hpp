// A dictionary with its memory, for tests only.
//
//     Held sut(shapes.tables());
//     EXPECT_EQ(sut.write(0x1018, 3, {1, 2}), AbortCode::none);
//     EXPECT_EQ(sut.read(0x1018, 3), (Bytes{1, 2}));
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"

namespace canvoy {

using Bytes = std::vector<std::uint8_t>;

/// A dictionary with its memory.
struct Held {
  explicit Held(const DictionaryTables& rows, std::uint8_t node_id = 5)
      : tables(rows),
        values(tables.value_bytes, 0xEE),
        states(tables.objects.size()),
        dictionary(tables, values, states) {
    dictionary.restore_defaults(0, 0xFFFF, node_id);
    dictionary.clear_changes();
  }

  AbortCode write(std::uint16_t index, std::uint8_t sub, const Bytes& bytes,
                  Source source = Source::sdo) {
    return dictionary.write(index, sub, bytes, source);
  }
  /// Value as a client reads it, or nothing and the reason in `abort`.
  Bytes read(std::uint16_t index, std::uint8_t sub) {
    const Result<Entry> entry = dictionary.find(index, sub);
    abort = entry.abort();
    if (!entry) return {};
    const auto bytes = dictionary.read(*entry);
    abort = bytes.abort();
    return bytes ? Bytes(bytes->begin(), bytes->end()) : Bytes{};
  }
  Entry entry(std::uint16_t index, std::uint8_t sub = 0) { return *dictionary.find(index, sub); }

  DictionaryTables tables;
  Bytes values;
  std::vector<ObjectState> states;
  Dictionary dictionary;
  AbortCode abort = AbortCode::none;
};

inline Bytes bytes_of(std::uint64_t number, std::size_t length) {
  Bytes bytes(8);
  store(bytes.data(), number);
  bytes.resize(length);
  return bytes;
}

// A variable, a record, an array, sixteen objects of one shape, and neighbours at both ends.
inline constexpr auto shapes = lay_out(
    std::to_array<ObjectRow>({{.index = 0x0001, .entry_count = 1},
                              {.index = 0x1018, .entry_count = 3},
                              {.index = 0x6000, .entry_count = 2},
                              {.index = 0x6100, .count = 16, .entry_count = 3},
                              {.index = 0xFFFF, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {{.access = Access::rw},
         {.access = Access::const_, .initial = 2},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .access = Access::rw},
         {.sub_first = 3, .sub_last = 3, .type = DataType::unsigned16, .access = Access::rw},
         {.access = Access::const_, .initial = 254},
         {.sub_first = 1, .sub_last = 254, .type = DataType::unsigned16, .access = Access::rw},
         {.access = Access::const_, .initial = 9},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned24, .access = Access::rw},
         {.sub_first = 9, .sub_last = 9, .type = DataType::boolean, .access = Access::rw},
         {.access = Access::rw}}));

}  // namespace canvoy
