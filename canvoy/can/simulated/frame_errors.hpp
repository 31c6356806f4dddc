// The errors of a frame on the simulated bus: disturbances of the cable, controllers that misread
// or have another bit rate, missing acknowledgement.
//
//     FrameErrors errors(options.seed, options.faults);
//     errors.disturb(1, 17);                                  // the next frame, in its 17th bit
//     deaf = errors.plan(wire, participants, bit_times);      // at each start of frame
//
// An error is decided at the start of a frame, as the bit at the end of which a controller detects
// it. All randomness comes from the seed: the same calls in the same order give the same errors.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/simulated/bit_times.hpp"
#include "canvoy/can/simulated/bus_faults.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/participants.hpp"
#include "canvoy/can/simulated/simulated_wire.hpp"

namespace canvoy {

/// The errors. Allocates in the constructor only.
class FrameErrors {
 public:
  /// Makes the errors. The probabilities are those of `faults`; its cable cut and babbling are not
  /// used.
  FrameErrors(std::uint64_t seed, const BusFaults& faults);

  /// Sets the share of the others' frames that this controller alone sees disturbed.
  void set_misreading(ControllerId id, Probability probability) {
    misreading_.assign(id, !probability.is_zero());
    misread_[id] = probability;
  }
  /// Destroys the next `frames` frames, in this bit, counted from 1.
  void disturb(std::uint32_t frames, unsigned bit);
  /// Sets the share of the frames that a disturbance destroys for all.
  void set_frame_error_probability(Probability probability);

  /// Plans the first error of the frame that has begun on the wire. Returns the controllers that
  /// have no part in it and cannot destroy it for the others: each counts a receive error.
  ControllerSet plan(SimulatedWire& wire, const Participants& who, const BitTimes& bit_times) {
    ControllerSet deaf;
    if (bit_times.are_mixed()) deaf = plan_foreign_rates(wire, who, bit_times);
    if (!misreading_.empty()) deaf = deaf | plan_misreading(wire, who);
    if ((wire.receivers() & who.acknowledging()).empty()) plan_missing_acknowledgement(wire, who);
    if (has_disturbances_) plan_disturbance(wire);
    return deaf;
  }

 private:
  static ControllerSet plan_foreign_rates(SimulatedWire& wire, const Participants& who,
                                          const BitTimes& bit_times);
  ControllerSet plan_misreading(SimulatedWire& wire, const Participants& who);
  static void plan_missing_acknowledgement(SimulatedWire& wire, const Participants& who);
  void plan_disturbance(SimulatedWire& wire);

  Random random_;
  Probability frame_error_;
  std::vector<std::uint64_t> bit_error_by_;  // threshold of an error in one of the first n bits
  std::uint32_t disturbances_left_ = 0;      // by disturb()
  unsigned disturbed_bit_ = 1;
  bool has_disturbances_ = false;
  ControllerSet misreading_{};
  std::array<Probability, ControllerSet::capacity> misread_{};
};

}  // namespace canvoy
