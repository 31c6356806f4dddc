#include "canvoy/decoder/unknown_pdos.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder::unknown_pdos_test {
namespace {

class UnknownPdosTest : public testing::Test {
 protected:
  void hear(std::string_view frame, int times = 1) {
    for (int i = 0; i < times; ++i) sut.add(parse_frame(frame).frame);
  }
  /// The guess by name; empty: none.
  std::string_view guess() {
    const Profile* profile = sut.guess(network());
    return profile == nullptr ? "" : profile->name;
  }
  /// PDOs of lift 1: CAN-IDs of CiA 417-3, objects of CiA 417-4 in clauses of their own.
  void hear_a_lift() {
    hear("18C#10270000", 100);         // 6383h, position value: INTEGER32
    hear("188#01", 20);                // 6482h, load signalling: UNSIGNED8
    hear("185#370210000000", 50);      // 6401h and 6433h: UNSIGNED16, INTEGER32
    hear("201#37020000", 10);          // 6301h and 6302h of door 1: two of 16 bits
    hear("205#00", 10);                // 6310h, light barrier: UNSIGNED8
    hear("400#400001FF0100", 30);      // 6011h, virtual output: 48 bits
    hear("481#010001030100");          // 6010h, virtual input: 48 bits
    hear("200#0100010001000100", 10);  // 6300h, four doors of 16 bits
  }
  /// PDOs of a car in the blocks of their nodes (CiA 447-4), objects of CiA 447-3, 4.2.
  void hear_a_car() {
    hear("187#E8039001102700", 100);  // 6050h, 6053h, 6055h: 16, 16 and 24 bits
    hear("180#03", 10);               // 6007h, ignition switch: UNSIGNED8
    hear("181#000000320000", 10);     // 6010h, 6005h, 601Ah: 24, 8 and 16 bits
    hear("182#00", 10);               // 6033h, tester present: UNSIGNED8
    hear("189#000000000000", 10);     // 6040h, 6047h, 604Ah: 32, 8 and 8 bits
    hear("219#01", 10);               // 60D8h of node 2, taximeter: UNSIGNED8
  }
  decoder::Network& network() { return decoder.network(); }

  UnknownPdos sut;
  Decoder decoder;
};

TEST_F(UnknownPdosTest, OfALiftLookLikeItsProfile) {
  hear_a_lift();
  EXPECT_EQ(guess(), "CiA 417-4");
  EXPECT_EQ(sut.count(network()).frames, 231U);
}

TEST_F(UnknownPdosTest, OfACarLookLikeItsProfile) {
  hear_a_car();
  EXPECT_EQ(guess(), "CiA 447-3");
}

TEST_F(UnknownPdosTest, OfNoProfileLookLikeNone) {
  hear("195#0102030405", 10);
  hear("295#0102030405", 10);
  hear("395#0102030405", 10);
  hear("495#01020304050607", 10);
  EXPECT_EQ(guess(), "");
  EXPECT_EQ(sut.count(network()).frames, 40U);
}

TEST_F(UnknownPdosTest, OfOtherLengthsLookLikeNone) {
  hear("18C#1027000000", 10);
  hear("188#0102", 10);
  hear("185#3702100000", 10);
  hear("400#400001FF01", 10);
  EXPECT_EQ(guess(), "");
}

TEST_F(UnknownPdosTest, OfWhichATenthFitsNothingLookLikeNone) {
  hear_a_lift();
  hear("395#0102030405", 26);
  EXPECT_EQ(guess(), "");
}

TEST_F(UnknownPdosTest, OfOneOrTwoCanIdsAreTooFewForAGuess) {
  hear("18C#10270000", 100);
  hear("400#400001FF0100", 100);
  EXPECT_EQ(guess(), "");
  hear("481#010001030100", 1);
  EXPECT_EQ(guess(), "CiA 417-4") << "three are enough";
}

TEST_F(UnknownPdosTest, ThatSeveralProfilesExplainLookLikeNone) {
  // Eight bytes: inputs and outputs of CiA 401, and of CiA 852, which is built on it.
  hear("185#0000000000000000", 10);
  hear("205#0000000000000000", 10);
  hear("305#0000000000000000", 10);
  hear("505#0000000000000000", 10);
  EXPECT_EQ(guess(), "");
}

TEST_F(UnknownPdosTest, AreNoLongerCountedOnceTheirNodeHasToldItsProfile) {
  // TPDO2 of CiA 419, 6.2.6.3, of node 10; node 5 has told nothing.
  hear("28A#011002", 10);
  hear("285#011002", 3);
  EXPECT_FALSE(sut.count(network()).is_any_node_known);
  decoder.decode(parse_frame("60A#4000100000000000").frame);
  decoder.decode(parse_frame("58A#43001000A3010000").frame);
  EXPECT_EQ(sut.count(network()).frames, 3U);
  EXPECT_TRUE(sut.count(network()).is_any_node_known);
}

TEST_F(UnknownPdosTest, AreGuessedAnewWhenMoreIsHeard) {
  hear("195#0102030405", 10);
  EXPECT_EQ(guess(), "");
  for (int i = 0; i < 10; ++i) hear_a_lift();
  EXPECT_EQ(guess(), "CiA 417-4");
}

TEST_F(UnknownPdosTest, AreDataFramesWithElevenBits) {
  hear("18A#R");
  hear("0000018A#01");
  EXPECT_EQ(sut.count(network()).frames, 0U);
}

TEST_F(UnknownPdosTest, AreNotDecodedByAGuess) {
  hear_a_lift();
  guess();
  EXPECT_EQ(network().pdo(0x18C), nullptr);
}

}  // namespace
}  // namespace canvoy::decoder::unknown_pdos_test
