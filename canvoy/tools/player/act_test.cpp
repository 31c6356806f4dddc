#include "canvoy/tools/player/act.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::act_test {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_act(text));
  } catch (const UsageError& refused) {
    return refused.what();
  }
  return "taken";
}

TEST(Act, IsReadAndWrittenAsTheSameText) {
  for (const std::string text :
       {"visit:from=2:to=7@1min", "read:bus=sim0:node=10:object=1018/04@63501250us",
        "write:bus=lift1:node=2:object=1017/00:bytes=F401@500ms",
        "write:bus=sim0:node=2:object=5F00/01:bytes=@2h", "nmt:bus=sim0:node=0:command=start@0s",
        "nmt:bus=sim0:node=127:command=reset-communication@1min"}) {
    EXPECT_EQ(act_text(parse_act(text)).substr(0, text.find('@')), text.substr(0, text.find('@')));
    EXPECT_EQ(parse_act(act_text(parse_act(text))).at, parse_act(text).at) << text;
  }
}

TEST(Act, OfNmtHasTheCommandSpecifier) {
  // CiA 301, 7.2.8.3.1: start 1, stop 2, enter pre-operational 80h, reset node 81h, communication
  // 82h.
  const auto specifier = [](const std::string& word) {
    return parse_act("nmt:bus=sim0:node=5:command=" + word + "@1s").request->bytes;
  };
  EXPECT_EQ(specifier("start"), SdoRequests::Bytes{0x01});
  EXPECT_EQ(specifier("stop"), SdoRequests::Bytes{0x02});
  EXPECT_EQ(specifier("enter-pre-operational"), SdoRequests::Bytes{0x80});
  EXPECT_EQ(specifier("reset-node"), SdoRequests::Bytes{0x81});
  EXPECT_EQ(specifier("reset-communication"), SdoRequests::Bytes{0x82});
}

TEST(Act, IsRefusedWithWhatIsWrong) {
  const auto expect_named = [](const std::string& text, const std::string& wrong) {
    EXPECT_NE(refusal_of(text).find(wrong), std::string::npos) << text << ": " << refusal_of(text);
  };
  expect_named("visit:from=2:to=7", "it has no time");
  expect_named("visit:from=2:to=7@soon", "'soon' is no time");
  expect_named("visit:from=2@1s", "it has no to=");
  expect_named("visit:from=0:to=7@1s", "'0' is no from");
  expect_named("visit:from=1:to=255@1s", "'255' is no to");
  expect_named("visit:from=1:to=2:by=3@1s", "'by' is not known");
  expect_named("visit:from=1:from=2:to=3@1s", "'from' is there twice");
  expect_named("dance:from=1@1s", "'dance' is not known");
  expect_named("read:bus=sim0:node=128:object=1018@1s", "'128' is no node");
  expect_named("read:bus=sim0:node=5:object=10000@1s", "'10000' is no object");
  expect_named("read:bus=sim0:node=5:object=1018/100@1s", "'100' is no object");
  expect_named("write:bus=sim0:node=5:object=1017:bytes=F40@1s", "whole byte");
  expect_named("write:bus=sim0:node=5:object=1017:bytes=GG@1s", "'GG' is no bytes");
  expect_named("nmt:bus=sim0:node=5:command=go@1s", "'go' is no command");
}

TEST(Act, ListIsInTheOrderOfTheTimes) {
  const std::vector<Act> acts =
      parse_acts({"visit:from=1:to=2@3s", "visit:from=2:to=3@1s", "visit:from=3:to=4@3s"});
  ASSERT_EQ(acts.size(), 3U);
  EXPECT_EQ(acts[0].from, 2U);
  EXPECT_EQ(acts[1].from, 1U);
  EXPECT_EQ(acts[2].from, 3U);
}

}  // namespace
}  // namespace canvoy::tools::act_test
