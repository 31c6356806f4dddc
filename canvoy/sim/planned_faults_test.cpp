#include "canvoy/sim/planned_faults.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/sim/fault.hpp"
#include "canvoy/sim/power_cuts.hpp"

namespace canvoy::planned_faults_test {

enum class Kind : std::uint8_t { lost_node, no_paper };
constexpr bool has_node(Kind kind) {
  return kind == Kind::lost_node;
}
struct Fault {
  Kind kind = Kind::lost_node;
  Time start{};
  Duration duration = for_the_rest;

  Time end() const { return end_of_fault(start, duration); }
};

namespace {

/// Writes down what it is told.
class Diary {
 public:
  explicit Diary(std::vector<Fault> plan)
      : plan_(std::move(plan)),
        faults_(plan_, {.began = Callback<void(std::size_t)>::to<&Diary::began>(*this),
                        .ended = Callback<void(std::size_t)>::to<&Diary::ended>(*this),
                        .set = Callback<void(const Fault&, bool)>::to<&Diary::set>(*this)}) {
    faults_.plan(world_);
  }
  std::string until(Time time) {
    world_.run_until(time);
    return std::exchange(text_, "");
  }
  bool is_present(Kind kind) const { return faults_.is_present(kind); }

 private:
  void began(std::size_t fault) { text_ += "begins " + std::to_string(fault) + "; "; }
  void ended(std::size_t fault) { text_ += "ends " + std::to_string(fault) + "; "; }
  void set(const Fault& fault, bool is_present) {
    text_ += (fault.kind == Kind::no_paper ? "paper" : "node");
    text_ += is_present ? " lost; " : " back; ";
  }

  World world_;
  std::vector<Fault> plan_;
  PlannedFaults<Fault, 2> faults_;
  std::string text_;
};

TEST(PlannedFaults, AFaultIsToldAndMadeAndMended) {
  Diary diary({{.kind = Kind::no_paper, .start = Time(2s), .duration = 3s}});
  EXPECT_EQ(diary.until(Time(1s)), "");
  EXPECT_EQ(diary.until(Time(2s)), "begins 0; paper lost; ");
  EXPECT_TRUE(diary.is_present(Kind::no_paper));
  EXPECT_EQ(diary.until(Time(10s)), "ends 0; paper back; ");
  EXPECT_FALSE(diary.is_present(Kind::no_paper));
}

TEST(PlannedFaults, OneThatDoesNotEndLasts) {
  Diary diary({{.kind = Kind::no_paper, .start = Time(2s)}});
  EXPECT_EQ(diary.until(Time(1h)), "begins 0; paper lost; ");
  EXPECT_TRUE(diary.is_present(Kind::no_paper));
}

TEST(PlannedFaults, OfTwoOfAKindTheLastOneMends) {
  Diary diary({{.kind = Kind::no_paper, .start = Time(1s), .duration = 3s},
               {.kind = Kind::no_paper, .start = Time(2s), .duration = 5s}});
  EXPECT_EQ(diary.until(Time(3s)), "begins 0; paper lost; begins 1; ");
  EXPECT_EQ(diary.until(Time(5s)), "ends 0; ");
  EXPECT_EQ(diary.until(Time(8s)), "ends 1; paper back; ");
}

TEST(PlannedFaults, EachFaultOfANodeIsMadeForItself) {
  Diary diary({{.start = Time(1s), .duration = 3s}, {.start = Time(2s), .duration = 5s}});
  EXPECT_EQ(diary.until(Time(3s)), "begins 0; node lost; begins 1; node lost; ");
  EXPECT_EQ(diary.until(Time(8s)), "ends 0; node back; ends 1; node back; ");
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
}  // namespace canvoy::planned_faults_test
