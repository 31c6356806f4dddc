#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::pdo_512_test {
namespace {

using enum AbortCode;

constexpr std::uint16_t all = 512;

constexpr auto full_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1400, .count = all, .entry_count = 2},
                                      {.index = 0x1600, .count = all, .entry_count = 2},
                                      {.index = 0x1800, .count = all, .entry_count = 2},
                                      {.index = 0x1A00, .count = all, .entry_count = 2},
                                      {.index = 0x2000, .count = all, .entry_count = 1},
                                      {.index = 0x3000, .count = all, .entry_count = 1}}),
            std::to_array<EntryRow>({
                invalid_cob_id,
                parameter(2, DataType::unsigned8, 255),
                parameter(0, DataType::unsigned8),
                {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
                invalid_cob_id,
                parameter(2, DataType::unsigned8, 255),
                parameter(0, DataType::unsigned8),
                {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
                mappable(0, 0, DataType::unsigned16),
                mappable(0, 0, DataType::unsigned16),
            }));
constexpr DictionaryTables full_tables = full_layout.tables();

/// RPDO n to object 2000h + n, object 3000h + n to TPDO n; both on CAN-ID 180h + n, since no other
/// node is on this bus.
struct FullNode : WireNode {
  FullNode() : WireNode(full_tables, 5) {
    boot();
    for (std::uint16_t i = 0; i < all; ++i) {
      const std::uint32_t cob_id = 0x4000'0181U + i;
      map(static_cast<std::uint16_t>(0x1400 + i), 0x2000U + i, cob_id);
      map(static_cast<std::uint16_t>(0x1800 + i), 0x3000U + i, cob_id);
    }
    receive("000#01 00");
  }
  void map(std::uint16_t parameters, std::uint32_t index, std::uint32_t cob_id) {
    const auto record = static_cast<std::uint16_t>(parameters + 0x200);
    write(record, 1, index << 16 | 0x10, 4);
    write(record, 0, 1, 1);
    write(parameters, 1, cob_id, 4);
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t size) {
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), number);
    ASSERT_EQ(node.dictionary().write(index, sub, std::span(bytes).first(size), Source::sdo), none);
  }

  std::vector<Rpdo> rpdo_memory = std::vector<Rpdo>(all);
  std::vector<Tpdo> tpdo_memory = std::vector<Tpdo>(all);
  std::vector<MappedValue> values = std::vector<MappedValue>(2U * all * 8);
  Sync sync{node};
  Rpdos rpdos{node, rpdo_memory, std::span(values).first(all * 8), &sync};
  Tpdos tpdos{node, tpdo_memory, std::span(values).last(all * 8), &sync,
              Tpdos::AtStart::wait_for_event};
};

TEST(Pdos, Of512InEachDirectionEachOneWorks) {
  FullNode node;
  node.expect({});
  for (std::uint16_t i = 0; i < all; ++i) {
    const auto low = static_cast<std::uint8_t>(i + 1);
    const auto high = static_cast<std::uint8_t>((i + 1) >> 8);
    node.node.receive(Frame::data_frame(0x181U + i, {low, high}), node.now);
  }
  for (std::uint16_t i = 0; i < all; ++i) {
    EXPECT_EQ(node.node.dictionary().number(static_cast<std::uint16_t>(0x2000 + i), 0), i + 1U);
  }
  node.expect({});
  for (std::uint16_t i = 0; i < all; ++i) {
    node.node.dictionary().set_number(static_cast<std::uint16_t>(0x3000 + i), 0, i + 1U);
    node.settle();
    ASSERT_EQ(node.sent.size(), 1U) << i;
    EXPECT_EQ(node.sent[0].frame.id, 0x181U + i);
    EXPECT_EQ(load<std::uint16_t>(node.sent[0].frame.data.data()), i + 1U);
    node.sent.clear();
  }
}

TEST(Pdos, ThatShareABitOfTheWatchersWorkOnWhereOneIsMadeInvalid) {
  FullNode node;
  // TPDOs 1 and 33 share a bit. The first gets an object that no other one watches.
  node.write(0x1800, 1, 0xC000'0181, 4);
  node.write(0x1A00, 0, 0, 1);
  node.write(0x1A00, 1, 0x2000'00'10, 4);
  node.write(0x1A00, 0, 1, 1);
  node.write(0x1800, 1, 0x4000'0181, 4);
  node.write(0x1820, 1, 0xC000'01A1, 4);
  node.node.dictionary().set_number(0x2000, 0, 1);
  node.settle();
  node.expect({"181#01 00"});
  node.node.dictionary().set_number(0x3020, 0, 1);
  node.settle();
  node.expect({});
  node.node.dictionary().set_number(0x3040, 0, 1);
  node.settle();
  node.expect({"1C1#01 00"});
}

TEST(Pdos, Of512ThatChangeAtOnceEachOneIsSent) {
  FullNode node;
  for (std::uint16_t i = 0; i < all; ++i) {
    node.node.dictionary().set_number(static_cast<std::uint16_t>(0x3000 + i), 0, 1);
  }
  node.settle();
  EXPECT_EQ(node.sent.size(), all);
}

TEST(Pdos, LeaveInTheOrderOfTheirNumbersInWhicheverOrderValuesChange) {
  FullNode node;
  for (const unsigned i : {400U, 33U, 7U, 65U, 1U}) {
    node.node.dictionary().set_number(static_cast<std::uint16_t>(0x3000 + i), 0, 1);
  }
  node.settle();
  node.expect({"182#01 00", "188#01 00", "1A2#01 00", "1C2#01 00", "311#01 00"});
}

TEST(Pdos, ThatMapOneValueAreAllSentHoweverManyTheyAre) {
  FullNode node;
  for (const unsigned count : {3U, 40U}) {
    for (unsigned i = 0; i < count; ++i) {
      const auto parameters = static_cast<std::uint16_t>(0x1800 + 10 * i);
      node.write(parameters, 1, 0xC000'0181U + 10 * i, 4);
      node.write(static_cast<std::uint16_t>(parameters + 0x200), 0, 0, 1);
      node.map(parameters, 0x3005, 0x4000'0181U + 10 * i);
    }
    node.settle();
    node.sent.clear();
    node.node.dictionary().set_number(0x3005, 0, count);
    node.settle();
    // And the sixth, which has its own.
    EXPECT_EQ(node.sent.size(), count + 1);
  }
}

TEST(Pdos, WithAValueThatChangesBackAreNotSent) {
  FullNode node;
  node.node.dictionary().set_number(0x3123, 0, 5);
  node.node.dictionary().set_number(0x3123, 0, 0);
  node.node.dictionary().set_number(0x3124, 0, 5);
  node.settle();
  node.expect({"2A5#05 00"});
}

TEST(Pdos, ThatWaitForSyncAreServedInTheOrderOfTheirNumbers) {
  FullNode node;
  for (const unsigned number : {512U, 1U, 64U, 65U, 300U}) {
    const unsigned offset = number - 1;
    for (const unsigned parameters : {0x1400U, 0x1800U}) {
      node.write(static_cast<std::uint16_t>(parameters + offset), 2, 1, 1);
    }
    node.node.receive(Frame::data_frame(0x180U + number, {7, 0}), node.now);
    EXPECT_EQ(node.node.dictionary().number(static_cast<std::uint16_t>(0x2000 + offset), 0), 0U);
  }
  node.settle();
  node.expect({});
  node.receive("080#");
  node.expect({"181#00 00", "1C0#00 00", "1C1#00 00", "2AC#00 00", "380#00 00"});
  for (const unsigned number : {512U, 1U, 64U, 65U, 300U}) {
    EXPECT_EQ(node.node.dictionary().number(static_cast<std::uint16_t>(0x1FFF + number), 0), 7U);
  }
  node.write(0x1800 + 64, 2, 255, 1);
  node.receive("080#");
  node.expect({"181#00 00", "1C0#00 00", "2AC#00 00", "380#00 00"});
}

}  // namespace
}  // namespace canvoy::pdo_512_test
