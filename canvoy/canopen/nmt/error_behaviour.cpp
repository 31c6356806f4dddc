#include "canvoy/canopen/nmt/error_behaviour.hpp"

namespace canvoy {

namespace {

/// The values of an entry of 1029h.
enum class Reaction : std::uint8_t { leave_operational = 0, none = 1, stop = 2 };

}  // namespace

[[gnu::always_inline]] inline bool ErrorBehaviour::is_communication_error(
    const ServiceEvent& event) {
  if (event.kind == ServiceEvent::error_came) {
    return event.error().code == emergency_code::heartbeat;
  }
  return event.kind == ServiceEvent::bus_state_changed && event.bus_state() == BusState::bus_off;
}

void ErrorBehaviour::on_event(NodeService& service, ServiceEvent& event) {
  if (is_communication_error(event)) static_cast<ErrorBehaviour&>(service).leave_operational();
}

void ErrorBehaviour::on_object_event(NodeService& service, ServiceEvent& event) {
  constexpr auto last = static_cast<std::uint32_t>(Reaction::stop);
  if (event.kind == ServiceEvent::before_write) {
    const bool known = event.entry().sub == 0 || load_word(event.value()) <= last;
    event.refuse(known ? AbortCode::none : AbortCode::value_range);
  }
  if (is_communication_error(event)) static_cast<ErrorBehaviour&>(service).device_failure();
}

void ErrorBehaviour::device_failure(std::uint8_t sub) {
  const auto reaction = static_cast<Reaction>(node_.dictionary().word(object, sub));
  if (reaction == Reaction::stop) return node_.command(NmtCommand::stop);
  if (reaction == Reaction::leave_operational) leave_operational();
}

void ErrorBehaviour::leave_operational() {
  if (node_.state() == NmtState::operational) node_.command(NmtCommand::enter_pre_operational);
}

}  // namespace canvoy
