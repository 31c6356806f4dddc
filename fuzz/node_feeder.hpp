// Hands frames, writes and points in time to a node, as fuzzers of devices do.
//
//     NodeFeeder feeder(device.node());    // starts it
//     feeder.receive(frame);
//     feeder.pass(20ms);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "canvoy/canopen/node.hpp"

namespace canvoy::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

class NodeFeeder {
 public:
  explicit NodeFeeder(Node& node) : node_(node) { node_.start(now_); }

  Time now() const { return now_; }

  void receive(const Frame& frame) {
    node_.receive(frame, now_);
    node_.advance(now_);
  }
  /// As an SDO client does; what is not there, or is refused, is not written.
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    const Result<Entry> entry = node_.dictionary().find(index, sub);
    if (!entry) return;
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), number);
    node_.advance(now_);
    static_cast<void>(node_.dictionary().write(*entry, std::span(bytes).first(entry->row->capacity),
                                               Source::sdo));
    node_.advance(now_);
  }
  /// All that is due until then is done at its time, and comes to an end.
  void pass(Duration duration) {
    const Time until = now_ + duration;
    for (int calls = 0; node_.deadline() <= until; ++calls) {
      require(calls < 1'000'000);
      now_ = std::max(now_, node_.deadline());
      node_.advance(now_);
    }
    now_ = until;
  }

 private:
  Node& node_;
  Time now_{};
};

}  // namespace canvoy::fuzz
