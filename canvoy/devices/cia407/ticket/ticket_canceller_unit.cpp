#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"

namespace canvoy::cia407 {

constexpr ServiceHandlers TicketCancellerUnit::service_calls = {
    .state_entered = method<&TicketCancellerUnit::state_entered>};

constexpr AccessHandlers TicketCancellerUnit::hook_calls[] = {
    after_any_write<&TicketCancellerUnit::told>};

TicketCancellerUnit::TicketCancellerUnit(VirtualDevice& device,
                                         const TicketCancellerHardware& hardware,
                                         const NoSettings& /*settings*/)
    : device_(device),
      hardware_(hardware),
      state_(device, Callback<std::uint16_t()>(
                         [](void* self) {
                           return static_cast<const TicketCancellerUnit*>(self)->cancelled_;
                         },
                         this)) {
  device.on_reset = callback<&TicketCancellerUnit::reset>(*this);
  device.react(*this, hook_calls);
  device.on_event = Callback<void(std::uint8_t, std::uint16_t)>(
      [](void* state, std::uint8_t flags, std::uint16_t) {
        static_cast<StateAnswer*>(state)->take(flags);
      },
      &state_);
  device.node().attach(service_);
}

void TicketCancellerUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) {
    cancelled_ = 0;
    place_.forget();
  }
  look();
}

void TicketCancellerUnit::told(const Entry& entry) {
  place_.hear(entry);
  look();
}

TicketAnswer TicketCancellerUnit::insert_ticket() {
  const TicketAnswer answer = can_have_tickets(device_, place_);
  if (answer != TicketAnswer::done) return answer;
  ++cancelled_;
  if (hardware_.stamp) hardware_.stamp(read_ticket_data(device_.values(), place_));
  return answer;
}

void TicketCancellerUnit::look() {
  const bool is_ready = can_have_tickets(device_, place_) == TicketAnswer::done;
  if (is_ready == is_ready_) return;
  is_ready_ = is_ready;
  if (hardware_.show_ready) hardware_.show_ready(is_ready);
}

}  // namespace canvoy::cia407
