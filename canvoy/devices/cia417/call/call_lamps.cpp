#include "canvoy/devices/cia417/call/call_lamps.hpp"

namespace canvoy::cia417 {

void CallLamps::begin_anew() {
  shown_.remove_all();
  forget();
}

void CallLamps::forget() {
  told_.remove_all();
  were_on_.remove_all();
  told_again_.remove_all();
  tells_again_ = false;
}

void CallLamps::set(const Call& call, bool on) {
  if (on) {
    shown_.add(call);
    told_.remove(call);
  } else {
    shown_.remove(call);
    told_.add(call);
  }
}

void CallLamps::report_again() {
  told_again_ = were_on_;
  tells_again_ = !told_again_.empty();
}

/// Changes come first; floor 0: nothing is waiting.
Call CallLamps::next_untold() const {
  const Call changed = shown_.first_difference(told_);
  constexpr LiftCalls none{};
  if (changed.floor != 0 || !tells_again_) return changed;
  return told_again_.first_difference(none);
}

VirtualOutput CallLamps::next(std::uint8_t lifts) {
  const Call call = next_untold();
  const bool on = shown_.contains(call);
  told_again_.remove(call);
  tells_again_ = tells_again_ && !told_again_.empty();
  if (on) {
    told_.add(call);
    were_on_.add(call);
  } else {
    told_.remove(call);
    if (call.kind != CallKind::car) report_overlapping(call);
  }
  return acknowledgement_of(call, lifts, on);
}

/// The sub-function addresses the lamps of each direction (4.4.1): when a call without a direction
/// goes out, those of both directions do as well, and vice versa. The lamps of existing calls are
/// lit again.
void CallLamps::report_overlapping(const Call& gone) {
  for (const CallKind kind : {CallKind::up, CallKind::down, CallKind::any}) {
    const Call standing{kind, gone.priority, gone.floor, gone.doors};
    const bool shares_a_lamp =
        kind != gone.kind && (hall_sub_function(kind) & hall_sub_function(gone.kind)) != 0;
    if (shares_a_lamp && shown_.contains(standing)) told_.remove(standing);
  }
}

}  // namespace canvoy::cia417
