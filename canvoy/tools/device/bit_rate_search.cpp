#include "canvoy/tools/device/bit_rate_search.hpp"

#include <linux/can/error.h>

#include "canvoy/can/host/can_link.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/canopen/lss/bit_rate_detection.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

/// Error frames report more than the traffic on the wire.
bool is_of_interest(const Frame& frame) {
  return !frame.is_error() || (frame.id & (CAN_ERR_PROT | CAN_ERR_BUSERROR)) != 0;
}

/// Restores the previous settings of an interface, unless the search ends with a bit rate.
class Restoration {
 public:
  explicit Restoration(const std::string& interface)
      : interface_(interface), before_(value_or_throw(host::read_can_link(interface))) {}
  ~Restoration() {
    if (!is_kept_ && before_.has_controller) (void)host::restore_can_link(interface_, before_);
  }
  Restoration(const Restoration&) = delete;
  Restoration& operator=(const Restoration&) = delete;

  void keep() { is_kept_ = true; }

 private:
  std::string interface_;
  host::CanLink before_;
  bool is_kept_ = false;
};

}  // namespace

std::uint32_t search_bit_rate(const std::string& interface,
                              const std::function<void(bool)>& under_way) {
  const auto loop = value_or_throw(host::EventLoop::create());
  Restoration restoration(interface);
  // The interface must be up to be opened, and invalid settings are reported at once.
  ok_or_throw(host::restart_can_link(interface, BitRateDetection::usual_bit_rates.front(), true));
  const auto bus = value_or_throw(host::open_bus(*loop, interface));
  Time restarted{};
  auto restart = [&](std::uint32_t bit_rate, bool listen_only) {
    const bool done = static_cast<bool>(host::restart_can_link(interface, bit_rate, listen_only));
    restarted = loop->now();
    return done;
  };
  BitRateDetection detection(BitRateDetection::Restart::of(restart));
  auto found = [&](std::uint32_t) { loop->stop(); };
  detection.on_found(Callback<void(std::uint32_t)>::of(found));
  auto tell = [&](bool is_under_way) {
    if (under_way) under_way(is_under_way);
  };
  detection.on_under_way(Callback<void(bool)>::of(tell));
  bus->on_frame([&](const host::BusFrame& heard) {
    // Frames at the previous bit rate may still arrive.
    if (heard.time >= restarted && is_of_interest(heard.frame))
      detection.receive(heard.frame, loop->now());
  });
  auto deadline = [&] { return detection.deadline(); };
  auto advance = [&](Time now) { detection.advance(now); };
  loop->add(
      {.deadline = Callback<Time()>::of(deadline), .advance = Callback<void(Time)>::of(advance)});
  ok_or_throw(loop->stop_on_signals());
  detection.start(loop->now());
  loop->run();
  if (detection.state() != BitRateDetection::State::found) throw Failure("interrupted");
  restoration.keep();
  return detection.bit_rate();
}

}  // namespace canvoy::tools
