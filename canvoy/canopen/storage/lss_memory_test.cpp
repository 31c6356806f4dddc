// Store configuration (CiA 305, service 17h) with a memory behind it.
#include "canvoy/canopen/storage/lss_memory.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary_layout.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {
namespace {

constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1018, .entry_count = 2}}),
                                std::to_array<EntryRow>({{.access = Access::const_, .initial = 4},
                                                         {.sub_first = 1,
                                                          .sub_last = 4,
                                                          .type = DataType::unsigned32,
                                                          .access = Access::const_,
                                                          .initial = 0x1234}}));
constexpr SimulatedFlash::Geometry geometry{.sector_size = 64, .sectors = 2, .unit = 8};
constexpr LssMemory::Place place{.address = 0, .slot_size = 64};

/// A node that has the node-ID that its memory keeps.
struct Device {
  explicit Device(SimulatedFlash& flash)
      : memory(flash.flash, place),
        kept(memory.find()),
        wire(layout.tables(), kept.node_id),
        slave(wire.node, hooks(), kept.bit_timing) {
    memory.serve(wire.node, slave);
    wire.boot();
  }
  LssSlaveHooks hooks() {
    LssSlaveHooks made;
    made.configure_bit_timing = {[](void*, std::uint8_t) { return LssError{}; }, nullptr};
    made.store = memory.store_hook();
    return made;
  }

  /// Gives it a node-ID and 250 kbit/s, and has them stored.
  void configure(unsigned node_id) {
    wire.receive("7E5#04 01 00 00 00 00 00 00");
    char text[40];
    std::snprintf(text, sizeof text, "7E5#11 %02X 00 00 00 00 00 00", node_id);
    wire.receive(text);
    wire.receive("7E5#13 00 03 00 00 00 00 00");
    wire.expect({"7E4#11 00 00 00 00 00 00 00", "7E4#13 00 00 00 00 00 00 00"});
    wire.receive("7E5#17 00 00 00 00 00 00 00");
  }

  LssMemory memory;
  LssMemory::Content kept;
  WireNode wire;
  LssSlave slave;
};

class LssMemoryTest : public testing::Test {
 protected:
  LssMemory::Content after_power_on() {
    LssMemory sut(memory.flash, place);
    return sut.find();
  }
  void TearDown() override { EXPECT_EQ(memory.violations, 0U); }
  SimulatedFlash memory{geometry};
};

TEST_F(LssMemoryTest, ADeviceThatWasNeverConfiguredHasNoNodeId) {
  Device sut(memory);
  EXPECT_EQ(sut.kept, LssMemory::Content{});
  EXPECT_EQ(sut.memory.state(), RecordState::empty);
}

TEST_F(LssMemoryTest, WhatIsStoredIsThereAfterPowerOn) {
  Device(memory).configure(33);
  Device again(memory);
  EXPECT_EQ(again.kept, (LssMemory::Content{.node_id = 33, .bit_timing = 3}));
  EXPECT_EQ(again.wire.node.id(), 33);
}

TEST_F(LssMemoryTest, TheMasterIsAnsweredWhenAllIsStored) {
  memory.busy_polls = 10;
  Device sut(memory);
  sut.configure(33);
  sut.wire.run_for(20ms);
  sut.wire.expect({});
  EXPECT_EQ(after_power_on(), LssMemory::Content{});
  sut.wire.run_for(1s);
  sut.wire.expect({"7E4#17 00 00 00 00 00 00 00"});
  EXPECT_EQ(after_power_on().node_id, 33);
}

TEST_F(LssMemoryTest, AFlashThatFailsIsToldToTheMasterAndTheOldContentStays) {
  Device(memory).configure(33);
  Device sut(memory);
  memory.fail_program = 1;
  sut.configure(34);
  sut.wire.expect({"7E4#17 02 00 00 00 00 00 00"});
  EXPECT_EQ(after_power_on().node_id, 33);
}

TEST_F(LssMemoryTest, AFlashThatIsBusyForEverIsToldAfterTenSeconds) {
  memory.busy_polls = 1'000'000;
  Device sut(memory);
  sut.configure(33);
  sut.wire.run_for(11s);
  sut.wire.expect({"7E4#17 02 00 00 00 00 00 00"});
}

TEST_F(LssMemoryTest, EachBitOfTheContentCounts) {
  Device(memory).configure(33);
  for (std::size_t bit = 0; bit < std::size_t{8} * 34; ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
    memory.bytes[bit / 8] ^= mask;
    LssMemory sut(memory.flash, place);
    ASSERT_EQ(sut.find(), LssMemory::Content{}) << bit;
    ASSERT_EQ(sut.state(), RecordState::damaged);
    memory.bytes[bit / 8] ^= mask;
  }
}

TEST_F(LssMemoryTest, ALossOfPowerLeavesTheOldContentOrTheNewOne) {
  Device(memory).configure(33);
  Device(memory).configure(34);
  bool is_new = false;
  for (std::uint64_t cut = 0; !is_new; ++cut) {
    ASSERT_LT(cut, 200U);
    for (const Tear tear : {Tear::some_bits, Tear::nothing}) {
      SimulatedFlash flash(geometry, memory.bytes);
      {
        Device sut(flash);
        flash.cut_after(cut, tear);
        sut.configure(35);
      }
      LssMemory later(flash.flash, place);
      const NodeId found = later.find().node_id;
      ASSERT_TRUE(found == 34 || found == 35) << cut;
      is_new = found == 35;
    }
  }
}

}  // namespace
}  // namespace canvoy
