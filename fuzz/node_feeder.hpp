// Passes frames, writes and time to a node, for fuzzers of devices.
//
//     NodeFeeder feeder(device.node());    // starts it
//     feeder.receive(frame);
//     feeder.pass(20ms);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "fuzz/require.hpp"

namespace canvoy::fuzz {

/// Writes an entry like an SDO client; no effect if it does not exist, or is refused.
inline void write(Node& node, Time now, std::uint16_t index, std::uint8_t sub,
                  std::uint64_t number) {
  const Result<Entry> entry = node.dictionary().find(index, sub);
  if (!entry) return;
  std::array<std::uint8_t, 8> bytes{};
  store(bytes.data(), number);
  const std::size_t length = std::min<std::size_t>(entry->row->capacity, bytes.size());
  node.advance(now);
  static_cast<void>(node.dictionary().write(*entry, std::span(bytes).first(length), Source::sdo));
  node.advance(now);
}

/// Performs all that is due within the duration at its time, with `now` set accordingly.
inline void pass(Node& node, Time& now, Duration duration) {
  const Time until = now + duration;
  for (int calls = 0; node.deadline() <= until; ++calls) {
    require(calls < 1'000'000);
    now = std::max(now, node.deadline());
    node.advance(now);
  }
  now = until;
}

class NodeFeeder {
 public:
  explicit NodeFeeder(Node& node) : node_(node) { node_.start(now_); }

  Time now() const { return now_; }

  void receive(const Frame& frame) {
    node_.receive(frame, now_);
    node_.advance(now_);
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    fuzz::write(node_, now_, index, sub, number);
  }
  void pass(Duration duration) { fuzz::pass(node_, now_, duration); }

 private:
  Node& node_;
  Time now_{};
};

}  // namespace canvoy::fuzz
