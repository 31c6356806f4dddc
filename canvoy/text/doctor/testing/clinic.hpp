// A simulated bus with nodes that send what a test gives, and a doctor that listens with a
// controller of its own, like an interface in listen-only mode.
//
//     Clinic clinic;
//     const ControllerId node = clinic.add_healthy(5);
//     clinic.at(20s, [&] { clinic.bus().power(node, false); });
//     const text::Findings findings = clinic.examine(60s);
//
// For tests only.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "canvoy/can/error_frame.hpp"
#include "canvoy/can/random.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/text/doctor/doctor.hpp"

namespace canvoy {

class Clinic {
 public:
  static constexpr Duration heartbeat = 500ms;
  static constexpr Duration pdo_period = 100ms;

  /// `listens_at`: the bit rate of the interface of the doctor; 0: that of the bus. Its position is
  /// the end of the cable, after all added controllers.
  explicit Clinic(const SimulatedBusOptions& options = {}, std::uint32_t listens_at = 0)
      : bus_(options), doctor_({.bit_rate = options.bit_rate}), listens_at_(listens_at) {}
  Clinic(const Clinic&) = delete;
  Clinic& operator=(const Clinic&) = delete;

  SimulatedBus& bus() { return bus_; }
  text::Doctor& doctor() { return doctor_; }

  /// Adds a controller that sends what it is given.
  ControllerId add(const ControllerOptions& options = {}) { return bus_.attach(options); }
  /// Adds a node with heartbeats, a read of its 1017h, and TPDO1 of four bytes.
  ControllerId add_healthy(NodeId node, const ControllerOptions& options = {}) {
    const ControllerId controller = add(options);
    beat(controller, node);
    every(pdo_period, 10ms + 7ms * node, [this, controller, node] {
      bus_.send(controller, Frame::data_frame(can_id::tpdo1 + node, {count_++, 0, 0, 0}));
    });
    answer(controller, node, 30ms * node, "\x4B\x17\x10\x00\xF4\x01\x00\x00");
    return controller;
  }
  /// Adds the heartbeats of an operational node, `behind` after the others in their period.
  void beat(ControllerId controller, NodeId node, Duration behind = {}) {
    every(heartbeat, 20ms + 11ms * node + behind, [this, controller, node] {
      bus_.send(controller, Frame::data_frame(can_id::error_control + node, {5}));
    });
  }
  /// Makes a client read an entry of the node, which answers 2 ms later: eight bytes, of which 2 to
  /// 4 name the entry.
  void answer(ControllerId controller, NodeId node, Duration at_time, const char* bytes,
              Duration later = 2ms) {
    std::array<std::uint8_t, 8> text{};
    for (std::size_t i = 0; i < text.size(); ++i) text.at(i) = static_cast<std::uint8_t>(bytes[i]);
    ask(at_time, node, text.at(1), text.at(2), text.at(3));
    at(at_time + later, [this, controller, node, text] {
      bus_.send(controller, Frame::data_frame(can_id::sdo_response + node, text));
    });
  }
  void ask(Duration at_time, NodeId node, std::uint8_t low, std::uint8_t high, std::uint8_t sub) {
    if (client_ == no_controller) client_ = add();
    at(at_time, [this, node, low, high, sub] {
      bus_.send(client_,
                Frame::data_frame(can_id::sdo_request + node, {0x40, low, high, sub, 0, 0, 0, 0}));
    });
  }
  void send(Duration at_time, ControllerId controller, const Frame& frame) {
    at(at_time, [this, controller, frame] { bus_.send(controller, frame); });
  }

  /// Makes two controllers send at the same time repeatedly: both wait for the end of a SYNC.
  void collide(const Frame& a, const Frame& b) {
    const ControllerId opener = add();
    every(5s, 777ms, [this, opener] { bus_.send(opener, Frame::data_frame(can_id::sync, {})); });
    for (const Frame& frame : {a, b}) {
      const ControllerId who = add();
      every(5s, 777ms + 200us, [this, who, frame] { bus_.send(who, frame); });
    }
  }

  void at(Duration time, std::function<void()> action) {
    plan_.emplace(Time(time), std::move(action));
  }
  void every(Duration period, Duration first, const std::function<void()>& action) {
    at(first, [this, period, first, action] {
      action();
      every(period, first + period, action);
    });
  }

  /// Takes the doctor's interface away from the bus.
  void lose(Duration at_time, const char* why) {
    at(at_time, [this, at_time, why] {
      is_away_ = true;
      doctor_.lose(Time(at_time), why);
    });
  }

  /// Listens from the start for this time.
  text::Findings examine(Duration time) {
    const ControllerId interface =
        bus_.attach({.listener = {.context = this, .on_frame = &Clinic::hear},
                     .bit_rate = listens_at_,
                     .listen_only = true,
                     .on_error = &Clinic::hear_error});
    static_cast<void>(interface);
    bus_.observe({.context = this, .on_error = &Clinic::note_error});
    doctor_.begin(Time{});
    const Time end(time);
    while (true) {
      const Time planned = plan_.empty() ? never : plan_.begin()->first;
      if (planned > end) break;
      bus_.advance(planned);
      const auto action = plan_.extract(plan_.begin());
      action.mapped()();
    }
    bus_.advance(end);
    return doctor_.findings(end);
  }

 private:
  static void hear(void* context, Time now, const Frame& frame) {
    auto& self = *static_cast<Clinic*>(context);
    if (!self.is_away_) self.doctor_.hear(now, frame);
  }
  static void note_error(void* context, Time /*now*/, const BusError& error) {
    static_cast<Clinic*>(context)->kind_ = error.kind;
  }
  /// Takes an error frame as SocketCAN reports it.
  static void hear_error(void* context, Time now) {
    auto& self = *static_cast<Clinic*>(context);
    if (self.is_away_) return;
    Frame frame;
    frame.flags = FrameFlags::error;
    frame.length = Frame::length_max;
    frame.id = error_class::protocol | error_class::bus_error;
    if (self.kind_ == BusErrorKind::acknowledgement) {
      frame.data[error_byte::location] = error_location::ack_slot;
    } else {
      frame.data[error_byte::violation] =
          self.kind_ == BusErrorKind::bit ? error_violation::bit : error_violation::stuff;
    }
    self.doctor_.hear(now, frame);
  }

  SimulatedBus bus_;
  text::Doctor doctor_;
  std::uint32_t listens_at_;
  ControllerId client_ = no_controller;
  std::multimap<Time, std::function<void()>> plan_;
  BusErrorKind kind_ = BusErrorKind::stuff;
  std::uint8_t count_ = 0;
  bool is_away_ = false;
};

}  // namespace canvoy
