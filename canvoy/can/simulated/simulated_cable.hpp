// The cable of the simulated bus: one wire for each of its pieces, and the controllers on each
// wire.
//
//     SimulatedCable cable(127, bit_time_ns(125'000), to_ns(Time(1s)));
//     cable.layout().cut(3);
//     cable.frames_that_meet().for_each([&](ControllerId number) { fail(cable.wires()[number]); });
//     Rewired rewired = cable.rewire(now_ns);
//
// After a change of its layout: frames_that_meet(), each of which ends in an error, then rewire().
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

/// Controllers affected by a change of the layout.
struct Rewired {
  ControllerSet interrupted{};  ///< were receiving a frame, and have left its wire
  ControllerSet cut_off{};      ///< sent a frame that continues without them
};

/// The cable. Allocates in the constructor only.
class SimulatedCable {
 public:
  /// Makes a cable in one piece; memory for `controllers_max` wires.
  SimulatedCable(std::size_t controllers_max, std::int64_t bit_ns, std::int64_t load_window_ns)
      : wires_(controllers_max, SimulatedWire(bit_ns, load_window_ns, 0)),
        load_window_ns_(load_window_ns) {}

  /// Layout, to be changed before rewire().
  CableLayout& layout() { return layout_; }

  /// Wire that a controller is on.
  SimulatedWire& wire_of(ControllerId id) { return wires_[wire_of_[id]]; }
  /// Wire that a controller is on.
  const SimulatedWire& wire_of(ControllerId id) const { return wires_[wire_of_[id]]; }
  /// Wires in use; one of them may have no controller.
  std::span<SimulatedWire> wires() { return std::span(wires_).first(used_); }
  /// True if it was never cut, or is mended on its first wire.
  bool is_one_wire() const { return used_ == 1; }

  /// Wire with the next event.
  SimulatedWire& earliest() { return is_one_wire() ? wires_.front() : earliest_of_pieces(); }
  /// Time of that event.
  std::int64_t next_event_ns() const {
    return is_one_wire() ? wires_.front().event_ns() : next_event_of_pieces_ns();
  }

  /// Wires, by number in wires(), with frames in progress on pieces that come together: none of
  /// these frames is complete.
  ControllerSet frames_that_meet() const;
  /// Assigns a wire to each piece of the layout.
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

  std::vector<SimulatedWire> wires_;  // one for each possible piece of the cable
  std::size_t used_ = 1;
  std::array<WireNumber, ControllerSet::capacity> wire_of_{};
  CableLayout layout_{};
  std::int64_t load_window_ns_ = 0;
};

}  // namespace canvoy
