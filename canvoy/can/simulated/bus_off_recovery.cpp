#include "canvoy/can/simulated/bus_off_recovery.hpp"

#include <algorithm>

#include "canvoy/can/simulated/wire_time.hpp"

namespace canvoy {

std::int64_t BusOffRecovery::end_ns(ControllerId id, std::int64_t recessive_since_ns,
                                    const BitTimes& bit_times) const {
  const Progress& progress = progress_[id];
  const std::int64_t from_ns = std::max(recessive_since_ns, progress.counted_to_ns);
  return from_ns + progress.sequences_left * sequence_bits * bit_times.of(id);
}

std::int64_t BusOffRecovery::next_ns(const ControllerSet& members, std::int64_t recessive_since_ns,
                                     const BitTimes& bit_times) const {
  std::int64_t next_ns = never_ns;
  (recovering_ & members).for_each([&](ControllerId id) {
    next_ns = std::min(next_ns, end_ns(id, recessive_since_ns, bit_times));
  });
  return next_ns;
}

void BusOffRecovery::interrupt(const ControllerSet& members, std::int64_t recessive_since_ns,
                               std::int64_t now_ns, const BitTimes& bit_times) {
  (recovering_ & members).for_each([&](ControllerId id) {
    Progress& progress = progress_[id];
    const std::int64_t from_ns = std::max(recessive_since_ns, progress.counted_to_ns);
    const std::int64_t seen = (now_ns - from_ns) / (sequence_bits * bit_times.of(id));
    progress.sequences_left -= static_cast<std::uint32_t>(seen);
    progress.counted_to_ns = now_ns;
  });
}

ControllerSet BusOffRecovery::take_completed(const ControllerSet& members,
                                             std::int64_t recessive_since_ns, std::int64_t now_ns,
                                             const BitTimes& bit_times) {
  ControllerSet completed;
  (recovering_ & members).for_each([&](ControllerId id) {
    completed.assign(id, end_ns(id, recessive_since_ns, bit_times) <= now_ns);
  });
  recovering_ = recovering_ - completed;
  return completed;
}

}  // namespace canvoy
