#include "canvoy/can/simulated/frame_errors.hpp"

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"

namespace canvoy {
namespace {

constexpr unsigned stuff_error_bits = 6;  // this number of equal bits is an error

/// For each n, the threshold of an error in one of the first n bits. In integers, so that it is the
/// same on every platform.
void fill_bit_errors(std::vector<std::uint64_t>& by_bit, Probability rate) {
  std::uint64_t unharmed = ~std::uint64_t{0};
  for (std::uint64_t& threshold : by_bit) {
    threshold = ~unharmed;
    const std::uint64_t high = (unharmed >> 32) * (rate.threshold() >> 32);
    const std::uint64_t low = ((unharmed >> 32) * (rate.threshold() & 0xFFFF'FFFF)) >> 32;
    unharmed -= std::min(unharmed, high + low);
  }
}

}  // namespace

FrameErrors::FrameErrors(std::uint64_t seed, const BusFaults& faults)
    : random_(seed), frame_error_(faults.frame_error_probability) {
  const Probability bit_error_rate(faults.bit_error_rate);
  if (!bit_error_rate.is_zero()) {
    bit_error_by_.resize(frame_bits_max + 1);
    fill_bit_errors(bit_error_by_, bit_error_rate);
  }
  has_disturbances_ = !frame_error_.is_zero() || !bit_error_by_.empty();
}

void FrameErrors::disturb(std::uint32_t frames, unsigned bit) {
  disturbances_left_ = frames;
  disturbed_bit_ = std::max(bit, 1U);
  has_disturbances_ = true;
}

void FrameErrors::set_frame_error_probability(Probability probability) {
  frame_error_ = probability;
  has_disturbances_ = true;
}

/// A controller with another bit rate cannot receive the frame. It is modelled to see six equal
/// bits in the first six bit times, its own or those of the sender, whichever are longer; at the
/// latest it destroys the acknowledgement.
ControllerSet FrameErrors::plan_foreign_rates(SimulatedWire& wire, const Participants& who,
                                              const BitTimes& bit_times) {
  ControllerSet deaf;
  const ControllerSet hearing = wire.members() & who.hearing();
  bit_times.other_than(wire.bit_ns(), hearing).for_each([&](ControllerId id) {
    wire.leave(id);
    if (!who.acknowledging().contains(id)) return;
    const std::int64_t longer_ns = std::max(bit_times.of(id), wire.bit_ns());
    const std::int64_t seen_ns = wire.bit_end_ns(0) + stuff_error_bits * longer_ns;
    const bool is_sending = wire.transmitters().contains(id);
    if (is_sending || who.flagging().contains(id)) {
      wire.plan_failure(std::min(seen_ns, wire.acknowledgement_ns()),
                        is_sending ? BusErrorKind::bit : BusErrorKind::stuff, id);
    } else {
      deaf.insert(id);
    }
  });
  return deaf;
}

/// A controller that misreads a frame destroys it for all, unless it is error-passive or only
/// listens: then the frame is missing there only.
ControllerSet FrameErrors::plan_misreading(SimulatedWire& wire, const Participants& who) {
  ControllerSet deaf;
  (wire.receivers() & misreading_).for_each([&](ControllerId id) {
    if (!random_.happens(misread_[id])) return;
    const unsigned bit = 1 + random_.below(wire.current().bits - 1);
    if (who.flagging().contains(id)) {
      wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::stuff, id);
      return;
    }
    wire.leave(id);
    deaf.assign(id, who.acknowledging().contains(id));
  });
  return deaf;
}

/// The error flag of an error-passive transmitter is recessive, as the end of a frame is: a
/// controller that only listens has the frame before the failure is over.
void FrameErrors::plan_missing_acknowledgement(SimulatedWire& wire, const Participants& who) {
  const bool is_unseen =
      !wire.receivers().empty() && (wire.transmitters() & who.flagging()).empty();
  wire.plan_failure(is_unseen ? wire.frame_end_ns() : wire.acknowledgement_ns(),
                    BusErrorKind::acknowledgement, no_controller);
}

void FrameErrors::plan_disturbance(SimulatedWire& wire) {
  const unsigned bits = wire.current().bits;
  const auto hit = [&wire](unsigned bit) {
    wire.plan_failure(wire.bit_end_ns(bit), BusErrorKind::bit, no_controller);
  };
  if (disturbances_left_ > 0) {
    --disturbances_left_;
    hit(std::min(disturbed_bit_, bits));
  }
  if (random_.happens(frame_error_)) hit(1 + random_.below(bits));
  if (bit_error_by_.empty()) return;
  const std::uint64_t drawn = random_.next();
  if (drawn >= bit_error_by_[bits]) return;
  const auto first = std::upper_bound(bit_error_by_.begin(), bit_error_by_.end(), drawn);
  hit(static_cast<unsigned>(first - bit_error_by_.begin()));
}

}  // namespace canvoy
