#include "canvoy/text/unknown_pdos_text.hpp"

#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::text::unknown_pdos_text_test {
namespace {

class UnknownPdosTextTest : public testing::Test {
 protected:
  void hear(std::string_view frame) { unknown.add(parse_frame(frame).frame); }
  /// Of lift 1: the car's position, load and velocity, door 1, an output (CiA 417-3).
  void hear_a_lift() {
    hear("18C#10270000");
    hear("188#01");
    hear("185#370210000000");
    hear("201#37020000");
    hear("400#400001FF0100");
  }
  std::string text(const UnknownPdosWords& words = {}) {
    return unknown_pdos_text(unknown, decoder.network(), words);
  }

  decoder::UnknownPdos unknown;
  decoder::Decoder decoder;
};

TEST_F(UnknownPdosTextTest, IsEmptyWhereAllIsKnown) {
  EXPECT_EQ(text(), "");
}

TEST_F(UnknownPdosTextTest, GivesTheOptionOfTheProfileThatExplainsThem) {
  hear_a_lift();
  EXPECT_EQ(text({.fate = "shown as bytes"}),
            "no node has told its profile (1000h): 5 PDOs are shown as bytes; they look like CiA "
            "417-4: --profile 417-4");
}

TEST_F(UnknownPdosTextTest, SaysWhichOptionsTellWhereNoProfileExplainsThem) {
  hear("195#0102030405");
  EXPECT_EQ(text(),
            "no node has told its profile (1000h): 1 PDO is not decoded; --profile or --node "
            "NODE=PROFILE says which");
}

TEST_F(UnknownPdosTextTest, OfOneBusOfSeveralHasItInTheOption) {
  hear_a_lift();
  EXPECT_TRUE(text({.bus = "can1"}).ends_with(": --profile can1=417-4"));
}

TEST_F(UnknownPdosTextTest, IsEmptyWithoutAGuessForACallerWhoTellsOfUnknownNodes) {
  hear("195#0102030405");
  EXPECT_EQ(text({.only_with_guess = true}), "");
  unknown = {};
  hear_a_lift();
  EXPECT_TRUE(text({.only_with_guess = true}).ends_with("--profile 417-4"));
}

TEST_F(UnknownPdosTextTest, HasNoNumberWhereItChanges) {
  hear_a_lift();
  EXPECT_TRUE(text({.is_counted = false})
                  .starts_with("no node has told its profile (1000h): PDOs are not decoded; they"));
}

TEST_F(UnknownPdosTextTest, OfSomeNodesSaysThatOthersAreKnown) {
  decoder.network().set_profile(10, *find_profile("419"));
  hear("195#0102030405");
  EXPECT_EQ(text(),
            "1 PDO is not decoded, since not all nodes have told their profile (1000h); --profile "
            "or --node NODE=PROFILE says which");
}

}  // namespace
}  // namespace canvoy::text::unknown_pdos_text_test
