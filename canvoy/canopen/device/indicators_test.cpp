#include "canvoy/canopen/device/indicators.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::indicators_test {
namespace {

using enum Indication;
using Condition = Indicators::Condition;

/// A character for each `step` from Time zero: # on, . off.
std::string drawn(Indication indication, Indicator indicator, Duration step, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += is_lit(indication, indicator, Time(i * step)) ? '#' : '.';
  }
  return text;
}

struct Pattern {
  Indication indication;
  Duration step;
  const char* run;
  const char* error;
};
// CiA 303-3: flickering 10 Hz, blinking 2.5 Hz, flashes of 200 ms with 200 ms between and a second
// after the last.
constexpr Pattern patterns[] = {
    {off, 50ms, "................", "................"},
    {on, 50ms, "################", "################"},
    {flickering, 50ms, "#.#.#.#.#.#.#.#.", ".#.#.#.#.#.#.#.#"},
    {blinking, 200ms, "#.#.#.#.#.#.#.#.", ".#.#.#.#.#.#.#.#"},
    {single_flash, 200ms, "#.....#.....#.", ".#.....#.....#"},
    {double_flash, 200ms, "#.#.....#.#...", ".#.#.....#.#.."},
    {triple_flash, 200ms, "#.#.#.....#.#.#.", ".#.#.#.....#.#.#"},
    {quadruple_flash, 200ms, "#.#.#.#.....#.#.", ".#.#.#.#.....#.#"},
};

TEST(Indication, HasTheRhythmOfCia3033) {
  for (const Pattern& pattern : patterns) {
    SCOPED_TRACE(static_cast<unsigned>(pattern.indication));
    const std::string run = pattern.run;
    const std::string error = pattern.error;
    EXPECT_EQ(drawn(pattern.indication, Indicator::run, pattern.step, run.size()), run);
    EXPECT_EQ(drawn(pattern.indication, Indicator::error, pattern.step, error.size()), error);
  }
}

TEST(Indication, IsNeverLitInBothColoursAtATimeUnlessBothAreOn) {
  for (const Pattern& pattern : patterns) {
    if (pattern.indication == on) continue;
    for (Time at{}; at < Time(5s); at += 25ms) {
      EXPECT_FALSE(is_lit(pattern.indication, Indicator::run, at) &&
                   is_lit(pattern.indication, Indicator::error, at))
          << static_cast<unsigned>(pattern.indication) << " at " << at.time_since_epoch() / 1ms;
    }
  }
}

TEST(Indication, ChangesToTheMicrosecondAndSaysWhen) {
  for (const Pattern& pattern : patterns) {
    for (const Indicator indicator : {Indicator::run, Indicator::error}) {
      const Indication sut = pattern.indication;
      if (sut == off || sut == on) {
        EXPECT_EQ(next_change(sut, indicator, Time(1s)), never);
        continue;
      }
      Time at{};
      for (int i = 0; i < 20; ++i) {
        const Time next = next_change(sut, indicator, at);
        ASSERT_GT(next, at);
        EXPECT_EQ(is_lit(sut, indicator, next - 1us), is_lit(sut, indicator, at));
        EXPECT_NE(is_lit(sut, indicator, next), is_lit(sut, indicator, at));
        EXPECT_EQ(next_change(sut, indicator, next - 1us), next);
        at = next;
      }
    }
  }
}

TEST(Indication, IsDefinedBeforeTimeZeroToo) {
  EXPECT_TRUE(is_lit(blinking, Indicator::run, Time(-400ms)));
  EXPECT_FALSE(is_lit(blinking, Indicator::run, Time(-200ms)));
  EXPECT_EQ(next_change(blinking, Indicator::run, Time(-250ms)), Time(-200ms));
  EXPECT_EQ(next_change(blinking, Indicator::run, Time(-200ms)), Time(0ms));
}

// With SYNC each 10 ms.
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1001, .entry_count = 1},
                                      {.index = 0x1005, .entry_count = 1},
                                      {.index = 0x1006, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned8},
                 {.type = DataType::unsigned32, .access = Access::rw, .initial = 0x80},
                 {.type = DataType::unsigned32, .access = Access::rw, .initial = 10'000}}));

struct LitNode : WireNode {
  LitNode() : WireNode(layout.tables(), 5) {}
  void bus(BusState state) { node.bus_state(state, now); }

  Error present[4];
  Emergency waiting[4];
  EmergencyProducer emergency{node, present, waiting};
  Sync sync{node};
  Indicators sut{node, &emergency, &sync};
};

TEST(RunIndicator, ShowsTheNmtState) {
  LitNode node;
  EXPECT_EQ(node.sut.run(), off);
  node.boot();
  EXPECT_EQ(node.sut.run(), blinking);
  node.receive("000#01 05");
  EXPECT_EQ(node.sut.run(), on);
  node.receive("000#02 05");
  EXPECT_EQ(node.sut.run(), single_flash);
  EXPECT_EQ(node.sut.error(), off);
}

TEST(RunIndicator, ShowsLssBeforeAProgramDownloadBeforeTheNmtState) {
  LitNode node;
  node.boot();
  node.sut.set(Condition::program_download, true);
  EXPECT_EQ(node.sut.run(), triple_flash);
  node.sut.set(Condition::lss, true);
  EXPECT_EQ(node.sut.run(), flickering);
  EXPECT_EQ(node.sut.error(), flickering);
  node.sut.set(Condition::program_download, false);
  node.sut.set(Condition::lss, false);
  EXPECT_EQ(node.sut.run(), blinking);
  EXPECT_EQ(node.sut.error(), off);
}

TEST(ErrorIndicator, ShowsTheStateOfTheBus) {
  LitNode node;
  node.boot();
  node.bus(BusState::error_warning);
  EXPECT_EQ(node.sut.error(), single_flash);
  node.bus(BusState::error_passive);
  EXPECT_EQ(node.sut.error(), single_flash);
  node.bus(BusState::bus_off);
  EXPECT_EQ(node.sut.error(), on);
  node.bus(BusState::error_active);
  EXPECT_EQ(node.sut.error(), off);
}

TEST(ErrorIndicator, ShowsErrorsWhileTheyArePresent) {
  struct Case {
    std::uint16_t code;
    Indication indication;
  };
  constexpr Case cases[] = {{0x8130, double_flash}, {0x8250, quadruple_flash}, {0x4210, off}};
  for (const Case& a : cases) {
    LitNode node;
    node.boot();
    node.node.raise({.code = a.code, .instance = 3});
    EXPECT_EQ(node.sut.error(), a.indication) << a.code;
    node.node.raise({.code = a.code, .instance = 4});
    node.node.clear({.code = a.code, .instance = 3});
    EXPECT_EQ(node.sut.error(), a.indication) << "the other is present still";
    node.node.clear({.code = a.code, .instance = 4});
    EXPECT_EQ(node.sut.error(), off) << a.code;
  }
}

TEST(ErrorIndicator, ShowsTheMostSeriousOfSeveral) {
  LitNode node;
  node.boot();
  // From the least serious on: each takes precedence over those before.
  node.sut.set(Condition::invalid_configuration, true);
  EXPECT_EQ(node.sut.error(), blinking);
  node.bus(BusState::error_warning);
  EXPECT_EQ(node.sut.error(), single_flash);
  node.sut.set(Condition::error_control, true);
  EXPECT_EQ(node.sut.error(), double_flash);
  node.receive("080#");
  EXPECT_EQ(node.sut.error(), double_flash) << "SYNC is there";
  node.run_for(1s);
  EXPECT_EQ(node.sut.error(), triple_flash) << "SYNC is lost";
  node.node.raise({.code = 0x8250, .instance = 1});
  EXPECT_EQ(node.sut.error(), quadruple_flash);
  node.sut.set(Condition::lss, true);
  EXPECT_EQ(node.sut.error(), flickering);
  node.bus(BusState::bus_off);
  EXPECT_EQ(node.sut.error(), on);
}

TEST(ErrorIndicator, KnowsNoErrorsWithoutAnEmergencyProducer) {
  LitNode node;
  const Indicators sut(node.node);
  node.boot();
  node.node.raise({.code = 0x8130});
  EXPECT_EQ(sut.error(), off);
}

}  // namespace
}  // namespace canvoy::indicators_test
