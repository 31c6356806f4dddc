// The common grammar of faults, and the faults of two worlds.
#include "canvoy/sim/fault.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "canvoy/worlds/charger/fault.hpp"
#include "canvoy/worlds/lift/fault.hpp"

namespace canvoy::fault_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr FaultRow names[] = {{"heartbeat-loss", "it is silent"}, {"not-ready", "it says so"}};
constexpr FaultPlaceName places[] = {{"node", 127}, {"group", 0, &AnyFault::part}};
constexpr FaultGrammar grammar{names, places};

TEST(FaultText, IsANameAndAStart) {
  const FaultParse parsed = parse_fault(grammar, "not-ready@20min");
  ASSERT_TRUE(parsed.fault) << parsed.error;
  EXPECT_EQ(parsed.fault->kind, 1U);
  EXPECT_EQ(parsed.fault->start, Time(20min));
  EXPECT_EQ(parsed.fault->duration, for_the_rest);
  EXPECT_EQ(parsed.fault->node, 0U);
  EXPECT_EQ(parsed.fault->part, 1U);
}

TEST(FaultText, MayHaveADurationAndPlaces) {
  const FaultParse parsed = parse_fault(grammar, "heartbeat-loss:node=5:group@1.5h+30s");
  ASSERT_TRUE(parsed.fault) << parsed.error;
  EXPECT_EQ(parsed.fault->kind, 0U);
  EXPECT_EQ(parsed.fault->start, Time(90min));
  EXPECT_EQ(parsed.fault->duration, 30s);
  EXPECT_EQ(parsed.fault->node, 5U);
  EXPECT_EQ(parsed.fault->part, 0U);
}

TEST(FaultText, MayBeginAtTheStart) {
  EXPECT_EQ(parse_fault(grammar, "not-ready@0s").fault->start, Time{});
}

TEST(FaultText, IsWrittenAsItIsRead) {
  for (const char* text : {"not-ready@20min", "heartbeat-loss:node=5:group@90min+30s",
                           "not-ready:group@0s", "not-ready@1500us+250ms"}) {
    const FaultParse parsed = parse_fault(grammar, text);
    ASSERT_TRUE(parsed.fault) << parsed.error;
    EXPECT_EQ(fault_text(grammar, *parsed.fault), text);
  }
}

TEST(FaultText, ThatIsWrongIsRefusedInOneLine) {
  struct Case {
    const char* text;
    const char* hint;
  };
  const Case cases[] = {
      {"", "there are heartbeat-loss, not-ready"},
      {"hartbeat-loss@1s", "there are heartbeat-loss, not-ready"},
      {"Heartbeat-Loss@1s", "no such fault"},
      {"not-ready", "not-ready@20min"},
      {"not-ready@", "the start is a number and us, ms, s, min or h"},
      {"not-ready@20", "the start is"},
      {"not-ready@-1s", "the start is"},
      {"not-ready@1s+", "the duration is a number above 0"},
      {"not-ready@1s+0s", "the duration is"},
      {"not-ready@1s+5", "the duration is"},
      {"not-ready@1s+5s+5s", "the duration is"},
      {"not-ready@1s@2s", "the start is"},
      {"not-ready:lift=1@1s", "there are node=, group"},
      {"not-ready:@1s", "'' is no place"},
      {"not-ready:node@1s", "'' is no number from 1 to 127"},
      {"not-ready:node=128@1s", "'128' is no number from 1 to 127"},
      {"not-ready:node=-1@1s", "is no number from 1 to 127"},
      {"not-ready:node=0@1s", "'0' is no number from 1 to 127"},
      {"not-ready:node=nan@1s", "'nan' is no number from 1 to 127"},
      {"not-ready:node=5.5@1s", "'5.5' is no number from 1 to 127"},
      {"not-ready:node=99999999999999999999@1s", "is no number from 1 to 127"},
      {"not-ready:node=5:node=6@1s", "'node=6': another place of the kind is named before"},
      {"not-ready:group:group@1s", "'group': another place of the kind is named before"},
      {"not-ready:group=1@1s", "'group=1' is no place"},
  };
  for (const Case& wrong : cases) {
    const FaultParse parsed = parse_fault(grammar, wrong.text);
    EXPECT_FALSE(parsed.fault) << wrong.text;
    EXPECT_THAT(parsed.error, HasSubstr(wrong.hint));
    EXPECT_THAT(parsed.error, HasSubstr(wrong.text));
    EXPECT_THAT(parsed.error, Not(HasSubstr("\n")));
  }
  EXPECT_THAT(parse_fault({names}, "not-ready:node=5@1s").error, HasSubstr("there are none here"));
}

void expect_names_of_their_own(const FaultGrammar& world) {
  std::set<std::string_view> seen;
  for (const FaultRow& kind : world.kinds) {
    EXPECT_TRUE(seen.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.description.empty()) << kind.name;
    EXPECT_THAT(std::string(kind.description), Not(HasSubstr("\n")));
    EXPECT_THAT(fault_help(world), HasSubstr(std::string(kind.description)));
  }
}

TEST(FaultOfACharger, EveryKindHasItsName) {
  using charger::FaultKind;
  const FaultGrammar world = fault_grammar<charger::FaultKind>();
  EXPECT_EQ(world.kinds.size(), charger::fault_kinds);
  expect_names_of_their_own(world);
  EXPECT_EQ(fault_name(FaultKind::heartbeat_loss), "heartbeat-loss");
  EXPECT_EQ(fault_name(FaultKind::pilot_loss), "pilot-loss");
  EXPECT_EQ(fault_name(FaultKind::clock_drift), "clock-drift");
}

TEST(FaultOfACharger, IsScheduledAsItIsWritten) {
  const charger::ScheduledFault cut{charger::FaultKind::cable_cut, Time(90min), 30s};
  EXPECT_EQ(parse_fault<charger::FaultKind>("cable-cut@90min+30s").fault, cut);
  EXPECT_EQ(cut.end(), Time(90min) + 30s);
  EXPECT_EQ(fault_text(cut), "cable-cut@90min+30s");
}

TEST(FaultOfALift, EveryKindHasItsName) {
  using lift::FaultKind;
  expect_names_of_their_own(fault_grammar<lift::FaultKind>());
  EXPECT_EQ(fault_name(FaultKind::lost_node), "lost-node");
  EXPECT_EQ(fault_name(FaultKind::fire_alarm), "fire-alarm");
  EXPECT_EQ(fault_name(FaultKind::smoke), "smoke");
}

TEST(FaultOfALift, IsScheduledAsItIsWritten) {
  struct Row {
    const char* text;
    lift::ScheduledFault fault;
  };
  using enum lift::FaultKind;
  const Row rows[] = {
      {"dead-encoder@10min", {.kind = dead_encoder, .start = Time(10min)}},
      {"lost-node:lift=2:node=6@10min+30s",
       {.kind = lost_node, .start = Time(10min), .duration = 30s, .part = 2, .node = 6}},
      {"cable-cut:group:node=2@5min",
       {.kind = cable_cut, .start = Time(5min), .part = 0, .node = 2}},
      {"stuck-button:floor=5@1h+2min",
       {.kind = stuck_button, .start = Time(1h), .duration = 2min, .spot = 5}},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(parse_fault<lift::FaultKind>(row.text).fault, row.fault) << row.text;
    EXPECT_EQ(fault_text(row.fault), row.text);
  }
}

}  // namespace
}  // namespace canvoy::fault_test
