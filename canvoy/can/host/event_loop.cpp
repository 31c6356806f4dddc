#include "canvoy/can/host/event_loop.hpp"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace canvoy::host {

namespace {

// The ids of the loop's own descriptors; ids for callers begin behind them.
constexpr EventLoop::Id timer_id = 1;
constexpr EventLoop::Id wakeup_id = 2;

constexpr Duration stuck_delay = 1ms;
// Stamps outside of this range are from a wall clock that was set since the loop began.
constexpr Duration stamp_age_max = 60s;
constexpr Duration stamp_lead_max = 1s;
// Of a task that is to be asked for its deadline.
constexpr Time always = Time::min();
// Beyond it a deadline has no effect, and would overflow in nanoseconds.
constexpr Time deadline_max{Duration{1h} * 24 * 365 * 50};

constexpr std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::int64_t read_clock(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return nanoseconds(time);
}

constexpr std::uint32_t epoll_events(Readiness wanted) {
  std::uint32_t events = 0;
  if (wanted.readable) events |= EPOLLIN;
  if (wanted.writable) events |= EPOLLOUT;
  return events;
}

constexpr Readiness readiness_of(std::uint32_t events) {
  return {.readable = (events & EPOLLIN) != 0,
          .writable = (events & EPOLLOUT) != 0,
          .failed = (events & (EPOLLERR | EPOLLHUP)) != 0};
}

bool control(int poll, int operation, int descriptor, Readiness wanted, EventLoop::Id id) {
  epoll_event event{};
  event.events = epoll_events(wanted);
  event.data.u64 = id;
  return epoll_ctl(poll, operation, descriptor, &event) == 0;
}

// Both an eventfd and a timerfd hold a count that a read resets.
void drain(const Descriptor& counter) {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t size = ::read(counter.get(), &count, sizeof count);
}

// SIGHUP only if it has its default effect: a program started by nohup must survive the terminal.
sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  struct sigaction hang_up {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler == SIG_DFL) sigaddset(&signals, SIGHUP);
  return signals;
}

const Time* due_of(const Task& task) {
  return task.due == nullptr ? &always : task.due;
}

constexpr Time earlier(Time one, Time other) {
  return other < one ? other : one;
}

constexpr std::size_t tasks_at_once = 8;

/// Without a branch between them.
template <std::size_t... i>
Time earliest_of(const Time* const* dues, std::index_sequence<i...>) {
  Time first = *dues[0];
  Time second = *dues[tasks_at_once / 2];
  ((i % 2 == 0 ? first = earlier(first, *dues[i]) : second = earlier(second, *dues[i])), ...);
  return earlier(first, second);
}

Error loop_error(int error) {
  return {"event loop", std::strerror(error), "close some files, or raise `ulimit -n`"};
}

}  // namespace

Result<std::unique_ptr<EventLoop>> EventLoop::create() {
  Descriptor poll{epoll_create1(EPOLL_CLOEXEC)};
  Descriptor timer{timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)};
  Descriptor wakeup{eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)};
  const Readiness readable{.readable = true};
  if (!poll || !timer || !wakeup ||
      !control(poll.get(), EPOLL_CTL_ADD, timer.get(), readable, timer_id) ||
      !control(poll.get(), EPOLL_CTL_ADD, wakeup.get(), readable, wakeup_id)) {
    return loop_error(errno);
  }
  return std::unique_ptr<EventLoop>(
      new EventLoop(std::move(poll), std::move(timer), std::move(wakeup)));
}

EventLoop::EventLoop(Descriptor poll, Descriptor timer, Descriptor wakeup)
    : poll_(std::move(poll)),
      timer_(std::move(timer)),
      wakeup_(std::move(wakeup)),
      origin_ns_(read_clock(CLOCK_MONOTONIC)),
      epoch_(read_clock(CLOCK_REALTIME) / 1000),
      last_id_(wakeup_id) {}

EventLoop::~EventLoop() {
  forget_signals();
}

Time EventLoop::now() const {
  return Time{Duration{(read_clock(CLOCK_MONOTONIC) - origin_ns_) / 1000}};
}

Time EventLoop::time_of(const timespec& wall_clock) const {
  const Time current = now();
  const Time time{Duration{nanoseconds(wall_clock) / 1000} - epoch_};
  const bool plausible = time >= current - stamp_age_max && time <= current + stamp_lead_max;
  return plausible ? time : current;
}

Result<EventLoop::Id> EventLoop::watch(int descriptor, Readiness wanted, Ready ready) {
  const Id id = ++last_id_;
  if (!control(poll_.get(), EPOLL_CTL_ADD, descriptor, wanted, id)) {
    return Error{"file descriptor " + std::to_string(descriptor), std::strerror(errno), ""};
  }
  watches_.push_back({id, descriptor, wanted, ready});
  return id;
}

void EventLoop::rewatch(Id id, Readiness wanted) {
  Watch* watch = find_watch(id);
  if (watch == nullptr || watch->wanted == wanted) return;
  watch->wanted = wanted;
  control(poll_.get(), EPOLL_CTL_MOD, watch->descriptor, wanted, id);
}

void EventLoop::unwatch(Id id) {
  Watch* watch = find_watch(id);
  if (watch == nullptr) return;
  control(poll_.get(), EPOLL_CTL_DEL, watch->descriptor, {}, id);
  watches_.erase(watches_.begin() + (watch - watches_.data()));
}

EventLoop::Watch* EventLoop::find_watch(Id id) {
  const auto found = std::ranges::find(watches_, id, &Watch::id);
  return found == watches_.end() ? nullptr : &*found;
}

EventLoop::Id EventLoop::add(const Task& task) {
  tasks_.push_back({++last_id_, task, {}});
  dues_.push_back(due_of(task));
  return last_id_;
}

// The entry stays until advance_tasks() begins again, which may be iterating over the list.
void EventLoop::remove(Id id) {
  const auto found = std::ranges::find(tasks_, id, &TaskEntry::id);
  if (found == tasks_.end()) return;
  found->id = 0;
  dues_[static_cast<std::size_t>(found - tasks_.begin())] = &never;
  has_removed_ = true;
}

EventLoop::Id EventLoop::at(Time time, TimerAction action) {
  timers_.emplace(std::pair{time, ++last_id_}, std::move(action));
  return last_id_;
}

void EventLoop::cancel(Id id) {
  std::erase_if(timers_, [id](const auto& timer) { return timer.first.second == id; });
}

Result<void> EventLoop::stop_on_signals() {
  if (signals_) return {};
  const sigset_t signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, &mask_before_);
  signals_ = Descriptor{signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC)};
  if (!signals_) {
    const int error = errno;
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
    return loop_error(error);
  }
  const Result<Id> watched =
      watch(signals_.get(), {.readable = true}, Ready::to<&EventLoop::on_signal>(*this));
  if (!watched) {
    forget_signals();
    return watched.error();
  }
  signal_watch_ = *watched;
  return {};
}

void EventLoop::on_signal(Readiness) {
  signalfd_siginfo info{};
  if (::read(signals_.get(), &info, sizeof info) != sizeof info) return;
  signal_ = static_cast<int>(info.ssi_signo);
  // Both the terminal and the shell send it, and the second one is not a request to end at once.
  if (signal_ == SIGHUP) std::signal(SIGHUP, SIG_IGN);
  forget_signals();
  stop();
}

void EventLoop::forget_signals() {
  if (!signals_) return;
  unwatch(signal_watch_);
  Descriptor closing = std::move(signals_);
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

EventLoop::End EventLoop::run_until(Time time) {
  // Next deadline, until a callback that could change it is called.
  std::optional<Time> known;
  while (!stop_requested_.exchange(false)) {
    // After the end of the time the loop does not wait.
    const bool is_over = time <= now();
    wait(is_over ? time : std::min(time, known ? *known : next_deadline()));
    known = advance_tasks();
    if (run_timers()) known.reset();
    if (now() >= time) return stop_requested_.exchange(false) ? End::stopped : End::reached;
  }
  return End::stopped;
}

void EventLoop::stop() {
  stop_requested_.store(true);
  wake();
}

void EventLoop::wake() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t size = ::write(wakeup_.get(), &one, sizeof one);
}

// By position, not by iterator: a task may add others, or remove itself. The next deadline is known
// if no task was advanced.
std::optional<Time> EventLoop::advance_tasks() {
  if (std::exchange(has_removed_, false)) {
    std::erase_if(tasks_, [](const TaskEntry& entry) { return entry.id == 0; });
    dues_.clear();
    for (const TaskEntry& entry : tasks_) dues_.push_back(due_of(entry.task));
  }
  advanced_to_ = now();
  Time next = first_timer();
  bool is_known = true;
  for (std::size_t position = 0; (position = skip_idle(position, next)) < tasks_.size();
       ++position) {
    const Time deadline = tasks_[position].next();
    if (deadline > advanced_to_) {
      next = std::min(next, deadline);
      continue;
    }
    is_known = false;
    const Task task = tasks_[position].task;
    task.advance(advanced_to_);
    if (tasks_[position].id == 0 || tasks_[position].deadline() > advanced_to_) continue;
    ++counters_.stuck;
    tasks_[position].not_before = advanced_to_ + stuck_delay;
  }
  return is_known ? std::optional(next) : std::nullopt;
}

// Most tasks of which the deadline stands in memory have nothing to do: the first other one from
// `position` on. `next` gets the earliest of their deadlines, if it is earlier.
std::size_t EventLoop::skip_idle(std::size_t position, Time& next) const {
  const std::span<const Time* const> dues = dues_;
  const Time current = advanced_to_;
  while (position < dues.size() && *dues[position] > current) {
    while (dues.size() - position >= tasks_at_once) {
      const Time several = earliest_of(&dues[position], std::make_index_sequence<tasks_at_once>());
      if (several <= current) break;
      next = earlier(next, several);
      position += tasks_at_once;
    }
    // One of these is due, or they are the last ones.
    const std::size_t end = std::min(dues.size(), position + tasks_at_once);
    for (; position<end&& * dues[position]> current; ++position) {
      next = earlier(next, *dues[position]);
    }
  }
  return position;
}

Time EventLoop::first_timer() const {
  return timers_.empty() ? never : timers_.begin()->first.first;
}

// Timers that actions set wait for the next turn, so that descriptors are served. Returns whether a
// timer ran.
bool EventLoop::run_timers() {
  const Time current = now();
  const Id last_to_run = last_id_;
  bool has_run = false;
  while (!timers_.empty()) {
    const auto first = timers_.begin();
    if (first->first.first > current || first->first.second > last_to_run) break;
    has_run = true;
    const TimerAction action = std::move(first->second);
    timers_.erase(first);
    action(current);
  }
  return has_run;
}

Time EventLoop::next_deadline() const {
  Time earliest = first_timer();
  for (std::size_t position = 0; (position = skip_idle(position, earliest)) < tasks_.size();
       ++position) {
    earliest = std::min(earliest, tasks_[position].next());
  }
  return earliest;
}

void EventLoop::wait(Time deadline) {
  std::array<epoll_event, 64> events{};
  const bool due = deadline <= now();
  if (!due) arm(deadline);
  const int count =
      epoll_wait(poll_.get(), events.data(), static_cast<int>(events.size()), due ? 0 : -1);
  ++counters_.wakeups;
  for (int i = 0; i < count; ++i) dispatch(events[static_cast<std::size_t>(i)]);
}

void EventLoop::arm(Time deadline) {
  if (deadline > deadline_max) deadline = never;
  if (deadline == armed_) return;
  itimerspec setting{};  // all zero: disarmed
  if (deadline != never) {
    const std::int64_t ns = origin_ns_ + deadline.time_since_epoch().count() * 1000;
    setting.it_value.tv_sec = ns / 1'000'000'000;
    setting.it_value.tv_nsec = ns % 1'000'000'000;
  }
  timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &setting, nullptr);
  armed_ = deadline;
}

void EventLoop::dispatch(const epoll_event& event) {
  if (event.data.u64 == timer_id) {
    drain(timer_);
    armed_ = never;
    return;
  }
  if (event.data.u64 == wakeup_id) return drain(wakeup_);
  const Watch* watch = find_watch(event.data.u64);
  if (watch == nullptr) return;  // removed by a callback of this turn
  const Ready ready = watch->ready;
  ready(readiness_of(event.events));
}

}  // namespace canvoy::host
