#include "canvoy/timing/response_time.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/arbitration.hpp"
#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

namespace {

// Counts the instances of a message that are queued in the first t of a busy period, and finds the
// times of their events, for response_time.cpp. Times are nanoseconds.
//
//     Release release = Release::anywhere(message);
//     release.count(t) * frame_ns

/// Quotient, rounded up. `divisor` is above zero.
constexpr std::int64_t divided_up(std::int64_t number, std::int64_t divisor) {
  return number > 0 ? (number - 1) / divisor + 1 : number / divisor;
}

class Release {
 public:
  /// Makes all instances come as early as possible: the first at the start of the busy period.
  static Release anywhere(const BusMessage& message) {
    Release made(message);
    made.add_row(message.period, message.ahead);
    if (message.distance > Duration{}) made.add_row(message.distance, Duration{});
    for (const Burst& each : message.bursts) made.add_row(each.period, each.ahead);
    return made;
  }
  /// Places the first event at or after the start of the busy period at `phase_ns`, 0 to below the
  /// period. Events before it count if their jitter brings them into the busy period.
  static Release at_phase(const BusMessage& message, std::int64_t phase_ns) {
    Release made(message);
    const std::int64_t period_ns = ns(message.period);
    const std::int64_t delayed = (made.jitter_ns_ + phase_ns) / period_ns;
    made.rows_.push_back({period_ns, delayed * period_ns - phase_ns});
    made.begins_with_row_ = true;
    return made;
  }

  /// Number of instances queued in [0, t), with t = `t_ns`. Not below 0.
  std::int64_t count(std::int64_t t_ns) const {
    std::int64_t least = divided_up(t_ns + rows_.front().lead_ns, rows_.front().period_ns);
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      least = std::min(least, divided_up(t_ns + rows_[i].lead_ns, rows_[i].period_ns));
    }
    return std::max<std::int64_t>(least, 0);
  }
  /// Event of an instance, counted from 0.
  std::int64_t event_ns(std::int64_t instance) const {
    const Row& first = rows_.front();
    if (begins_with_row_) return instance * first.period_ns - first.lead_ns;
    std::int64_t latest_ns = -jitter_ns_;  // not before the first
    for (const Row& row : rows_) {
      latest_ns = std::max(latest_ns, instance * row.period_ns - row.lead_ns);
    }
    return latest_ns;
  }

 private:
  struct Row {
    std::int64_t period_ns;  ///< above 0
    std::int64_t lead_ns;    ///< greatest lead of an instance over its place, with its jitter
  };

  static std::int64_t ns(Duration duration) { return std::chrono::nanoseconds(duration).count(); }
  explicit Release(const BusMessage& message) : jitter_ns_(ns(message.jitter)) {}
  void add_row(Duration period, Duration ahead) {
    rows_.push_back({ns(period), jitter_ns_ + ns(ahead)});
  }

  std::vector<Row> rows_;
  std::int64_t jitter_ns_;
  bool begins_with_row_ = false;
};

constexpr std::uint64_t second_ns = 1'000'000'000;
constexpr unsigned error_bits = 31;  // both flags, the delimiter, the wait of a passive sender

std::int64_t ns_of(Duration duration) {
  return Nanoseconds(duration).count();
}

/// Frequency of an instance in the long run, per second.
double rate_of(const BusMessage& message) {
  const Duration apart =
      message.offset ? message.period : std::max(message.period, message.distance);
  return 1e6 / static_cast<double>(apart.count());
}

/// A place behind SYNC at which a busy period may begin.
struct Place {
  std::size_t message = 0;  ///< by priority
  std::int64_t start_ns = 0;
};

/// All messages by their priority, the highest first.
class Bus {
 public:
  explicit Bus(const BusModel& model) : model_(&model), order_(model.messages.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {},
                             [&](std::size_t i) { return priority(model.messages[i]); });
    bit_ns_ = wire_time(1, model.bit_rate).count();
    for (const std::size_t i : order_) {
      frame_ns_.push_back(wire_time(model.messages[i].bits, model.bit_rate).count());
    }
    find_places();
  }

  std::size_t size() const { return order_.size(); }
  std::size_t place_in_model(std::size_t own) const { return order_[own]; }
  const BusMessage& message(std::size_t own) const { return model_->messages[order_[own]]; }
  std::int64_t frame_ns(std::size_t own) const { return frame_ns_[own]; }
  std::int64_t bit_ns() const { return bit_ns_; }
  /// Places behind SYNC at which a busy period of this priority may begin.
  std::span<const Place> places() const { return places_; }

  std::int64_t blocking_ns(std::size_t own) const {
    const auto lower = frame_ns_.begin() + static_cast<std::ptrdiff_t>(own) + 1;
    return lower == frame_ns_.end() ? 0 : *std::max_element(lower, frame_ns_.end());
  }
  /// Cost of an error while this message waits.
  std::int64_t error_ns(std::size_t own) const {
    const auto end = frame_ns_.begin() + static_cast<std::ptrdiff_t>(own) + 1;
    return wire_time(error_bits, model_->bit_rate).count() +
           *std::max_element(frame_ns_.begin(), end);
  }
  std::int64_t errors_within(std::int64_t t_ns) const {
    const ErrorModel& errors = model_->errors;
    if (t_ns <= 0) return 0;
    if (errors.each <= Duration::zero()) return errors.at_once;
    const std::int64_t first = std::max<std::int64_t>(errors.at_once, 1);
    return first + divided_up(t_ns, ns_of(errors.each)) - 1;
  }
  /// Share of the bus for errors and all messages down to this priority.
  double share(std::size_t own) const {
    double taken = 0;
    for (std::size_t k = 0; k <= own; ++k) {
      taken += rate_of(message(k)) * static_cast<double>(frame_ns_[k]) / 1e9;
    }
    const Duration each = model_->errors.each;
    if (each <= Duration::zero()) return taken;
    return taken + static_cast<double>(error_ns(own)) / static_cast<double>(ns_of(each));
  }

 private:
  void find_places() {
    std::int64_t all_ns = 0;
    for (const std::size_t i : order_) {
      const BusMessage& each = model_->messages[i];
      if (!each.offset) continue;
      const std::int64_t period_ns = ns_of(each.period);
      const std::int64_t shared = all_ns == 0 ? period_ns : std::gcd(all_ns, period_ns);
      if (all_ns != 0 && all_ns / shared > static_cast<std::int64_t>(places_max)) return;
      all_ns = all_ns == 0 ? period_ns : all_ns / shared * period_ns;
    }
    for (std::size_t own = 0; own < order_.size(); ++own) {
      const BusMessage& each = message(own);
      if (!each.offset) continue;
      const std::int64_t first_ns = ns_of(*each.offset) + ns_of(each.jitter);
      const std::int64_t count = all_ns / ns_of(each.period);
      if (count + static_cast<std::int64_t>(places_.size()) >
          static_cast<std::int64_t>(places_max)) {
        places_.clear();
        return;
      }
      for (std::int64_t n = 0; n < count; ++n) {
        places_.push_back({own, first_ns + n * ns_of(each.period)});
      }
    }
  }

  const BusModel* model_;
  std::vector<std::size_t> order_;
  std::vector<std::int64_t> frame_ns_;
  std::vector<Place> places_;
  std::int64_t bit_ns_ = 0;
};

/// The busy period of one priority, with one way to begin.
class BusyPeriod {
 public:
  /// `place`: the moment behind SYNC at which it begins; null: messages without places.
  BusyPeriod(const Bus& bus, std::size_t own, const Place* place, std::uint64_t& looks)
      : bus_(&bus), own_(own), looks_(&looks), blocking_ns_(bus.blocking_ns(own)) {
    for (std::size_t k = 0; k <= own; ++k) releases_.push_back(release_of(k, place));
  }

  /// Enters the longest response of all instances into `worst`; false if the busy period has no
  /// end.
  bool look(Response& worst) {
    const std::int64_t end_ns = fixed_point(bus_->frame_ns(own_), [&](std::int64_t t_ns) {
      return blocking_ns_ + errors_ns(t_ns) + demand_ns(own_ + 1, t_ns);
    });
    if (end_ns < 0) return false;
    const std::int64_t instances = releases_[own_].count(end_ns);
    std::int64_t wait_ns = 0;
    for (std::int64_t q = 0; q < instances; ++q) {
      wait_ns = waiting_ns(q, wait_ns);
      if (wait_ns < 0) return false;
      const Nanoseconds time(wait_ns + bus_->frame_ns(own_) - releases_[own_].event_ns(q));
      if (q == 0) worst.first = std::max(worst.first, time);
      worst.time = std::max(worst.time, time);
    }
    worst.instances = std::max(worst.instances, static_cast<std::uint32_t>(instances));
    return true;
  }

 private:
  Release release_of(std::size_t k, const Place* place) const {
    const BusMessage& message = bus_->message(k);
    if (place == nullptr || !message.offset) return Release::anywhere(message);
    const std::int64_t period_ns = ns_of(message.period);
    const std::int64_t phase_ns = (ns_of(*message.offset) - place->start_ns) % period_ns;
    return Release::at_phase(message, phase_ns < 0 ? phase_ns + period_ns : phase_ns);
  }

  /// Time from the start of the busy period until the frame of this instance begins.
  std::int64_t waiting_ns(std::int64_t instance, std::int64_t before_ns) {
    const std::int64_t own_ns = instance * bus_->frame_ns(own_);
    const std::int64_t from_ns = std::max(before_ns, blocking_ns_ + own_ns);
    return fixed_point(from_ns, [&](std::int64_t wait_ns) {
      return blocking_ns_ + errors_ns(wait_ns + bus_->frame_ns(own_)) + own_ns +
             demand_ns(own_, wait_ns + bus_->bit_ns());
    });
  }

  std::int64_t errors_ns(std::int64_t t_ns) const {
    return bus_->errors_within(t_ns) * bus_->error_ns(own_);
  }
  /// Demand of the first `priorities` in the first t.
  std::int64_t demand_ns(std::size_t priorities, std::int64_t t_ns) const {
    std::int64_t sum_ns = 0;
    for (std::size_t k = 0; k < priorities; ++k) {
      sum_ns += releases_[k].count(t_ns) * bus_->frame_ns(k);
      if (sum_ns > busy_period_max.count()) break;  // it has no end, whatever the exact value
    }
    return sum_ns;
  }

  /// First t, from `from_ns` on, that equals its own demand; -1 if there is none within the limits.
  template <class Demand>
  std::int64_t fixed_point(std::int64_t from_ns, Demand demand) {
    std::int64_t t_ns = from_ns;
    while (t_ns <= busy_period_max.count() && *looks_ < looks_max) {
      *looks_ += own_ + 1;
      const std::int64_t next_ns = demand(t_ns);
      if (next_ns <= t_ns) return t_ns;
      t_ns = next_ns;
    }
    return -1;
  }

  const Bus* bus_;
  std::size_t own_;
  std::uint64_t* looks_;
  std::int64_t blocking_ns_;
  std::vector<Release> releases_;
};

Response response_of(const Bus& bus, std::size_t own) {
  Response worst{.blocking = Nanoseconds(bus.blocking_ns(own))};
  if (bus.share(own) >= 1.0) return worst;
  std::uint64_t looks = 0;
  bool is_bounded = true;
  bool has_place = false;
  for (const Place& place : bus.places()) {
    if (place.message > own) continue;
    has_place = true;
    is_bounded = is_bounded && BusyPeriod(bus, own, &place, looks).look(worst);
  }
  if (!has_place) is_bounded = BusyPeriod(bus, own, nullptr, looks).look(worst);
  worst.is_bounded = is_bounded;
  worst.meets_deadline = is_bounded && worst.time <= Nanoseconds(bus.message(own).deadline);
  return worst;
}

}  // namespace

std::uint32_t priority(const BusMessage& message) {
  const auto extended = message.is_extended ? FrameFlags::extended : FrameFlags::none;
  const auto remote = message.is_remote ? FrameFlags::remote : FrameFlags::none;
  return arbitration_key({.id = message.id, .flags = extended | remote, .data = {}});
}

Nanoseconds wire_time(std::uint64_t bits, std::uint32_t bit_rate) {
  return Nanoseconds(
      divided_up(static_cast<std::int64_t>(bits * second_ns), static_cast<std::int64_t>(bit_rate)));
}

double utilisation(const BusModel& model) {
  double taken = 0;
  for (const BusMessage& each : model.messages) {
    taken += rate_of(each) * each.bits / static_cast<double>(model.bit_rate);
  }
  return taken;
}

bool meets_all(const BusModel& model) {
  const Bus bus(model);
  for (std::size_t own = 0; own < bus.size(); ++own) {
    if (!response_of(bus, own).meets_deadline) return false;
  }
  return true;
}

std::vector<Response> response_times(const BusModel& model) {
  const Bus bus(model);
  std::vector<Response> responses(bus.size());
  for (std::size_t own = 0; own < bus.size(); ++own) {
    responses[bus.place_in_model(own)] = response_of(bus, own);
  }
  return responses;
}

}  // namespace canvoy::timing
