// One epoll loop for a process: it serves any number of nodes, buses and files, and calls each when
// it is due.
//
//     std::unique_ptr<EventLoop> loop = *EventLoop::create();
//     Attachment charger(*loop, *bus);  ...  charger.serve(node);
//     loop->stop_on_signals();
//     loop->run();
#pragma once

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/can/time.hpp"

struct epoll_event;

namespace canvoy::host {

/// Which readiness of a file descriptor is waited for, or has come.
struct Readiness {
  bool readable = false;
  bool writable = false;
  bool failed = false;  ///< an error or the other end gone; always waited for

  friend bool operator==(const Readiness&, const Readiness&) = default;
};

/// Something that is driven by time: a node, the replay of a log. Both callbacks are called by the
/// loop only.
struct Task {
  Callback<Time()> deadline;  ///< when it next wants to be advanced; asked anew before every wait
  Callback<void(Time)> advance;  ///< does all that is due at the time given
};

/// What the loop has seen of itself.
struct LoopCounters {
  std::uint64_t wakeups = 0;  ///< returns from the wait
  std::uint64_t stuck =
      0;  ///< a task still due right after it was advanced: it is called again 1 ms later
};

/// Everything but stop() and wake() belongs to the thread that runs the loop, and may be called
/// from its callbacks; what is removed is not called any more, also in the same turn. A turn waits
/// for a descriptor, a deadline or wake(), serves the descriptors, advances the tasks that are due
/// and runs the timers. Deadlines are asked for when all who could change them were called, so that
/// none is missed whoever changed it, at the cost of a call or two a task and turn; a task that
/// stays due, however wrong it is, does not make the loop spin.
class EventLoop {
 public:
  using Id = std::uint64_t;  ///< of a watch, a task or a timer; never used twice
  using Ready = Callback<void(Readiness)>;
  using TimerAction = std::function<void(Time now)>;
  enum class End { stopped, reached };

  /// Fails only where the process is out of file descriptors or memory.
  static Result<std::unique_ptr<EventLoop>> create();
  ~EventLoop();
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  /// Microseconds of CLOCK_MONOTONIC since create().
  Time now() const;
  /// The latest time that any task was advanced to: a frame stamped earlier is to be taken as of
  /// this time.
  Time advanced_to() const { return advanced_to_; }
  /// The wall clock at Time{}, as microseconds since 1970. It is read once, so that epoch() + time
  /// is steady.
  Duration epoch() const { return epoch_; }
  /// A kernel time stamp of CLOCK_REALTIME as loop time; now() where the wall clock was set in the
  /// meantime.
  Time time_of(const timespec& wall_clock) const;

  /// Calls `ready` while the descriptor is ready for what is waited for (level-triggered). It stays
  /// the caller's.
  Result<Id> watch(int descriptor, Readiness wanted, Ready ready);
  void rewatch(Id id, Readiness wanted);
  void unwatch(Id id);

  Id add(const Task& task);
  void remove(Id id);

  /// Calls `action` once, at `time` or as soon after it as possible.
  Id at(Time time, TimerAction action);
  void cancel(Id id);

  /// From now on SIGINT, SIGTERM, and SIGHUP unless it is ignored or handled (nohup), stop the
  /// loop. After the first of them they have their old effect again, so that a second one ends a
  /// process that hangs; only a SIGHUP that follows another is ignored.
  Result<void> stop_on_signals();
  /// The signal that stopped the loop, or 0.
  int signal() const { return signal_; }

  /// Runs until stop(): one that came before is taken as well, and each ends one run. Not from a
  /// callback.
  void run() { run_until(never); }
  End run_until(Time time);
  /// Ends the run after the current turn. From any thread, also from a signal handler.
  void stop();
  /// Makes the loop ask for all deadlines again. From any thread.
  void wake();

  const LoopCounters& counters() const { return counters_; }

 private:
  struct Watch {
    Id id = 0;
    int descriptor = -1;
    Readiness wanted;
    Ready ready;
  };
  struct TaskEntry {
    Id id = 0;
    Task task;
    Time not_before{};

    Time next() const { return std::max(task.deadline(), not_before); }
  };

  EventLoop(Descriptor poll, Descriptor timer, Descriptor wakeup);

  std::optional<Time> advance_tasks();
  bool run_timers();
  Time first_timer() const;
  Time next_deadline() const;
  void wait(Time deadline);
  void arm(Time deadline);
  void dispatch(const epoll_event& event);
  void on_signal(Readiness);
  void forget_signals();
  Watch* find_watch(Id id);

  Descriptor poll_;
  Descriptor timer_;
  Descriptor wakeup_;
  Descriptor signals_;
  Id signal_watch_ = 0;
  sigset_t mask_before_{};
  int signal_ = 0;
  std::atomic<bool> stop_requested_{false};

  std::int64_t origin_ns_ = 0;
  Duration epoch_{};
  Time advanced_to_{};
  Time armed_ = never;

  Id last_id_ = 0;
  std::vector<Watch> watches_;
  std::vector<TaskEntry> tasks_;
  bool has_removed_ = false;  ///< a task
  std::map<std::pair<Time, Id>, TimerAction> timers_;
  LoopCounters counters_;
};

}  // namespace canvoy::host
