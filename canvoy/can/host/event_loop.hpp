// One epoll loop for a process: serves any number of nodes, buses and files, and calls each when it
// is due.
//
//     std::unique_ptr<EventLoop> loop = *EventLoop::create();
//     Attachment charger(*loop, *bus);
//     charger.attach(node);
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

/// Readiness of a file descriptor, to wait for or reported.
struct Readiness {
  bool readable = false;  ///< a read does not block
  bool writable = false;  ///< a write does not block
  bool failed = false;    ///< an error, or the other end closed; always waited for

  friend bool operator==(const Readiness&, const Readiness&) = default;
};

/// Something driven by time: a node, the replay of a log. Only the loop calls both callbacks.
struct Task {
  Callback<Time()> deadline;     ///< time of the next call of advance; read again before every wait
  Callback<void(Time)> advance;  ///< does everything that is due at the time passed
  /// In place of `deadline`: where that time stands. It costs a load for each turn instead of a
  /// call. It must outlive the task.
  const Time* due = nullptr;
};

/// Counters of the loop.
struct LoopCounters {
  std::uint64_t wakeups = 0;  ///< returns from the wait
  /// Tasks still due right after they were advanced: called again 1 ms later.
  std::uint64_t stuck = 0;
};

/// The loop. Everything except stop() and wake() belongs to the thread that runs the loop, and may
/// be called from its callbacks; a removed object is not called any more, also in the same turn. A
/// turn waits for a descriptor, a deadline or wake(), serves the descriptors, advances the tasks
/// that are due and runs the timers. Deadlines are read after all callbacks that could change them,
/// so that none is missed, at the cost of a call or two for each task and turn, or of a load (see
/// Task::due); a task that stays due by mistake does not make the loop spin.
class EventLoop {
 public:
  using Id = std::uint64_t;  ///< of a watch, a task or a timer; never reused
  /// Called with what the descriptor is ready for.
  using Ready = Callback<void(Readiness)>;
  /// Called with the time of the turn, not before its own.
  using TimerAction = std::function<void(Time now)>;
  /// Why run_until() returned: by stop(), or at its time.
  enum class End { stopped, reached };

  /// Makes a loop. Fails only if the process is out of file descriptors or memory.
  static Result<std::unique_ptr<EventLoop>> create();
  ~EventLoop();
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  /// Time since create(), in microseconds of CLOCK_MONOTONIC.
  Time now() const;
  /// Latest time that any task was advanced to: a frame with an earlier stamp must be taken as of
  /// this time.
  Time advanced_to() const { return advanced_to_; }
  /// Wall clock at Time{}, in microseconds since 1970. It is read once, so that epoch() + time is
  /// steady.
  Duration epoch() const { return epoch_; }
  /// Converts a kernel time stamp of CLOCK_REALTIME to loop time; now() if the wall clock was set
  /// in the meantime.
  Time time_of(const timespec& wall_clock) const;

  /// Calls `ready` while the descriptor is ready as requested (level-triggered). The caller keeps
  /// the descriptor.
  Result<Id> watch(int descriptor, Readiness wanted, Ready ready);
  /// Changes what a watch waits for. Ids that are gone are ignored.
  void rewatch(Id id, Readiness wanted);
  /// Ends a watch; its descriptor stays open. Ids that are gone are ignored.
  void unwatch(Id id);

  /// Adds a task, which is asked for its deadline before each wait.
  Id add(const Task& task);
  /// Removes a task; Ids that are gone are ignored.
  void remove(Id id);

  /// Calls `action` once, at `time` or as soon after it as possible.
  Id at(Time time, TimerAction action);
  /// Cancels a timer; one that has run is ignored.
  void cancel(Id id);

  /// Stops the loop on SIGINT, SIGTERM, and SIGHUP unless it is ignored or handled (nohup). After
  /// the first of them they have their previous effect again, so that a second one ends a process
  /// that hangs; only a SIGHUP that follows another is ignored.
  Result<void> stop_on_signals();
  /// Signal that stopped the loop, or 0.
  int signal() const { return signal_; }

  /// Runs until stop(): an earlier call counts as well, and each ends one run. Must not be called
  /// from a callback.
  void run() { run_until(never); }
  /// Like run(), but until `time` at the latest.
  End run_until(Time time);
  /// Ends the run after the current turn. May be called from any thread, also from a signal
  /// handler.
  void stop();
  /// Makes the loop read all deadlines again. May be called from any thread.
  void wake();

  /// Counters since the loop was made.
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

    Time next() const { return std::max(deadline(), not_before); }
    /// What the task says, at Task::due or when it is asked.
    Time deadline() const { return task.due != nullptr ? *task.due : task.deadline(); }
  };

  EventLoop(Descriptor poll, Descriptor timer, Descriptor wakeup);

  std::optional<Time> advance_tasks();
  std::size_t skip_idle(std::size_t position, Time& next) const;
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
  std::vector<const Time*> dues_;  ///< of `tasks_`, side by side
  bool has_removed_ = false;       ///< a task
  std::map<std::pair<Time, Id>, TimerAction> timers_;
  LoopCounters counters_;
};

}  // namespace canvoy::host
