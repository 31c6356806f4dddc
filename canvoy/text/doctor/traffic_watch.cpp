#include "canvoy/text/doctor/traffic_watch.hpp"

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"

namespace canvoy::text {

void TrafficWatch::hear(Time at, const Frame& frame, NodeId node) {
  if (frames_.count != 0) pass(at);
  frames_.add(std::max(at, frames_.last));
  if (node != 0) nodes_[node] = true;
  if (bit_rate_ != 0) count(at, frame, node);
}

void TrafficWatch::end(Time at) {
  if (frames_.count != 0) pass(at);
  if (bit_rate_ != 0) close_second();
}

void TrafficWatch::pass(Time at) {
  const Duration gap = std::max(at - frames_.last, Duration::zero());
  if (gap < silence_least) {
    awake_ += gap;
    return;
  }
  silences_.add(at);
  longest_silence_ = std::max(longest_silence_, gap);
  awoken_ = at;
}

void TrafficWatch::count(Time at, const Frame& frame, NodeId node) {
  constexpr Duration second = 1s;
  if (at - second_ >= second || at < second_) {
    close_second();
    second_ = at;
  }
  const unsigned bits = frame_bits(frame) + intermission_bits;
  bits_ += bits;
  constexpr std::size_t senders_max = 4096;
  if (senders_.size() == senders_max && !senders_.contains(frame.id)) return;
  Sender& sender = senders_[frame.id];
  sender.node = node;
  sender.bits += bits;
}

void TrafficWatch::close_second() {
  const double load = static_cast<double>(bits_) / bit_rate_;
  if (load > load_most) peaks_.add(second_);
  if (load > highest_) {
    highest_ = load;
    peak_shares_.clear();
    for (const auto& [id, sender] : senders_) {
      peak_shares_.push_back({id, sender.node, static_cast<double>(sender.bits) / bit_rate_});
    }
    std::ranges::sort(peak_shares_, std::ranges::greater{}, &Share::of_bus);
    constexpr std::size_t shown_max = 3;
    if (peak_shares_.size() > shown_max) peak_shares_.resize(shown_max);
  }
  bits_ = 0;
  senders_.clear();
}

}  // namespace canvoy::text
