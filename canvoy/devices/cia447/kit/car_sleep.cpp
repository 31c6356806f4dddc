#include "canvoy/devices/cia447/kit/car_sleep.hpp"

namespace canvoy::cia447 {

CarSleep::CarSleep(CarNetwork& network, MutedPort& port, const CarSleepSettings& settings)
    : network_(network),
      port_(port),
      settings_(settings),
      timer_(callback<&CarSleep::expired>(*this)) {
  const auto came = Callback<void(const Frame&, Time)>::to<&CarSleep::received>(*this);
  for (unsigned node = 0; node <= node_id_max; ++node) {
    network.node().router().add(static_cast<std::uint16_t>(sleep_can_id(node)), came);
  }
}

void CarSleep::received(const Frame& frame, Time) {
  constexpr std::uint8_t length = 8;
  if (frame.length != length) return network_.node().count_malformed();
  const bool is_of_gateway = frame.id == sleep_can_id(gateway_node_id);
  switch (static_cast<SleepCommand>(frame.data[0])) {
    case SleepCommand::query_objection:
      if (const auto reason = network_.sleep_objection(); is_of_gateway && reason) {
        send(SleepCommand::objection, *reason);
      }
      break;
    case SleepCommand::set_sleep_mode:
      if (is_of_gateway) prepare();
      break;
    case SleepCommand::wake_up:
      if (state_ != SleepState::awake) awake();
      break;
    default:
      break;
  }
}

void CarSleep::prepare() {
  if (state_ != SleepState::awake) return;
  enter(SleepState::preparing);
  network_.node().timers().arm(timer_, network_.node().now() + settings_.preparation);
}

/// During its preparation: silence. Later: the second wake-up message.
void CarSleep::expired(Time) {
  if (state_ != SleepState::preparing) return send(SleepCommand::wake_up, no_reason);
  // Stopped, so that events of this time are not sent after the wake-up.
  network_.node().command(NmtCommand::stop);
  port_.mute(true);
  enter(SleepState::asleep);
}

void CarSleep::wake_up() {
  const Time now = network_.node().now();
  port_.mute(false);
  send(SleepCommand::wake_up, no_reason);
  if (state_ != SleepState::awake) awake();
  network_.node().timers().arm(timer_, now + settings_.repetition);
}

void CarSleep::say(SleepCommand command) {
  const bool was_muted = port_.is_muted();
  port_.mute(false);
  send(command, 0);
  port_.mute(was_muted);
}

void CarSleep::awake() {
  if (state_ == SleepState::preparing) network_.node().timers().disarm(timer_);
  port_.mute(false);
  enter(SleepState::awake);
  network_.node().command(NmtCommand::reset_communication);
}

void CarSleep::enter(SleepState state) {
  state_ = state;
  if (changed_) changed_(state);
}

void CarSleep::send(SleepCommand command, std::uint8_t reason) {
  const bool is_named = canvoy::is_node_id(network_.node().id());
  const Frame frame = {.id = sleep_can_id(is_named ? network_.node().id() : 0),
                       .length = 8,
                       .data = {static_cast<std::uint8_t>(command), reason}};
  network_.node().transmitter().send(frame);
}

}  // namespace canvoy::cia447
