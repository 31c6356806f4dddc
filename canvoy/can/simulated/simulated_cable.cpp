#include "canvoy/can/simulated/simulated_cable.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {
namespace {

bool is_in(const ControllerSet& piece, ControllerId id) {
  return id != no_controller && piece.contains(id);
}

}  // namespace

SimulatedWire& SimulatedCable::earliest_of_pieces() {
  SimulatedWire* earliest = &wires_.front();
  for (SimulatedWire& wire : wires()) {
    if (wire.event_ns() < earliest->event_ns()) earliest = &wire;
  }
  return *earliest;
}

std::int64_t SimulatedCable::next_event_of_pieces_ns() const {
  std::int64_t next_ns = never_ns;
  for (std::size_t i = 0; i < used_; ++i) next_ns = std::min(next_ns, wires_[i].event_ns());
  return next_ns;
}

ControllerSet SimulatedCable::frames_that_meet() const {
  CableLayout::Pieces storage;
  ControllerSet meeting;
  for (const ControllerSet& piece : layout_.pieces(storage)) {
    ControllerSet busy_here;
    for (std::size_t i = 0; i < used_; ++i) {
      const bool is_here = wires_[i].is_busy() && is_in(piece, wires_[i].transmitters().first());
      busy_here.assign(static_cast<WireNumber>(i), is_here);
    }
    if (busy_here.has_several()) meeting = meeting | busy_here;
  }
  return meeting;
}

Rewired SimulatedCable::rewire(std::int64_t now_ns) {
  CableLayout::Pieces storage;
  const std::span<const ControllerSet> pieces = layout_.pieces(storage);
  WireOfPiece wire_of;
  assign_wires(pieces, wire_of, now_ns);

  ControllerSet receiving;
  for (const SimulatedWire& wire : wires()) {
    if (wire.is_busy()) receiving = receiving | wire.receivers();
  }
  Rewired rewired;
  used_ = 1;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const WireNumber number = wire_of[i];
    check_invariant(number < wires_.size());
    SimulatedWire& wire = wires_[number];
    used_ = std::max(used_, number + std::size_t{1});
    if (wire.is_busy()) rewired.cut_off = rewired.cut_off | (wire.transmitters() - pieces[i]);
    pieces[i].for_each([&](ControllerId id) {
      if (wire_of_[id] != number && receiving.contains(id)) rewired.interrupted.insert(id);
      wire_of_[id] = number;
    });
    wire.connect(pieces[i]);
  }
  return rewired;
}

/// A frame in progress stays with its transmitter; the wire without a frame continues with the
/// first of its controllers. The others start again on an unused wire.
void SimulatedCable::assign_wires(std::span<const ControllerSet> pieces, WireOfPiece& wire_of,
                                  std::int64_t now_ns) {
  wire_of.fill(no_wire);
  ControllerSet taken;  // by number of the wire
  const auto take = [&](std::size_t piece, WireNumber number) {
    if (wire_of[piece] != no_wire || taken.contains(number)) return false;
    wire_of[piece] = number;
    taken.insert(number);
    return true;
  };
  const WireNumber used = static_cast<WireNumber>(used_);
  for (const bool with_frame : {true, false}) {
    for (WireNumber number = 0; number < used; ++number) {
      const SimulatedWire& wire = wires_[number];
      if (wire.is_busy() != with_frame) continue;
      const ControllerId heir = with_frame ? wire.transmitters().first() : wire.members().first();
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (is_in(pieces[i], heir)) take(i, number);
      }
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (WireNumber number = 0; wire_of[i] == no_wire; ++number) {
      if (take(i, number)) clear(wires_[number], now_ns);
    }
  }
  for (WireNumber number = 0; number < used; ++number) {
    if (!taken.contains(number)) clear(wires_[number], now_ns);
  }
}

void SimulatedCable::clear(SimulatedWire& wire, std::int64_t now_ns) {
  wire = SimulatedWire(wires_.front().bit_ns(), load_window_ns_, now_ns);
}

}  // namespace canvoy
