// The cable of the simulated bus: one wire for each piece that it has fallen into, and who is on
// which.
//
//     SimulatedCable cable(127, bit_time_ns(125'000), to_ns(Time(1s)));
//     cable.layout().cut(3);
//     cable.frames_that_meet().for_each([&](ControllerId number) { fail(cable.wires()[number]); });
//     Rewired rewired = cable.rewire(now_ns);
//
// After a change of its layout: frames_that_meet(), which end in an error each, then rewire().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/can/simulated/cable_layout.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/simulated_wire.hpp"

namespace canvoy {

/// Who has noticed that the cable lies otherwise.
struct Rewired {
  ControllerSet interrupted{};  ///< were receiving a frame, and have gone from its wire
  ControllerSet cut_off{};      ///< sent a frame that goes on without them
};

/// It allocates in the constructor only.
class SimulatedCable {
 public:
  SimulatedCable(std::size_t controllers_max, std::int64_t bit_ns, std::int64_t load_window_ns)
      : wires_(controllers_max, SimulatedWire(bit_ns, load_window_ns, 0)),
        load_window_ns_(load_window_ns) {}

  CableLayout& layout() { return layout_; }

  SimulatedWire& wire_of(ControllerId id) { return wires_[wire_of_[id]]; }
  const SimulatedWire& wire_of(ControllerId id) const { return wires_[wire_of_[id]]; }
  /// Those in use; there may be one among them with nobody on it.
  std::span<SimulatedWire> wires() { return std::span(wires_).first(used_); }
  /// Whether it was never cut, or is mended on its first wire.
  bool is_one_wire() const { return used_ == 1; }

  /// The wire on which something happens next.
  SimulatedWire& earliest() { return is_one_wire() ? wires_.front() : earliest_of_pieces(); }
  /// When that is.
  std::int64_t next_event_ns() const {
    return is_one_wire() ? wires_.front().event_ns() : next_event_of_pieces_ns();
  }

  /// Where pieces come together on which frames are under way, none of these is whole: their wires,
  /// by number in wires().
  ControllerSet frames_that_meet() const;
  /// Gives each piece of the layout a wire.
  Rewired rewire(std::int64_t now_ns);

 private:
  using WireNumber = std::uint8_t;
  static constexpr WireNumber no_wire = no_controller;
  using WireOfPiece = std::array<WireNumber, ControllerSet::capacity>;

  SimulatedWire& earliest_of_pieces();
  std::int64_t next_event_of_pieces_ns() const;
  void assign_wires(std::span<const ControllerSet> pieces, WireOfPiece& wire_of,
                    std::int64_t now_ns);
  void clear(SimulatedWire& wire, std::int64_t now_ns);

  std::vector<SimulatedWire> wires_;  // one for each piece that the cable can fall into
  std::size_t used_ = 1;
  std::array<WireNumber, ControllerSet::capacity> wire_of_{};
  CableLayout layout_{};
  std::int64_t load_window_ns_ = 0;
};

}  // namespace canvoy
