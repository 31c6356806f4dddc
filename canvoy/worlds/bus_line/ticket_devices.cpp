#include "canvoy/worlds/bus_line/ticket_devices.hpp"

namespace canvoy::bus_line {

void TicketDevices::add_nodes() {
  using namespace cia407;
  Environment& canceller = nodes_.add_site();
  canceller.provide(callback<&TicketDevices::canceller_hardware>(*this));
  canceller.watch(canceller_);
  nodes_.add(canceller_id, canceller);
  Environment& printer = nodes_.add_site();
  printer.provide(callback<&TicketDevices::printer_hardware>(*this));
  printer.watch(printer_);
  nodes_.add(printer_id, printer);
}

bool TicketDevices::cancel() {
  if (sabotage_.jammed_canceller) return false;
  bool is_done = false;
  nodes_.node(canceller_id).with([&] {
    is_done = canceller_->insert_ticket() == cia407::TicketAnswer::done;
  });
  return is_done || !nodes_.is_played(canceller_id);
}

bool TicketDevices::buy() {
  bool is_done = false;
  nodes_.node(printer_id).with([&] {
    is_done = printer_->sell_ticket() == cia407::TicketAnswer::done;
  });
  return is_done || !nodes_.is_played(printer_id);
}

cia407::TicketCancellerHardware TicketDevices::canceller_hardware() {
  return {.stamp = callback<&TicketDevices::stamp>(*this)};
}

void TicketDevices::stamp(const cia407::TicketData& ticket) {
  constexpr std::uint8_t false_zone = 99;
  cia407::TicketData stamped = ticket;
  if (sabotage_.stuck_zone_wheel) stamped.fare_zone = false_zone;
  issued_(stamped, false);
}

cia407::TicketPrinterHardware TicketDevices::printer_hardware() {
  return {.print = callback<&TicketDevices::print>(*this),
          .has_paper = callback<&TicketDevices::has_paper>(*this)};
}

bool TicketDevices::print(const cia407::TicketData& ticket) {
  if (has_paper()) issued_(ticket, true);
  return has_paper();
}

}  // namespace canvoy::bus_line
