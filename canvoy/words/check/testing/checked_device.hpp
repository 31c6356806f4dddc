// A device of the catalogue on the line of a conformance test, at exact virtual times, with
// somebody in the middle who may change, drop and add frames.
//
//     CheckedDevice device(*find_device_kind("charger"));
//     device.from_device = [](Frame& frame) { return frame.id != 0x581; };
//     Check check(device.line(), device.node(), {});
#pragma once

#include <deque>
#include <functional>

#include "canvoy/devices/testing/every_device.hpp"
#include "canvoy/words/check/check.hpp"

namespace canvoy::conformance {

class CheckedDevice {
 public:
  explicit CheckedDevice(const DeviceKind& kind)
      : device_(Port{this, &CheckedDevice::take, nullptr}, kind) {
    device_.node().start(now_);
    run_until(now_ + 1s);
    queue_.clear();
  }
  CheckedDevice(const CheckedDevice&) = delete;
  CheckedDevice& operator=(const CheckedDevice&) = delete;

  /// It must outlive the line.
  Line line() {
    return {.send =
                [this](const Frame& frame) {
                  if (is_bus_off) return false;
                  Frame sent = frame;
                  if (to_device(sent)) device_.node().receive(sent, now_);
                  return true;
                },
            .next = [this](Time until) { return next(until); },
            .now = [this] { return now_; }};
  }
  NodeId node() { return device_.node().id(); }
  Node& device() { return device_.node(); }
  Time now() const { return now_; }
  /// As if the device had sent it.
  void add(const Frame& frame) { queue_.push_back({now_, frame}); }

  /// False: the frame is lost.
  std::function<bool(Frame&)> from_device = [](Frame&) { return true; };
  std::function<bool(Frame&)> to_device = [](Frame&) { return true; };
  bool is_bus_off = false;

 private:
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<CheckedDevice*>(context);
    Frame sent = frame;
    if (self.from_device(sent)) self.queue_.push_back({self.now_, sent});
    return true;
  }
  std::optional<Heard> next(Time until) {
    run_until(until);
    if (queue_.empty()) return std::nullopt;
    const Heard heard = queue_.front();
    queue_.pop_front();
    return heard;
  }
  /// Or until there is a frame.
  void run_until(Time until) {
    while (queue_.empty() && device_.node().deadline() <= until) {
      now_ = std::max(now_, device_.node().deadline());
      device_.node().advance(now_);
    }
    if (queue_.empty()) now_ = std::max(now_, until);
  }

  Time now_{};
  std::deque<Heard> queue_;
  DeviceOfKind device_;
};

}  // namespace canvoy::conformance
