// Sleep and wake-up of an add-on device (CiA 447-1, which is not at hand: this is how public
// implementations do it, canvoy/profiles/cia447/network.hpp).
//
// The gateway asks whether anybody objects (01h); who does answers with a reason (81h). When the
// gateway orders sleep (02h), the device prepares itself, and falls silent: nothing is sent,
// whatever happens. A wake-up message of any node (82h) ends that: the device boots anew.
//
//     MutedPort muted(port);
//     CarSleep sleep(network, muted, {});
//     sleep.object(0x02);          // "not now": the meter is running
//     sleep.wake_up();             // a key was pressed
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/muted_port.hpp"

namespace canvoy::cia447 {

struct CarSleepSettings {
  /// From the order to silence.
  Duration preparation = 1s;
  /// A wake-up message is sent once more after this.
  Duration repetition = 500ms;
};

enum class SleepState : std::uint8_t { awake, preparing, asleep };

class CarSleep {
 public:
  static constexpr std::size_t routes = node_id_max + 1;

  /// `port` is that of the node of `network`; both must outlive this.
  CarSleep(CarNetwork& network, MutedPort& port, const CarSleepSettings& settings = {});
  CarSleep(const CarSleep&) = delete;
  CarSleep& operator=(const CarSleep&) = delete;

  SleepState state() const { return state_; }
  void on_change(Callback<void(SleepState)> changed) { changed_ = changed; }

  /// From now on queries are answered with this reason; nothing: with silence, which is consent.
  void object(std::optional<std::uint8_t> reason) { network_.object_to_sleep(reason); }
  /// As if the gateway had ordered sleep: for the gateway itself.
  void prepare();
  /// Also while this device sleeps, which stays silent otherwise.
  void say(SleepCommand command);
  /// Asks the gateway to let the network sleep.
  void request_sleep() { send(SleepCommand::request_sleep, 0); }
  /// Wakes everybody up, and this device where it sleeps.
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
