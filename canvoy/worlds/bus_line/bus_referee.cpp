#include "canvoy/worlds/bus_line/bus_referee.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::bus_line {

namespace {

/// Time until the loss of the on-board computer, or of identification, is detected.
constexpr Duration grace = 1500ms;

/// Longest time for which something may be wrong; empty: errors are counted, and none is allowed.
Duration bound_of(InvariantKind kind) {
  switch (kind) {
    case InvariantKind::passengers:
      return 3s;
    case InvariantKind::clock:
      // Each minute, by a clock that may be a second late.
      return 62s;
    case InvariantKind::device_missing:
      return 10s;
    case InvariantKind::texts:
    case InvariantKind::announcements:
    case InvariantKind::tickets:
    case InvariantKind::pdo_tables:
    case InvariantKind::service:
    case InvariantKind::second_announcements:
    case InvariantKind::third_announcements:
    case InvariantKind::fourth_announcements:
    case InvariantKind::early_departure:
    case InvariantKind::left_behind:
      return {};
    default:
      return 1s;
  }
}

/// True for what holds before any device has booted.
bool holds_from_the_beginning(InvariantKind kind) {
  switch (kind) {
    case InvariantKind::stop_sign:
    case InvariantKind::second_stop_sign:
    case InvariantKind::third_stop_sign:
    case InvariantKind::fourth_stop_sign:
    case InvariantKind::false_stop_sign:
    case InvariantKind::passengers:
    case InvariantKind::overcrowded:
      return true;
    default:
      return false;
  }
}

double in_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void BusReferee::fault_begins(const InvariantSet& kinds, Time now) {
  ++faults_;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (kinds[i]) ++kept_[i].faults;
  }
  troubled_until_ = std::max(troubled_until_, now + return_bound);
}

void BusReferee::fault_ends(const InvariantSet& kinds, Time now) {
  --faults_;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (!kinds[i]) continue;
    --kept_[i].faults;
    const auto kind = static_cast<InvariantKind>(i);
    excuse(kind, now + (kind == InvariantKind::service ? service_bound : return_bound));
  }
  troubled_until_ = std::max(troubled_until_, now + return_bound);
}

void BusReferee::excuse(InvariantKind kind, Time until) {
  Time& excused = kept_[index(kind)].excused_until;
  excused = std::max(excused, until);
}

bool BusReferee::is_excused(InvariantKind kind, Time now) const {
  const Kept& kept = kept_[index(kind)];
  const bool boots = now < Time(return_bound) && !holds_from_the_beginning(kind);
  return kept.faults != 0 || now < kept.excused_until || boots;
}

void BusReferee::judge(InvariantKind kind, Time now, bool is_right, bool applies) {
  Kept& kept = kept_[index(kind)];
  const bool is_judged = applies && !is_excused(kind, now);
  if (is_right || !is_judged) kept.right_at = now;
  kept.worst = std::max(kept.worst, now - kept.right_at);
  if (is_judged) ++kept.judged;
}

void BusReferee::judge_honesty(Time now, bool is_honest) {
  Kept& kept = kept_[index(InvariantKind::lie)];
  ++kept.judged;
  if (is_honest) kept.right_at = now;
  const Duration lied = now - kept.right_at;
  kept.worst = std::max(kept.worst, has_fault(now) ? lied - grace : lied);
}

void BusReferee::judge_device(NodeId id, Time now, bool is_there) {
  Time& at = there_at_.at(id);
  if (is_there) at = now;
  Kept& kept = kept_[index(InvariantKind::device_missing)];
  kept.worst = std::max(kept.worst, now - at);
  ++kept.judged;
}

void BusReferee::judge_one(InvariantKind kind, Time now, bool is_right) {
  if (is_excused(kind, now)) return;
  Kept& kept = kept_[index(kind)];
  ++kept.judged;
  if (!is_right) ++kept.wrong;
}

bool BusReferee::is_broken(std::size_t kind) const {
  const Duration bound = bound_of(static_cast<InvariantKind>(kind));
  return !undecided_[kind] &&
         (kept_[kind].wrong != 0 || (bound > Duration::zero() && kept_[kind].worst > bound));
}

bool BusReferee::has_news() {
  std::size_t broken = 0;
  for (std::size_t i = 0; i < kept_.size(); ++i) broken += is_broken(i) ? 1U : 0U;
  return std::exchange(broken_, broken) != broken;
}

std::vector<Invariant> BusReferee::verdicts() const {
  std::vector<Invariant> all;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const auto kind = static_cast<InvariantKind>(i);
    const Duration bound = bound_of(kind);
    Invariant made{.kind = kind, .judged = undecided_[i] ? 0 : kept_[i].judged};
    const bool has_time = bound > Duration::zero();
    made.worst = has_time ? in_seconds(kept_[i].worst) : kept_[i].wrong;
    made.allowed = in_seconds(bound);
    made.held = !is_broken(i);
    all.push_back(made);
  }
  return all;
}

}  // namespace canvoy::bus_line
