// A slow or failing flash: storing blocks nothing, ends in time, and never destroys the old set.
#include <gtest/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_flash_test {
namespace {

class StorageFlash : public testing::Test {
 protected:
  void SetUp() override {
    sut.booted();
    sut.set_all(1);
    old = sut.parameters();
    sut.save();
    sut.set_all(2);
  }
  void TearDown() override { EXPECT_EQ(memory.violations, 0U); }
  StoringNode::Parameters after_power_on() {
    SimulatedFlash other(stored_geometry, memory.bytes);
    return StoringNode(other).parameters();
  }
  void ask_to_save() { sut.receive("605#23 10 10 01 73 61 76 65"); }
  /// A store that is stopped while its head is being programmed, without an end of that operation.
  void time_out_at_the_head() {
    memory.busy_polls = 3;
    const unsigned syncs = memory.syncs;
    ask_to_save();
    while (memory.syncs == syncs) sut.run_for(1ms);
    memory.busy_polls = 1'000'000;
    sut.run_for(11s);
    sut.expect({"585#80 10 10 01 00 00 06 06"});
    memory.busy_polls = 0;
  }

  SimulatedFlash memory{stored_geometry};
  StoringNode sut{memory};
  StoringNode::Parameters old;
};

TEST_F(StorageFlash, TheAnswerComesWhenAllIsStored) {
  memory.busy_polls = 5;
  ask_to_save();
  EXPECT_TRUE(sut.storage.busy());
  sut.run_for(20ms);
  sut.expect({});
  EXPECT_EQ(after_power_on(), old);
  sut.run_for(1s);
  sut.expect({"585#60 10 10 01 00 00 00 00"});
  EXPECT_FALSE(sut.storage.busy());
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, TheFlashIsAskedEachMillisecond) {
  memory.busy_polls = 40;
  ask_to_save();
  const Time begun = sut.now;
  sut.run_until(begun + 40ms - 1us);
  EXPECT_EQ(memory.programmings, 5U) << "of the first set; the sector is still being erased";
  sut.run_until(begun + 41ms);
  EXPECT_EQ(memory.programmings, 6U);
}

TEST_F(StorageFlash, OthersAreServedMeanwhile) {
  memory.busy_polls = 100;
  ask_to_save();
  sut.run_for(10ms);
  sut.receive("605#40 00 10 00 00 00 00 00");
  sut.expect({"585#43 00 10 00 A2 01 02 00"});
  sut.receive("000#01 05");
  EXPECT_EQ(sut.node.state(), NmtState::operational);
  sut.run_for(5s);
  sut.expect({});
  EXPECT_EQ(after_power_on(), sut.parameters()) << "the client waits no more, and it is stored";
}

TEST_F(StorageFlash, ASecondClientIsRefusedMeanwhile) {
  memory.busy_polls = 100;
  ask_to_save();
  sut.ask("23 11 10 01 6C 6F 61 64", "80 11 10 01 22 00 00 08");
  sut.ask("23 10 10 01 73 61 76 65", "80 10 10 01 22 00 00 08");
  sut.run_for(5s);
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, ValuesThatChangeMeanwhileAreStoredAsTheyWereAtOneMoment) {
  memory.busy_polls = 3;
  ask_to_save();
  sut.run_for(12ms);
  sut.set_all(3);
  sut.run_for(1s);
  sut.expect({"585#60 10 10 01 00 00 00 00"});
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, ValuesThatNeverHoldStillAreNotStored) {
  memory.busy_polls = 3;
  ask_to_save();
  for (unsigned number = 0; number < 300; ++number) {
    sut.set_all(number);
    sut.run_for(1ms);
  }
  sut.expect({"585#80 10 10 01 22 00 00 08"});
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AnEraseThatFailsIsAHardwareErrorAndTheOldSetStays) {
  memory.fail_erase = true;
  ask_to_save();
  sut.expect({"585#80 10 10 01 00 00 06 06"});
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AnyProgrammingThatFailsIsAHardwareErrorAndTheOldSetStays) {
  unsigned failures = 0;
  for (unsigned number = 1; number < 100; ++number, ++failures) {
    SimulatedFlash other(stored_geometry, memory.bytes);
    other.fail_program = number;
    StoringNode node(other);
    node.booted();
    node.set_all(2);
    node.receive("605#23 10 10 01 73 61 76 65");
    if (other.fail_program != 0) break;
    node.expect({"585#80 10 10 01 00 00 06 06"});
    EXPECT_EQ(StoringNode(other).parameters(), old);
  }
  EXPECT_EQ(failures, 5U) << "four pieces of 102 bytes, and the head";
}

TEST_F(StorageFlash, AFailureThatIsToldLateIsAHardwareErrorToo) {
  memory.busy_polls = 4;
  memory.fail_program = 2;
  ask_to_save();
  sut.run_for(1s);
  sut.expect({"585#80 10 10 01 00 00 06 06"});
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, WhatCannotBeMadeLastingIsAHardwareError) {
  memory.fail_sync = 1;
  ask_to_save();
  sut.expect({"585#80 10 10 01 00 00 06 06"});
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AHeadThatCannotBeMadeLastingIsAHardwareErrorUntilItCan) {
  for (const unsigned busy_polls : {0U, 3U}) {
    memory.busy_polls = busy_polls;
    memory.fail_sync = 2;
    ask_to_save();
    sut.run_for(1s);
    sut.expect({"585#80 10 10 01 00 00 06 06"});
    memory.fail_sync = 1;
    ask_to_save();
    sut.run_for(1s);
    sut.expect({"585#80 10 10 01 00 00 06 06"});
    ask_to_save();
    sut.run_for(1s);
    sut.expect({"585#60 10 10 01 00 00 00 00"});
    EXPECT_EQ(after_power_on(), sut.parameters());
    sut.set_all(3);
  }
}

TEST_F(StorageFlash, TheOldValuesAreStoredAgainAfterATimeOutThatLeftTheNewOnes) {
  time_out_at_the_head();
  memory.end_operation();
  EXPECT_NE(after_power_on(), old) << "the head was finished after all";
  sut.set_all(1);
  sut.save();
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AFailureThatIsToldAfterATimeOutIsNotThatOfTheNextStore) {
  memory.fail_program = 5;
  time_out_at_the_head();
  memory.end_operation();
  EXPECT_EQ(after_power_on(), old);
  sut.set_all(3);
  sut.save();
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, NothingIsStoredOverWhatCouldNotBeRead) {
  sut.save();
  const auto kept = after_power_on();
  memory.fail_read = true;
  sut.receive("000#82 05");
  memory.fail_read = false;
  sut.sent.clear();
  for (const char* sub : {"01", "03"}) {
    const std::string sub_index = sub;
    sut.ask("23 10 10 " + sub_index + " 73 61 76 65", "80 10 10 " + sub_index + " 00 00 06 06");
    sut.ask("23 11 10 " + sub_index + " 6C 6F 61 64", "80 11 10 " + sub_index + " 00 00 06 06");
    EXPECT_EQ(after_power_on(), kept);
  }
}

TEST_F(StorageFlash, AFlashThatDoesNotAnswerDuringAStoreIsAHardwareErrorAndTheOldSetStays) {
  sut.set_all(1);
  sut.save();
  sut.set_all(2);
  memory.fail_read = true;
  ask_to_save();
  sut.expect({"585#80 10 10 01 00 00 06 06"});
  memory.fail_read = false;
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AResetDuringAnOperationThatNeverEndsFindsNothing) {
  memory.busy_polls = 3'000'000;
  ask_to_save();
  sut.receive("000#81 05");
  sut.expect({"705#00", "085#00 63 01 07 00 00 00 00"});
  memory.busy_polls = 0;
  memory.end_operation();
  sut.receive("000#81 05");
  sut.booted();
  EXPECT_EQ(sut.parameters(), old);
}

TEST_F(StorageFlash, AFlashThatKeepsSomethingElseIsFoundOut) {
  memory.stuck_bit = true;
  ask_to_save();
  sut.expect({"585#80 10 10 01 00 00 06 06"});
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AFlashThatIsBusyForEverIsGivenUpAfterTenSeconds) {
  memory.busy_polls = 1'000'000;
  ask_to_save();
  sut.run_for(10s - 1ms);
  sut.expect({});
  sut.run_for(2ms);
  sut.expect({"585#80 10 10 01 00 00 06 06"});
  EXPECT_FALSE(sut.storage.busy());
  EXPECT_EQ(after_power_on(), old);
}

TEST_F(StorageFlash, AfterAFailureItCanBeTriedAgain) {
  memory.fail_program = 1;
  ask_to_save();
  sut.sent.clear();
  sut.save();
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, ASetThatDoesNotFitIsRefusedAndTheOldOneStays) {
  SimulatedFlash small({.sector_size = 128, .sectors = 2, .unit = 8});
  StoringNode node(small, {.slot_size = 128, .groups = stored_groups});
  node.booted();
  node.save(2);
  const auto before = StoringNode(small, {.slot_size = 128}).parameters();
  node.set_all(1);
  node.ask("23 10 10 01 73 61 76 65", "80 10 10 01 05 00 04 05");
  EXPECT_EQ(StoringNode(small, {.slot_size = 128}).parameters(), before);
}

TEST_F(StorageFlash, AResetMeanwhileLeavesTheOldSet) {
  memory.busy_polls = 5;
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    sut.set_all(2);
    ask_to_save();
    sut.run_for(10ms);
    sut.receive(reset);
    sut.expect({"705#00"});
    EXPECT_FALSE(sut.storage.busy());
    EXPECT_FALSE(sut.node.is_deferred());
    sut.run_for(1s);
    EXPECT_EQ(after_power_on(), old);
  }
  sut.set_all(3);
  ask_to_save();
  sut.run_for(1s);
  sut.expect({"585#60 10 10 01 00 00 00 00"});
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, AResetMeanwhileLeavesAnEmptyOneEmpty) {
  SimulatedFlash blank{stored_geometry};
  blank.busy_polls = 5;
  StoringNode node(blank);
  node.booted();
  node.receive("605#23 10 10 01 73 61 76 65");
  node.run_for(1ms);
  node.receive("000#82 05");
  node.run_for(1s);
  EXPECT_EQ(node.storage.state(), RecordState::empty);
}

TEST_F(StorageFlash, ANodeThatIsStoppedMeanwhileStoresAndDoesNotAnswer) {
  memory.busy_polls = 5;
  ask_to_save();
  sut.receive("000#02 05");
  sut.run_for(1s);
  sut.expect({});
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageFlash, AllUnitsAndSectorSizesHoldTheSameSet) {
  for (const std::uint32_t unit : {1U, 2U, 4U, 8U, 16U, 32U}) {
    for (const std::uint32_t sector_size : {64U, 256U, 2048U}) {
      const SimulatedFlash::Geometry geometry{
          .sector_size = sector_size, .sectors = 2 * (sector_size == 64 ? 4U : 1U), .unit = unit};
      const Storage::Settings settings{.slot_size = sector_size == 64 ? 256 : sector_size,
                                       .groups = stored_groups};
      SimulatedFlash other(geometry);
      StoringNode node(other, settings);
      node.booted();
      for (const unsigned number : std::to_array<unsigned>({1, 2, 3})) {
        node.set_all(number);
        node.save();
        EXPECT_EQ(StoringNode(other, settings).parameters(), node.parameters());
      }
      EXPECT_EQ(other.violations, 0U) << "unit " << unit << ", sector " << sector_size;
    }
  }
}

TEST_F(StorageFlash, TheSlotsMayStandAnywhere) {
  SimulatedFlash other({.sector_size = 256, .sectors = 5, .unit = 8});
  const Storage::Settings settings{.address = 512, .slot_size = 256, .groups = stored_groups};
  StoringNode node(other, settings);
  node.booted();
  for (const unsigned number : std::to_array<unsigned>({1, 2, 3})) {
    node.set_all(number);
    node.save();
  }
  EXPECT_EQ(StoringNode(other, settings).parameters(), node.parameters());
  const auto untouched = [&](std::size_t first, std::size_t last) {
    return std::all_of(other.bytes.begin() + static_cast<std::ptrdiff_t>(first),
                       other.bytes.begin() + static_cast<std::ptrdiff_t>(last),
                       [](std::uint8_t byte) { return byte == 0xFF; });
  };
  EXPECT_TRUE(untouched(0, 512));
  EXPECT_TRUE(untouched(1024, 1280));
}

}  // namespace
}  // namespace canvoy::storage_flash_test
