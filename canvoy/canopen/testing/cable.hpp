// A cable between nodes for tests: frames arrive at once, in the order in which they were sent, and
// the test receives and sends too. No arbitration, no errors, no load: SimulatedBus has them.
//
//     Cable cable;
//     BatteryDevice battery(cable.port(0), 10, hardware);
//     cable.connect(0, battery.node());
//     cable.run_for(1s);
//     EXPECT_EQ(cable.last(0x18A), "18A#A8 00 01");
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

class Cable {
 public:
  static constexpr std::size_t nodes_max = 8;

  Port port(std::size_t place) {
    places_[place].cable = this;
    places_[place].number = place;
    return {&places_[place], &Cable::take, nullptr};
  }
  void connect(std::size_t place, Node& node) { places_[place].node = &node; }
  /// Disconnects a node: its frames are lost, and none reach it.
  void cut(std::size_t place, bool is_cut = true) { places_[place].is_cut = is_cut; }
  /// Makes a controller full: frames to send wait in its node.
  void refuse(std::size_t place, bool is_full = true) { places_[place].is_full = is_full; }

  void start_all() {
    for (Place& place : places_) {
      if (place.node != nullptr) place.node->start(now);
    }
    deliver();
  }
  /// Sends a frame of the test to all.
  void send(std::string_view frame) { send(wire_frame(frame)); }
  void send(const Frame& frame) { send_from(nodes_max, frame); }
  /// Sends a frame in place of the node there, which does not hear it.
  void send_from(std::size_t place, std::string_view frame) { send_from(place, wire_frame(frame)); }
  void send_from(std::size_t place, const Frame& frame) {
    queue_.push_back({place, frame});
    settle();
  }

  void run_until(Time until) {
    settle();
    for (Time next = deadline(); next <= until; next = deadline()) {
      now = std::max(now, next);
      settle();
    }
    now = until;
  }
  void run_for(Duration duration) { run_until(now + duration); }

  struct Heard {
    Time at;
    Frame frame;
  };
  /// All frames on the cable since the last clear().
  std::vector<Heard> heard;
  /// Frames for which this returns false are lost.
  std::function<bool(const Frame&)> filter = [](const Frame&) { return true; };
  Time now{};

  std::size_t count(std::uint32_t id) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(heard, [id](const Heard& h) { return h.frame.id == id; }));
  }
  /// Last frame with this CAN-ID as wire_text(), or nothing.
  std::string last(std::uint32_t id) const {
    const Frame* const frame = last_frame(id);
    return frame == nullptr ? "" : wire_text(*frame);
  }
  /// Like last(), but the frame itself, or null; valid until the next frame.
  const Frame* last_frame(std::uint32_t id) const {
    for (auto h = heard.rbegin(); h != heard.rend(); ++h) {
      if (h->frame.id == id) return &h->frame;
    }
    return nullptr;
  }
  void clear() { heard.clear(); }

 private:
  struct Place {
    Cable* cable = nullptr;
    std::size_t number = 0;
    Node* node = nullptr;
    bool is_cut = false;
    bool is_full = false;
  };
  struct Sent {
    std::size_t from;
    Frame frame;
  };

  static bool take(void* context, const Frame& frame) {
    const auto& place = *static_cast<Place*>(context);
    if (place.is_full) return false;
    if (!place.is_cut) place.cable->queue_.push_back({place.number, frame});
    return true;
  }
  Time deadline() const {
    Time earliest = never;
    for (const Place& place : places_) {
      if (place.node != nullptr) earliest = std::min(earliest, place.node->deadline());
    }
    return earliest;
  }
  void settle() {
    deliver();
    for (int i = 0; deadline() <= now; ++i) {
      ASSERT_LT(i, 10'000) << "a node wants to be called again and again";
      for (Place& place : places_) {
        if (place.node != nullptr && place.node->deadline() <= now) place.node->advance(now);
      }
      deliver();
    }
  }
  void deliver() {
    while (!queue_.empty()) {
      const Sent sent = queue_.front();
      queue_.pop_front();
      heard.push_back({now, sent.frame});
      if (!filter(sent.frame)) continue;
      for (Place& place : places_) {
        if (place.node == nullptr || place.is_cut || place.number == sent.from) continue;
        place.node->receive(sent.frame, now);
      }
    }
  }

  std::array<Place, nodes_max> places_{};
  std::deque<Sent> queue_;
};

}  // namespace canvoy
