#include "canvoy/worlds/police/police_referee.hpp"

#include <algorithm>

namespace canvoy::police {

namespace {

/// Longest time for which something may be wrong.
Duration bound_of(InvariantKind kind) {
  switch (kind) {
    // Another client may have the pad first, while its destination is typed.
    case InvariantKind::terminal_wait:
      return 20s;
    case InvariantKind::blue_light:
    case InvariantKind::siren:
    case InvariantKind::speech:
    case InvariantKind::carrier:
      return 2s;
    case InvariantKind::device_missing:
      return 20s;
    case InvariantKind::siren_alone:
      return 500ms;  // one flash
    default:
      return 3s;
  }
}

bool has_time(InvariantKind kind) {
  return kind != InvariantKind::keypad && kind != InvariantKind::silence &&
         kind != InvariantKind::calls;
}

double in_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void PoliceReferee::pressed(const KeyAction& key, bool may_come_late) {
  std::vector<Pressed>& pad = pads_[key.is_function_key ? 1 : 0];
  const auto is_other = [&](const Pressed& one) { return !one.is_for(key); };
  if (!may_come_late) std::erase_if(pad, is_other);
  const auto same = std::ranges::find_if_not(pad, is_other);
  if (same == pad.end()) {
    pad.push_back({key.client, key.key, 1});
  } else {
    ++same->open;
  }
}

void PoliceReferee::acted(const KeyAction& action) {
  ++keys_;
  std::vector<Pressed>& pad = pads_[action.is_function_key ? 1 : 0];
  const auto meant = std::ranges::find_if(
      pad, [&](const Pressed& one) { return one.is_for(action) && one.open != 0; });
  if (meant != pad.end()) {
    --meant->open;
  } else {
    ++wrong_keys_;
  }
}

Duration PoliceReferee::worst(InvariantKind kind) const {
  if (kind == InvariantKind::device_missing) return missing_.worst();
  if (kind == InvariantKind::terminal_wait) return longest_wait_;
  return wrong_[index(kind)].worst();
}

std::uint64_t PoliceReferee::judged(InvariantKind kind, std::size_t calls) const {
  switch (kind) {
    case InvariantKind::keypad:
      return keys_;
    case InvariantKind::terminal_wait:
      return waits_;
    case InvariantKind::silence:
      return quiet_;
    case InvariantKind::calls:
      return calls;
    case InvariantKind::device_missing:
      return missing_.judged();
    default:
      return wrong_[index(kind)].judged();
  }
}

std::vector<Invariant> PoliceReferee::verdicts(std::span<const EmergencyCall> calls) const {
  const auto failed = static_cast<double>(std::ranges::count_if(
      calls, [](const EmergencyCall& call) { return call.age > call_bound; }));
  std::vector<Invariant> all;
  for (std::size_t i = 0; i < kinds; ++i) {
    const auto kind = static_cast<InvariantKind>(i);
    Invariant made{.kind = kind, .judged = undecided_[i] ? 0 : judged(kind, calls.size())};
    if (has_time(kind)) {
      made.worst = in_seconds(worst(kind));
      made.allowed = in_seconds(bound_of(kind));
    } else if (kind == InvariantKind::keypad) {
      made.worst = wrong_keys_;
    } else if (kind == InvariantKind::silence) {
      made.worst = static_cast<double>(frames_asleep_);
    } else {
      made.worst = failed;
    }
    made.held = !made.is_decided() || made.worst <= made.allowed;
    all.push_back(made);
  }
  return all;
}

}  // namespace canvoy::police
