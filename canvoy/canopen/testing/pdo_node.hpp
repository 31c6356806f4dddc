// A node with SYNC, four RPDOs and four TPDOs, and objects of all kinds to map, for tests at the
// wire.
//
//     PdoNode node;
//     node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
//     node.operate();
//     node.set(0x2010, 1, 0x1234);
//     node.expect({"185#34 12"});
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/sync/sync.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

/// True if a configurable communication object may use the CAN-ID, with 180h free for CiA 417 (CiA
/// 301, 7.3.5).
inline bool is_free(unsigned can_id) {
  return (can_id >= 0x080 && can_id <= 0x100) || (can_id >= 0x180 && can_id <= 0x580) ||
         can_id == 0x600 || (can_id >= 0x680 && can_id <= 0x6DF) || can_id == 0x700;
}

inline constexpr Access pdo_access = Access::rw | Access::rpdo | Access::tpdo;

/// Entry of sub-indices `first` to `last` of one type, mappable in both directions.
constexpr EntryRow mappable(std::uint8_t first, std::uint8_t last, DataType type) {
  return {.sub_first = first, .sub_last = last, .type = type, .access = pdo_access};
}
constexpr EntryRow parameter(std::uint8_t sub, DataType type, std::int64_t initial = 0) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}

/// PDOs are invalid at first, like those of CiA 419.
constexpr EntryRow invalid_cob_id = parameter(1, DataType::unsigned32, CobId::bit31);

inline constexpr auto pdo_layout = lay_out(
    std::to_array<ObjectRow>({
        {.index = 0x1005, .entry_count = 1},
        {.index = 0x1006, .entry_count = 1},
        {.index = 0x1007, .entry_count = 1},
        {.index = 0x1019, .entry_count = 1},
        {.index = 0x1400, .count = 4, .entry_count = 4},
        {.index = 0x1600, .count = 4, .entry_count = 2},
        {.index = 0x1800, .count = 4, .entry_count = 6},
        {.index = 0x1A00, .count = 4, .entry_count = 2},
        {.index = 0x2000, .entry_count = 1},   // U8 1..16
        {.index = 0x2010, .entry_count = 1},   // U16 1..8
        {.index = 0x2020, .entry_count = 1},   // U32 1..4
        {.index = 0x2030, .entry_count = 1},   // BOOLEAN 1..64
        {.index = 0x2040, .entry_count = 27},  // the odd sizes of CiA 447, type 60h at sub 1
        {.index = 0x2050, .entry_count = 12},  // other sizes
        {.index = 0x2060, .entry_count = 1},   // U8 10..20, and 255
        {.index = 0x2061, .entry_count = 1},   // I16 -100..100
        {.index = 0x2062, .entry_count = 1},   // U16 with a hook, if the test sets one
        {.index = 0x2070, .entry_count = 1},   // VISIBLE_STRING of 4
        {.index = 0x2071, .entry_count = 1},   // VISIBLE_STRING of 9
        {.index = 0x2080, .entry_count = 1},   // U16, not mappable
        {.index = 0x2081, .entry_count = 1},   // U16, TPDO only
        {.index = 0x2082, .entry_count = 1},   // U16, RPDO only
        {.index = 0x2083, .entry_count = 1},   // DOMAIN
    }),
    std::to_array<EntryRow>({
        parameter(0, DataType::unsigned32, 0x80),
        parameter(0, DataType::unsigned32),
        parameter(0, DataType::unsigned32),
        parameter(0, DataType::unsigned8),
        {.type = DataType::unsigned8, .initial = 5},
        invalid_cob_id,
        parameter(2, DataType::unsigned8, 255),
        parameter(5, DataType::unsigned16),
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 64, .type = DataType::unsigned32, .access = Access::rw},
        {.type = DataType::unsigned8, .initial = 6},
        invalid_cob_id,
        parameter(2, DataType::unsigned8, 255),
        parameter(3, DataType::unsigned16),
        parameter(5, DataType::unsigned16),
        parameter(6, DataType::unsigned8),
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 64, .type = DataType::unsigned32, .access = Access::rw},
        mappable(1, 16, DataType::unsigned8),
        mappable(1, 8, DataType::unsigned16),
        mappable(1, 4, DataType::unsigned32),
        mappable(1, 64, DataType::boolean),
        mappable(1, 1, DataType{0x60}),
        mappable(2, 2, DataType{0x61}),
        mappable(3, 3, DataType{0x62}),
        mappable(4, 4, DataType{0x63}),
        mappable(5, 5, DataType{0x64}),
        mappable(6, 6, DataType{0x65}),
        mappable(7, 7, DataType{0x66}),
        mappable(8, 8, DataType{0x67}),
        mappable(9, 9, DataType{0x68}),
        mappable(10, 10, DataType{0x69}),
        mappable(11, 11, DataType{0x6A}),
        mappable(12, 12, DataType{0x6B}),
        mappable(13, 13, DataType{0x6C}),
        mappable(14, 14, DataType{0x6D}),
        mappable(15, 15, DataType{0x6E}),
        mappable(16, 16, DataType{0x6F}),
        mappable(17, 17, DataType{0x70}),
        mappable(18, 18, DataType{0x71}),
        mappable(19, 19, DataType{0x72}),
        mappable(20, 20, DataType{0x73}),
        mappable(21, 21, DataType{0x74}),
        mappable(22, 22, DataType{0x75}),
        mappable(23, 23, DataType{0x76}),
        mappable(24, 24, DataType{0x77}),
        mappable(25, 25, DataType{0x78}),
        mappable(26, 26, DataType{0x79}),
        mappable(27, 27, DataType{0x7A}),
        mappable(1, 1, DataType::integer8),
        mappable(2, 2, DataType::integer24),
        mappable(3, 3, DataType::unsigned24),
        mappable(4, 4, DataType::integer40),
        mappable(5, 5, DataType::unsigned48),
        mappable(6, 6, DataType::integer56),
        mappable(7, 7, DataType::unsigned64),
        mappable(8, 8, DataType::real32),
        mappable(9, 9, DataType::real64),
        mappable(10, 10, DataType::time_of_day),
        mappable(11, 11, DataType::integer16),
        mappable(12, 12, DataType::unsigned56),
        {.type = DataType::unsigned8,
         .access = pdo_access,
         .traits = EntryTraits::limited | EntryTraits::has_sentinel,
         .low = 10,
         .high = 20,
         .sentinel = 255,
         .initial = 15},
        {.type = DataType::integer16,
         .access = pdo_access,
         .traits = EntryTraits::limited,
         .low = -100,
         .high = 100},
        mappable(0, 0, DataType::unsigned16),
        {.type = DataType::visible_string, .access = pdo_access, .capacity = 4},
        {.type = DataType::visible_string, .access = pdo_access, .capacity = 9},
        {.type = DataType::unsigned16, .access = Access::rw},
        {.type = DataType::unsigned16, .access = Access::ro | Access::tpdo},
        {.type = DataType::unsigned16, .access = Access::rw | Access::rpdo},
        {.type = DataType::domain, .access = pdo_access},
    }));
inline constexpr DictionaryTables pdo_tables = pdo_layout.tables();

/// Node 5. Values are written like by an SDO server, and mapping follows the procedure of CiA 301.
class PdoNode : public WireNode {
 public:
  static constexpr std::size_t pdo_count = 4;

  explicit PdoNode(Tpdos::AtStart at_start = Tpdos::AtStart::wait_for_event, bool boots = true,
                   std::size_t backlog_size = 16)
      : WireNode(pdo_tables, 5, false, backlog_size),
        sync(node),
        rpdos(node, rpdo_memory_, rpdo_values_, &sync),
        tpdos(node, tpdo_memory_, tpdo_values_, &sync, at_start) {
    recorder_.error_changed = callback<&PdoNode::record>(*this);
    node.attach(recorder_);
    if (boots) boot();
  }

  AbortCode write(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    const Result<Entry> entry = node.dictionary().find(index, sub);
    if (!entry) return entry.abort();
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), number);
    node.advance(now);
    const AbortCode answer =
        node.dictionary().write(*entry, std::span(bytes).first(entry->row->capacity), Source::sdo);
    settle();
    return answer;
  }
  /// Sets a value like the application.
  void set(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    node.advance(now);
    ASSERT_TRUE(node.dictionary().set_number(index, sub, number));
    settle();
  }
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) const {
    return node.dictionary().number(index, sub);
  }

  /// Sets up an RPDO; `mapped`: index, sub-index and bits, as in the mapping record.
  void map_rpdo(unsigned pdo, std::uint32_t cob_id, unsigned type,
                const std::vector<std::uint32_t>& mapped) {
    map(0x1400, 0x1600, pdo, cob_id, type, mapped);
  }
  void map_tpdo(unsigned pdo, std::uint32_t cob_id, unsigned type,
                const std::vector<std::uint32_t>& mapped) {
    map(0x1800, 0x1A00, pdo, cob_id, type, mapped);
  }
  /// Puts the node into NMT state operational; frames sent then are kept.
  void operate() { receive("000#01 00"); }

  /// Errors that appeared (+) and disappeared (-) since the last call: "+8210/1" with code and
  /// instance.
  std::vector<std::string> errors() { return std::exchange(errors_, {}); }
  const Error& last_error() const { return last_error_; }

 private:
  void map(std::uint16_t parameters, std::uint16_t records, unsigned pdo, std::uint32_t cob_id,
           unsigned type, const std::vector<std::uint32_t>& mapped) {
    const auto parameter_index = static_cast<std::uint16_t>(parameters + pdo - 1);
    const auto record = static_cast<std::uint16_t>(records + pdo - 1);
    ASSERT_EQ(write(parameter_index, 1, cob_id | CobId::bit31), AbortCode::none);
    ASSERT_EQ(write(parameter_index, 2, type), AbortCode::none);
    ASSERT_EQ(write(record, 0, 0), AbortCode::none);
    std::uint8_t sub = 0;
    for (const std::uint32_t entry : mapped) {
      ASSERT_EQ(write(record, ++sub, entry), AbortCode::none) << std::hex << entry;
    }
    ASSERT_EQ(write(record, 0, mapped.size()), AbortCode::none);
    ASSERT_EQ(write(parameter_index, 1, cob_id), AbortCode::none);
  }
  void record(const Error& error, bool present) {
    char text[16];
    std::snprintf(text, sizeof text, "%c%04X/%u", present ? '+' : '-', error.code, error.instance);
    errors_.emplace_back(text);
    last_error_ = error;
  }

  std::array<Rpdo, pdo_count> rpdo_memory_;
  std::array<Tpdo, pdo_count> tpdo_memory_;
  std::array<MappedValue, pdo_count * pdo_values_max> rpdo_values_;
  std::array<MappedValue, pdo_count * pdo_values_max> tpdo_values_;
  std::vector<std::string> errors_;
  Error last_error_;
  Service recorder_;

 public:
  Sync sync;
  Rpdos rpdos;
  Tpdos tpdos;
};

}  // namespace canvoy
