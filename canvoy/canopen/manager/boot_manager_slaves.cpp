#include <utility>

#include "canvoy/canopen/manager/boot_manager.hpp"

namespace canvoy {

namespace {

// Of a slave that restarts by itself: so often it is booted anew at once, and so often it waits
// before, twice as long each time; without a restart for `calm` it begins to count anew.
constexpr unsigned prompt_restarts_max = 3;
constexpr unsigned slow_restarts_max = 4;
constexpr unsigned restarts_max = prompt_restarts_max + slow_restarts_max;
constexpr Duration slowest = 8s;
constexpr Duration calm = 30s;

}  // namespace

/// Each error control message of each node.
void BootManager::heard(NodeId slave, RemoteState state) {
  if (!is_active()) return;
  if (state == RemoteState::boot_up) return booted_up(slave);
  if (BootSlave* slot = find_slot(slave); slot != nullptr) slot->heard(state);
}

void BootManager::changed(NodeId slave, RemoteState state) {
  if (state == RemoteState::lost) return lost(slave);
  // Who did not answer until it was given up is there after all.
  const Record& silent = record(slave);
  const bool is_given_up = silent.state == SlaveState::failed &&
                           silent.error == BootError::no_answer && silent.restarts < restarts_max;
  if (is_active() && is_given_up) queue(slave, node_.now());
}

void BootManager::booted_up(NodeId slave) {
  if (slave == node_.id()) return;
  if (!assignment(slave).is_slave()) {
    return report({.slave = slave,
                   .event = BootEvent::unknown,
                   .step = BootStep::waiting,
                   .outcome = {BootError::not_in_list, AbortCode::none}});
  }
  Record& booted = record(slave);
  BootSlave* slot = find_slot(slave);
  if (slot != nullptr && slot->expects_boot_up()) return slot->booted_up();
  if (slot != nullptr || booted.state == SlaveState::booted) {
    BootReport restart = slot != nullptr ? slot->report_of(BootEvent::restarted) : BootReport{};
    restart.slave = slave;
    restart.event = BootEvent::restarted;
    if (slot == nullptr) restart.step = BootStep::done;
    report(restart);
    if (!is_active()) return;
    if (slot != nullptr) slot->abandon();
    return restarted(slave, restart);
  }
  booted.since = node_.now();
  booted.is_fresh = true;
  booted.is_started = false;
  const bool is_slow =
      booted.restarts > prompt_restarts_max && node_.now() - booted.restarted <= calm;
  const bool waits = booted.state == SlaveState::waiting && booted.due != never;
  if (is_slow && waits) return;
  queue(slave, is_slow ? node_.now() + slowest : node_.now());
}

/// What the boot-up itself brings about would go on for ever, as fast as the bus is.
void BootManager::restarted(NodeId slave, BootReport restart) {
  Record& again = record(slave);
  if (node_.now() - again.restarted > calm) again.restarts = 0;
  again.restarted = node_.now();
  again.is_fresh = true;
  again.is_started = false;
  if (again.restarts == restarts_max) return give_up(slave, restart);
  ++again.restarts;
  if (again.restarts <= prompt_restarts_max) return queue(slave, node_.now());
  restart.event = BootEvent::slowed;
  restart.delay = slowest / (1U << (restarts_max - again.restarts));
  queue(slave, node_.now() + restart.delay);
  report(restart);
}

void BootManager::give_up(NodeId slave, BootReport restart) {
  Record& failed = record(slave);
  failed.state = SlaveState::failed;
  failed.error =
      restart.step == BootStep::configuration ? BootError::configuration : BootError::no_answer;
  failed.was_tried = true;
  context_.master.set_time_out(slave, Duration::zero());
  context_.guarding.stop(slave);
  restart.event = BootEvent::given_up;
  restart.outcome.error = failed.error;
  report(restart);
  check_network();
  if (is_active()) node_.timers().arm(timer_, node_.now());  // its slot is free
}

/// The reaction of 1F80h bits 4 and 6, or the slave alone. A slave that the master does not boot is
/// told of only.
void BootManager::lost(NodeId slave) {
  if (!is_active() || record(slave).state != SlaveState::booted) return;
  const SlaveAssignment assigned = assignment(slave);
  report({.slave = slave, .event = BootEvent::lost, .step = BootStep::done});
  if (!is_active() || !assigned.is_booted()) return;
  const NmtStartup wanted = startup();
  bool is_reset = false;
  if (assigned.is_mandatory() && wanted.stops_all_on_error()) {
    context_.commands.add({NmtQueue::all_nodes, NmtCommand::stop});
  } else if (assigned.is_mandatory() && wanted.resets_all_on_error()) {
    context_.commands.add({NmtQueue::all_nodes, NmtCommand::reset_node});
  } else if (!assigned.is_kept_alive()) {
    is_reset = context_.commands.add({slave, NmtCommand::reset_node});
  }
  Record& lost = record(slave);
  lost.since = node_.now();
  lost.is_fresh = lost.is_started = false;
  queue(slave, is_reset ? never : node_.now());
}

void BootManager::queue(NodeId slave, Time due) {
  Record& waiting = record(slave);
  if (waiting.state == SlaveState::none) waiting.since = node_.now();
  waiting.state = SlaveState::waiting;
  waiting.due = due;
  context_.master.set_time_out(slave, Duration::zero());
  context_.guarding.stop(slave);
  if (due < timer_.at()) node_.timers().arm(timer_, due);
}

void BootManager::forget(NodeId slave) {
  if (BootSlave* slot = find_slot(slave); slot != nullptr) slot->abandon();
  if (record(slave).state == SlaveState::none) return;
  record(slave) = {};
  context_.master.set_time_out(slave, Duration::zero());
  context_.guarding.stop(slave);
}

BootSlave* BootManager::find_slot(NodeId slave) {
  for (BootSlave& slot : memory_.slots) {
    if (slot.slave() == slave) return &slot;
  }
  return nullptr;
}

/// The slave that has waited longest; 0 where none is due.
NodeId BootManager::find_due(Time now) const {
  NodeId found = 0;
  Time earliest = never;
  for (NodeId slave = node_id_min; slave <= node_id_max; ++slave) {
    const Record& waiting = record(slave);
    if (waiting.state != SlaveState::waiting || waiting.due >= earliest) continue;
    earliest = waiting.due;
    if (waiting.due <= now) found = slave;
  }
  return found;
}

/// One slave a call, as it may come back at once; the timer goes on with the next.
void BootManager::run_due(Time now) {
  node_.timers().disarm(timer_);
  constexpr NodeId nobody = 0;
  BootSlave* slot = find_slot(nobody);
  if (slot == nullptr || node_.state() == NmtState::stopped) return;
  if (const NodeId slave = find_due(now); slave != nobody) {
    Record& booting = record(slave);
    booting.state = SlaveState::booting;
    slot->begin(slave, std::exchange(booting.is_fresh, false));
  }
  Time next = never;
  for (const Record& waiting : memory_.records) {
    if (waiting.state == SlaveState::waiting && waiting.due < next) next = waiting.due;
  }
  if (next < timer_.at()) node_.timers().arm(timer_, next);
}

void BootManager::finished(BootSlave& slot, BootOutcome outcome) {
  const NodeId slave = slot.slave();
  BootReport end = slot.report_of(BootEvent::failed);
  end.outcome = outcome;
  slot.slave_ = 0;
  Record& ended = record(slave);
  ended.error = outcome.error;
  ended.was_tried = true;
  const bool is_up =
      outcome.error == BootError::none || outcome.error == BootError::already_operational;
  if (outcome.error == BootError::no_answer || outcome.abort == AbortCode::time_out) {
    no_answer(slave, end);
  } else {
    ended.state = is_up ? SlaveState::booted : SlaveState::failed;
    if (is_up) {
      end.event = BootEvent::booted;
      end.step = BootStep::done;
    }
    report(end);
    // Whoever is told may have it retire.
    if (is_up && is_active()) start(slave);
  }
  check_network();
  if (is_active() && timer_.at() > node_.now()) node_.timers().arm(timer_, node_.now());
}

/// The next attempt follows, unless the boot time of a mandatory slave is over by then.
void BootManager::no_answer(NodeId slave, BootReport report_of_end) {
  const auto limit =
      std::chrono::milliseconds(node_.dictionary().number(master_object::boot_time, 0));
  const Time next = node_.now() + context_.options.retry_interval;
  const bool is_over = assignment(slave).is_mandatory() && limit != Duration::zero() &&
                       next > record(slave).since + limit;
  record(slave).state = SlaveState::failed;
  if (!is_over) {
    report_of_end.event = BootEvent::retried;
    queue(slave, next);
  }
  report(report_of_end);
}

/// Where all are started at once, those that come later are started one by one.
void BootManager::start(NodeId slave) {
  Record& booted = record(slave);
  const NmtStartup wanted = startup();
  const bool waits = wanted.starts_all_at_once() && network_ != NetworkBoot::complete;
  if (!wanted.starts_slaves() || !assignment(slave).is_booted() || waits) return;
  booted.is_started = true;
  if (booted.error == BootError::already_operational) return;
  if (!context_.commands.add({slave, NmtCommand::start})) return;
  report({.slave = slave, .event = BootEvent::started, .step = BootStep::done});
}

}  // namespace canvoy
