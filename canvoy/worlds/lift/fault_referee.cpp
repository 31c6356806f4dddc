#include "canvoy/worlds/lift/fault_referee.hpp"

#include <algorithm>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::lift {

namespace {

/// Judges an event that was required within `bound` from `from`, and came at `came`; an end before
/// that leaves no judgement.
Invariant promise(InvariantKind kind, Time from, Time came, Time until, Duration bound) {
  const Duration took = std::min(came, until) - from;
  const bool is_late = took > bound;
  return {.kind = kind,
          .worst = in_seconds(took),
          .allowed = in_seconds(bound),
          .held = !is_late,
          .judged = is_late || came != never ? 1U : 0U};
}

}  // namespace

void FaultReferee::began(Time now, std::size_t fault, const FaultExpectation& expectation) {
  faults_.push_back({.fault = fault,
                     .expected = expectation,
                     .began_at = now,
                     .stood_before = !moves(expectation.lift)});
}

void FaultReferee::ended(Time now, std::size_t fault) {
  for (Watched& watched : faults_) {
    if (watched.fault != fault || watched.ended_at != never) continue;
    watched.ended_at = now;
    watched.has_moved = moves(watched.expected.lift);
  }
}

void FaultReferee::handed_back(Time now, LiftNumber lift) {
  for (Watched& watched : faults_) {
    if (watched.expected.lift == lift && watched.ended_at <= now) watched.handed_back_at = now;
  }
}

void FaultReferee::stands(Time now, LiftNumber lift) {
  moving_ &= ~(1U << (lift - 1));
  for (Watched& watched : faults_) {
    if (watched.expected.lift == lift && watched.stood_at == never) watched.stood_at = now;
  }
}

void FaultReferee::starts(Time now, LiftNumber lift) {
  moving_ |= 1U << (lift - 1);
  for (Watched& watched : faults_) {
    if (watched.expected.lift != lift) continue;
    const auto& noticed = watched.expected.noticed_within;
    watched.has_moved = watched.has_moved || watched.ended_at != never;
    if (watched.ended_at != never || !noticed || watched.started_at != never) continue;
    if (watched.expected.noticed_when_told && watched.reported_at == never) continue;
    if (now - watched.began_at > *noticed) watched.started_at = now;
  }
}

void FaultReferee::emergency_seen(Time now, LiftNumber lift, std::uint16_t code) {
  for (Watched& watched : faults_) {
    const auto& wanted = watched.expected.emergencies;
    const bool fits = std::find(wanted.begin(), wanted.end(), code) != wanted.end();
    if (watched.expected.lift == lift && fits && watched.reported_at == never)
      watched.reported_at = now;
  }
}

void FaultReferee::serves(Time now, LiftNumber lift) {
  for (Watched& watched : faults_) {
    const bool is_over = watched.ended_at <= now && (lift == 0 || watched.has_moved);
    if (watched.expected.lift == lift && is_over && watched.served_at == never) {
      watched.served_at = now;
    }
  }
}

/// True if no other fault of the same lift is present; for a group no fault at all, nor its effects
/// on one of the lifts, which the group needs to serve.
bool FaultReferee::is_alone(const Watched& watched, Time now) const {
  return std::ranges::none_of(faults_, [&](const Watched& other) {
    if (&other == &watched || other.began_at > now) return false;
    const bool is_there = other.ended_at > now && other.expected.lift == watched.expected.lift;
    return is_there || (watched.expected.lift == 0 && hinders(other, now));
  });
}

void FaultReferee::passed(Time now, Duration time,
                          const std::function<bool(LiftNumber)>& is_wanted) {
  for (Watched& watched : faults_) {
    const bool is_over = watched.ended_at <= now;
    if ((is_over ? watched.served_at : watched.reported_at) != never) continue;
    if (is_over) {
      if (is_alone(watched, now) && is_wanted(watched.expected.lift)) watched.wanted += time;
    } else if (!is_alone(watched, now)) {
      watched.beside_others += time;
    }
  }
}

/// Not for ever: whether people want the lift is unknown.
bool FaultReferee::recovers(const Watched& watched, Time now) {
  if (watched.ended_at > now) return true;
  const bool is_expected = watched.expected.serves_within.has_value();
  const Duration bound = is_expected ? watched.expected.recovers_within : 0s;
  const Time since = std::max(watched.ended_at, watched.handed_back_at);
  return watched.served_at == never && now - since < bound;
}

bool FaultReferee::hinders(const Watched& watched, Time now) {
  const std::optional<Duration> bound = watched.expected.hinders_for;
  if (!bound) return recovers(watched, now);
  const Time since = watched.ended_at <= now ? watched.ended_at : watched.began_at;
  return now - since < *bound;
}

bool FaultReferee::is_hindered(Time now, LiftNumber lift) const {
  return std::any_of(faults_.begin(), faults_.end(), [&](const Watched& watched) {
    return watched.expected.lift == lift && hinders(watched, now);
  });
}

bool FaultReferee::excuses_waiting(Time since) const {
  return std::ranges::any_of(faults_, [since](const Watched& watched) {
    const FaultExpectation& expected = watched.expected;
    if (expected.hinders_for || !expected.serves_within) return false;
    return watched.ended_at == never || since - watched.ended_at < *expected.serves_within;
  });
}

bool FaultReferee::is_faulty(Time now, LiftNumber lift) const {
  return std::any_of(faults_.begin(), faults_.end(), [&](const Watched& watched) {
    return watched.expected.lift == lift && recovers(watched, now) && !watched.expected.is_fire;
  });
}

Invariant FaultReferee::service(const Watched& watched) {
  const Duration bound = watched.expected.serves_within.value_or(0s);
  const bool is_late = watched.wanted > bound;
  return {.kind = InvariantKind::service_resumed,
          .worst = in_seconds(watched.wanted),
          .allowed = in_seconds(bound),
          .held = !is_late,
          .judged = is_late || watched.served_at != never ? 1U : 0U};
}

/// It stands in time, and stays at a standstill. Of a car that stood before, the second is judged
/// alone: the first is not the lift's doing.
Invariant FaultReferee::safe_stand(const Watched& watched, Time until) {
  const std::optional<Duration>& noticed = watched.expected.noticed_within;
  if (watched.started_at == never) {
    Invariant stand = promise(InvariantKind::safe_stand, watched.began_at, watched.stood_at, until,
                              watched.expected.stands_within.value_or(0s));
    const bool could_start = noticed && until - watched.began_at > *noticed;
    if (watched.stood_before && !could_start) stand.judged = 0;
    return stand;
  }
  return {.kind = InvariantKind::safe_stand,
          .worst = in_seconds(watched.started_at - watched.began_at),
          .allowed = in_seconds(watched.expected.noticed_within.value_or(0s)),
          .held = false,
          .judged = 1};
}

std::vector<Invariant> FaultReferee::invariants(Time now) const {
  std::vector<Invariant> all;
  const auto add = [&](const Watched& watched, Invariant invariant) {
    invariant.part = watched.expected.lift;
    invariant.fault = watched.fault;
    all.push_back(invariant);
  };
  for (const Watched& watched : faults_) {
    const Time until = std::min(now, watched.ended_at);
    if (watched.expected.stands_within) add(watched, safe_stand(watched, until));
    if (!watched.expected.emergencies.empty()) {
      add(watched, promise(InvariantKind::emergency_told, watched.began_at, watched.reported_at,
                           until, watched.expected.told_within + watched.beside_others));
    }
    if (watched.expected.serves_within && watched.ended_at <= now) {
      add(watched, service(watched));
    }
  }
  return all;
}

}  // namespace canvoy::lift
