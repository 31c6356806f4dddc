// PDO access services: set rpdo, set tpdo, set tpdox, read pdo, write pdo, and the event of a
// received PDO (CiA 309-3).
#include <gtest/gtest.h>

#include "canvoy/gateway/testing/wire_gateway.hpp"

namespace canvoy::gateway::pdo_access_test {
namespace {

/// A gateway that is node 9, in NMT state operational.
class GatewayPdo : public testing::Test {
 protected:
  GatewayPdo() : gateway({.node_id = 9}) {}
  void ok(std::string_view line) { EXPECT_EQ(gateway.ask(line), "[1] OK") << line; }
  void fails(std::string_view line, std::string_view code) {
    EXPECT_EQ(gateway.ask(line), "[1] ERROR:" + std::string(code)) << line;
  }

  WireGateway gateway;
};

TEST_F(GatewayPdo, AnRpdoThatComesIsToldToAllClients) {
  ok("[1] set rpdo 1 0x182 event 3 0x2003 0 u8 0x2004 0 u16 0x2005 0 u32");
  Session& other = gateway.gateway.open();
  gateway.receive("182#12 56 34 DE BC 9A 78");
  gateway.expect_lines({"1 pdo 1 3 0x12 0x3456 0x789abcde"});
  gateway.expect_lines(other, {"1 pdo 1 3 0x12 0x3456 0x789abcde"});
}

TEST_F(GatewayPdo, TheLastValuesCanBeRead) {
  ok("[1] set rpdo 7 0x182 event 2 u8 i8");
  fails("[1] r p 7", "102");
  gateway.receive("182#01 FF");
  gateway.receive("182#02 FE");
  gateway.expect_lines({"1 pdo 7 2 0x1 0xff", "1 pdo 7 2 0x2 0xfe"});
  EXPECT_EQ(gateway.ask("[1] r p 7"), "[1] 1 pdo 7 2 0x2 0xfe");
  gateway.expect_frames({});
}

TEST_F(GatewayPdo, SynchronousValuesAreTakenOverAtSync) {
  ok("[1] set rpdo 1 0x182 sync0 1 u8");
  gateway.receive("182#05");
  gateway.expect_lines({});
  gateway.receive("080#");
  gateway.expect_lines({"1 pdo 1 1 0x5"});
}

TEST_F(GatewayPdo, APdoOnRequestIsAskedForAndAnswered) {
  ok("[1] set rpdo 1 0x182 rtr 1 u16");
  gateway.say("[2] r p 1");
  gateway.expect_frames({"182#R2"});
  gateway.expect_lines({});
  gateway.receive("182#34 12");
  gateway.expect_lines({"1 pdo 1 1 0x1234", "[2] 1 pdo 1 1 0x1234"});
}

TEST_F(GatewayPdo, APdoOnRequestThatDoesNotComeTimesOut) {
  ok("[1] set sdo_timeout 50");
  ok("[1] set rpdo 1 0x182 rtr 1 u16");
  gateway.say("[2] r p 1");
  gateway.run_until(Time(49'999us));
  gateway.expect_lines({});
  gateway.run_until(Time(50ms));
  gateway.expect_lines({"[2] ERROR:103"});
}

TEST_F(GatewayPdo, BitsAndOddLengthsStandSideBySide) {
  ok("[1] set rpdo 1 0x182 event 5 b b u24 u8 i16");
  gateway.receive("182#FE FF FF FF FF FF FF");
  gateway.expect_lines({"1 pdo 1 5 0x0 0x1 0xffffff 0xff 0xffff"});
}

TEST_F(GatewayPdo, SixtyFourBooleansFillAPdo) {
  std::string line = "[1] set rpdo 1 0x182 event 64";
  std::string values;
  for (int i = 0; i < 64; ++i) line += " b";
  for (int i = 0; i < 64; ++i) values += i == 1 || i == 63 ? " 0x1" : " 0x0";
  ok(line);
  gateway.receive("182#02 00 00 00 00 00 00 80");
  gateway.expect_lines({"1 pdo 1 64" + values});
}

TEST_F(GatewayPdo, EachTypeHasItsLength) {
  for (const auto& [type, frame, value] :
       {std::tuple{"u8", "182#EF", "0xef"},
        {"i16", "182#EF CD", "0xcdef"},
        {"u24", "182#EF CD AB", "0xabcdef"},
        {"r32", "182#EF CD AB 89", "0x89abcdef"},
        {"i40", "182#EF CD AB 89 67", "0x6789abcdef"},
        {"t", "182#EF CD AB 89 67 45", "0x456789abcdef"},
        {"u56", "182#EF CD AB 89 67 45 23", "0x23456789abcdef"},
        {"r64", "182#EF CD AB 89 67 45 23 01", "0x123456789abcdef"}}) {
    ok("[1] set rpdo 1 0x182 event 1 " + std::string(type));
    gateway.receive(frame);
    gateway.expect_lines({"1 pdo 1 1 " + std::string(value)});
  }
}

TEST_F(GatewayPdo, ATpdoIsSentWhenItIsWritten) {
  ok("[1] set tpdo 1 0x202 event 3 0x2000 0 u8 0x2001 0 u16 0x2002 0 u32");
  gateway.run_for(1s);
  gateway.expect_frames({});
  ok("[1] write pdo 1 3 0x12 0x3456 0x789ABCDE");
  gateway.expect_frames({"202#12 56 34 DE BC 9A 78"});
}

TEST_F(GatewayPdo, ATpdoIsSentAgainWithTheSameValues) {
  ok("[1] set tpdo 1 0x202 event 1 u8");
  ok("[1] w p 1 1 5");
  ok("[1] w p 1 1 5");
  ok("[1] w p 1 1 6");
  gateway.expect_frames({"202#05", "202#05", "202#06"});
}

TEST_F(GatewayPdo, ASynchronousTpdoGoesWithEveryNthSync) {
  ok("[1] set tpdo 1 0x202 sync2 1 u8");
  gateway.receive("080#");
  gateway.receive("080#");
  gateway.expect_frames({});
  ok("[1] w p 1 1 5");
  gateway.expect_frames({});
  for (int i = 0; i < 4; ++i) gateway.receive("080#");
  gateway.expect_frames({"202#05", "202#05"});
}

TEST_F(GatewayPdo, ATpdoOnRequestAnswersARemoteFrame) {
  ok("[1] set tpdo 1 0x202 rtr 1 u8");
  ok("[1] w p 1 1 5");
  gateway.expect_frames({});
  gateway.receive("202#R1");
  gateway.expect_frames({"202#05"});
}

TEST_F(GatewayPdo, AnExtendedTpdoKeepsItsInhibitTimeAndItsPeriod) {
  ok("[1] set tpdox 1 0x202 event20 100 1 u8");
  ok("[1] w p 1 1 1");
  gateway.run_for(5ms);
  ok("[1] w p 1 1 2");
  gateway.run_until(Time(125ms));
  gateway.expect_frames({"@0 202#01", "@20000 202#02", "@120000 202#02"});
}

TEST_F(GatewayPdo, AWrongNumberOfValuesOrOneThatIsTooLargeIsRefused) {
  ok("[1] set tpdo 1 0x202 event 2 u8 b");
  fails("[1] w p 1 3 1 1 1", "401");
  fails("[1] w p 1 1 1", "101");
  fails("[1] w p 1 2 256 1", "101");
  fails("[1] w p 1 2 1 2", "101");
  fails("[1] w p 2 2 1 1", "102");
  gateway.expect_frames({});
}

TEST_F(GatewayPdo, MoreThanEightBytesAreRefused) {
  fails("[1] set rpdo 1 0x182 event 2 u64 b", "401");
  fails("[1] set tpdo 1 0x202 event 9 u8 u8 u8 u8 u8 u8 u8 u8 u8", "401");
}

TEST_F(GatewayPdo, ACobIdBelongsToOnePdo) {
  ok("[1] set rpdo 1 0x182 event 1 u8");
  fails("[1] set rpdo 2 0x182 event 1 u8", "400");
  fails("[1] set tpdo 1 0x182 event 1 u8", "400");
  ok("[1] set rpdo 1 0x182 event 1 u16");
  ok("[1] set rpdo 1 0x80000182 event 0");
  ok("[1] set rpdo 2 0x182 event 1 u8");
}

TEST_F(GatewayPdo, RestrictedCobIdsAreRefusedWithTheAbortCodeOfTheDictionary) {
  for (const char* cob_id :
       {"0x000", "0x07F", "0x101", "0x581", "0x601", "0x6E0", "0x701", "0x7FF", "0x20000182"}) {
    fails("[1] set rpdo 1 " + std::string(cob_id) + " event 1 u8", "0x06090030");
    fails("[1] set tpdo 1 " + std::string(cob_id) + " event 1 u8", "0x06090030");
  }
}

TEST_F(GatewayPdo, ATpdoThatIsSetUpAnewIsSilentAgain) {
  ok("[1] set tpdo 1 0x202 event 1 u8");
  ok("[1] w p 1 1 5");
  ok("[1] set tpdo 1 0x202 event 2 u8 u8");
  gateway.expect_frames({"202#05"});
  ok("[1] w p 1 2 6 7");
  gateway.expect_frames({"202#06 07"});
}

TEST_F(GatewayPdo, TheFirstAndTheLastNumberWork) {
  ok("[1] set rpdo 512 0x182 event 1 u8");
  ok("[1] set tpdo 512 0x202 event 1 u8");
  gateway.receive("182#05");
  gateway.expect_lines({"1 pdo 512 1 0x5"});
  ok("[1] w p 512 1 6");
  gateway.expect_frames({"202#06"});
}

TEST_F(GatewayPdo, NothingFlowsWhileTheGatewayItselfIsStopped) {
  ok("[1] set tpdo 1 0x202 event 1 u8");
  ok("[1] w p 1 1 5");
  ok("[1] 9 stop");
  ok("[1] w p 1 1 6");
  gateway.expect_frames({"202#05", "000#02 09"});
}

TEST_F(GatewayPdo, AResetOfTheGatewaysNodeForgetsAllPdos) {
  ok("[1] set rpdo 1 0x182 event 1 u8");
  gateway.receive("000#82 09");
  gateway.receive("182#05");
  gateway.expect_lines({});
  fails("[1] r p 1", "102");
}

TEST(GatewayWithoutNodeId, HasNoPdos) {
  WireGateway gateway;
  EXPECT_EQ(gateway.ask("[1] set rpdo 1 0x182 event 1 u8"), "[1] ERROR:102");
  EXPECT_EQ(gateway.ask("[1] set tpdo 1 0x202 event 1 u8"), "[1] ERROR:102");
  EXPECT_EQ(gateway.ask("[1] r p 1"), "[1] ERROR:102");
  EXPECT_EQ(gateway.ask("[1] w p 1 0"), "[1] ERROR:102");
}

}  // namespace
}  // namespace canvoy::gateway::pdo_access_test
