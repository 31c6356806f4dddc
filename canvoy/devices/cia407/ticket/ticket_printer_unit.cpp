#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"

#include "canvoy/devices/cia407/kit/errors.hpp"

namespace canvoy::cia407 {

constexpr AccessHandlers TicketPrinterUnit::hook_calls[] = {
    after_any_write<&TicketPrinterUnit::told>};

TicketPrinterUnit::TicketPrinterUnit(VirtualDevice& device, const TicketPrinterHardware& hardware,
                                     const NoSettings& /*settings*/)
    : device_(device), hardware_(hardware), timer_(callback<&TicketPrinterUnit::look>(*this)) {
  device.on_reset = callback<&TicketPrinterUnit::reset>(*this);
  device.react(*this, hook_calls);
}

void TicketPrinterUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) place_.forget();
  look(device_.node().now());
}

void TicketPrinterUnit::look(Time now) {
  if (!hardware_.has_paper) return;
  device_.node().timers().arm(timer_, now + 1s);
  report_paper(hardware_.has_paper());
}

void TicketPrinterUnit::report_paper(bool has_paper) {
  device_.report(bus_error::out_of_paper, !has_paper);
}

TicketAnswer TicketPrinterUnit::sell_ticket() {
  const TicketAnswer answer = can_have_tickets(device_, place_);
  if (answer != TicketAnswer::done || !hardware_.print) return answer;
  const bool is_printed = hardware_.print(read_ticket_data(device_.values(), place_));
  report_paper(is_printed);
  return is_printed ? answer : TicketAnswer::out_of_paper;
}

}  // namespace canvoy::cia407
