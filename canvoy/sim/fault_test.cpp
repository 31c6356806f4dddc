#include "canvoy/sim/fault.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace canvoy {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(FaultTest, ReadsNameAndStart) {
  const FaultParse parsed = parse_fault("heartbeat-loss@20min");
  ASSERT_TRUE(parsed.fault) << parsed.error;
  EXPECT_EQ(parsed.fault->kind, FaultKind::heartbeat_loss);
  EXPECT_EQ(parsed.fault->start, Time(20min));
  EXPECT_EQ(parsed.fault->duration, for_the_rest);
  EXPECT_EQ(parsed.fault->end(), never);
}

TEST(FaultTest, ReadsADuration) {
  const FaultParse parsed = parse_fault("cable-cut@1.5h+30s");
  ASSERT_TRUE(parsed.fault) << parsed.error;
  EXPECT_EQ(*parsed.fault, (ScheduledFault{FaultKind::cable_cut, Time(90min), 30s}));
  EXPECT_EQ(parsed.fault->end(), Time(90min) + 30s);
}

TEST(FaultTest, AFaultMayHoldFromTheStart) {
  EXPECT_EQ(parse_fault("clock-drift@0s").fault->start, Time{});
}

TEST(FaultTest, EveryKindHasANameOfItsOwnThatIsReadBack) {
  std::set<std::string> seen;
  int kind = 0;
  for (const FaultName& name : fault_names()) {
    EXPECT_EQ(static_cast<int>(name.kind), kind++) << "in the order of FaultKind";
    EXPECT_TRUE(seen.insert(std::string(name.name)).second);
    EXPECT_EQ(fault_name(name.kind), name.name);
    const FaultParse parsed = parse_fault(std::string(name.name) + "@1s");
    ASSERT_TRUE(parsed.fault) << parsed.error;
    EXPECT_EQ(parsed.fault->kind, name.kind);
    EXPECT_FALSE(name.description.empty());
    EXPECT_THAT(std::string(name.description), Not(HasSubstr("\n")));
  }
  EXPECT_EQ(kind, 16);
}

TEST(FaultTest, SaysInOneLineWhatIsWrong) {
  struct Case {
    const char* text;
    const char* hint;
  };
  const Case cases[] = {
      {"", "there are heartbeat-loss, pdo-loss"},
      {"hartbeat-loss@1s", "there are heartbeat-loss, pdo-loss"},
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
  };
  for (const Case& wrong : cases) {
    const FaultParse parsed = parse_fault(wrong.text);
    EXPECT_FALSE(parsed.fault) << wrong.text;
    EXPECT_THAT(parsed.error, HasSubstr(wrong.hint));
    EXPECT_THAT(parsed.error, HasSubstr(wrong.text));
    EXPECT_THAT(parsed.error, Not(HasSubstr("\n")));
  }
}

}  // namespace
}  // namespace canvoy
