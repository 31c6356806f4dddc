// An RPDO writes values that TPDOs map.
#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/testing/pdo_node.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::rpdo_watched_test {
namespace {

/// RPDO 1 writes 3000h:01 and 02. TPDO 1 maps 3000h:01, with an inhibit time of 10 ms; TPDO 2,
/// which maps it too, is invalid at first.
class WatchedNode : public WireNode {
  constexpr static auto layout =
      lay_out(std::to_array<ObjectRow>({{.index = 0x1400, .entry_count = 1},
                                        {.index = 0x1600, .entry_count = 3},
                                        {.index = 0x1800, .entry_count = 2},
                                        {.index = 0x1801, .entry_count = 1},
                                        {.index = 0x1A00, .count = 2, .entry_count = 2},
                                        {.index = 0x3000, .entry_count = 1}}),
              std::to_array<EntryRow>({
                  parameter(1, DataType::unsigned32, 0x205),
                  parameter(0, DataType::unsigned8, 2),
                  parameter(1, DataType::unsigned32, 0x3000'01'10),
                  parameter(2, DataType::unsigned32, 0x3000'02'10),
                  parameter(1, DataType::unsigned32, 0x185),
                  parameter(3, DataType::unsigned16, 100),
                  parameter(1, DataType::unsigned32, 0x8000'0285),
                  parameter(0, DataType::unsigned8, 1),
                  parameter(1, DataType::unsigned32, 0x3000'01'10),
                  mappable(1, 2, DataType::unsigned16),
              }));
  constexpr static DictionaryTables tables = layout.tables();

 public:
  WatchedNode() : WireNode(tables, 5) {}
  void write(std::uint16_t index, std::uint8_t sub, std::uint32_t number) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&number);
    const Result<Entry> entry = node.dictionary().find(index, sub);
    ASSERT_TRUE(entry);
    EXPECT_EQ(node.dictionary().write(*entry, {bytes, entry->row->capacity}, Source::sdo),
              AbortCode::none);
  }
  /// At 0 the TPDO is sent, and is inhibited for 10 ms.
  void send_first() {
    boot_operational();
    receive("205#01 00 02 00");
    expect({"@0 185#01 00"});
  }
  void receive_at(Time time, std::string_view frame) {
    run_until(time);
    receive(frame);
  }

 private:
  std::array<Rpdo, 1> rpdo_memory_;
  std::array<Tpdo, 2> tpdo_memory_;
  std::array<MappedValue, 2> rpdo_values_;
  std::array<MappedValue, 4> tpdo_values_;

 public:
  Rpdos rpdos{node, rpdo_memory_, rpdo_values_};
  Tpdos tpdos{node, tpdo_memory_, tpdo_values_, nullptr, Tpdos::AtStart::wait_for_event};
};

TEST(Rpdo, WritesAValueOfATpdoThatWaitsAndIsSentWithTheLastOne) {
  WatchedNode node;
  node.send_first();
  node.receive_at(Time(2ms), "205#05 00 00 00");
  node.receive_at(Time(4ms), "205#07 00 00 00");
  node.receive_at(Time(6ms), "205#07 00 09 00");
  node.expect({});
  node.run_until(Time(1s));
  node.expect({"@10000 185#07 00"});
  node.receive("205#08 00 09 00");
  node.expect({"@1000000 185#08 00"});
}

TEST(Rpdo, WritesAValueOfATpdoThatWaitsThoughTheChangeIsTakenBack) {
  WatchedNode node;
  node.send_first();
  node.receive_at(Time(2ms), "205#05 00 02 00");
  node.receive_at(Time(4ms), "205#01 00 02 00");
  node.run_until(Time(1s));
  node.expect({"@10000 185#01 00"});
}

TEST(Rpdo, TellsAServiceOfEachChangeWhileTheTpdoWaits) {
  WatchedNode node;
  Service service;
  int told = 0;
  auto count = [&](std::uint32_t) { ++told; };
  service.values_changed = Callback<void(std::uint32_t)>::of(count);
  node.send_first();
  node.receive_at(Time(2ms), "205#05 00 02 00");
  node.node.attach(service);
  node.receive_at(Time(4ms), "205#06 00 02 00");
  node.receive_at(Time(6ms), "205#07 00 02 00");
  EXPECT_EQ(told, 2);
  node.run_until(Time(1s));
  node.expect({"@10000 185#07 00"});
}

TEST(Rpdo, ChangesATpdoThatComesToMapTheValueWhileAnotherOneWaits) {
  WatchedNode node;
  node.send_first();
  node.receive_at(Time(2ms), "205#05 00 02 00");
  node.write(0x1801, 1, 0x285);
  node.receive_at(Time(4ms), "205#06 00 02 00");
  node.expect({"@4000 285#06 00"});
  node.write(0x1801, 1, 0x8000'0285);
  node.receive_at(Time(6ms), "205#07 00 02 00");
  node.expect({});
  node.run_until(Time(1s));
  node.expect({"@10000 185#07 00"});
}

TEST(Rpdo, ChangesATpdoThatBecomesValidAnewAfterItWaited) {
  WatchedNode node;
  node.send_first();
  node.receive_at(Time(2ms), "205#05 00 02 00");
  node.write(0x1800, 1, 0x8000'0185);
  node.receive_at(Time(4ms), "205#06 00 02 00");
  node.write(0x1800, 1, 0x185);
  node.expect({});
  node.receive_at(Time(6ms), "205#07 00 02 00");
  node.expect({"@6000 185#07 00"});
}

TEST(Rpdo, NotifiesOfNoMoreValuesWhenTheFirstOneEndsTheMapping) {
  WatchedNode node;
  int told = 0;
  auto end = [&](const Entry& entry, Source) {
    ++told;
    node.write(0x1400, 1, 0x8000'0205);
    node.write(0x1600, 0, 0);
    EXPECT_EQ(entry.index, 0x3000U) << "the entry of the write, also now";
    EXPECT_EQ(entry.sub, 1U);
  };
  Hook hook{.first = 0x3000, .last = 0x3000};
  hook.after_write = Callback<void(const Entry&, Source)>::of(end);
  node.node.dictionary().attach(hook);
  node.boot_operational();
  node.receive("205#01 00 02 00");
  EXPECT_EQ(told, 1);
  EXPECT_EQ(node.node.dictionary().number(0x3000, 2), 2U);
}

}  // namespace
}  // namespace canvoy::rpdo_watched_test
