// Storing parameters (CiA 301, 7.5.2.13, object 1010h).
#include "canvoy/canopen/storage/storage.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_store_test {
namespace {

class StorageStore : public testing::Test {
 protected:
  /// Values of a device after power-on with the present contents of the flash.
  StoringNode::Parameters after_power_on() {
    StoringNode node(memory);
    node.booted();
    return node.parameters();
  }

  SimulatedFlash memory{stored_geometry};
  StoringNode::Parameters defaults = after_power_on();
  StoringNode sut{memory};
  void SetUp() override { sut.booted(); }
  void TearDown() override { EXPECT_EQ(memory.violations, 0U); }
};

TEST_F(StorageStore, ADeviceThatHasStoredNothingHasItsDefaultsAndNoError) {
  EXPECT_EQ(sut.storage.state(), RecordState::empty);
  EXPECT_EQ(sut.get(0x6000), 100U);
  EXPECT_EQ(sut.text(), "charger");
  EXPECT_EQ(sut.get(0x1014), 0x85U);
}

TEST_F(StorageStore, ReadingTellsThatTheDeviceStoresOnCommand) {
  sut.ask("40 10 10 00 00 00 00 00", "4F 10 10 00 05 00 00 00");
  sut.ask("40 10 10 01 00 00 00 00", "43 10 10 01 01 00 00 00");
  sut.ask("40 10 10 05 00 00 00 00", "43 10 10 05 01 00 00 00");
}

TEST_F(StorageStore, SaveInSubIndex1StoresAllParameters) {
  sut.set_all(1);
  const auto stored = sut.parameters();
  sut.save(1);
  EXPECT_EQ(after_power_on(), stored);
}

TEST_F(StorageStore, WhatIsWrittenAfterTheSavingIsNotStored) {
  sut.set_all(1);
  const auto stored = sut.parameters();
  sut.save(1);
  sut.set_all(2);
  EXPECT_EQ(after_power_on(), stored);
}

TEST_F(StorageStore, TheSecondSetReplacesTheFirst) {
  for (const unsigned number : std::to_array<unsigned>({1, 2, 3, 4, 5})) {
    sut.set_all(number);
    sut.save(1);
    EXPECT_EQ(after_power_on(), sut.parameters()) << number;
  }
}

TEST_F(StorageStore, Subindex2StoresTheCommunicationParametersAlone) {
  sut.set_all(1);
  sut.save(2);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x1014), 0x4000'0001U);
  EXPECT_EQ(again.get(0x1017), 1001U);
  EXPECT_EQ(again.get(0x2000), 0x20U);
  EXPECT_EQ(again.get(0x6000), 100U);
  EXPECT_EQ(again.get(0xA000), 0xA0U);
}

TEST_F(StorageStore, SubIndex3StoresTheApplicationParametersAlone) {
  sut.set_all(1);
  sut.save(3);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x1017), 0U);
  EXPECT_EQ(again.get(0x2000), 0x20U);
  EXPECT_EQ(again.get(0x6000), 601U);
  EXPECT_EQ(again.get(0x6021, 2), 16U);
  EXPECT_EQ(again.get(0xA000), 0xA0U);
}

TEST_F(StorageStore, FromSubIndex4OnTheManufacturerDividesHisObjects) {
  sut.set_all(1);
  sut.save(4);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x2000), 1U);
  EXPECT_EQ(again.text(), "set 1");
  EXPECT_EQ(again.get(0x2100), 0x2100U);
  EXPECT_EQ(again.get(0x6000), 100U);
}

TEST_F(StorageStore, AGroupThatIsNotAskedForStaysAsItWasStored) {
  sut.set_all(1);
  sut.save(1);
  sut.set_all(2);
  sut.save(3);
  sut.set_all(3);
  sut.save(5);
  StoringNode again(memory);
  EXPECT_EQ(again.get(0x1017), 1001U);
  EXPECT_EQ(again.text(), "set 1");
  EXPECT_EQ(again.get(0x6000), 602U);
  EXPECT_EQ(again.get(0x6020, 1), 21U);
  EXPECT_EQ(again.get(0x2100), 2003U);
  EXPECT_EQ(again.get(0xA000), 101U);
}

TEST_F(StorageStore, AValueOfTheProcessIsNoParameter) {
  sut.set(0x6010, 0x1234);
  sut.save(1);
  EXPECT_EQ(StoringNode(memory).get(0x6010), 0xFFFFU);
}

TEST_F(StorageStore, WhatACanOnlyReadIsNoParameter) {
  sut.set(0x6030, 1);
  sut.set(0x1000, 2);
  sut.save(1);
  EXPECT_EQ(StoringNode(memory).get(0x6030), 0x6030U);
  EXPECT_EQ(StoringNode(memory).get(0x1000), stored_device_type);
}

TEST_F(StorageStore, ADefaultThatFollowsTheNodeIdGoesOnFollowingIt) {
  sut.save(1);
  StoringNode other(memory, stored_settings, stored_layout.tables(), 6);
  EXPECT_EQ(other.get(0x1014), 0x86U);
}

TEST_F(StorageStore, AnotherValueInThePlaceOfSuchADefaultIsStored) {
  sut.set(0x1014, 0x8000'0085);
  sut.save(1);
  StoringNode other(memory, stored_settings, stored_layout.tables(), 6);
  EXPECT_EQ(other.get(0x1014), 0x8000'0085U);
}

TEST_F(StorageStore, StringsOfAnyLengthAreStored) {
  for (const std::string text : {"", "a", "0123456789"}) {
    sut.set_text(text);
    sut.save(1);
    EXPECT_EQ(StoringNode(memory).text(), text);
  }
}

// "evas", "SAVE", "load", 0, and values of a client without signatures.
TEST_F(StorageStore, AnotherSignatureIsRefusedAndNothingIsStored) {
  sut.set_all(1);
  for (const char* signature :
       {"65 76 61 73", "53 41 56 45", "6C 6F 61 64", "00 00 00 00", "01 00 00 00"}) {
    sut.ask(std::string("23 10 10 01 ") + signature, "80 10 10 01 20 00 00 08");
  }
  EXPECT_EQ(memory.programmings, 0U);
  EXPECT_EQ(after_power_on(), defaults);
}

TEST_F(StorageStore, EachBitOfTheSignatureCounts) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    Frame request = wire_frame("605#23 10 10 01 73 61 76 65");
    request.data.at(4 + bit / 8) ^= static_cast<std::uint8_t>(1U << bit % 8);
    sut.receive(wire_text(request));
    sut.expect({"585#80 10 10 01 20 00 00 08"});
  }
}

TEST_F(StorageStore, TheSignatureHasFourBytes) {
  sut.ask("2B 10 10 01 73 61 00 00", "80 10 10 01 13 00 07 06");
}

TEST_F(StorageStore, TheNumberOfGroupsCannotBeWritten) {
  sut.ask("2F 10 10 00 01 00 00 00", "80 10 10 00 02 00 01 06");
}

TEST_F(StorageStore, AGroupThatThereIsNotHasNoSubIndex) {
  sut.ask("23 10 10 06 73 61 76 65", "80 10 10 06 11 00 09 06");
}

TEST_F(StorageStore, AGroupThatTheDeviceDoesNotStoreOnCommandIsRefused) {
  sut.set(0x1010, 0, 3);
  sut.ask("23 10 10 03 73 61 76 65", "80 10 10 03 20 00 00 08");
}

TEST_F(StorageStore, TheSavingLeavesTheObjectAsItIs) {
  sut.save(1);
  sut.ask("40 10 10 01 00 00 00 00", "43 10 10 01 01 00 00 00");
}

TEST_F(StorageStore, TheSignatureMayComeInASegment) {
  sut.set_all(1);
  sut.ask("21 10 10 01 04 00 00 00", "60 10 10 01 00 00 00 00");
  sut.ask("07 73 61 76 65 00 00 00", "20 00 00 00 00 00 00 00");
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageStore, ResetCommunicationGivesTheCommunicationParametersTheirStoredValues) {
  sut.set_all(1);
  sut.save(1);
  sut.set_all(2);
  sut.receive("000#82 05");
  EXPECT_EQ(sut.get(0x1017), 1001U);
  EXPECT_EQ(sut.get(0x6000), 602U);
}

TEST_F(StorageStore, ResetNodeGivesAllParametersTheirStoredValues) {
  sut.set_all(1);
  const auto stored = sut.parameters();
  sut.save(1);
  sut.set_all(2);
  sut.receive("000#81 05");
  EXPECT_EQ(sut.parameters(), stored);
}

TEST_F(StorageStore, ServicesBeginWithTheStoredValues) {
  struct Witness {
    explicit Witness(StoringNode& device) : device_(device) {
      service.reset = callback<&Witness::reset>(*this);
      device.node.attach(service);
    }
    void reset(ResetScope) { heartbeat_ms = device_.get(0x1017); }
    StoringNode& device_;
    std::uint64_t heartbeat_ms = 0;
    Service service;
  };
  sut.set(0x1017, 500);
  sut.save(1);
  Witness witness(sut);
  sut.receive("000#81 05");
  EXPECT_EQ(witness.heartbeat_ms, 500U);
}

TEST_F(StorageStore, ADeviceStoresInNmtStateOperationalToo) {
  sut.receive("000#01 05");
  sut.set_all(1);
  sut.save(1);
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageStore, WhatIsStoredAlreadyIsNotWrittenAgain) {
  sut.set_all(1);
  sut.save(1);
  const unsigned erasures = memory.erasures;
  for (int i = 0; i < 100; ++i) sut.save(1);
  EXPECT_EQ(memory.erasures, erasures);
}

TEST_F(StorageStore, TheSectorsWearEqually) {
  for (unsigned number = 0; number < 100; ++number) {
    sut.set_all(number);
    sut.save(1);
  }
  EXPECT_EQ(memory.erasures, 100U);
  EXPECT_EQ(after_power_on(), sut.parameters());
}

TEST_F(StorageStore, TheApplicationStoresWithoutABus) {
  AbortCode answer = AbortCode::general;
  auto done = [&](AbortCode code) { answer = code; };
  sut.set_all(1);
  EXPECT_EQ(sut.storage.store(1, Storage::Done::of(done)), AbortCode::none);
  EXPECT_EQ(sut.storage.store(1), AbortCode::device_state);
  EXPECT_EQ(sut.storage.restore(1), AbortCode::device_state);
  sut.settle();
  EXPECT_EQ(answer, AbortCode::none);
  EXPECT_EQ(after_power_on(), sut.parameters());
}

}  // namespace
}  // namespace canvoy::storage_store_test
