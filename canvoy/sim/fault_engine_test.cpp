#include "canvoy/sim/fault_engine.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "canvoy/sim/power_cuts.hpp"

namespace canvoy::fault_engine_test {

enum class Kind : std::uint8_t { lost_node, no_paper, restart, stuck_axis };
constexpr FaultRow rows[] = {
    {"node", "it has no power", {.is_at_node = true, .node = 5}},
    {"paper", "there is none"},
    {"restart", "it boots", {.is_at_node = true, .node = 5, .is_over_at_once = true}},
    {"axis", "it stays", {.is_at_spot = true, .spot = 4}}};
constexpr FaultGrammar grammar_of(Kind) {
  return {rows};
}
using Fault = ScheduledFault<Kind>;

namespace {

/// Records what it receives.
class Diary {
 public:
  explicit Diary(std::vector<Fault> plan, FaultMaking making = FaultMaking::first)
      : plan_(std::move(plan)), faults_(plan_, FaultEngine<Kind>::of(*this), making) {
    faults_.plan(world_);
  }
  std::string until(Time time) {
    world_.run_until(time);
    return std::exchange(text_, "");
  }
  const FaultEngine<Kind>& faults() const { return faults_; }

 private:
  friend FaultEngine<Kind>;
  void began(std::size_t fault) { text_ += "begins " + std::to_string(fault) + "; "; }
  void ended(std::size_t fault) { text_ += "ends " + std::to_string(fault) + "; "; }
  void set(std::size_t fault, bool is_present) {
    text_ += std::string(fault_name(faults_[fault].kind)) + (is_present ? " lost; " : " back; ");
  }

  World world_;
  std::vector<Fault> plan_;
  FaultEngine<Kind> faults_;
  std::string text_;
};

TEST(FaultEngine, AFaultIsToldAndMadeAndMended) {
  Diary diary({{.kind = Kind::no_paper, .start = Time(2s), .duration = 3s}});
  EXPECT_EQ(diary.until(Time(1s)), "");
  EXPECT_EQ(diary.until(Time(2s)), "begins 0; paper lost; ");
  EXPECT_TRUE(diary.faults().is_present(Kind::no_paper));
  EXPECT_EQ(diary.until(Time(10s)), "ends 0; paper back; ");
  EXPECT_FALSE(diary.faults().is_present(Kind::no_paper));
}

TEST(FaultEngine, OneThatDoesNotEndLasts) {
  Diary diary({{.kind = Kind::no_paper, .start = Time(2s)}});
  EXPECT_EQ(diary.until(Time(1h)), "begins 0; paper lost; ");
  EXPECT_TRUE(diary.faults().is_present(Kind::no_paper));
}

TEST(FaultEngine, OfTwoOfAKindTheLastOneMends) {
  Diary diary({{.kind = Kind::no_paper, .start = Time(1s), .duration = 3s},
               {.kind = Kind::no_paper, .start = Time(2s), .duration = 5s}});
  EXPECT_EQ(diary.until(Time(3s)), "begins 0; paper lost; begins 1; ");
  EXPECT_EQ(diary.until(Time(5s)), "ends 0; ");
  EXPECT_EQ(diary.until(Time(8s)), "ends 1; paper back; ");
}

TEST(FaultEngine, FaultsOfTwoNodesOrSpotsAreMadeForThemselves) {
  Diary nodes(
      {{.start = Time(1s), .duration = 3s}, {.start = Time(2s), .duration = 5s, .node = 6}});
  EXPECT_EQ(nodes.until(Time(3s)), "begins 0; node lost; begins 1; node lost; ");
  EXPECT_TRUE(nodes.faults().is_present(Kind::lost_node, 5)) << "where the plan leaves it open";
  EXPECT_FALSE(nodes.faults().is_present(Kind::lost_node, 7));
  EXPECT_EQ(nodes.until(Time(8s)), "ends 0; node back; ends 1; node back; ");
  const Fault open{.kind = Kind::stuck_axis, .start = Time(1s), .duration = 3s};
  Fault fourth = open;
  fourth.spot = 4;
  EXPECT_EQ(Diary({open, fourth}).until(Time(8s)),
            "begins 0; axis lost; begins 1; ends 0; ends 1; axis back; ");
}

TEST(FaultEngine, WhatIsOverAtOnceIsMadeEachTime) {
  const Fault restart{.kind = Kind::restart, .start = Time(1s)};
  EXPECT_EQ(Diary({restart, restart}).until(Time(8s)),
            "begins 0; restart lost; begins 1; restart lost; ");
}

TEST(FaultEngine, EachIsMadeAnewWhereTheWorldWantsIt) {
  const std::vector<Fault> plan = {{.kind = Kind::no_paper, .start = Time(1s), .duration = 3s},
                                   {.kind = Kind::no_paper, .start = Time(2s), .duration = 5s}};
  EXPECT_EQ(Diary(plan, FaultMaking::each).until(Time(9s)),
            "begins 0; paper lost; begins 1; paper lost; ends 0; ends 1; paper back; ");
  EXPECT_EQ(Diary(plan, FaultMaking::by_world).until(Time(9s)),
            "begins 0; paper lost; begins 1; paper lost; ends 0; paper back; ends 1; paper back; ");
}

/// At one instant.
TEST(FaultEngine, WhatTakesOverLeavesNoPauseWhereTheWorldKnowsWhatIsAlike) {
  const std::vector<Fault> plan = {{.kind = Kind::no_paper, .start = Time(1s), .duration = 1s},
                                   {.kind = Kind::no_paper, .start = Time(2s), .duration = 1s}};
  EXPECT_EQ(Diary(plan).until(Time(2s)),
            "begins 0; paper lost; ends 0; paper back; begins 1; paper lost; ");
  EXPECT_EQ(Diary(plan, FaultMaking::by_world).until(Time(2s)),
            "begins 0; paper lost; begins 1; paper lost; ends 0; paper back; ");
}

struct PowerDiary {
  std::string text;

  void power(NodeId id, bool is_on) { text += std::to_string(id) + (is_on ? " on; " : " off; "); }
};

TEST(PowerCuts, ANodeHasItsPowerAgainWhenTheLastCutIsOver) {
  PowerDiary diary;
  PowerCuts cuts(PowerCuts::Switch::to<&PowerDiary::power>(diary));
  cuts.set_power(5, false);
  cuts.set_power(5, false);
  cuts.set_power(5, true);
  EXPECT_TRUE(cuts.is_cut(5));
  EXPECT_FALSE(cuts.is_cut(6));
  EXPECT_EQ(diary.text, "5 off; ");
  cuts.set_power(5, true);
  EXPECT_FALSE(cuts.is_cut(5));
  EXPECT_EQ(diary.text, "5 off; 5 on; ");
}

TEST(PowerCuts, ANodeWithoutPowerDoesNotRestart) {
  PowerDiary diary;
  PowerCuts cuts(PowerCuts::Switch::to<&PowerDiary::power>(diary));
  cuts.set_power(5, false);
  cuts.restart(5);
  cuts.restart(6);
  EXPECT_EQ(diary.text, "5 off; 6 off; 6 on; ");
}

}  // namespace
}  // namespace canvoy::fault_engine_test
