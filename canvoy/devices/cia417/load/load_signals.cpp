#include "canvoy/devices/cia417/load/load_signals.hpp"

#include "canvoy/profiles/cia417/pdos.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

/// RPDO of the load signaling of lift 1; those of the next lift are 10h above.
constexpr unsigned load_rpdo = 0x1502;
/// When many nodes return at one time, the bus may have no room for a request.
constexpr Duration asks_again_after = 1s;
/// A car waits with open doors until the end of an overload: that PDO may be lost.
constexpr Duration asks_for_overload_after = 5s;

}  // namespace

constexpr AccessHandlers LoadSignals::hook_calls[] = {
    after_write<&LoadSignals::received, zero_load_reached>};
constexpr ServiceHandlers LoadSignals::service_calls = {
    .reset = method<&LoadSignals::reset>,
    .state_entered = method<&LoadSignals::state_entered>,
    .error_changed = method<&LoadSignals::error_changed>,
    .hooks = hook_calls};

LoadSignals::LoadSignals(Node& node, Rpdos& rpdos, HeartbeatConsumer& heartbeats,
                         const LoadSignalsSettings& settings)
    : node_(node),
      rpdos_(rpdos),
      heartbeats_(heartbeats),
      settings_(settings),
      zero_(node.dictionary(), settings.lift),
      full_(node.dictionary(), settings.lift),
      overload_(node.dictionary(), settings.lift),
      timer_(callback<&LoadSignals::expired>(*this)) {
  node.attach(service_);
}

void LoadSignals::reset(ResetScope) {
  is_heard_ = false;
  node_.timers().disarm(timer_);
}

void LoadSignals::state_entered(NmtState state) {
  if (state == NmtState::operational) ask();
}

void LoadSignals::begin_anew() {
  forget();
  ask();
}

void LoadSignals::heard(NodeId node, RemoteState state) {
  if (node != settings_.load_unit) return;
  if (state == RemoteState::boot_up) forget();
  if (state == RemoteState::operational) ask();
}

void LoadSignals::forget() {
  is_heard_ = false;
  changed_();
}

void LoadSignals::ask() {
  if (settings_.load_unit == 0 || node_.state() != NmtState::operational) return;
  node_.timers().arm(timer_, node_.now() + asks_again_after);
  rpdos_.request(number_of_rpdo(load_rpdo + lift_pdo_pitch * (settings_.lift - 1)));
}

void LoadSignals::expired(Time) {
  const bool waits = !is_heard_ || overload_.is_set();
  if (waits && heartbeats_.state(settings_.load_unit) != RemoteState::lost) ask();
}

void LoadSignals::received() {
  is_heard_ = true;
  if (overload_.is_set()) node_.timers().arm(timer_, node_.now() + asks_for_overload_after);
  changed_();
}

LiftLoad LoadSignals::now() {
  if (settings_.load_unit == 0) return {};
  return {.known = is_heard_ && heartbeats_.state(settings_.load_unit) != RemoteState::lost,
          .zero = zero_.is_set(),
          .full = full_.is_set(),
          .overload = overload_.is_set()};
}

void LoadSignals::error_changed(const Error& error, bool present) {
  if (error.code != canvoy::emergency_code::heartbeat || error.instance != settings_.load_unit)
    return;
  forget();
  if (!present) ask();
}

}  // namespace canvoy::cia417
