// Nodes that are heard but not understood, separately for each bus.
#include "canvoy/tools/session/unknown_nodes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "canvoy/can/frame_text.hpp"

namespace canvoy::tools::unknown_nodes_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class UnknownNodesTest : public testing::Test {
 protected:
  void hear(std::string_view bus, std::string_view frame, std::string_view service) {
    sut_.hear(bus, parse_frame(frame).frame, {.service = service});
  }
  void hear_known(std::string_view bus, std::string_view frame) {
    const decoder::DecodedValue value;
    sut_.hear(bus, parse_frame(frame).frame, {.service = "TPDO1", .values = {&value, 1}});
  }

  UnknownNodes sut_;
};

TEST_F(UnknownNodesTest, APdoThatIsUnderstoodSaysNothingOfTheNodeOfAnotherBus) {
  hear("can1", "18A#01", "TPDO1");
  hear_known("can0", "18A#01");
  EXPECT_THAT(sut_.unknown(), ElementsAre(NodeOnBus{"can1", 10}));
  EXPECT_EQ(
      sut_.text(),
      "not known: node can1:10. Say a profile, --node can1:10=418, or have them asked, --ask");
  hear_known("can1", "18A#01");
  EXPECT_THAT(sut_.unknown(), IsEmpty());
  EXPECT_EQ(sut_.text(), "");
}

TEST_F(UnknownNodesTest, TheBusIsToldWhereAnotherHasTheNodeIdOnly) {
  hear("can0", "183#01", "TPDO1");
  hear("can0", "70A#05", "heartbeat");
  hear("can1", "18A#01", "TPDO1");
  EXPECT_THAT(sut_.text(), HasSubstr("not known: nodes 3, can1:10. Say a profile, --node 3=418"));
}

TEST_F(UnknownNodesTest, EachIsToldOnce) {
  hear("can0", "18A#01", "TPDO1");
  EXPECT_THAT(sut_.next_untold(), HasSubstr("node 10 (0Ah) sends PDOs"));
  EXPECT_EQ(sut_.next_untold(), "");
  hear("can1", "18A#01", "TPDO1");
  hear("can0", "18A#01", "TPDO1");
  const std::string told = sut_.next_untold();
  EXPECT_THAT(told, HasSubstr("node 10 (0Ah) on can1 sends PDOs"));
  EXPECT_THAT(told, HasSubstr("--node can1:10=418"));
  EXPECT_THAT(told, HasSubstr("--eds can1:10=FILE"));
  EXPECT_EQ(sut_.next_untold(), "");
}

TEST_F(UnknownNodesTest, AreAskedOnTheBusOnWhichTheyWereHeard) {
  hear("can1", "70A#05", "heartbeat");
  EXPECT_EQ(sut_.next_unasked(), (NodeOnBus{"can1", 10}));
  EXPECT_EQ(sut_.next_unasked(), std::nullopt);
  hear("can0", "70A#05", "heartbeat");
  EXPECT_EQ(sut_.next_unasked(), (NodeOnBus{"can0", 10}));
  EXPECT_EQ(sut_.next_unasked(), std::nullopt);
}

TEST_F(UnknownNodesTest, OfALogWithoutEndOfBusesAreBounded) {
  for (unsigned bus = 0; bus < 2 * UnknownNodes::buses_max; ++bus)
    hear(fmt::format("bus {:04}", bus), "18A#01", "TPDO1");
  EXPECT_EQ(sut_.unknown().size(), UnknownNodes::buses_max);
}

}  // namespace
}  // namespace canvoy::tools::unknown_nodes_test
