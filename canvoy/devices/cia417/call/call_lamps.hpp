// The lamps of calls: which ones panels have to show, and which acknowledgements they have received
// (CiA 417-4, 4.4.1: basic functions 02h to 07h). This is a state, not a queue: a lamp that changes
// twice is sent once.
//
//     CallLamps lamps;
//     lamps.set({.kind = CallKind::up, .floor = 3}, true);
//     while (lamps.waits()) send(lamps.next(lift_bit(1)));
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/call/call_records.hpp"
#include "canvoy/devices/cia417/lift/lift_calls.hpp"

namespace canvoy::cia417 {

class CallLamps {
 public:
  /// Starts with all lamps off, as in the panels.
  void begin_anew();

  /// The lamps that panels have to show.
  const LiftCalls& shown() const { return shown_; }
  /// Sets the lamps of a call. They are sent in any case.
  void set(const Call& call, bool on);
  /// Ends the lamps of a call. They are sent where they were on.
  void end(const Call& call) { shown_.remove(call); }
  /// Ends the lamps of calls of these kinds at a floor.
  void end_at(std::uint8_t floor, CallKinds kinds) { shown_.remove_at(floor, kinds); }
  /// Ends the lamps of calls of these kinds at all floors.
  void end_all(CallKinds kinds) { shown_.remove_all(kinds); }

  /// Starts with other panels, which have received nothing.
  void forget();
  /// Sends all that is shown, and all that was shown before and has ended, since panels have come
  /// that may not have received it.
  void report_again();

  /// True if an acknowledgement has to be sent.
  bool waits() const { return next_untold().floor != 0; }
  /// Returns the next acknowledgement of lift `lifts`, and marks it as sent. Call it only while one
  /// is waiting.
  VirtualOutput next(std::uint8_t lifts);

 private:
  Call next_untold() const;
  void report_overlapping(const Call& gone);

  LiftCalls shown_;       ///< lamps that panels have to show
  LiftCalls told_;        ///< lamps that they have received
  LiftCalls were_on_;     ///< lamps that they have shown since the controller started
  LiftCalls told_again_;  ///< lamps to send even if unchanged
  bool tells_again_ = false;
};

}  // namespace canvoy::cia417
