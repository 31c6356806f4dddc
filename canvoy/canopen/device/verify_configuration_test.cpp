// 1020h of the slave, at the wire (CiA 301, 7.5.2.23).
#include "canvoy/canopen/device/verify_configuration.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::verify_configuration_test {
namespace {

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1003, .entry_count = 1},
                              {.index = 0x1010, .entry_count = 2},
                              {.index = 0x1017, .entry_count = 1},
                              {.index = 0x1020, .entry_count = 2},
                              {.index = 0x1201, .entry_count = 2},
                              {.index = 0x1F25, .entry_count = 1},
                              {.index = 0x2000, .entry_count = 1},
                              {.index = 0x6200, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {{.access = Access::rw},
         {.access = Access::const_, .initial = 1},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::unsigned16, .access = Access::rw},
         {.access = Access::const_, .initial = 2},
         {.sub_first = 1, .sub_last = 2, .type = DataType::unsigned32, .access = Access::rw},
         {.sub_first = 1,
          .sub_last = 2,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = 0x8000'0000},
         {.sub_first = 3, .sub_last = 3, .access = Access::rw},
         {.type = DataType::unsigned32, .access = Access::wo},
         {.type = DataType::unsigned8, .access = Access::rw},
         {.type = DataType::unsigned8, .access = Access::rw | Access::rpdo}}));

struct Slave : WireNode {
  Slave() : WireNode(layout.tables(), 5) { boot(); }

  void configure() {
    receive("605#23 20 10 01 E8 03 00 00");  // 1000 days
    receive("605#23 20 10 02 70 17 00 00");  // 6000 ms
    sent.clear();
  }
  bool is_configured() {
    return node.dictionary().number(0x1020, 1) == 1000 &&
           node.dictionary().number(0x1020, 2) == 6000;
  }
  bool is_unconfigured() {
    return node.dictionary().number(0x1020, 1) == 0 && node.dictionary().number(0x1020, 2) == 0;
  }

  SdoServer server{node, 0, {}};
  VerifyConfiguration sut{node};
};

TEST(VerifyConfiguration, KeepsTheDateAndTimeThatItWasGiven) {
  Slave slave;
  slave.configure();
  EXPECT_TRUE(slave.is_configured());
  slave.receive("605#40 20 10 01 00 00 00 00");
  slave.receive("605#40 20 10 02 00 00 00 00");
  slave.expect({"585#43 20 10 01 E8 03 00 00", "585#43 20 10 02 70 17 00 00"});
}

TEST(VerifyConfiguration, AWriteToAConfigurationObjectMakesItZero) {
  Slave slave;
  for (const char* write : {"605#2B 17 10 00 F4 01 00 00", "605#2F 00 20 00 07 00 00 00",
                            "605#23 01 12 01 40 06 00 00"}) {
    slave.configure();
    slave.receive(write);
    EXPECT_TRUE(slave.is_unconfigured()) << write;
  }
  slave.sent.clear();
  slave.receive("605#40 20 10 01 00 00 00 00");
  slave.receive("605#40 20 10 02 00 00 00 00");
  slave.expect({"585#43 20 10 01 00 00 00 00", "585#43 20 10 02 00 00 00 00"});
}

TEST(VerifyConfiguration, TheNextConfigurationIsKeptAgain) {
  Slave slave;
  slave.configure();
  slave.receive("605#2B 17 10 00 F4 01 00 00");
  slave.configure();
  EXPECT_TRUE(slave.is_configured());
}

TEST(VerifyConfiguration, AWriteThatIsRefusedChangesNothing) {
  Slave slave;
  slave.configure();
  slave.receive("605#2F 17 10 00 F4 00 00 00");  // too short
  slave.receive("605#2F 10 10 00 F4 00 00 00");  // read only
  EXPECT_TRUE(slave.is_configured());
}

TEST(VerifyConfiguration, ProcessDataCommandsAndStatesAreNoConfiguration) {
  Slave slave;
  slave.configure();
  for (const char* write : {"605#2F 00 62 00 01 00 00 00", "605#2F 03 10 00 00 00 00 00",
                            "605#23 10 10 01 73 61 76 65", "605#23 25 1F 00 63 6F 6E 66"}) {
    slave.sent.clear();
    slave.receive(write);
    ASSERT_EQ(slave.sent.size(), 1u);
    EXPECT_EQ(slave.sent[0].frame.data[0], 0x60) << "it is written";
    EXPECT_TRUE(slave.is_configured()) << write;
  }
}

TEST(VerifyConfiguration, AnSdoChannelThatIsGivenOutDynamicallyIsNoConfiguration) {
  Slave slave;
  slave.configure();
  slave.receive("605#23 01 12 01 40 06 00 40");
  slave.receive("605#23 01 12 02 C0 05 00 40");
  slave.receive("605#2F 01 12 03 07 00 00 00");
  slave.receive("605#23 01 12 01 00 00 00 C0");
  EXPECT_EQ(slave.node.dictionary().number(0x1201, 1), 0xC000'0000u);
  EXPECT_TRUE(slave.is_configured());
}

TEST(VerifyConfiguration, WhatTheDeviceItselfWritesIsNoConfiguration) {
  Slave slave;
  slave.configure();
  const std::uint8_t value[] = {0x64, 0x00};
  ASSERT_EQ(slave.node.dictionary().write(0x1017, 0, value, Source::application), AbortCode::none);
  EXPECT_TRUE(slave.is_configured());
}

TEST(VerifyConfiguration, AResetOfCommunicationTakesTheValuesOfPowerOn) {
  Slave slave;
  slave.configure();
  slave.receive("000#82 05");
  EXPECT_TRUE(slave.is_unconfigured());
}

}  // namespace
}  // namespace canvoy::verify_configuration_test
