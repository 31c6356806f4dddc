// What may go wrong on a simulated bus: a plain struct of options. With the seed of the bus it
// decides every failure.
//
//     BusFaults faults{.frame_error_probability = 0.001,
//                      .cable_cut = {.after = 3, .from = Time(20min), .until = Time(21min)}};
//
// Faults of one controller (a foreign bit rate, a drifting clock, an input that reads bits wrongly)
// are options of the controller. Two nodes with one node-ID are simply two controllers whose nodes
// send the same identifiers.
#pragma once

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// The cable is cut between controller `after` and the next one, and mended at `until`.
struct CableCut {
  ControllerId after = no_controller;
  Time from = never;
  Time until = never;
};

/// A node that sends `frame` again and again, as fast as the bus lets it.
struct Babbling {
  ControllerId controller = no_controller;
  Frame frame{};
  Time from = never;
  Time until = never;
};

/// All are absent by default.
struct BusFaults {
  /// Share of the frames (0 to 1) that a disturbance destroys for all, in a bit chosen at random.
  double frame_error_probability = 0.0;
  /// Probability (0 to 1) that a bit of a frame is disturbed for all.
  double bit_error_rate = 0.0;
  CableCut cable_cut{};
  Babbling babbling{};
};

}  // namespace canvoy
