#include "canvoy/can/host/event_loop.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace canvoy::host::event_loop_test {
namespace {

constexpr Duration soon = 2ms;

struct SocketPair {
  SocketPair() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()), 0);
    near = Descriptor{ends[0]};
    far = Descriptor{ends[1]};
  }
  void say() const { EXPECT_EQ(::write(far.get(), "x", 1), 1); }
  void hear() const {
    char byte = 0;
    EXPECT_EQ(::read(near.get(), &byte, 1), 1);
  }

  Descriptor near;
  Descriptor far;
};

// A node of which only the deadlines matter.
struct Worker {
  Time due = never;
  Duration period{};  // 0: once
  std::vector<Time> calls;
  std::function<void()> work;

  Time deadline() { return due; }
  void advance(Time now) {
    calls.push_back(now);
    due = period > Duration{} ? due + period : never;
    if (work) work();
  }
  Task task() { return {callback<&Worker::deadline>(*this), callback<&Worker::advance>(*this)}; }
};

class EventLoopTest : public testing::Test {
 protected:
  EventLoop::Id watch(const Descriptor& descriptor, Readiness wanted,
                      std::function<void(Readiness)>& action) {
    Result<EventLoop::Id> id = loop_->watch(descriptor.get(), wanted, EventLoop::Ready::of(action));
    EXPECT_TRUE(id);
    return *id;
  }

  std::unique_ptr<EventLoop> loop_ = *EventLoop::create();
};

TEST_F(EventLoopTest, TimeBeginsAtZeroAndDoesNotGoBack) {
  const Time first = loop_->now();
  EXPECT_GE(first, Time{});
  EXPECT_LT(first, Time{60s});
  EXPECT_GE(loop_->now(), first);
}

TEST_F(EventLoopTest, TheEpochIsTheWallClockAtTimeZero) {
  timespec wall{};
  clock_gettime(CLOCK_REALTIME, &wall);
  const Duration since_1970 = std::chrono::seconds{wall.tv_sec} + Duration{wall.tv_nsec / 1000};
  const Duration difference = loop_->epoch() + loop_->now().time_since_epoch() - since_1970;
  EXPECT_LT(std::chrono::abs(difference), 10s) << "between two looks, a busy machine stands still";
}

TEST_F(EventLoopTest, AKernelStampKeepsItsMicrosecondsWhenItBecomesLoopTimeAndBack) {
  const Duration moment = loop_->epoch() + loop_->now().time_since_epoch() - 1234us;
  const timespec stamp{.tv_sec = moment.count() / 1'000'000,
                       .tv_nsec = moment.count() % 1'000'000 * 1000 + 999};
  EXPECT_EQ(loop_->epoch() + loop_->time_of(stamp).time_since_epoch(), moment);
}

TEST_F(EventLoopTest, AStampOfAWallClockThatWasSetIsTakenAsNow) {
  const timespec long_ago{.tv_sec = 1, .tv_nsec = 0};
  const Time before = loop_->now();
  const Time told = loop_->time_of(long_ago);
  EXPECT_GE(told, before);
  EXPECT_LE(told, loop_->now());
}

TEST_F(EventLoopTest, ATimerRunsOnceAndNotBeforeItsTime) {
  int runs = 0;
  const Time due = loop_->now() + soon;
  loop_->at(due, [&](Time now) {
    ++runs;
    EXPECT_GE(now, due);
  });
  EXPECT_EQ(loop_->run_until(due + 3ms), EventLoop::End::reached);
  EXPECT_EQ(runs, 1);
}

TEST_F(EventLoopTest, TimersRunInTheOrderOfTheirTimesAndThoseOfOneTimeAsTheyWereSet) {
  std::string order;
  const Time due = loop_->now() + soon;
  loop_->at(due + 1us, [&](Time) { order += 'c'; });
  loop_->at(due, [&](Time) { order += 'a'; });
  loop_->at(due, [&](Time) { order += 'b'; });
  loop_->run_until(due + 1us);
  EXPECT_EQ(order, "abc");
}

TEST_F(EventLoopTest, ACancelledTimerDoesNotRun) {
  int runs = 0;
  EventLoop::Id second = 0;
  loop_->at(loop_->now(), [&](Time) { loop_->cancel(second); });
  second = loop_->at(loop_->now(), [&](Time) { ++runs; });
  loop_->run_until(loop_->now() + soon);
  EXPECT_EQ(runs, 0);
}

TEST_F(EventLoopTest, ATimerThatSetsItselfAgainDoesNotStarveTheDescriptors) {
  const SocketPair pair;
  bool heard = false;
  std::function<void(Time)> again = [&](Time now) { loop_->at(now, again); };
  std::function<void(Readiness)> on_ready = [&](Readiness) {
    pair.hear();
    heard = true;
    loop_->stop();
  };
  watch(pair.near, {.readable = true}, on_ready);
  loop_->at(loop_->now(), again);
  pair.say();
  loop_->run_until(loop_->now() + 5s);
  EXPECT_TRUE(heard);
}

TEST_F(EventLoopTest, ATaskIsAdvancedAtEachOfItsDeadlinesAndNeverEarly) {
  Worker worker;
  const Time start = loop_->now();
  worker.due = start + 1ms;
  worker.period = 1ms;
  worker.work = [&] {
    EXPECT_EQ(loop_->advanced_to(), worker.calls.back());
    if (worker.calls.size() == 5) loop_->stop();
  };
  loop_->add(worker.task());
  EXPECT_EQ(loop_->run_until(start + 5s), EventLoop::End::stopped);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_GE(worker.calls[i], start + (i + 1) * 1ms);
}

TEST_F(EventLoopTest, ADeadlineThatADescriptorsCallbackBringsForwardIsNotMissed) {
  const SocketPair pair;
  Worker worker;
  worker.work = [&] { loop_->stop(); };
  loop_->add(worker.task());
  std::function<void(Readiness)> on_ready = [&](Readiness) {
    pair.hear();
    worker.due = loop_->now() + soon;
  };
  watch(pair.near, {.readable = true}, on_ready);
  pair.say();
  EXPECT_EQ(loop_->run_until(loop_->now() + 5s), EventLoop::End::stopped);
  EXPECT_EQ(worker.calls.size(), 1U);
}

TEST_F(EventLoopTest, ADeadlineOfATaskThatAnotherOneChangesIsNotMissed) {
  Worker late;
  Worker early;
  late.work = [&] { loop_->stop(); };
  early.work = [&] { late.due = loop_->now() + soon; };
  early.due = loop_->now();
  loop_->add(late.task());
  loop_->add(early.task());
  EXPECT_EQ(loop_->run_until(loop_->now() + 5s), EventLoop::End::stopped);
}

TEST_F(EventLoopTest, ADeadlineThatStandsInMemoryIsReadThere) {
  EventLoop::Id id = 0;
  Worker worker;
  Worker other;
  worker.period = 1ms;
  worker.work = [&] { loop_->remove(worker.calls.size() == 3 ? id : 0); };
  other.work = [&] { loop_->stop(); };
  const auto task = [](Worker& its) {
    return Task{.deadline = {}, .advance = its.task().advance, .due = &its.due};
  };
  const Time start = loop_->now();
  worker.due = start + 1ms;
  other.due = start + 20ms;
  id = loop_->add(task(worker));
  loop_->add(task(other));
  EXPECT_EQ(loop_->run_until(start + 5s), EventLoop::End::stopped);
  ASSERT_EQ(worker.calls.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(worker.calls[i], start + (i + 1) * 1ms);
  EXPECT_EQ(other.calls.size(), 1U);
  EXPECT_LE(loop_->counters().wakeups, 10U);
}

TEST_F(EventLoopTest, OfManyDeadlinesInMemoryEachIsKeptWhereverItStands) {
  std::array<Worker, 37> workers;
  const Time start = loop_->now();
  // Of each eight neighbours another one, and the last; one among them is asked.
  constexpr std::array<std::size_t, 6> busy = {0, 9, 18, 27, 28, 36};
  for (std::size_t i = 0; i < busy.size(); ++i) {
    workers.at(busy.at(i)).due = start + (6 - i) * 1ms;
  }
  workers[0].work = [&] { loop_->stop(); };
  for (std::size_t i = 0; i < workers.size(); ++i) {
    Task task = workers.at(i).task();
    if (i != 18) task.due = &workers.at(i).due;
    loop_->add(task);
  }
  EXPECT_EQ(loop_->run_until(start + 5s), EventLoop::End::stopped);
  for (std::size_t i = 0; i < busy.size(); ++i) {
    const Worker& worker = workers.at(busy.at(i));
    ASSERT_EQ(worker.calls.size(), 1U) << busy.at(i);
    EXPECT_GE(worker.calls[0], start + (6 - i) * 1ms) << busy.at(i);
  }
  EXPECT_TRUE(workers[1].calls.empty());
}

TEST_F(EventLoopTest, WithNothingToDoTheLoopSleeps) {
  loop_->run_until(loop_->now() + 20ms);
  EXPECT_LE(loop_->counters().wakeups, 3U);
}

TEST_F(EventLoopTest, ATaskThatStaysDueIsCalledEachMillisecondAndCounted) {
  Worker worker;
  worker.due = Time{};
  worker.work = [&] {
    worker.due = Time{};
    if (worker.calls.size() == 10) loop_->stop();
  };
  loop_->add(worker.task());
  EXPECT_EQ(loop_->run_until(loop_->now() + 5s), EventLoop::End::stopped);
  for (std::size_t i = 1; i < 10; ++i) EXPECT_GE(worker.calls[i], worker.calls[i - 1] + 1ms);
  EXPECT_EQ(loop_->counters().stuck, 10U);
  EXPECT_LE(loop_->counters().wakeups, 25U);
}

TEST_F(EventLoopTest, ATaskMayRemoveItselfAndOthersThatAreDueInTheSameTurn) {
  Worker first;
  Worker second;
  EventLoop::Id first_id = 0;
  EventLoop::Id second_id = 0;
  first.due = second.due = loop_->now();
  first.work = [&] {
    loop_->remove(first_id);
    loop_->remove(second_id);
  };
  first_id = loop_->add(first.task());
  second_id = loop_->add(second.task());
  loop_->run_until(loop_->now() + soon);
  EXPECT_EQ(first.calls.size(), 1U);
  EXPECT_EQ(second.calls.size(), 0U);
}

TEST_F(EventLoopTest, ATaskMayAddManyOthers) {
  std::array<Worker, 300> others;
  Worker first;
  first.due = loop_->now();
  first.work = [&] {
    for (Worker& other : others) {
      other.due = loop_->now();
      loop_->add(other.task());
    }
  };
  others.back().work = [&] { loop_->stop(); };
  loop_->add(first.task());
  EXPECT_EQ(loop_->run_until(loop_->now() + 5s), EventLoop::End::stopped);
  for (const Worker& other : others) EXPECT_EQ(other.calls.size(), 1U);
}

TEST_F(EventLoopTest, ADescriptorIsServedAsLongAsItIsReady) {
  const SocketPair pair;
  int calls = 0;
  std::function<void(Readiness)> on_ready = [&](Readiness ready) {
    EXPECT_EQ(ready, Readiness{.readable = true});
    pair.hear();
    if (++calls == 2) loop_->stop();
  };
  watch(pair.near, {.readable = true}, on_ready);
  pair.say();
  pair.say();
  EXPECT_EQ(loop_->run_until(loop_->now() + 5s), EventLoop::End::stopped);
  EXPECT_EQ(calls, 2);
}

TEST_F(EventLoopTest, ReadinessToWriteIsToldOnlyWhereItIsWanted) {
  const SocketPair pair;
  int calls = 0;
  std::function<void(Readiness)> on_ready = [&](Readiness ready) {
    EXPECT_TRUE(ready.writable);
    ++calls;
    loop_->stop();
  };
  const EventLoop::Id id = watch(pair.near, {}, on_ready);
  loop_->run_until(loop_->now() + soon);
  EXPECT_EQ(calls, 0);
  loop_->rewatch(id, {.writable = true});
  loop_->run_until(loop_->now() + 5s);
  EXPECT_EQ(calls, 1);
}

TEST_F(EventLoopTest, TheEndOfTheOtherSideIsTold) {
  SocketPair pair;
  bool failed = false;
  std::function<void(Readiness)> on_ready = [&](Readiness ready) {
    failed = ready.failed;
    loop_->stop();
  };
  watch(pair.near, {}, on_ready);
  pair.far = Descriptor{};
  loop_->run_until(loop_->now() + 5s);
  EXPECT_TRUE(failed);
}

TEST_F(EventLoopTest, AWatchThatIsTakenAwayInTheSameTurnIsNotCalled) {
  const SocketPair one;
  const SocketPair two;
  int calls = 0;
  EventLoop::Id first = 0;
  EventLoop::Id second = 0;
  std::function<void(Readiness)> on_ready = [&](Readiness) {
    ++calls;
    loop_->unwatch(first);
    loop_->unwatch(second);
  };
  first = watch(one.near, {.readable = true}, on_ready);
  second = watch(two.near, {.readable = true}, on_ready);
  one.say();
  two.say();
  loop_->run_until(loop_->now() + soon);
  EXPECT_EQ(calls, 1);
}

TEST_F(EventLoopTest, WhatCannotBeWatchedIsRefusedInOneLine) {
  std::function<void(Readiness)> on_ready;
  const Result<EventLoop::Id> id =
      loop_->watch(-1, {.readable = true}, EventLoop::Ready::of(on_ready));
  ASSERT_FALSE(id);
  EXPECT_EQ(id.error().line(), "file descriptor -1: Bad file descriptor");
}

TEST_F(EventLoopTest, AStopBeforeTheRunEndsItAndOnlyThatOne) {
  loop_->stop();
  EXPECT_EQ(loop_->run_until(never), EventLoop::End::stopped);
  EXPECT_EQ(loop_->run_until(loop_->now()), EventLoop::End::reached);
}

TEST_F(EventLoopTest, AnotherThreadStopsTheLoop) {
  std::thread other([&] { loop_->stop(); });
  loop_->run();
  other.join();
}

TEST_F(EventLoopTest, AnotherThreadWakesTheLoopToAskForDeadlinesAgain) {
  std::atomic<Time::rep> due = never.time_since_epoch().count();
  bool advanced = false;
  auto deadline = [&] { return Time{Duration{due.load()}}; };
  auto advance = [&](Time) {
    advanced = true;
    due = never.time_since_epoch().count();
    loop_->stop();
  };
  loop_->add({Callback<Time()>::of(deadline), Callback<void(Time)>::of(advance)});
  std::thread other([&] {
    due = 0;
    loop_->wake();
  });
  loop_->run_until(loop_->now() + 5s);
  other.join();
  EXPECT_TRUE(advanced);
}

TEST_F(EventLoopTest, ASignalStopsTheLoopAndIsKnownAfterwards) {
  ASSERT_TRUE(loop_->stop_on_signals());
  EXPECT_EQ(loop_->signal(), 0);
  loop_->at(loop_->now(), [](Time) { ::kill(::getpid(), SIGTERM); });
  EXPECT_EQ(loop_->run_until(loop_->now() + 5s), EventLoop::End::stopped);
  EXPECT_EQ(loop_->signal(), SIGTERM);
}

// The effect of a signal belongs to the process: each of these tests has a separate one.
TEST_F(EventLoopTest, AHangUpStopsTheLoopAndThoseThatFollowDoNothing) {
  const auto hang_up = [this] {
    std::signal(SIGHUP, SIG_DFL);  // the tests may run under nohup
    if (!loop_->stop_on_signals()) std::exit(2);
    loop_->at(loop_->now(), [](Time) { ::kill(::getpid(), SIGHUP); });
    loop_->run_until(loop_->now() + 5s);
    // The terminal sends it, and then the shell.
    ::kill(::getpid(), SIGHUP);
    std::exit(loop_->signal() == SIGHUP ? 0 : 1);
  };
  EXPECT_EXIT(hang_up(), testing::ExitedWithCode(0), "");
}

TEST_F(EventLoopTest, AHangUpThatIsIgnoredStaysSo) {
  const auto hang_up = [this] {
    std::signal(SIGHUP, SIG_IGN);  // like nohup
    if (!loop_->stop_on_signals()) std::exit(2);
    loop_->at(loop_->now(), [](Time) { ::kill(::getpid(), SIGHUP); });
    loop_->run_until(loop_->now() + soon);
    std::exit(loop_->signal() == 0 ? 0 : 1);
  };
  EXPECT_EXIT(hang_up(), testing::ExitedWithCode(0), "");
}

TEST_F(EventLoopTest, AfterTheFirstSignalASecondOneHasItsOldEffect) {
  std::signal(SIGINT, SIG_DFL);  // the tests may run in the background of a shell, which ignores it
  ASSERT_TRUE(loop_->stop_on_signals());
  loop_->at(loop_->now(), [](Time) { ::kill(::getpid(), SIGINT); });
  loop_->run_until(loop_->now() + 5s);
  sigset_t mask;
  pthread_sigmask(SIG_BLOCK, nullptr, &mask);
  EXPECT_EQ(sigismember(&mask, SIGINT), 0);
  EXPECT_EQ(sigismember(&mask, SIGTERM), 0);
  EXPECT_EXIT(::kill(::getpid(), SIGINT), testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace canvoy::host::event_loop_test
