#include "canvoy/timing/breakdown.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "canvoy/timing/response_time.hpp"

namespace canvoy::timing {
namespace {

constexpr double precision = 0.001;

Duration times(Duration duration, double scale) {
  const double us = static_cast<double>(duration.count()) * scale;
  return Duration(static_cast<std::int64_t>(std::llround(us)));
}

/// Common divisor of all periods behind SYNC, which stay multiples of it.
Duration sync_period(const BusModel& model) {
  std::int64_t shared_us = 0;
  for (const BusMessage& each : model.messages) {
    if (each.offset) shared_us = std::gcd(shared_us, each.period.count());
  }
  return Duration(shared_us);
}

}  // namespace

BusModel scaled(const BusModel& model, double scale) {
  BusModel made = model;
  const Duration sync = sync_period(model);
  const Duration scaled_sync = std::max(times(sync, scale), Duration{1});
  for (BusMessage& each : made.messages) {
    const bool is_due_with_next = each.deadline == each.period;
    each.period = each.offset ? each.period / sync * scaled_sync
                              : std::max(times(each.period, scale), Duration{1});
    if (is_due_with_next) each.deadline = each.period;
    each.ahead = times(each.ahead, scale);
    each.distance = std::min(times(each.distance, scale), each.period);
    for (Burst& burst : each.bursts) {
      burst.period = std::max(times(burst.period, scale), Duration{1});
      burst.ahead = times(burst.ahead, scale);
    }
    if (each.offset) each.offset = std::min(times(*each.offset, scale), each.period - Duration{1});
  }
  return made;
}

std::optional<Breakdown> breakdown(const BusModel& model) {
  if (model.messages.empty()) return std::nullopt;
  double late = utilisation(model);  // at this scale the bus is full
  double met = std::max(1.0, late);
  while (!meets_all(scaled(model, met))) {
    late = met;
    met *= 2;
    if (met > scale_max) return std::nullopt;
  }
  while (met - late > precision * met) {
    const double middle = (met + late) / 2;
    (meets_all(scaled(model, middle)) ? met : late) = middle;
  }
  return Breakdown{.scale = met, .utilisation = utilisation(scaled(model, met))};
}

}  // namespace canvoy::timing
