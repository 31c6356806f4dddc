#include "canvoy/canopen/manager/slave_boots.hpp"

#include <utility>

namespace canvoy {

SlaveBoots::SlaveBoots(BootContext& context, const Memory& memory, const Owner& owner)
    : context_(context),
      memory_(memory),
      owner_(owner),
      timer_(callback<&SlaveBoots::run_due>(*this)) {
  for (BootSlave& slot : memory_.slots) {
    slot.prepare(context_, BootSlave::Finished::to<&SlaveBoots::finished>(*this));
  }
}

// All of them

void SlaveBoots::begin() {
  is_active_ = true;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    at(slave) = {};
    if (slave == context_.node.id() || !assignment(slave).is_slave()) continue;
    at(slave) = {.due = now(), .since = now(), .state = State::waiting};
  }
}

/// Resets all by one command, unless one of them must be kept alive.
void SlaveBoots::reset_all() {
  bool keeps_some = false;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const bool is_slave = record(slave).state != State::none;
    keeps_some = keeps_some || (is_slave && assignment(slave).is_kept_alive());
  }
  const bool resets_all =
      !keeps_some &&
      context_.commands.add({NmtQueue::all_nodes, NmtCommand::reset_communication, true});
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    if (record(slave).state == State::none || assignment(slave).is_kept_alive()) continue;
    const bool is_reset =
        resets_all || context_.commands.add({slave, NmtCommand::reset_communication});
    if (is_reset) at(slave).due = never;
  }
}

void SlaveBoots::reset_sent(std::uint8_t slave_or_all) {
  const Time due = now() + context_.options.boot_up_time_out;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    if (slave_or_all != slave && slave_or_all != NmtQueue::all_nodes) continue;
    if (BootSlave* slot = find_slot(slave); slot != nullptr) slot->reset_sent();
    Record& told = at(slave);
    if (told.state == State::booted) told.is_told_reset = true;
    if (told.state == State::waiting && told.due == never) queue(slave, due);
  }
}

void SlaveBoots::retire() {
  rest();
  context_.node.timers().disarm(timer_);
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) forget(slave);
  is_active_ = false;
}

void SlaveBoots::rest() {
  for (BootSlave& slot : memory_.slots) {
    if (!slot.busy()) continue;
    const NodeId slave = slot.slave();
    slot.abandon();
    queue(slave, now());
  }
}

/// Starts all by one command, or one by one if there is no room for it.
void SlaveBoots::start_all() {
  const bool is_sent = context_.commands.add({NmtQueue::all_nodes, NmtCommand::start, true});
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    Record& booted = at(slave);
    if (booted.state != State::booted || booted.is_started) continue;
    if (!is_sent) {
      start(slave);
      continue;
    }
    booted.is_started = true;
    report({.slave = slave, .event = BootEvent::started, .step = BootStep::done});
  }
}

void SlaveBoots::assign(NodeId slave, bool is_slave) {
  if (!is_slave) {
    forget(slave);
    if (is_active_) wake();  // its slot may be free
  }
  if (is_slave && record(slave).state == State::none) queue(slave, now());
}

// One of them

void SlaveBoots::heard(NodeId slave, RemoteState state) {
  if (!is_active_) return;
  if (state == RemoteState::boot_up) return booted_up(slave);
  if (BootSlave* slot = find_slot(slave); slot != nullptr) slot->heard(state);
}

void SlaveBoots::changed(NodeId slave, RemoteState state) {
  if (state == RemoteState::lost) return lost(slave);
  // A slave that was given up without an answer is present after all.
  const Record& silent = record(slave);
  const bool is_given_up = silent.state == State::failed && silent.error == BootError::no_answer &&
                           !silent.restarts.is_exhausted();
  if (is_active_ && is_given_up) queue(slave, now());
}

void SlaveBoots::booted_up(NodeId slave) {
  if (slave == context_.node.id()) return;
  if (!assignment(slave).is_slave()) {
    return report({.slave = slave,
                   .event = BootEvent::unknown,
                   .step = BootStep::waiting,
                   .outcome = {BootError::not_in_list, AbortCode::none}});
  }
  Record& booted = at(slave);
  BootSlave* slot = find_slot(slave);
  if (slot != nullptr && slot->expects_boot_up()) return slot->booted_up();
  const bool was_told = std::exchange(booted.is_told_reset, false);
  if (slot != nullptr || (booted.state == State::booted && !was_told)) {
    BootReport restart = slot != nullptr ? slot->report_of(BootEvent::restarted) : BootReport{};
    restart.slave = slave;
    restart.event = BootEvent::restarted;
    if (slot == nullptr) restart.step = BootStep::done;
    report(restart);
    if (!is_active_) return;
    if (slot != nullptr) {
      slot->abandon();
      wake();  // its slot is free
    }
    return restarted(slave, restart);
  }
  booted.since = now();
  booted.is_fresh = true;
  booted.is_started = false;
  const bool is_slow = booted.restarts.is_slow(now());
  const bool waits = booted.state == State::waiting && booted.due != never;
  if (is_slow && waits) return;
  queue(slave, is_slow ? now() + SlaveRestarts::slowest : now());
}

void SlaveBoots::restarted(NodeId slave, BootReport restart) {
  Record& again = at(slave);
  again.is_fresh = true;
  again.is_started = false;
  const std::optional<Duration> delay = again.restarts.count(now());
  if (!delay) return give_up(slave, restart);
  queue(slave, now() + *delay);
  if (*delay == Duration::zero()) return;
  restart.event = BootEvent::slowed;
  restart.delay = *delay;
  report(restart);
}

void SlaveBoots::give_up(NodeId slave, BootReport restart) {
  Record& failed = at(slave);
  failed.state = State::failed;
  failed.error =
      restart.step == BootStep::configuration ? BootError::configuration : BootError::no_answer;
  failed.was_tried = true;
  context_.master.set_time_out(slave, Duration::zero());
  context_.guarding.stop(slave);
  restart.event = BootEvent::given_up;
  restart.outcome.error = failed.error;
  report(restart);
  owner_.changed();
}

/// Reacts as 1F80h bits 4 and 6 require, or for the slave alone. A slave that the master does not
/// boot is only reported.
void SlaveBoots::lost(NodeId slave) {
  if (!is_active_ || record(slave).state != State::booted) return;
  const SlaveAssignment assigned = assignment(slave);
  report({.slave = slave, .event = BootEvent::lost, .step = BootStep::done});
  if (!is_active_ || !assigned.is_booted()) return;
  const NmtStartup wanted = nmt_startup(context_.node.dictionary());
  bool is_reset = false;
  if (assigned.is_mandatory() && wanted.stops_all_on_error()) {
    context_.commands.add({NmtQueue::all_nodes, NmtCommand::stop});
  } else if (assigned.is_mandatory() && wanted.resets_all_on_error()) {
    context_.commands.add({NmtQueue::all_nodes, NmtCommand::reset_node});
  } else if (!assigned.is_kept_alive()) {
    is_reset = context_.commands.add({slave, NmtCommand::reset_node});
  }
  Record& lost = at(slave);
  lost.since = now();
  lost.is_fresh = lost.is_started = false;
  queue(slave, is_reset ? never : now());
}

void SlaveBoots::queue(NodeId slave, Time due) {
  Record& waiting = at(slave);
  if (waiting.state == State::none) waiting.since = now();
  waiting.state = State::waiting;
  waiting.due = due;
  context_.master.set_time_out(slave, Duration::zero());
  context_.guarding.stop(slave);
  wake_at(due);
}

void SlaveBoots::forget(NodeId slave) {
  if (BootSlave* slot = find_slot(slave); slot != nullptr) slot->abandon();
  if (record(slave).state == State::none) return;
  at(slave) = {};
  context_.master.set_time_out(slave, Duration::zero());
  context_.guarding.stop(slave);
}

BootSlave* SlaveBoots::find_slot(NodeId slave) {
  for (BootSlave& slot : memory_.slots) {
    if (slot.slave() == slave) return &slot;
  }
  return nullptr;
}

/// Slave that has waited longest; 0 if none is due.
NodeId SlaveBoots::find_due(Time now) const {
  NodeId found = 0;
  Time earliest = never;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const Record& waiting = record(slave);
    if (waiting.state != State::waiting || waiting.due >= earliest) continue;
    earliest = waiting.due;
    if (waiting.due <= now) found = slave;
  }
  return found;
}

/// Starts slaves that had no room for their command.
void SlaveBoots::start_late(Time now) {
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    Record& booted = at(slave);
    if (!starts_late(booted) || booted.due > now) continue;
    booted.due = never;
    start(slave);
  }
}

/// Boots one slave a call, since it may call back at once; the timer continues with the next.
void SlaveBoots::boot_next(Time now) {
  BootSlave* slot = find_slot(nobody);
  const NodeId slave = find_due(now);
  if (slot == nullptr || slave == nobody) return;
  Record& booting = at(slave);
  booting.state = State::booting;
  slot->begin(slave, std::exchange(booting.is_fresh, false));
}

/// A slave that waits for a turn is checked again when a slot is free.
void SlaveBoots::run_due(Time now) {
  context_.node.timers().disarm(timer_);
  if (context_.node.state() == NmtState::stopped) return;
  start_late(now);
  boot_next(now);
  const bool has_turn = find_slot(nobody) != nullptr;
  for (const Record& waiting : memory_.records) {
    if ((has_turn && waiting.state == State::waiting) || starts_late(waiting)) wake_at(waiting.due);
  }
}

void SlaveBoots::finished(BootSlave& slot, BootOutcome outcome) {
  const NodeId slave = slot.slave();
  BootReport end = slot.report_of(BootEvent::failed);
  end.outcome = outcome;
  slot.release();
  Record& ended = at(slave);
  ended.error = outcome.error;
  ended.was_tried = true;
  ended.due = never;
  const bool is_up =
      outcome.error == BootError::none || outcome.error == BootError::already_operational;
  // Every device has 1000h: one that refuses it is not ready.
  const bool is_refused = outcome.error == BootError::device_type && !outcome.end;
  if (outcome.error == BootError::no_answer || outcome.end.is_silence() || is_refused) {
    try_again(slave, end);
  } else {
    ended.state = is_up ? State::booted : State::failed;
    if (is_up) {
      end.event = BootEvent::booted;
      end.step = BootStep::done;
    }
    report(end);
    // The callback may have retired it.
    if (is_up && is_active_) owner_.booted(slave);
  }
  owner_.changed();
  if (is_active_ && timer_.at() > now()) wake();
}

/// The next attempt follows, unless the boot time of a mandatory slave ends before.
void SlaveBoots::try_again(NodeId slave, BootReport end) {
  const auto limit =
      std::chrono::milliseconds(context_.node.dictionary().number(master_object::boot_time, 0));
  const Time next = now() + context_.options.retry_interval;
  const bool is_over = assignment(slave).is_mandatory() && limit != Duration::zero() &&
                       next > record(slave).since + limit;
  at(slave).state = State::failed;
  if (!is_over) {
    end.event = BootEvent::retried;
    queue(slave, next);
  }
  report(end);
}

void SlaveBoots::start(NodeId slave) {
  Record& booted = at(slave);
  const bool runs_already = booted.error == BootError::already_operational;
  booted.is_started = runs_already || context_.commands.add({slave, NmtCommand::start});
  if (runs_already) return;
  if (booted.is_started) {
    return report({.slave = slave, .event = BootEvent::started, .step = BootStep::done});
  }
  booted.due = now() + context_.options.retry_interval;
  wake_at(booted.due);
}

}  // namespace canvoy
