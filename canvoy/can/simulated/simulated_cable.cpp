// The cable of the simulated bus and its pieces when it is cut; what befalls single nodes: power,
// bit rate, babbling; and the faults that the options ask for.
#include <algorithm>
#include <array>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/arbitration.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"

namespace canvoy {
namespace {

/// Who is cut off in the middle of a frame sees six recessive bits, sends an error flag, and waits
/// for the delimiter.
constexpr unsigned bits_after_cut = 6 + 6 + 8 + intermission_bits;

bool is_in(const ControllerSet& piece, ControllerId id) {
  return id != no_controller && piece.contains(id);
}

}  // namespace

void SimulatedBus::cut_cable(ControllerId after) {
  cut_after_.insert(at(after).id);
  rewire();
}

void SimulatedBus::mend_cable() {
  cut_after_.clear();
  rewire();
}

void SimulatedBus::unplug(ControllerId id) {
  at(id).is_plugged = false;
  rewire();
}

void SimulatedBus::plug(ControllerId id) {
  at(id).is_plugged = true;
  rewire();
}

/// Gives each piece of the cable a wire.
void SimulatedBus::rewire() {
  PerPiece<ControllerSet> storage;
  const std::span<const ControllerSet> pieces(storage.data(), list_pieces(storage));
  fail_frames_that_meet(pieces);

  PerPiece<Wire*> wire_of{};
  assign_wires(pieces, wire_of);
  ControllerSet receiving;
  for (const Wire& wire : wires_) {
    if (wire.is_busy()) receiving = receiving | wire.receivers;
  }
  ControllerSet interrupted;
  wires_used_ = 1;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    interrupted = interrupted | (occupy(*wire_of[i], pieces[i]) & receiving);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Wire& wire = *wire_of[i];
    if (!(wire.members & interrupted).empty()) {
      wire.free_ns = std::max(wire.free_ns, now_ns_ + bits_after_cut * wire.bit_ns);
    }
    schedule(wire);
  }
  interrupted.for_each([this](ControllerId id) { count_receive_error(controllers_[id], false); });
}

/// The cable from its beginning to its end; each controller that is not plugged in is a piece of
/// its own.
std::size_t SimulatedBus::list_pieces(std::span<ControllerSet> pieces) const {
  std::size_t count = 0;
  ControllerSet piece;
  for (std::size_t i = 0; i < controller_count_; ++i) {
    const ControllerId id = controllers_[i].id;
    if (controllers_[i].is_plugged) {
      piece.insert(id);
    } else {
      pieces[count++].insert(id);
    }
    const bool ends_here = i + 1 == controller_count_ || cut_after_.contains(id);
    if (!ends_here || piece.empty()) continue;
    pieces[count++] = piece;
    piece.clear();
  }
  return count;
}

/// Where pieces come together on which frames are under way, none of these is whole.
void SimulatedBus::fail_frames_that_meet(std::span<const ControllerSet> pieces) {
  for (const ControllerSet& piece : pieces) {
    const auto is_busy_here = [&](const Wire& wire) {
      return wire.is_busy() && is_in(piece, wire.transmitters.first());
    };
    if (std::count_if(wires_.begin(), wires_.end(), is_busy_here) < 2) continue;
    for (Wire& wire : wires_) {
      if (!is_busy_here(wire)) continue;
      wire.failure_kind = BusErrorKind::bit;
      wire.detectors.clear();
      fail(wire);
    }
  }
}

/// A frame under way stays with its transmitter; the wire without a frame goes on with the first of
/// its controllers. What is left starts afresh on a wire that nobody uses.
void SimulatedBus::assign_wires(std::span<const ControllerSet> pieces, PerPiece<Wire*>& wire_of) {
  ControllerSet taken;  // by number of the wire
  const auto take = [&](std::size_t piece, Wire& wire) {
    if (wire_of[piece] != nullptr || taken.contains(number_of(wire))) return false;
    wire_of[piece] = &wire;
    taken.insert(number_of(wire));
    return true;
  };
  for (const bool with_frame : {true, false}) {
    for (Wire& wire : wires_) {
      if (wire.is_busy() != with_frame) continue;
      const ControllerId heir = with_frame ? wire.transmitters.first() : wire.members.first();
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (is_in(pieces[i], heir)) take(i, wire);
      }
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (Wire& wire : wires_) {
      if (take(i, wire)) clear(wire);
    }
  }
  for (Wire& wire : wires_) {
    if (!taken.contains(number_of(wire))) clear(wire);
  }
}

void SimulatedBus::clear(Wire& wire) {
  wire = {.bit_ns = wires_[0].bit_ns,
          .free_ns = now_ns_,
          .recessive_since_ns = now_ns_,
          .load = BusLoad(to_ns(Time(options_.load_window)))};
}

/// Puts the controllers of a piece on a wire. The answer is those that come from another wire.
ControllerSet SimulatedBus::occupy(Wire& wire, const ControllerSet& piece) {
  const ControllerId number = number_of(wire);
  wires_used_ = std::max<std::size_t>(wires_used_, number + std::size_t{1});
  ControllerSet newcomers;
  piece.for_each([&](ControllerId id) {
    if (controllers_[id].wire != number) newcomers.insert(id);
    controllers_[id].wire = number;
  });
  if (wire.is_busy()) {
    (wire.transmitters - piece).for_each([this](ControllerId id) {
      controllers_[id].to_send.unlock();
    });
  }
  wire.members = piece;
  wire.transmitters = wire.transmitters & piece;
  wire.receivers = wire.receivers & piece;
  expect_acknowledgement(wire);
  return newcomers;
}

/// Receivers have gone in the middle of a frame: perhaps there is nobody left.
void SimulatedBus::expect_acknowledgement(Wire& wire) {
  if (wire.phase != Wire::Phase::frame || now_ns_ >= wire.acknowledgement_ns()) return;
  if (!(wire.receivers & acknowledging_).empty()) return;
  wire.plan_failure(wire.acknowledgement_ns(), BusErrorKind::acknowledgement, no_controller);
  wire.event_ns = std::min(wire.event_ns, wire.failure_ns);
}

/// A node loses its part in the frame that is on the wire. A frame without a transmitter ends in a
/// stuff error.
void SimulatedBus::leave_frame(Controller& controller) {
  Wire& wire = wires_[controller.wire];
  if (!wire.is_busy()) return;
  wire.receivers.erase(controller.id);
  expect_acknowledgement(wire);
  if (!wire.transmitters.contains(controller.id)) return;
  wire.transmitters.erase(controller.id);
  if (!controller.is_sending_babble) controller.to_send.unlock();
  if (!wire.transmitters.empty()) return;
  wire.plan_failure(now_ns_, BusErrorKind::stuff, no_controller);
  wire.event_ns = wire.failure_ns;
}

void SimulatedBus::power(ControllerId id, bool on) {
  Controller& controller = at(id);
  if (controller.is_powered == on) return;
  leave_frame(controller);
  controller.is_powered = on;
  controller.to_send.unlock();
  controller.to_send.clear();
  controller.received.clear();
  controller.counters.restart();
  controller.state = BusState::error_active;
  controller.has_overrun = false;
  recovering_.erase(id);
  to_tell_.erase(id);
  refresh(controller);
}

void SimulatedBus::set_bit_rate(ControllerId id, std::uint32_t bit_rate) {
  Controller& controller = at(id);
  leave_frame(controller);
  controller.bit_ns = bit_time_ns(bit_rate == 0 ? options_.bit_rate : bit_rate);
  const std::span<const Controller> all(controllers_.data(), controller_count_);
  has_mixed_rates_ = std::any_of(all.begin(), all.end(), [&](const Controller& other) {
    return other.bit_ns != controller.bit_ns;
  });
}

void SimulatedBus::set_listen_only(ControllerId id, bool on) {
  Controller& controller = at(id);
  if (on) leave_frame(controller);
  controller.is_listen_only = on;
  refresh(controller);
}

void SimulatedBus::babble(ControllerId id, const Frame& frame) {
  Controller& controller = at(id);
  controller.babble = {frame, arbitration_key(frame), frame_bits(frame)};
  controller.is_babbling = true;
  refresh(controller);
}

void SimulatedBus::stop_babbling(ControllerId id) {
  at(id).is_babbling = false;
  refresh(at(id));
}

void SimulatedBus::apply_fault() {
  const CableCut& cut = options_.faults.cable_cut;
  const Babbling& babbling = options_.faults.babbling;
  const auto is_due = [this](Time time) { return to_ns(time) == fault_ns_; };
  const auto is_attached = [this](ControllerId id) { return id < controller_count_; };
  if (is_attached(cut.after)) {
    if (is_due(cut.from)) cut_cable(cut.after);
    if (is_due(cut.until)) mend_cable();
  }
  if (is_attached(babbling.controller)) {
    if (is_due(babbling.from)) babble(babbling.controller, babbling.frame);
    if (is_due(babbling.until)) stop_babbling(babbling.controller);
  }
  fault_ns_ = next_fault_after(fault_ns_);
}

std::int64_t SimulatedBus::next_fault_after(std::int64_t ns) const {
  std::int64_t next_ns = never_ns;
  const BusFaults& faults = options_.faults;
  for (const Time time : {faults.cable_cut.from, faults.cable_cut.until, faults.babbling.from,
                          faults.babbling.until}) {
    if (to_ns(time) > ns) next_ns = std::min(next_ns, to_ns(time));
  }
  return next_ns;
}

}  // namespace canvoy
