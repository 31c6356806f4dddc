// Restoring default parameters (CiA 301, 7.5.2.14, object 1011h).
#include <gtest/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_restore_test {
namespace {

class StorageRestore : public testing::Test {
 protected:
  void SetUp() override {
    sut.booted();
    defaults = sut.parameters();
    sut.set_all(1);
    stored = sut.parameters();
    sut.save(1);
  }
  void TearDown() override { EXPECT_EQ(memory.violations, 0U); }

  SimulatedFlash memory{stored_geometry};
  StoringNode sut{memory};
  StoringNode::Parameters defaults;
  StoringNode::Parameters stored;
};

TEST_F(StorageRestore, ReadingTellsThatTheDeviceRestoresOnCommand) {
  sut.ask("40 11 10 01 00 00 00 00", "43 11 10 01 01 00 00 00");
}

TEST_F(StorageRestore, TheValuesStayUntilTheReset) {
  sut.load(1);
  EXPECT_EQ(sut.parameters(), stored);
}

TEST_F(StorageRestore, ResetNodePutsTheDefaultsInForce) {
  sut.load(1);
  sut.receive("000#81 05");
  EXPECT_EQ(sut.parameters(), defaults);
}

TEST_F(StorageRestore, PowerOnPutsTheDefaultsInForce) {
  sut.load(1);
  StoringNode again(memory);
  again.booted();
  EXPECT_EQ(again.parameters(), defaults);
  EXPECT_EQ(again.storage.state(), RecordState::valid);
}

TEST_F(StorageRestore, ResetCommunicationPutsThoseOfTheCommunicationParametersInForce) {
  sut.load(1);
  sut.receive("000#82 05");
  EXPECT_EQ(sut.get(0x1017), 0U);
  EXPECT_EQ(sut.get(0x1014), 0x85U);
  EXPECT_EQ(sut.get(0x6000), 601U);
}

TEST_F(StorageRestore, SubIndex2RestoresTheCommunicationParametersAlone) {
  sut.load(2);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x1017), 0U);
  EXPECT_EQ(again.get(0x6000), 601U);
  EXPECT_EQ(again.text(), "set 1");
  EXPECT_EQ(again.get(0xA000), 101U);
}

TEST_F(StorageRestore, SubIndex3RestoresTheApplicationParametersAlone) {
  sut.load(3);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x1017), 1001U);
  EXPECT_EQ(again.get(0x6000), 100U);
  EXPECT_EQ(again.get(0x6021, 1), 0x60U);
}

TEST_F(StorageRestore, FromSubIndex4OnTheManufacturersGroupsAreRestored) {
  sut.load(5);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x2000), 1U);
  EXPECT_EQ(again.get(0x2100), 0x2100U);
}

TEST_F(StorageRestore, WhatIsStoredAfterwardsHolds) {
  sut.load(1);
  sut.save(3);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x1017), 0U);
  EXPECT_EQ(again.get(0x6000), 601U);
}

TEST_F(StorageRestore, AnotherSignatureIsRefusedAndNothingIsRestored) {
  for (const char* signature :
       {"64 61 6F 6C", "4C 4F 41 44", "73 61 76 65", "00 00 00 00", "01 00 00 00"}) {
    sut.ask(std::string("23 11 10 01 ") + signature, "80 11 10 01 20 00 00 08");
  }
  EXPECT_EQ(StoringNode(memory).parameters(), stored);
}

TEST_F(StorageRestore, AGroupThatTheDeviceCannotRestoreIsRefused) {
  sut.set(0x1011, 0, 2);
  sut.ask("23 11 10 02 6C 6F 61 64", "80 11 10 02 20 00 00 08");
}

TEST_F(StorageRestore, AGroupThatThereIsNotHasNoSubIndex) {
  sut.ask("23 11 10 06 6C 6F 61 64", "80 11 10 06 11 00 09 06");
}

TEST_F(StorageRestore, WhereNothingIsStoredThereIsNothingToDo) {
  SimulatedFlash blank{stored_geometry};
  StoringNode fresh(blank);
  fresh.booted();
  fresh.load(1);
  StoringNode again(blank);
  again.booted();
  EXPECT_EQ(again.parameters(), defaults);
}

}  // namespace
}  // namespace canvoy::storage_restore_test
