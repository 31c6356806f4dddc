// A recorded shift that is played again.
#include "canvoy/worlds/excavator/recorded_shift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::recorded_shift_test {
namespace {

/// All frames of both buses, with their times.
std::vector<std::string> frames_of(ExcavatorNetwork& network, Time until) {
  std::vector<std::string> frames;
  const BusTap tap{.context = &frames,
                   .on_frame = [](void* all, Time at, ControllerId, const Frame& frame) {
                     static_cast<std::vector<std::string>*>(all)->push_back(
                         std::to_string(at.time_since_epoch().count()) + " " + wire_text(frame));
                   }};
  network.world().bus(0).observe(tap);
  network.world().bus(1).observe(tap);
  network.run_until(until);
  return frames;
}

/// Sorts moves at one instant by their inputs: their order is not specified.
RecordedShift in_order(RecordedShift shift) {
  std::ranges::sort(shift, {}, [](const HandMove& move) { return std::pair(move.at, move.input); });
  return shift;
}

/// Recording of the default operator.
RecordedShift recording_of(Duration length) {
  ExcavatorOptions options{.length = length};
  options.records_shift = true;
  ExcavatorNetwork network(options);
  network.run_until(Time(length));
  return network.recorded_shift();
}

TEST(RecordedShift, GivesTheSameFramesWhenItIsPlayedAgain) {
  ExcavatorOptions options{.length = 7min};
  options.shift.work = 3min;
  options.shift.rest = 1min;
  options.records_shift = true;
  ExcavatorNetwork first(options);
  const std::vector<std::string> frames = frames_of(first, Time(7min));
  const ExcavatorStatistics done = first.snapshot().statistics;
  ASSERT_GT(done.earth.heaped, 5);

  ExcavatorOptions again{.length = 7min};
  again.faults.seed = options.faults.seed;
  again.shift.recorded = first.recorded_shift();
  ExcavatorNetwork second(again);
  const std::vector<std::string> replayed = frames_of(second, Time(7min));
  const auto [one, other] = std::ranges::mismatch(frames, replayed);
  EXPECT_TRUE(one == frames.end() && other == replayed.end())
      << (one == frames.end() ? "its end" : *one) << " became "
      << (other == replayed.end() ? "its end" : *other);
  EXPECT_EQ(broken(second), Names());
  const ExcavatorStatistics redone = second.snapshot().statistics;
  EXPECT_EQ(redone.cycles, done.cycles);
  EXPECT_EQ(redone.presses, done.presses);
  EXPECT_EQ(redone.earth.heaped, done.earth.heaped);
}

TEST(RecordedShift, IsPlayedAsItWasWhateverHappens) {
  ExcavatorOptions options{.length = 10min};
  options.records_shift = true;
  ExcavatorNetwork first(options);
  first.run_until(Time(10min));
  ExcavatorOptions again = with_faults({{.start = Time(3min), .duration = 20s}});
  again.shift.recorded = first.recorded_shift();
  again.records_shift = true;
  ExcavatorNetwork second(again);
  second.run_until(Time(10min));
  EXPECT_TRUE(in_order(second.recorded_shift()) == in_order(first.recorded_shift()));
  EXPECT_LT(second.machine().earth().heaped, first.machine().earth().heaped)
      << "nobody unlocks the hydraulics again";
  EXPECT_EQ(broken(second), Names()) << "and the lamp says so";
  EXPECT_FALSE(second.machine().has_pilot_pressure());
  EXPECT_TRUE(is_lit(second.panel().lit(), Lamp::locked));
}

/// In a recording, lamps are not looked at, except by the referee.
TEST(RecordedShift, ALampThatDoesNotSayWhyNobodyDigsIsSeen) {
  ExcavatorOptions again = with_faults({{.start = Time(3min), .duration = 20s}});
  again.shift.recorded = recording_of(Duration(10min));
  ExcavatorNetwork network(again);
  network.panel().burn_out(Lamp::locked);
  network.run_until(Time(10min));
  EXPECT_EQ(broken(network), Names({"indicators", "service"}));
}

TEST(RecordedShift, ALampThatIsBurntIsSeenAsWell) {
  ExcavatorOptions again{.length = 10min};
  again.shift.recorded = recording_of(Duration(10min));
  again.sabotage.burnt_lamp = true;  // of the work light
  ExcavatorNetwork network(again);
  network.run_until(Time(10min));
  EXPECT_EQ(broken(network), Names({"indicators"}));
}

/// Only a fault excuses it: in a shift without one, a locked machine is a failure.
TEST(RecordedShift, WithoutAFaultALockedMachineIsNoService) {
  ExcavatorOptions again{.length = 10min};
  again.shift.recorded = recording_of(Duration(10min));
  std::erase_if(again.shift.recorded,
                [](const HandMove& move) { return move.input == HandInput::lock; });
  ExcavatorNetwork network(again);
  network.run_until(Time(10min));
  EXPECT_EQ(broken(network), Names({"service"}));
}

TEST(RecordedShift, HasEachInput) {
  SeatPanel panel;
  ShiftRecorder recorder;
  recorder.look(Time(1s), panel);
  EXPECT_TRUE(recorder.shift().empty()) << "all is at rest at the start";
  RecordedShift moves;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(HandInput::lever); ++i) {
    const auto input = static_cast<HandInput>(i);
    const bool is_clicks = input == HandInput::knob;
    moves.push_back({Time(Duration(2s) + i * Duration(1s)), input,
                     is_clicks                   ? -3.0
                     : input == HandInput::lever ? 1.0
                                                 : 0.25 + 0.01 * static_cast<double>(i)});
    move_hand(panel, moves.back());
    recorder.look(moves.back().at, panel);
  }
  recorder.pressed(Time(30s), Button::travel, Duration(5ms));
  moves.push_back({Time(30s), HandInput::travel, 0.005});
  recorder.began(Time(31s), static_cast<std::uint8_t>(Activity::digs));
  moves.push_back({Time(31s), HandInput::activity, 3});
  EXPECT_EQ(recorder.shift(), moves);
}

}  // namespace
}  // namespace canvoy::excavator::recorded_shift_test
