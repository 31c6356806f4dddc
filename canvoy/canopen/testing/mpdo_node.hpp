// A node with two RPDOs and three TPDOs that can be multiplexed, two scanner and two dispatching
// lists, and objects of all kinds, for tests at the wire.
//
//     MpdoNode node;
//     node.use_tpdo(1, 0x185, 0xFE);            // source address mode
//     ASSERT_EQ(node.write(0x1FA0, 1, 0x01'2000'01), AbortCode::none);
//     ASSERT_EQ(node.write(0x1FA0, 0, 1), AbortCode::none);
//     node.operate();
//     node.set(0x2000, 1, 7);
//     node.expect({"185#05 00 20 01 07 00 00 00"});
#pragma once

#include "canvoy/canopen/pdo/mpdo_consumer.hpp"
#include "canvoy/canopen/pdo/mpdo_producer.hpp"
#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy {

inline constexpr auto mpdo_layout = lay_out(
    std::to_array<ObjectRow>({
        {.index = 0x1400, .count = 2, .entry_count = 3},
        {.index = 0x1600, .count = 2, .entry_count = 2},
        {.index = 0x1800, .count = 3, .entry_count = 4},
        {.index = 0x1A00, .count = 3, .entry_count = 2},
        {.index = 0x1FA0, .count = 2, .entry_count = 2},
        {.index = 0x1FD0, .count = 2, .entry_count = 2},
        {.index = 0x2000, .entry_count = 1},  // U8 1..16
        {.index = 0x2010, .entry_count = 1},  // U16 1..8
        {.index = 0x2020, .entry_count = 1},  // U32 1..4
        {.index = 0x2030, .entry_count = 1},  // U64: longer than an MPDO
        {.index = 0x2040, .entry_count = 1},  // I24
        {.index = 0x2050, .entry_count = 1},  // BOOLEAN
        {.index = 0x2060, .entry_count = 1},  // U8 10..20
        {.index = 0x2070, .entry_count = 1},  // VISIBLE_STRING of 4
        {.index = 0x2080, .entry_count = 1},  // U16, not mappable
        {.index = 0x2081, .entry_count = 1},  // U16, TPDO only
        {.index = 0x2082, .entry_count = 1},  // U16, RPDO only
        {.index = 0x2090, .entry_count = 2},  // U8 at sub-indices 1 and 3
    }),
    std::to_array<EntryRow>({
        invalid_cob_id,
        parameter(2, DataType::unsigned8, 255),
        parameter(5, DataType::unsigned16),
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
        invalid_cob_id,
        parameter(2, DataType::unsigned8, 255),
        parameter(3, DataType::unsigned16),
        parameter(5, DataType::unsigned16),
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 254, .type = DataType::unsigned32, .access = Access::rw},
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 254, .type = DataType::unsigned64, .access = Access::rw},
        mappable(1, 16, DataType::unsigned8),
        mappable(1, 8, DataType::unsigned16),
        mappable(1, 4, DataType::unsigned32),
        mappable(0, 0, DataType::unsigned64),
        mappable(0, 0, DataType::integer24),
        mappable(0, 0, DataType::boolean),
        {.type = DataType::unsigned8,
         .access = pdo_access,
         .traits = EntryTraits::limited,
         .low = 10,
         .high = 20,
         .initial = 15},
        {.type = DataType::visible_string, .access = pdo_access, .capacity = 4},
        {.type = DataType::unsigned16, .access = Access::rw},
        {.type = DataType::unsigned16, .access = Access::ro | Access::tpdo},
        {.type = DataType::unsigned16, .access = Access::rw | Access::rpdo},
        mappable(1, 1, DataType::unsigned8),
        mappable(3, 3, DataType::unsigned8),
    }));
inline constexpr DictionaryTables mpdo_tables = mpdo_layout.tables();

/// Node 5, or another, with room for 24 scanned objects and a queue of 4 frames.
class MpdoNode : public WireNode {
 public:
  explicit MpdoNode(Tpdos::AtStart at_start = Tpdos::AtStart::wait_for_event, NodeId id = 5,
                    const DictionaryTables& tables = mpdo_tables)
      : WireNode(tables, id),
        sync(node),
        rpdos(node, rpdo_memory_, rpdo_values_, &sync),
        tpdos(node, tpdo_memory_, tpdo_values_, &sync, at_start),
        mpdo_consumer(node, rpdos),
        mpdo_producer(node, tpdos, scanned_, queue_) {
    recorder_.error_changed = callback<&MpdoNode::record>(*this);
    node.attach(recorder_);
    boot();
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

  /// Sets up a multiplexed RPDO; `mode` is FEh or FFh.
  void use_rpdo(unsigned pdo, std::uint32_t cob_id, unsigned mode) {
    use(static_cast<std::uint16_t>(0x1400 + pdo - 1), cob_id, mode);
  }
  void use_tpdo(unsigned pdo, std::uint32_t cob_id, unsigned mode) {
    use(static_cast<std::uint16_t>(0x1800 + pdo - 1), cob_id, mode);
  }
  /// Fills a scanner or dispatching list.
  void fill_list(std::uint16_t index, const std::vector<std::uint64_t>& entries) {
    std::uint8_t sub = 0;
    for (const std::uint64_t entry : entries) {
      ASSERT_EQ(write(index, ++sub, entry), AbortCode::none) << std::hex << entry;
    }
    ASSERT_EQ(write(index, 0, sub), AbortCode::none);
  }
  void operate() { receive("000#01 00"); }

  /// Like PdoNode::errors().
  std::vector<std::string> errors() { return std::exchange(errors_, {}); }
  const Error& last_error() const { return last_error_; }

 private:
  void use(std::uint16_t parameters, std::uint32_t cob_id, unsigned mode) {
    ASSERT_EQ(write(parameters, 1, cob_id | CobId::bit31), AbortCode::none);
    ASSERT_EQ(write(static_cast<std::uint16_t>(parameters + 0x200), 0, mode), AbortCode::none);
    ASSERT_EQ(write(parameters, 1, cob_id), AbortCode::none);
  }
  void record(const Error& error, bool present) {
    char text[16];
    std::snprintf(text, sizeof text, "%c%04X/%u", present ? '+' : '-', error.code, error.instance);
    errors_.emplace_back(text);
    last_error_ = error;
  }

  std::array<Rpdo, 2> rpdo_memory_;
  std::array<Tpdo, 3> tpdo_memory_;
  std::array<MappedValue, 2 * 8> rpdo_values_;
  std::array<MappedValue, 3 * 8> tpdo_values_;
  std::array<ScannedObject, 24> scanned_;
  std::array<MpdoProducer::Message, 4> queue_;
  std::vector<std::string> errors_;
  Error last_error_;
  Service recorder_;

 public:
  Sync sync;
  Rpdos rpdos;
  Tpdos tpdos;
  MpdoConsumer mpdo_consumer;
  MpdoProducer mpdo_producer;
};

}  // namespace canvoy
