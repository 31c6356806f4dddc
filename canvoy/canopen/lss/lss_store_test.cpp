// LSS store service with a flash: the stored contents, and the state after power failures.
#include "canvoy/canopen/lss/lss_store.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_store_test {
namespace {

constexpr SimulatedFlash::Geometry geometry{.sector_size = 128, .sectors = 2, .unit = 8};

/// A node from its power-on on.
struct StoringNode : WireNode {
  explicit StoringNode(SimulatedFlash& memory, NodeId id = node_id_unconfigured)
      : WireNode(lss_layout.tables(), id),
        store(node, memory.flash, {.address = 0, .slot_size = 128}),
        lss(node,
            {.configure_bit_timing = {},
             .activate_bit_timing = {},
             .store = store.hook(),
             .state_entered = {}},
            store.bit_timing()) {
    store.on_stored(LssStore::Stored::to<&LssSlave::stored>(lss));
    start();
  }
  void receive(std::string_view frame) { WireNode::receive(lss_frame(frame)); }
  /// Gives it a node-ID to store.
  void name(const char* configure) {
    receive("7E5#04 01");
    receive(configure);
    receive("7E5#17");
    run_for(1s);
    receive("7E5#04 00");
  }
  std::string answer_to_store() {
    for (const Sent& frame : sent) {
      if (frame.frame.id == 0x7E4 && frame.frame.data[0] == 0x17) return wire_text(frame.frame);
    }
    return "";
  }

  LssStore store;
  LssSlave lss;
};

TEST(LssStoreInFlash, KeepsTheNodeIdOverThePower) {
  SimulatedFlash memory(geometry);
  {
    StoringNode node(memory);
    EXPECT_EQ(node.store.state(), RecordState::empty);
    EXPECT_EQ(node.node.state(), NmtState::initialisation);
    node.name("7E5#11 20");
    EXPECT_EQ(node.answer_to_store(), lss_frame("7E4#17 00"));
    EXPECT_EQ(node.node.id(), 0x20);
  }
  StoringNode node(memory);
  node.expect({"720#00"});
  EXPECT_EQ(node.node.id(), 0x20);
  EXPECT_EQ(memory.violations, 0U);
}

TEST(LssStoreInFlash, KeepsThatThereIsNoNodeId) {
  SimulatedFlash memory(geometry);
  StoringNode(memory, 5).name("7E5#11 FF");
  StoringNode node(memory, 5);
  node.expect({});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
}

TEST(LssStoreInFlash, KeepsTheLastOfMany) {
  SimulatedFlash memory(geometry);
  for (const char* configure : {"7E5#11 01", "7E5#11 02", "7E5#11 03", "7E5#11 7F"}) {
    StoringNode(memory).name(configure);
  }
  EXPECT_EQ(StoringNode(memory).node.id(), 0x7F);
}

TEST(LssStoreInFlash, TellsThatTheFlashDoesNotWork) {
  SimulatedFlash memory(geometry);
  StoringNode node(memory);
  memory.fail_erase = memory.stuck_bit = true;
  node.name("7E5#11 20");
  EXPECT_EQ(node.answer_to_store(), lss_frame("7E4#17 02"));
  EXPECT_EQ(node.node.id(), 0x20) << "it has its node-ID until the power goes";
}

TEST(LssStoreInFlash, WaitsForASlowFlashAndLetsOthersInBetween) {
  SimulatedFlash memory(geometry);
  StoringNode node(memory);
  memory.busy_polls = 50;
  node.receive("7E5#04 01");
  node.receive("7E5#11 20");
  node.receive("7E5#17");
  node.sent.clear();
  node.run_for(5ms);
  node.receive("7E5#5E");
  node.expect({"7E4#5E FF 00 00 00 00 00 00"});
  node.run_for(2s);
  node.expect({lss_frame("7E4#17 00")});
}

TEST(LssStoreInFlash, HasTheOldOrTheNewNodeIdWhereverPowerFails) {
  SimulatedFlash before(geometry);
  StoringNode(before).name("7E5#11 01");
  bool complete = false;
  bool has_old = false;
  for (std::uint64_t cut = 0; !complete; ++cut) {
    for (const Tear tear : {Tear::nothing, Tear::some_bits}) {
      SimulatedFlash memory(geometry, before.bytes);
      {
        StoringNode node(memory);
        memory.cut_after(cut, tear);
        node.name("7E5#11 02");
        complete = !memory.is_dead();
      }
      SimulatedFlash after(geometry, memory.bytes);
      const NodeId id = StoringNode(after).node.id();
      ASSERT_TRUE(id == 1 || id == 2) << cut;
      has_old = has_old || id == 1;
      if (complete) {
        ASSERT_EQ(id, 2);
      }
    }
    ASSERT_LT(cut, 10'000U);
  }
  EXPECT_TRUE(has_old);
}

TEST(LssStoreInFlash, TellsThatTheFlashIsBusyForEverAfterTenSeconds) {
  SimulatedFlash memory(geometry);
  StoringNode node(memory);
  memory.busy_polls = 1'000'000;
  node.receive("7E5#04 01");
  node.receive("7E5#11 20");
  node.receive("7E5#17");
  node.run_for(10s - 1ms);
  EXPECT_EQ(node.answer_to_store(), "");
  node.run_for(2ms);
  EXPECT_EQ(node.answer_to_store(), lss_frame("7E4#17 02"));
}

/// Changes the record in the first slot, with correct CRCs.
void seal(SimulatedFlash& memory, std::uint32_t length) {
  const auto bytes = std::span(memory.bytes);
  store(bytes.data() + 12, length);
  store(bytes.data() + 16, crc32(bytes.subspan(32, length)));
  store(bytes.data() + 28, crc32(bytes.first(28)));
}

TEST(LssStoreInFlash, TakesNoNodeIdThatIsNone) {
  SimulatedFlash memory(geometry);
  StoringNode(memory).name("7E5#11 20");
  for (unsigned id = 0; id <= 0xFF; ++id) {
    memory.bytes[32] = static_cast<std::uint8_t>(id);
    seal(memory, 2);
    StoringNode node(memory, 5);
    const bool good = (id >= 1 && id <= 127) || id == 0xFF;
    ASSERT_EQ(node.store.state(), good ? RecordState::valid : RecordState::damaged) << id;
    ASSERT_EQ(node.node.id(), good ? id : 5);
  }
}

TEST(LssStoreInFlash, TakesNothingOfAnotherLength) {
  SimulatedFlash memory(geometry);
  StoringNode(memory).name("7E5#11 20");
  for (const std::uint32_t length : {0U, 1U, 3U, 96U}) {
    seal(memory, length);
    StoringNode node(memory, 5);
    EXPECT_EQ(node.store.state(), RecordState::damaged) << length;
    EXPECT_EQ(node.node.id(), 5);
  }
}

TEST(LssStoreInFlash, TakesNothingThatIsDamaged) {
  SimulatedFlash memory(geometry);
  StoringNode(memory).name("7E5#11 20");
  const auto good = memory.bytes;
  for (std::size_t i = 0; i < good.size(); ++i) {
    SimulatedFlash damaged(geometry, good);
    damaged.bytes[i] ^= 0x10;
    const NodeId id = StoringNode(damaged).node.id();
    ASSERT_TRUE(id == 0x20 || id == node_id_unconfigured) << i;
  }
}

}  // namespace
}  // namespace canvoy::lss_store_test
