// Random sets of messages, and their response times on the simulated bus: at the critical instant
// of each message, and at random. Frames have the length of their contents, in the analysis as on
// the bus: no data makes every frame as long as the analysis would have to assume, so that a bound
// could be reached. All times are whole bits.
//
//     Random random(seed);
//     const MessageSet set = message_set(random);
//     const std::optional<Duration> seen = longest_at_critical_instants(set, 3, response);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <numeric>
#include <set>
#include <vector>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/random.hpp"
#include "canvoy/can/simulated/arbitration.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/timing/response_time.hpp"

namespace canvoy::timing {

/// A model with the frame of each message.
struct MessageSet {
  BusModel model;
  std::vector<Frame> frames;

  Duration bits(std::int64_t count) const { return Duration(count * 1'000'000 / model.bit_rate); }
};

/// An instance of a message: the time of its event, and the time at which it is queued.
struct Instance {
  std::size_t message = 0;
  Time event{};
  Time queued{};
};

/// Plays instances on the simulated bus.
class Playing {
 public:
  explicit Playing(const MessageSet& set)
      : set_(&set),
        bus_({.bit_rate = set.model.bit_rate,
              .controllers_max = set.frames.size() + 1,
              .transmit_queue_max = 512}) {
    senders_.resize(set.frames.size());
    for (Sender& sender : senders_) {
      sender.playing = this;
      sender.id = bus_.attach({.listener = {.context = &sender, .on_sent = sent}});
    }
    bus_.attach({});  // acknowledges all frames
  }
  Playing(const Playing&) = delete;
  Playing& operator=(const Playing&) = delete;

  /// Puts one instance alone on the bus before the others come, so that it blocks them.
  void block(std::size_t message, Time when) {
    bus_.advance(when);
    queue({.message = message, .event = when, .queued = when});
    bus_.advance(when);
  }
  /// Destroys the next frames, within the checksum of the shortest frame.
  void disturb(std::uint32_t frames) {
    if (frames > 0) bus_.disturb(frames, 33);
  }

  /// Plays the instances in the order of their queueing; then advances until all is sent.
  void play(std::vector<Instance> instances) {
    std::ranges::stable_sort(instances, {}, &Instance::queued);
    for (const Instance& each : instances) {
      // A frame that is queued when the bus becomes free takes part. On an idle bus it begins.
      bus_.advance(waiting_ > 0 ? each.queued - Duration{1} : each.queued);
      queue(each);
    }
    while (waiting_ > 0 && bus_.next_event() != never) bus_.advance(bus_.next_event());
  }

  /// Number of instances for which a sender had no room.
  std::size_t lost() const { return lost_; }
  /// Longest time from an event to the end of the intermission, among the instances played.
  Duration longest(std::size_t message) const { return senders_[message].longest; }

 private:
  struct Sender {
    Playing* playing = nullptr;
    ControllerId id = no_controller;
    std::deque<Time> events{};
    Duration longest{};
  };

  void queue(const Instance& instance) {
    Sender& sender = senders_[instance.message];
    if (!bus_.send(sender.id, set_->frames[instance.message])) {
      ++lost_;
      return;
    }
    sender.events.push_back(instance.event);
    ++waiting_;
  }
  static void sent(void* context, Time now, const Frame& /*frame*/) {
    Sender& sender = *static_cast<Sender*>(context);
    const Duration behind = sender.playing->set_->bits(intermission_bits);
    sender.longest = std::max(sender.longest, now + behind - sender.events.front());
    sender.events.pop_front();
    --sender.playing->waiting_;
  }

  const MessageSet* set_;
  SimulatedBus bus_;
  std::vector<Sender> senders_;
  std::size_t waiting_ = 0;
  std::size_t lost_ = 0;
};

/// Draws 3 to 16 messages that take 30 to 95 % of the bus, half of them with jitters.
inline MessageSet message_set(Random& random) {
  constexpr std::array<std::uint32_t, 4> rates = {125'000, 250'000, 500'000, 1'000'000};
  MessageSet set;
  set.model.bit_rate = rates[random.below(4)];
  std::set<std::uint32_t> keys;
  const std::size_t count = 3 + random.below(14);
  while (set.frames.size() < count) {
    Frame frame;
    const bool is_extended = random.below(5) == 0;
    if (is_extended) frame.flags = FrameFlags::extended;
    frame.id = random.below(is_extended ? 1U << 29 : 1U << 11);
    frame.length = static_cast<std::uint8_t>(random.below(9));
    const std::uint64_t bytes = random.next() & (random.below(3) == 0 ? random.next() : ~0ULL);
    for (unsigned i = 0; i < frame.length; ++i) {
      frame.data.at(i) = static_cast<std::uint8_t>(bytes >> (8 * i));
    }
    if (!keys.insert(arbitration_key(frame)).second) continue;
    set.frames.push_back(frame);
    BusMessage& message = set.model.messages.emplace_back();
    message.id = frame.id;
    message.is_extended = is_extended;
    message.bits = frame_bits(frame) + intermission_bits;
    message.period = set.bits(300 + random.below(1U << (7 + random.below(9))));
  }
  // Scales the periods to the load that was drawn.
  const double load = 0.3 + 0.65 * random.below(1000) / 1000.0;
  const double scale = utilisation(set.model) / load;
  for (BusMessage& each : set.model.messages) {
    const Duration bit = set.bits(1);
    const auto period = static_cast<std::uint32_t>(static_cast<double>(each.period / bit) * scale);
    each.period = (1 + std::max(period, each.bits)) * bit;
    each.deadline = each.period;
    if (random.below(2) == 0) each.jitter = random.below(2 * period + 1) * bit;
    if (random.below(4) == 0) {
      each.distance = random.below(period + 1) * bit;
      each.ahead = random.below(3 * period + 1) * bit;
      if (random.below(2) == 0) {
        const Duration row = (1 + random.below(period)) * bit;
        each.bursts.push_back({row, random.below(2 * period + 1) * bit});
      }
    }
  }
  return set;
}

/// Gives about half of the messages a place behind a SYNC, with one, two, three or four times its
/// period.
inline void put_behind_sync(MessageSet& set, Random& random) {
  const Duration bit = set.bits(1);
  const Duration sync = (3000 + random.below(3000)) * bit;
  for (BusMessage& each : set.model.messages) {
    if (random.below(2) == 0) continue;
    each.period = each.deadline = (1 + random.below(4)) * sync;
    each.ahead = each.distance = Duration{};
    each.bursts.clear();
    each.jitter = random.below(2) * random.below(2000) * bit;
    each.offset = random.below(static_cast<std::uint32_t>(each.period / bit)) * bit;
  }
}

namespace detail {

/// Adds the instances of a message without a place, from the start of a busy period on, as early as
/// possible.
inline void add_earliest(std::vector<Instance>& to, const MessageSet& set, std::size_t message,
                         Time start, Duration length) {
  const BusMessage& each = set.model.messages[message];
  const Time first = start - each.jitter;
  for (std::int64_t n = 0;; ++n) {
    Duration behind = std::max({Duration{}, n * each.period - each.ahead, n * each.distance});
    for (const Burst& row : each.bursts) behind = std::max(behind, n * row.period - row.ahead);
    const Time event = first + behind;
    if (event > start + length) return;
    to.push_back({message, event, std::max(event, start)});
  }
}

/// Adds the instances of a message with a place, for a row of SYNC that begins at `sync`: all that
/// can be queued from the start on, as early as possible.
inline void add_in_row(std::vector<Instance>& to, const MessageSet& set, std::size_t message,
                       Time sync, Time start, Duration length) {
  const BusMessage& each = set.model.messages[message];
  Time event = sync + *each.offset;
  while (event + each.jitter >= start) event -= each.period;
  while (event + each.jitter < start) event += each.period;
  for (; event <= start + length; event += each.period) {
    to.push_back({message, event, std::max(event, start)});
  }
}

/// Beginnings of SYNC's row for each message that can begin the busy period.
inline std::vector<Time> sync_rows(const MessageSet& set, std::size_t own, Time start) {
  const std::uint32_t key = arbitration_key(set.frames[own]);
  Duration all{};
  for (const BusMessage& each : set.model.messages) {
    if (!each.offset) continue;
    all = Duration(all == Duration{} ? each.period.count()
                                     : std::lcm(all.count(), each.period.count()));
  }
  std::vector<Time> rows;
  for (std::size_t k = 0; k < set.frames.size(); ++k) {
    const BusMessage& each = set.model.messages[k];
    if (!each.offset || arbitration_key(set.frames[k]) > key) continue;
    for (Duration at{}; at < all; at += each.period) {
      rows.push_back(start - each.jitter - *each.offset - at);
    }
  }
  if (rows.empty()) rows.push_back(start);
  return rows;
}

}  // namespace detail

/// Longest response of a message at its critical instants: the longest frame of lower priority has
/// just begun, and all of higher priority come at once, with their jitters. `errors` frames are
/// destroyed. `bound` limits the duration.
inline Duration longest_at_critical_instants(const MessageSet& set, std::size_t own,
                                             const Response& bound, std::uint32_t errors = 0) {
  const Time start = Time(10s) + set.bits(1);
  const std::uint32_t key = arbitration_key(set.frames[own]);
  const Duration length =
      std::chrono::ceil<Duration>(bound.time) +
      static_cast<std::int64_t>(bound.instances) * set.model.messages[own].period;
  std::size_t blocker = own;
  for (std::size_t k = 0; k < set.frames.size(); ++k) {
    if (arbitration_key(set.frames[k]) <= key) continue;
    if (blocker == own || set.model.messages[k].bits > set.model.messages[blocker].bits)
      blocker = k;
  }
  Duration longest{};
  for (const Time row : detail::sync_rows(set, own, start)) {
    std::vector<Instance> instances;
    for (std::size_t k = 0; k < set.frames.size(); ++k) {
      if (arbitration_key(set.frames[k]) > key) continue;
      set.model.messages[k].offset ? detail::add_in_row(instances, set, k, row, start, length)
                                   : detail::add_earliest(instances, set, k, start, length);
    }
    Playing playing(set);
    if (blocker != own) playing.block(blocker, start);
    playing.disturb(errors);
    playing.play(std::move(instances));
    check_invariant(playing.lost() == 0);
    longest = std::max(longest, playing.longest(own));
  }
  return longest;
}

/// Longest response of each message at random times within the limits of the model, for `periods`
/// periods of the slowest.
inline std::vector<Duration> longest_by_chance(const MessageSet& set, Random& random,
                                               std::int64_t periods) {
  const Duration bit = set.bits(1);
  const auto draw = [&](Duration below) {
    return random.below(static_cast<std::uint32_t>(below / bit) + 1) * bit;
  };
  const Duration slowest = std::ranges::max(set.model.messages, {}, &BusMessage::period).period;
  const Time begin = Time(10s);
  const Time sync = begin + draw(slowest);
  std::vector<Instance> instances;
  for (std::size_t k = 0; k < set.frames.size(); ++k) {
    const BusMessage& each = set.model.messages[k];
    Time place = each.offset ? sync + *each.offset : begin + draw(each.period) + each.ahead;
    Time event_before = begin - each.period;
    Time queued_before = begin;
    std::vector<Time> row_ends(each.bursts.size(), begin - each.period);
    for (; place < begin + periods * slowest; place += each.period) {
      const Duration early = random.below(3) == 0 ? each.ahead : draw(each.ahead);
      Time event = std::max(place - early, event_before + each.distance);
      for (std::size_t row = 0; row < row_ends.size(); ++row) {
        event = std::max(event, row_ends[row] - each.bursts[row].ahead);
      }
      for (std::size_t row = 0; row < row_ends.size(); ++row) {
        row_ends[row] = std::max(row_ends[row], event) + each.bursts[row].period;
      }
      const Duration late = random.below(3) == 0 ? each.jitter : draw(each.jitter);
      const Time queued = std::max(event + late, queued_before);
      instances.push_back({k, event, queued});
      event_before = std::max(event, event_before);
      queued_before = queued;
    }
  }
  Playing playing(set);
  playing.play(std::move(instances));
  check_invariant(playing.lost() == 0);
  std::vector<Duration> longest;
  for (std::size_t k = 0; k < set.frames.size(); ++k) longest.push_back(playing.longest(k));
  return longest;
}

}  // namespace canvoy::timing
