// One piece of cable of the simulated bus and the frame that is on it. A bus has one, until its
// cable is cut.
//
//     wire.begin(frame, bit_ns, now_ns, transmitters, hearing);
//     wire.plan_failure(wire.bit_end_ns(17), BusErrorKind::bit, detector);
//     wire.await_delivery();
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/bus_load.hpp"
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/bus_error.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/transmit_queue.hpp"
#include "canvoy/can/simulated/wire_time.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// Who is on it, what it carries, what is due next, and how busy it was. It decides nothing: who
/// sends, and what goes wrong, it is told.
class SimulatedWire {
 public:
  /// What the next event is: a start of frame, receivers having the frame, the end of it. While a
  /// transmitter is told that it has ended, the next is not yet known.
  enum class Phase : std::uint8_t { idle, frame, last_bit, ended };

  /// Idle, with nobody on it.
  SimulatedWire(std::int64_t bit_ns, std::int64_t load_window_ns, std::int64_t now_ns)
      : bit_ns_(bit_ns), free_ns_(now_ns), recessive_since_ns_(now_ns), load_(load_window_ns) {}

  Phase phase() const { return phase_; }
  bool is_busy() const { return phase_ == Phase::frame || phase_ == Phase::last_bit; }
  /// When something is due.
  std::int64_t event_ns() const { return event_ns_; }
  /// Whether it is a frame that is due to begin, or an error that is due to be detected.
  bool may_start(std::int64_t now_ns) const { return start_ns_ <= now_ns; }
  bool has_failed(std::int64_t now_ns) const { return failure_ns_ <= now_ns; }

  const ControllerSet& members() const { return members_; }  ///< with power or without
  const ControllerSet& transmitters() const { return transmitters_; }
  const ControllerSet& receivers() const { return receivers_; }
  /// Error-passive, and the last to send: they let others go first.
  const ControllerSet& suspended() const { return suspended_; }
  /// Of the error that is going to be detected; none: the transmitters.
  const ControllerSet& detectors() const { return detectors_; }

  /// The frame that it carries.
  const PendingFrame& current() const { return current_; }
  std::int64_t bit_ns() const { return bit_ns_; }  ///< of this frame, or the last one
  std::int64_t bit_end_ns(unsigned bit) const { return begin_ns_ + bit * bit_ns_; }
  std::int64_t frame_end_ns() const { return bit_end_ns(current_.bits); }
  /// The acknowledgement slot, in which the transmitter learns whether anybody has the frame.
  std::int64_t acknowledgement_ns() const {
    return bit_end_ns(current_.bits - bits_after_acknowledgement);
  }
  /// Since when there has been no dominant bit, or from when on there will be none.
  std::int64_t recessive_since_ns() const { return recessive_since_ns_; }
  const BusLoad& load() const { return load_; }

  /// While it is idle: the first of `ready` begins as soon as it may.
  void await_start(const ControllerSet& ready, std::int64_t now_ns) {
    start_ns_ = never_ns;
    if (!ready.empty()) {
      const bool are_suspended = (ready - suspended_).empty();
      start_ns_ = std::max(are_suspended ? suspended_until_ns() : free_ns_, now_ns);
    }
    event_ns_ = start_ns_;
  }
  /// Something else is due at that time at the latest.
  void wake_at(std::int64_t at_ns) { event_ns_ = std::min(event_ns_, at_ns); }
  /// Nothing begins before that time.
  void hold_until(std::int64_t at_ns) { free_ns_ = std::max(free_ns_, at_ns); }

  /// An error-passive transmitter has sent: it waits for longer than the others.
  void suspend(ControllerId id) { suspended_.insert(id); }
  /// Those of `contenders` that may begin a frame now. After it nobody is suspended any more.
  ControllerSet admit(const ControllerSet& contenders, std::int64_t now_ns) {
    ControllerSet admitted = contenders & members_;
    if (now_ns < suspended_until_ns()) admitted = admitted - suspended_;
    suspended_.clear();
    return admitted;
  }

  /// A start of frame, for those of `hearing` that are on this wire.
  void begin(const PendingFrame& frame, std::int64_t bit_ns, std::int64_t now_ns,
             const ControllerSet& transmitters, const ControllerSet& hearing) {
    phase_ = Phase::frame;
    current_ = frame;
    begin_ns_ = now_ns;
    bit_ns_ = bit_ns;
    failure_ns_ = never_ns;
    detectors_.clear();
    transmitters_ = transmitters;
    receivers_ = (hearing & members_) - transmitters;
  }
  /// Of several transmitters the one that goes on sends `frame`.
  void carry(const PendingFrame& frame) { current_ = frame; }
  /// A transmitter sees another bit than it sends, and no one sees its error flag.
  void drop_out(ControllerId id) {
    transmitters_.erase(id);
    suspended_.insert(id);
  }
  /// A receiver that has no part in the frame any more.
  void leave(ControllerId id) { receivers_.erase(id); }
  /// A transmitter that has gone. A frame without one ends in a stuff error.
  void abandon(ControllerId id, std::int64_t now_ns) {
    transmitters_.erase(id);
    if (!transmitters_.empty()) return;
    plan_failure(now_ns, BusErrorKind::stuff, no_controller);
    event_ns_ = failure_ns_;
  }
  /// Receivers have gone in the middle of a frame: perhaps nobody of `acknowledging` is left.
  void expect_acknowledgement(const ControllerSet& acknowledging, std::int64_t now_ns) {
    if (phase_ != Phase::frame || now_ns >= acknowledgement_ns()) return;
    if (!(receivers_ & acknowledging).empty()) return;
    plan_failure(acknowledgement_ns(), BusErrorKind::acknowledgement, no_controller);
    wake_at(failure_ns_);
  }

  /// An error that `detector` is going to see, or, where that is no_controller, the transmitters.
  /// The earliest counts; several may see one at the same time.
  void plan_failure(std::int64_t at_ns, BusErrorKind kind, ControllerId detector) {
    if (at_ns > failure_ns_) return;
    if (at_ns < failure_ns_) detectors_.clear();
    failure_ns_ = at_ns;
    failure_kind_ = kind;
    if (detector != no_controller) detectors_.insert(detector);
  }
  /// Another frame has come into this one: a bit error, now.
  void spoil() {
    failure_kind_ = BusErrorKind::bit;
    detectors_.clear();
  }
  bool will_be_acknowledged() const {
    return failure_ns_ == never_ns || failure_kind_ != BusErrorKind::acknowledgement;
  }
  BusErrorKind failure_kind() const { return failure_kind_; }
  /// The error that is detected now.
  BusError error(std::int64_t now_ns) const {
    return {.kind = failure_kind_,
            .sender = transmitters_.first(),
            .detector = detectors_.first(),
            .bit = static_cast<unsigned>((now_ns - begin_ns_) / bit_ns_),
            .frame = current_.frame};
  }

  /// Receivers have the frame when all but the last bit of the end of frame are seen.
  void await_delivery() { event_ns_ = std::min(failure_ns_, bit_end_ns(current_.bits - 1)); }
  void await_end() {
    phase_ = Phase::last_bit;
    event_ns_ = frame_end_ns();
  }
  /// The end of a frame that was good; then turn_idle().
  void end() {
    phase_ = Phase::ended;
    recessive_since_ns_ = acknowledgement_ns();
    occupy_until(bit_end_ns(current_.bits + intermission_bits));
  }
  void turn_idle() { phase_ = Phase::idle; }
  /// The end of a frame that was destroyed: an error flag from `detected_ns` on, in bits of
  /// `flag_bit_ns`, six more of those that see an error only in that flag, the error delimiter.
  void end_in_error(std::int64_t detected_ns, std::int64_t flag_bit_ns, bool is_echoed) {
    phase_ = Phase::idle;
    recessive_since_ns_ = detected_ns + error_flag_bits * flag_bit_ns;
    if (is_echoed) recessive_since_ns_ += error_flag_bits * bit_ns_;
    occupy_until(recessive_since_ns_ + (error_delimiter_bits + intermission_bits) * bit_ns_);
  }
  /// Who is cut off in the middle of a frame sees six recessive bits, sends an error flag, and
  /// waits for the delimiter.
  void hold_after_cut(std::int64_t now_ns) {
    constexpr unsigned bits = 6 + error_flag_bits + error_delimiter_bits + intermission_bits;
    hold_until(now_ns + bits * bit_ns_);
  }

  /// From now on these are on the wire. Others have no part in its frame any more.
  void connect(const ControllerSet& members) {
    members_ = members;
    transmitters_ = transmitters_ & members;
    receivers_ = receivers_ & members;
  }

 private:
  static constexpr unsigned error_flag_bits = 6;
  static constexpr unsigned error_delimiter_bits = 8;
  /// Recessive bits that an error-passive transmitter waits, beyond the intermission, before it
  /// sends again.
  static constexpr unsigned suspend_bits = 8;

  std::int64_t suspended_until_ns() const { return free_ns_ + suspend_bits * bit_ns_; }
  void occupy_until(std::int64_t free_ns) {
    free_ns_ = free_ns;
    load_.add(begin_ns_, free_ns_);
  }

  Phase phase_ = Phase::idle;
  BusErrorKind failure_kind_ = BusErrorKind::bit;
  ControllerSet members_{};
  ControllerSet transmitters_{};  // of the frame on the wire: one, or more that send the same
  ControllerSet receivers_{};     // of the frame on the wire
  ControllerSet suspended_{};
  ControllerSet detectors_{};

  PendingFrame current_{};
  std::int64_t bit_ns_ = 0;
  std::int64_t begin_ns_ = 0;           // of the start of frame
  std::int64_t event_ns_ = never_ns;    // what is due next
  std::int64_t start_ns_ = never_ns;    // while idle: of the next start of frame
  std::int64_t failure_ns_ = never_ns;  // when an error is going to be detected
  std::int64_t free_ns_ = 0;            // end of the intermission
  std::int64_t recessive_since_ns_ = 0;
  BusLoad load_;
};

}  // namespace canvoy
