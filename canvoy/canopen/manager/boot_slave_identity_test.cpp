// The first steps of the boot-up of a slave: is it present, and is it the expected one (CiA 302-2;
// letters A to D and M to O).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_slave_identity_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;
constexpr std::uint32_t mandatory_slave = 0x0D;

/// Slave 5 with all five expectations.
struct IdentifyingMaster : BootNetwork {
  explicit IdentifyingMaster(std::uint32_t assignment = optional_slave) {
    assign(5, assignment);
    stored.store(0x1F84, 5, 0x000F'0191);
    stored.store(0x1F85, 5, 0x0000'0123);
    stored.store(0x1F86, 5, 0x0000'0007);
    stored.store(0x1F87, 5, 0x0001'0002);
    stored.store(0x1F88, 5, 0xDEAD'BEEF);
    start();
    forget();
    run_until(Time(30ms));
    boot_up(5);
  }
};

TEST(BootSlaveIdentity, AsksForTheDeviceTypeWhenTheSlaveHasBooted) {
  BootNetwork sut;
  sut.assign(5, optional_slave);
  sut.start();
  sut.expect({"77F#00", "000#82 00"});
  sut.run_until(Time(30ms));
  sut.receive("705#00");
  sut.expect({"@30000 605#40 00 10 00 00 00 00 00"});
  sut.run_until(Time(31ms));
  sut.receive("585#43 00 10 00 91 01 0F 00");
  sut.expect({"@31000 000#01 05"});
  sut.expect_log({"@0 network booting", "@0 network complete", "@30 5 device_type",
                  "@31 5 error_control", "@31 5 booted", "@31 5 started"});
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
  EXPECT_EQ(sut.manager.slave_error(5), BootError::none);
}

TEST(BootSlaveIdentity, ComparesTheIdentityInTheOrderOfItsSubIndices) {
  IdentifyingMaster sut;
  sut.expect({"@30000 605#40 00 10 00 00 00 00 00"});
  sut.receive("585#43 00 10 00 91 01 0F 00");
  sut.expect({"605#40 18 10 01 00 00 00 00"});
  sut.receive("585#43 18 10 01 23 01 00 00");
  sut.expect({"605#40 18 10 02 00 00 00 00"});
  sut.receive("585#43 18 10 02 07 00 00 00");
  sut.expect({"605#40 18 10 03 00 00 00 00"});
  sut.receive("585#43 18 10 03 02 00 01 00");
  sut.expect({"605#40 18 10 04 00 00 00 00"});
  sut.receive("585#43 18 10 04 EF BE AD DE");
  sut.expect({"000#01 05"});
  sut.expect_log({"5 device_type", "5 vendor_id", "5 product_code", "5 revision_number",
                  "5 serial_number", "5 error_control", "5 booted", "5 started"});
}

TEST(BootSlaveIdentity, AsksOnlyForWhatIsExpected) {
  for (unsigned expected = 0; expected < 32; ++expected) {
    BootNetwork sut;
    sut.assign(5, optional_slave);
    for (unsigned question = 0; question < 5; ++question) {
      if ((expected >> question & 1U) == 0) continue;
      sut.stored.store(static_cast<std::uint16_t>(0x1F84 + question), 5, 0x55 + question);
    }
    sut.start();
    sut.forget();
    sut.boot_up(5);
    sut.expect({"605#40 00 10 00 00 00 00 00"});
    sut.answer(5, 0x1000, 0, 0x55);
    for (unsigned sub = 1; sub <= 4; ++sub) {
      if ((expected >> sub & 1U) == 0) continue;
      sut.expect({"605#40 18 10 0" + std::to_string(sub) + " 00 00 00 00"});
      sut.answer(5, 0x1018, static_cast<std::uint8_t>(sub), 0x55 + sub);
    }
    sut.expect({"000#01 05"});
    EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted) << expected;
  }
}

struct Difference {
  std::uint8_t sub;  // 0: the device type
  char letter;
  const char* told;
};

class BootSlaveDifference : public testing::TestWithParam<Difference> {};

TEST_P(BootSlaveDifference, EndsTheBootUpForGood) {
  IdentifyingMaster sut;
  const std::uint32_t good[] = {0x000F'0191, 0x123, 7, 0x0001'0002, 0xDEAD'BEEF};
  for (std::uint8_t sub = 0; sub < GetParam().sub; ++sub) {
    sut.answer(5, sub == 0 ? 0x1000 : 0x1018, sub, good[sub]);
  }
  sut.forget();
  sut.answer(5, GetParam().sub == 0 ? 0x1000 : 0x1018, GetParam().sub, 0x99);
  sut.expect_log({GetParam().told});
  EXPECT_EQ(letter(sut.manager.slave_error(5)), GetParam().letter);
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::failed);
  sut.run_for(1h);
  sut.expect({});
  sut.expect_log({});
}

TEST_P(BootSlaveDifference, IsAssumedWhereTheSlaveRefusesToAnswer) {
  IdentifyingMaster sut;
  const std::uint32_t good[] = {0x000F'0191, 0x123, 7, 0x0001'0002, 0xDEAD'BEEF};
  if (GetParam().sub == 0) return;  // it may change: see below
  for (std::uint8_t sub = 0; sub < GetParam().sub; ++sub) {
    sut.answer(5, sub == 0 ? 0x1000 : 0x1018, sub, good[sub]);
  }
  sut.forget();
  sut.receive("585#80 18 10 0" + std::to_string(GetParam().sub) + " 11 00 09 06");
  sut.expect_log({std::string("5 failed ") + GetParam().letter + " 06090011"});
}

INSTANTIATE_TEST_SUITE_P(Each, BootSlaveDifference,
                         testing::Values(Difference{0, 'C', "5 failed C 00000099 not 000F0191"},
                                         Difference{1, 'D', "5 failed D 00000099 not 00000123"},
                                         Difference{2, 'M', "5 failed M 00000099 not 00000007"},
                                         Difference{3, 'N', "5 failed N 00000099 not 00010002"},
                                         Difference{4, 'O', "5 failed O 00000099 not DEADBEEF"}));

TEST(BootSlaveIdentity, IsAskedForAgainEachSecondByAnOptionalSlaveWithoutEnd) {
  BootNetwork sut;
  sut.assign(5, optional_slave);
  sut.stored.store(0x1F89, 0, 5000);
  sut.start();
  sut.forget();
  // One second for the boot-up message, one for the answer, one until the next attempt.
  sut.run_until(Time(4500ms));
  sut.expect({"@1000000 605#40 00 10 00 00 00 00 00", "@2000000 605#80 00 10 00 00 00 04 05",
              "@3000000 605#40 00 10 00 00 00 00 00", "@4000000 605#80 00 10 00 00 00 04 05"});
  sut.expect_log({"@1000 5 device_type", "@2000 5 retried B 05040000", "@3000 5 device_type",
                  "@4000 5 retried B 05040000"});
  EXPECT_EQ(sut.manager.slave_error(5), BootError::no_answer);
  sut.run_until(Time(1000s + 500ms));
  EXPECT_EQ(sut.sent.size(), 996U);
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::waiting);
}

TEST(BootSlaveIdentity, IsAskedForAgainByAMandatorySlaveUntilItsBootTimeIsOver) {
  BootNetwork sut;
  sut.assign(5, mandatory_slave);
  sut.stored.store(0x1F89, 0, 5000);
  sut.start();
  sut.run_until(Time(1h));
  sut.expect_log({"@0 network booting", "@1000 5 device_type", "@2000 5 retried B 05040000",
                  "@3000 5 device_type", "@4000 5 retried B 05040000", "@5000 5 device_type",
                  "@6000 5 failed B 05040000", "@6000 network failed"});
}

TEST(BootSlaveIdentity, IsWaitedForWithoutEndWhereTheBootTimeIs0) {
  BootNetwork sut;
  sut.assign(5, mandatory_slave);
  sut.start();
  sut.run_until(Time(999s));
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booting);
  EXPECT_EQ(sut.manager.network(), NetworkBoot::booting);
}

/// It has answered, so the error is not B. Each device has 1000h: it is not ready yet.
TEST(BootSlaveIdentity, IsAskedForAgainWhereTheDeviceTypeIsRefused) {
  IdentifyingMaster sut;
  sut.forget();
  sut.receive("585#80 00 10 00 00 00 02 06");
  sut.expect_log({"5 retried C 06020000"});
  EXPECT_EQ(sut.manager.slave_error(5), BootError::device_type);
  sut.run_until(Time(1030ms));
  sut.expect({"@1030000 605#40 00 10 00 00 00 00 00"});
}

TEST(BootSlaveIdentity, IsAnotherWhereTheSlaveTellsATimeOut) {
  IdentifyingMaster sut;
  sut.answer(5, 0x1000, 0, 0x000F'0191);
  sut.forget();
  sut.receive("585#80 18 10 01 00 00 04 05");
  sut.expect_log({"5 failed D 05040000"});
  EXPECT_EQ(sut.manager.slave_error(5), BootError::vendor_id);
}

TEST(BootSlaveIdentity, IsAskedForAgainFromTheBeginningWhereOneAnswerWasLost) {
  IdentifyingMaster sut;
  sut.answer(5, 0x1000, 0, 0x000F'0191);
  sut.forget();
  sut.run_until(Time(2030ms));
  sut.expect({"@1030000 605#80 18 10 01 00 00 04 05", "@2030000 605#40 00 10 00 00 00 00 00"});
  sut.expect_log({"@1030 5 retried B 05040000", "@2030 5 device_type"});
}

TEST(BootSlaveIdentity, TakesALateAnswerForNone) {
  IdentifyingMaster sut;
  sut.run_until(Time(1500ms));
  sut.forget();
  sut.receive("585#43 00 10 00 91 01 0F 00");
  sut.expect({});
  sut.run_until(Time(2030ms));
  sut.expect({"@2030000 605#40 00 10 00 00 00 00 00"});
}

TEST(BootSlaveIdentity, ReadsADeviceTypeThatIsShorterOrWithoutSize) {
  for (const char* answer : {"585#43 00 10 00 91 01 0F 00", "585#42 00 10 00 91 01 0F 00"}) {
    IdentifyingMaster sut;
    sut.forget();
    sut.receive(answer);
    sut.expect({"605#40 18 10 01 00 00 00 00"});
  }
  IdentifyingMaster sut;
  sut.forget();
  sut.receive("585#4B 00 10 00 91 01 0F 00");
  sut.expect_log({"5 failed C 00000191 not 000F0191"});
}

TEST(BootSlaveIdentity, IsUnknownOfANodeThat1F81hDoesNotName) {
  for (const std::uint32_t assignment : {0x00U, 0x0CU, 0xFFFF'FFFEU}) {
    BootNetwork sut;
    sut.assign(6, assignment);
    sut.start();
    sut.forget();
    sut.receive("706#00");
    sut.receive("706#7F");
    sut.expect_log({"6 unknown A"});
    sut.run_for(1h);
    sut.expect({});
    EXPECT_EQ(sut.manager.slave_state(6), BootManager::SlaveState::none);
  }
}

TEST(BootSlaveIdentity, OfTheMasterItselfIsNotAskedFor) {
  BootNetwork sut;
  sut.assign(127, mandatory_slave);
  sut.start();
  sut.forget();
  sut.receive("77F#00");
  sut.run_for(10s);
  sut.expect({});
  sut.expect_log({});
}

}  // namespace
}  // namespace canvoy::boot_slave_identity_test
