// One piece of cable of the simulated bus and the frame on it. A bus has one, until its cable is
// cut.
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

/// Members, frame, next event, and load of the wire. It makes no decisions: transmitters and faults
/// are set from outside.
class SimulatedWire {
 public:
  /// The next event: a start of frame, reception of the frame, its end. During the notification of
  /// a transmitter about the end, the next event is not yet determined.
  enum class Phase : std::uint8_t { idle, frame, last_bit, ended };

  /// Makes an idle wire without members.
  SimulatedWire(std::int64_t bit_ns, std::int64_t load_window_ns, std::int64_t now_ns)
      : bit_ns_(bit_ns), free_ns_(now_ns), recessive_since_ns_(now_ns), load_(load_window_ns) {}

  /// What the wire is doing.
  Phase phase() const { return phase_; }
  /// True while a frame is on the wire.
  bool is_busy() const { return phase_ == Phase::frame || phase_ == Phase::last_bit; }
  /// Time of the next event.
  std::int64_t event_ns() const { return event_ns_; }
  /// True if a frame is due to begin, or an error to be detected.
  bool may_start(std::int64_t now_ns) const { return start_ns_ <= now_ns; }
  /// True if an error is to be detected by now.
  bool has_failed(std::int64_t now_ns) const { return failure_ns_ <= now_ns; }

  const ControllerSet& members() const { return members_; }  ///< with power or without
  /// Controllers that send the present or last frame; several send the same bits so far.
  const ControllerSet& transmitters() const { return transmitters_; }
  /// Members that take part in the frame as receivers.
  const ControllerSet& receivers() const { return receivers_; }
  /// Controllers that are error-passive and sent last: they let others go first.
  const ControllerSet& suspended() const { return suspended_; }
  /// Detectors of the coming error; none: the transmitters.
  const ControllerSet& detectors() const { return detectors_; }

  /// Frame on the wire.
  const PendingFrame& current() const { return current_; }
  std::int64_t bit_ns() const { return bit_ns_; }  ///< of this frame, or the last one
  /// End of a bit of the frame, counted from 1 at the start of frame.
  std::int64_t bit_end_ns(unsigned bit) const { return begin_ns_ + bit * bit_ns_; }
  /// End of the last bit of the end of frame.
  std::int64_t frame_end_ns() const { return bit_end_ns(current_.bits); }
  /// Acknowledgement slot, in which the transmitter detects whether a controller has received the
  /// frame.
  std::int64_t acknowledgement_ns() const {
    return bit_end_ns(current_.bits - bits_after_acknowledgement);
  }
  /// Time since which the wire is recessive, or from which it will be.
  std::int64_t recessive_since_ns() const { return recessive_since_ns_; }
  /// Load of the wire, as its members see it.
  const BusLoad& load() const { return load_; }

  /// While idle: makes the first of `ready` begin as soon as allowed.
  void await_start(const ControllerSet& ready, std::int64_t now_ns) {
    start_ns_ = never_ns;
    if (!ready.empty()) {
      const bool are_suspended = (ready - suspended_).empty();
      start_ns_ = std::max(are_suspended ? suspended_until_ns() : free_ns_, now_ns);
    }
    event_ns_ = start_ns_;
  }
  /// Sets the next event to that time at the latest.
  void wake_at(std::int64_t at_ns) { event_ns_ = std::min(event_ns_, at_ns); }
  /// Delays the next frame to that time or later.
  void hold_until(std::int64_t at_ns) { free_ns_ = std::max(free_ns_, at_ns); }

  /// Makes an error-passive transmitter wait for longer than the others after its frame.
  void suspend(ControllerId id) { suspended_.insert(id); }
  /// Members of `contenders` that may begin a frame at `now_ns`. Afterwards no controller is
  /// suspended.
  ControllerSet admit(const ControllerSet& contenders, std::int64_t now_ns) {
    ControllerSet admitted = contenders & members_;
    if (now_ns < suspended_until_ns()) admitted = admitted - suspended_;
    suspended_.clear();
    return admitted;
  }

  /// Begins a frame, for the members of `hearing` on this wire.
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
  /// Sets the frame of the transmitter that continues, of several.
  void carry(const PendingFrame& frame) { current_ = frame; }
  /// Removes a transmitter that reads another bit than it sends, with an error flag that no other
  /// controller sees.
  void drop_out(ControllerId id) {
    transmitters_.erase(id);
    suspended_.insert(id);
  }
  /// Removes a receiver from the frame.
  void leave(ControllerId id) { receivers_.erase(id); }
  /// Removes a transmitter that is gone. A frame without one ends in a stuff error.
  void abandon(ControllerId id, std::int64_t now_ns) {
    transmitters_.erase(id);
    if (!transmitters_.empty()) return;
    plan_failure(now_ns, BusErrorKind::stuff, no_controller);
    event_ns_ = failure_ns_;
  }
  /// Handles receivers that left during a frame: there may be none of `acknowledging` left.
  void expect_acknowledgement(const ControllerSet& acknowledging, std::int64_t now_ns) {
    if (phase_ != Phase::frame || now_ns >= acknowledgement_ns()) return;
    if (!(receivers_ & acknowledging).empty()) return;
    plan_failure(acknowledgement_ns(), BusErrorKind::acknowledgement, no_controller);
    wake_at(failure_ns_);
  }

  /// Plans an error that `detector` will detect, or, if that is no_controller, the transmitters.
  /// The earliest counts; several may detect one at the same time.
  void plan_failure(std::int64_t at_ns, BusErrorKind kind, ControllerId detector) {
    if (at_ns > failure_ns_) return;
    if (at_ns < failure_ns_) detectors_.clear();
    failure_ns_ = at_ns;
    failure_kind_ = kind;
    if (detector != no_controller) detectors_.insert(detector);
  }
  /// Makes the frame fail at once with a bit error, since another frame has met it.
  void spoil() {
    failure_kind_ = BusErrorKind::bit;
    detectors_.clear();
  }
  /// False if the planned error is a missing acknowledgement.
  bool will_be_acknowledged() const {
    return failure_ns_ == never_ns || failure_kind_ != BusErrorKind::acknowledgement;
  }
  /// Kind of the planned error; meaningless if none is planned.
  BusErrorKind failure_kind() const { return failure_kind_; }
  /// Error that is detected at `now_ns`.
  BusError error(std::int64_t now_ns) const {
    return {.kind = failure_kind_,
            .sender = transmitters_.first(),
            .detector = detectors_.first(),
            .bit = static_cast<unsigned>((now_ns - begin_ns_) / bit_ns_),
            .frame = current_.frame};
  }

  /// Waits for delivery: receivers have the frame when all but the last bit of the end of frame are
  /// seen.
  void await_delivery() { event_ns_ = std::min(failure_ns_, bit_end_ns(current_.bits - 1)); }
  /// Waits for the end of the last bit of the frame.
  void await_end() {
    phase_ = Phase::last_bit;
    event_ns_ = frame_end_ns();
  }
  /// Ends a good frame; turn_idle() follows.
  void end() {
    phase_ = Phase::ended;
    recessive_since_ns_ = acknowledgement_ns();
    occupy_until(bit_end_ns(current_.bits + intermission_bits));
  }
  /// Ends the notification of the end of a frame.
  void turn_idle() { phase_ = Phase::idle; }
  /// Ends a destroyed frame: an error flag from `detected_ns` on, in bits of `flag_bit_ns`, six
  /// more of controllers that see an error only in that flag, the error delimiter.
  void end_in_error(std::int64_t detected_ns, std::int64_t flag_bit_ns, bool is_echoed) {
    phase_ = Phase::idle;
    recessive_since_ns_ = detected_ns + error_flag_bits * flag_bit_ns;
    if (is_echoed) recessive_since_ns_ += error_flag_bits * bit_ns_;
    occupy_until(recessive_since_ns_ + (error_delimiter_bits + intermission_bits) * bit_ns_);
  }
  /// Delays a piece that was cut off during a frame: its controllers see six recessive bits, send
  /// an error flag, and wait for the delimiter.
  void hold_after_cut(std::int64_t now_ns) {
    constexpr unsigned bits = 6 + error_flag_bits + error_delimiter_bits + intermission_bits;
    hold_until(now_ns + bits * bit_ns_);
  }

  /// Sets the members. Others have no further part in the frame.
  void connect(const ControllerSet& members) {
    members_ = members;
    transmitters_ = transmitters_ & members;
    receivers_ = receivers_ & members;
  }

 private:
  static constexpr unsigned error_flag_bits = 6;
  static constexpr unsigned error_delimiter_bits = 8;
  /// Number of recessive bits that an error-passive transmitter waits, beyond the intermission,
  /// before it sends again.
  static constexpr unsigned suspend_bits = 8;

  std::int64_t suspended_until_ns() const { return free_ns_ + suspend_bits * bit_ns_; }
  void occupy_until(std::int64_t free_ns) {
    free_ns_ = free_ns;
    load_.add(begin_ns_, free_ns_);
  }

  Phase phase_ = Phase::idle;
  BusErrorKind failure_kind_ = BusErrorKind::bit;
  ControllerSet members_{};
  ControllerSet transmitters_{};  // of the frame on the wire: one, or several that send the same
  ControllerSet receivers_{};     // of the frame on the wire
  ControllerSet suspended_{};
  ControllerSet detectors_{};

  PendingFrame current_{};
  std::int64_t bit_ns_ = 0;
  std::int64_t begin_ns_ = 0;           // of the start of frame
  std::int64_t event_ns_ = never_ns;    // time of the next event
  std::int64_t start_ns_ = never_ns;    // while idle: of the next start of frame
  std::int64_t failure_ns_ = never_ns;  // time at which an error will be detected
  std::int64_t free_ns_ = 0;            // end of the intermission
  std::int64_t recessive_since_ns_ = 0;
  BusLoad load_;
};

}  // namespace canvoy
