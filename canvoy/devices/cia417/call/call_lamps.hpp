// The lamps of calls: which ones panels are to show, and what they have been told of it (CiA 417-4,
// 4.4.1: basic functions 02h to 07h). A state, not a queue: what has changed twice is told once.
//
//     CallLamps lamps;
//     lamps.set({.kind = CallKind::up, .floor = 3}, true);
//     while (lamps.waits()) send(lamps.next(lift_bit(1)));
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/call/call_records.hpp"
#include "canvoy/devices/cia417/controller/lift_calls.hpp"

namespace canvoy::cia417 {

class CallLamps {
 public:
  /// None is lit, as the panels know.
  void begin_anew();

  /// What panels are to show.
  const LiftCalls& shown() const { return shown_; }
  /// A call is shown from here on, or no more: that is told in any case.
  void set(const Call& call, bool on);
  /// It is shown no more: told where it was.
  void end(const Call& call) { shown_.remove(call); }
  void end_at(std::uint8_t floor, CallKinds kinds) { shown_.remove_at(floor, kinds); }
  void end_all(CallKinds kinds) { shown_.remove_all(kinds); }

  /// Other panels listen, which know nothing.
  void forget();
  /// Panels have come that may not have heard what is shown, and what was once and is not any more.
  void tell_again();

  bool waits() const { return next_untold().floor != 0; }
  /// The next acknowledgement of lift `lifts`, which is told with that; asked only while something
  /// waits.
  VirtualOutput next(std::uint8_t lifts);

 private:
  Call next_untold() const;
  void tell_overlapping(const Call& gone);

  LiftCalls shown_;       ///< what panels are to show
  LiftCalls told_;        ///< what they were told
  LiftCalls were_on_;     ///< what they have shown since the controller began
  LiftCalls told_again_;  ///< what they are told whether it has changed or not
  bool tells_again_ = false;
};

}  // namespace canvoy::cia417
