#include "canvoy/canopen/service/timer_queue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <deque>
#include <map>
#include <vector>

namespace canvoy::timer_queue_test {
namespace {

/// Timers with numbers, and the order in which they expired.
struct Bells {
  struct Bell {
    Bell(Bells& bells, int bell) : owner(bells), number(bell) {}
    void ring(Time now) {
      owner.rung.push_back(number);
      owner.rung_at.push_back(now);
      if (on_ring) on_ring(now);
    }
    Bells& owner;
    int number;
    std::function<void(Time)> on_ring;
    Timer timer{callback<&Bell::ring>(*this)};
  };

  explicit Bells(int count) {
    for (int i = 0; i < count; ++i) bells.emplace_back(*this, i);
  }
  Timer& operator[](std::size_t number) { return bells[number].timer; }
  std::vector<int> take() { return std::exchange(rung, {}); }

  std::deque<Bell> bells;
  std::vector<int> rung;
  std::vector<Time> rung_at;
  TimerQueue queue;
};

using Order = std::vector<int>;

TEST(TimerQueue, WaitsForNothingWhileItIsEmpty) {
  TimerQueue sut;
  EXPECT_EQ(sut.deadline(), never);
  sut.run(Time::max());
}

TEST(TimerQueue, CallsATimerAtItsTimeAndNotBefore) {
  Bells sut(1);
  sut.queue.arm(sut[0], Time(10us));
  EXPECT_TRUE(sut[0].armed());
  EXPECT_EQ(sut[0].at(), Time(10us));
  EXPECT_EQ(sut.queue.deadline(), Time(10us));
  sut.queue.run(Time(9us));
  EXPECT_EQ(sut.take(), Order{});
  sut.queue.run(Time(10us));
  EXPECT_EQ(sut.take(), Order{0});
  EXPECT_FALSE(sut[0].armed());
  EXPECT_EQ(sut[0].at(), never);
  EXPECT_EQ(sut.queue.deadline(), never);
  sut.queue.run(Time(99us));
  EXPECT_EQ(sut.take(), Order{});
}

TEST(TimerQueue, TellsTheTimeOfTheCallAndNotOfTheDeadline) {
  Bells sut(1);
  sut.queue.arm(sut[0], Time(10us));
  sut.queue.run(Time(25us));
  EXPECT_EQ(sut.rung_at, std::vector<Time>{Time(25us)});
}

TEST(TimerQueue, CallsInTheOrderOfTheDeadlines) {
  Bells sut(5);
  const int times[] = {30, 10, 50, 20, 40};
  for (std::size_t i = 0; i < 5; ++i) sut.queue.arm(sut[i], Time(times[i] * 1us));
  sut.queue.run(Time(50us));
  EXPECT_EQ(sut.take(), (Order{1, 3, 0, 4, 2}));
}

TEST(TimerQueue, CallsInTheOrderOfArmingWhatIsDueAtOneTime) {
  Bells sut(6);
  for (const std::size_t i : {3U, 1U, 4U, 0U, 5U, 2U}) sut.queue.arm(sut[i], Time(10us));
  sut.queue.arm(sut[1], Time(10us));  // again, and so after the others
  sut.queue.run(Time(10us));
  EXPECT_EQ(sut.take(), (Order{3, 4, 0, 5, 2, 1}));
}

TEST(TimerQueue, MovesATimerThatIsArmedAgain) {
  Bells sut(2);
  sut.queue.arm(sut[0], Time(10us));
  sut.queue.arm(sut[1], Time(20us));
  sut.queue.arm(sut[0], Time(30us));
  EXPECT_EQ(sut.queue.deadline(), Time(20us));
  sut.queue.run(Time(40us));
  EXPECT_EQ(sut.take(), (Order{1, 0}));
}

TEST(TimerQueue, TakesNeverAsDisarming) {
  Bells sut(1);
  sut.queue.arm(sut[0], never);
  EXPECT_FALSE(sut[0].armed());
  sut.queue.arm(sut[0], Time(10us));
  sut.queue.arm(sut[0], never);
  EXPECT_FALSE(sut[0].armed());
  EXPECT_EQ(sut.queue.deadline(), never);
}

TEST(TimerQueue, DisarmsAtTheTopInTheMiddleAndWhatIsNotArmed) {
  Bells sut(4);
  for (std::size_t i = 0; i < 4; ++i) sut.queue.arm(sut[i], Time(static_cast<int>(i) * 1us));
  sut.queue.disarm(sut[0]);
  sut.queue.disarm(sut[2]);
  sut.queue.disarm(sut[2]);
  sut.queue.run(Time(9us));
  EXPECT_EQ(sut.take(), (Order{1, 3}));
}

TEST(TimerQueue, ServesTimesBeforeTheStartAndAtTheEndOfAllDays) {
  Bells sut(2);
  sut.queue.arm(sut[0], Time::min());
  sut.queue.arm(sut[1], never - 1us);
  sut.queue.run(Time{});
  EXPECT_EQ(sut.take(), Order{0});
  sut.queue.run(never);
  EXPECT_EQ(sut.take(), Order{1});
}

TEST(TimerQueue, LetsACallbackArmItsOwnTimerAgain) {
  Bells sut(1);
  sut.bells[0].on_ring = [&](Time now) { sut.queue.arm(sut[0], now + 10us); };
  sut.queue.arm(sut[0], Time(10us));
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(sut.queue.deadline(), Time(i * 10us));
    sut.queue.run(sut.queue.deadline());
  }
  EXPECT_EQ(sut.take(), (Order{0, 0, 0}));
}

TEST(TimerQueue, DoesNotRunWithoutEndWhenACallbackArmsForThePresent) {
  Bells sut(1);
  sut.bells[0].on_ring = [&](Time now) { sut.queue.arm(sut[0], now); };
  sut.queue.arm(sut[0], Time(10us));
  sut.queue.run(Time(10us));
  EXPECT_EQ(sut.take(), Order{0});
  EXPECT_EQ(sut.queue.deadline(), Time(10us)) << "another run is needed";
  sut.queue.run(Time(10us));
  EXPECT_EQ(sut.take(), Order{0});
}

TEST(TimerQueue, CallsAllInTheEndWhenOneIsArmedInFrontOfTheOthers) {
  Bells sut(2);
  int again = 1;
  sut.bells[0].on_ring = [&](Time) {
    if (again-- > 0) sut.queue.arm(sut[0], Time(15us));
  };
  sut.queue.arm(sut[0], Time(10us));
  sut.queue.arm(sut[1], Time(20us));
  while (sut.queue.deadline() <= Time(30us)) sut.queue.run(Time(30us));
  EXPECT_EQ(sut.take(), (Order{0, 0, 1}));
}

TEST(TimerQueue, CallsATimerHoweverManyRunsItHasWaited) {
  for (int runs = 0; runs < 600; ++runs) {
    Bells sut(1);
    sut.queue.run(Time(0us));
    sut.queue.arm(sut[0], Time(10us));
    for (int i = 0; i < runs; ++i) sut.queue.run(Time(9us));
    EXPECT_EQ(sut.take(), Order{});
    for (int i = 0; i < 2 && sut.queue.deadline() <= Time(10us); ++i) sut.queue.run(Time(10us));
    EXPECT_EQ(sut.take(), Order{0}) << runs;
  }
}

TEST(TimerQueue, LetsACallbackDisarmAnotherThatIsDue) {
  Bells sut(2);
  sut.bells[0].on_ring = [&](Time) { sut.queue.disarm(sut[1]); };
  sut.queue.arm(sut[0], Time(10us));
  sut.queue.arm(sut[1], Time(10us));
  sut.queue.run(Time(10us));
  EXPECT_EQ(sut.take(), Order{0});
}

TEST(TimerQueue, CallsNothingForATimerWithoutACallback) {
  TimerQueue sut;
  Timer timer;
  sut.arm(timer, Time(1us));
  sut.run(Time(1us));
  EXPECT_FALSE(timer.armed());
}

/// The queue as a sorted list, with the same rules.
struct Model {
  using Key = std::pair<Time, int>;  // the time, and the number of timers armed before
  void arm(int timer, Time at) {
    disarm(timer);
    if (at != never) sorted.emplace(Key{at, order++}, timer);
  }
  void disarm(int timer) {
    std::erase_if(sorted, [&](const auto& item) { return item.second == timer; });
  }
  template <class Rung>
  void run(Time now, Rung rung) {
    const int armed_during_run = order;
    while (!sorted.empty() && sorted.begin()->first.first <= now &&
           sorted.begin()->first.second < armed_during_run) {
      const int timer = sorted.begin()->second;
      sorted.erase(sorted.begin());
      rung(timer);
    }
  }
  Time deadline() const { return sorted.empty() ? never : sorted.begin()->first.first; }

  std::multimap<Key, int> sorted;
  int order = 0;
};

/// Reaction of a timer when it expires: arms or disarms another, by arithmetic on its number, in
/// the queue and in the model alike.
struct Reaction {
  int other;
  bool arms;
  Duration delay;
};
Reaction reaction_of(int timer, int count) {
  return {(timer * 7 + 3) % count, timer % 3 != 0, Duration(timer % 5 - 1)};
}

TEST(TimerQueue, BehavesLikeASortedListInAnySequenceOfCalls) {
  struct Step {
    int what;
    int timer;
    int time;
  };
  const bool held = rc::check("like a multimap", [] {
    constexpr int count = 12;
    const auto steps = *rc::gen::container<std::vector<Step>>(rc::gen::construct<Step>(
        rc::gen::inRange(0, 8), rc::gen::inRange(0, count), rc::gen::inRange(0, 30)));
    Bells sut(count);
    Model model;
    Order expected;
    Time now{};
    for (auto& bell : sut.bells) {
      bell.on_ring = [&sut, number = bell.number](Time at) {
        const Reaction reaction = reaction_of(number, count);
        Timer& other = sut[static_cast<std::size_t>(reaction.other)];
        if (reaction.arms) {
          sut.queue.arm(other, at + reaction.delay);
        } else {
          sut.queue.disarm(other);
        }
      };
    }
    for (const Step& step : steps) {
      Timer& timer = sut[static_cast<std::size_t>(step.timer)];
      if (step.what < 5) {
        sut.queue.arm(timer, now + Duration(step.time));
        model.arm(step.timer, now + Duration(step.time));
      } else if (step.what == 5) {
        sut.queue.disarm(timer);
        model.disarm(step.timer);
      } else {
        now += Duration(step.time);
        sut.queue.run(now);
        model.run(now, [&](int rung) {
          expected.push_back(rung);
          const Reaction reaction = reaction_of(rung, count);
          if (reaction.arms) {
            model.arm(reaction.other, now + reaction.delay);
          } else {
            model.disarm(reaction.other);
          }
        });
      }
      RC_ASSERT(sut.rung == expected);
      RC_ASSERT(sut.queue.deadline() == model.deadline());
    }
  });
  EXPECT_TRUE(held);
}

TEST(TimerQueue, SortsTenThousandTimers) {
  constexpr int count = 10'000;
  Bells sut(count);
  for (std::size_t i = 0; i < count; ++i) {
    sut.queue.arm(sut[i], Time(Duration(i * 7919 % 10'007)));
  }
  sut.queue.run(Time(1s));
  ASSERT_EQ(sut.rung.size(), std::size_t{count});
  const auto time_of = [](int number) { return std::size_t(number) * 7919 % 10'007; };
  EXPECT_TRUE(std::ranges::is_sorted(sut.rung, {}, time_of));
}

}  // namespace
}  // namespace canvoy::timer_queue_test
