// Faults of a simulated bus: a plain struct of options. Together with the seed of the bus it
// determines every failure.
//
//     BusFaults faults{.frame_error_probability = 0.001,
//                      .cable_cut = {.after = 3, .from = Time(20min), .until = Time(21min)}};
//
// Faults of one controller (a different bit rate, a drifting clock, an input that misreads bits)
// are options of the controller. Two nodes with one node-ID are two controllers with nodes that
// send the same identifiers.
#pragma once

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// A cut of the cable between controller `after` and the next one, mended at `until`.
struct CableCut {
  ControllerId after = no_controller;  ///< no_controller: no cut
  Time from = never;                   ///< begin of the cut
  Time until = never;                  ///< end of the cut; never: it stays
};

/// A node that sends `frame` again and again, as fast as the bus allows.
struct Babbling {
  ControllerId controller = no_controller;  ///< no_controller: none
  Frame frame{};                            ///< sent beside its queued frames
  Time from = never;                        ///< begin
  Time until = never;                       ///< end; never: it goes on
};

/// Faults, all absent by default.
struct BusFaults {
  /// Share of the frames (0 to 1) that a disturbance destroys for all, in a random bit.
  double frame_error_probability = 0.0;
  /// Probability (0 to 1) that a bit of a frame is disturbed for all.
  double bit_error_rate = 0.0;
  CableCut cable_cut{};  ///< at most one
  Babbling babbling{};   ///< at most one
};

}  // namespace canvoy
