// Sleep and wake-up of an add-on device (CiA 447-1, which is not at hand: this follows public
// implementations, canvoy/profiles/cia447/network.hpp).
//
// The gateway asks for objections (01h); a device that objects answers with a reason (81h). When
// the gateway orders sleep (02h), the device prepares itself, and becomes silent: it sends nothing
// at all. A wake-up message of any node (82h) ends that: the device boots again.
//
//     MutedPort muted(port);
//     CarSleep sleep(network, muted, {});
//     sleep.object(0x02);          // "not now": the meter is running
//     sleep.wake_up();             // a key was pressed
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/port.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"

namespace canvoy::cia447 {

/// The access of a device to the bus, which can be closed: a device that sleeps sends nothing.
///
///     MutedPort muted(port);
///     Node node(tables, memory, muted.port(), 5);
///     muted.mute(true);
class MutedPort {
 public:
  /// Makes an open access; the context of `port` must outlive it.
  explicit MutedPort(const Port& port) : port_(port) {}
  MutedPort(const MutedPort&) = delete;
  MutedPort& operator=(const MutedPort&) = delete;

  /// Must not outlive this.
  Port port() {
    return {.context = this,
            .send =
                [](void* self, const Frame& frame) {
                  return static_cast<MutedPort*>(self)->send(frame);
                },
            .accept = port_.accept == nullptr ? nullptr
                                              : +[](void* self, std::uint16_t id, bool wanted) {
                                                  const Port& port =
                                                      static_cast<MutedPort*>(self)->port_;
                                                  port.accept(port.context, id, wanted);
                                                }};
  }
  /// Frames that are sent meanwhile are lost.
  void mute(bool is_muted) { is_muted_ = is_muted; }
  /// True while nothing is sent.
  bool is_muted() const { return is_muted_; }

 private:
  bool send(const Frame& frame) { return is_muted_ || port_.send(port_.context, frame); }

  Port port_;
  bool is_muted_ = false;
};

/// Times of sleep.
struct CarSleepSettings {
  /// From the order to silence.
  Duration preparation = 1s;
  /// A wake-up message is repeated after this time.
  Duration repetition = 500ms;
};

/// State of the device: works, is about to sleep, or sends nothing.
enum class SleepState : std::uint8_t { awake, preparing, asleep };

class CarSleep {
 public:
  static constexpr std::size_t routes = node_id_max + 1;  ///< CAN-IDs that it receives

  /// `port` is that of the node of `network`; both must outlive this.
  CarSleep(CarNetwork& network, MutedPort& port, const CarSleepSettings& settings = {});

  /// State at present.
  SleepState state() const { return state_; }
  /// Sets the callback for each change of state().
  void on_change(Callback<void(SleepState)> changed) { changed_ = changed; }

  /// Answers queries with this reason; nothing: with silence, which is consent.
  void object(std::optional<std::uint8_t> reason) { network_.object_to_sleep(reason); }
  /// Prepares for sleep, like an order of the gateway: for the gateway itself.
  void prepare();
  /// Sends also while this device sleeps, which is otherwise silent.
  void say(SleepCommand command);
  /// Asks the gateway to let the network sleep.
  void request_sleep() { send(SleepCommand::request_sleep, 0); }
  /// Wakes up all nodes, and this device if it sleeps.
  void wake_up();

 private:
  void received(const Frame& frame, Time now);
  void expired(Time now);
  void awake();
  void enter(SleepState state);
  void send(SleepCommand command, std::uint8_t reason);

  CarNetwork& network_;
  MutedPort& port_;
  CarSleepSettings settings_;
  Callback<void(SleepState)> changed_;
  SleepState state_ = SleepState::awake;
  Timer timer_;
};

}  // namespace canvoy::cia447
