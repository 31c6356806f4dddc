// The ticket canceller and the driver's ticket printer of a bus, with their slot, stamp and paper.
//
//     TicketDevices tickets(nodes, options.sabotage, issued);
//     tickets.cancel();      // a passenger puts his ticket into the slot
//     tickets.buy();
#pragma once

#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"

namespace canvoy::bus_line {

class TicketDevices {
 public:
  /// Called with each ticket as a passenger reads it.
  using Issued = Callback<void(const cia407::TicketData& ticket, bool is_printed)>;

  /// All must outlive this object.
  TicketDevices(BusNodes& nodes, const Sabotage& sabotage, const Issued& issued)
      : nodes_(nodes), sabotage_(sabotage), issued_(issued) {}
  TicketDevices(const TicketDevices&) = delete;
  TicketDevices& operator=(const TicketDevices&) = delete;

  /// Puts both on the bus.
  void add_nodes();
  /// Cancels a ticket. False: the passenger has no valid ticket yet. A real device cannot be seen,
  /// and counts as successful.
  bool cancel();
  /// Buys a ticket from the driver, like cancel(). False: none was printed.
  bool buy();
  /// Takes the paper out of the printer, or puts it back.
  void take_paper(bool is_out) { paper_is_out_ = is_out; }

 private:
  cia407::TicketCancellerHardware canceller_hardware();
  void stamp(const cia407::TicketData& ticket);
  cia407::TicketPrinterHardware printer_hardware();
  bool print(const cia407::TicketData& ticket);
  bool has_paper() { return !paper_is_out_; }

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  Issued issued_;
  cia407::TicketCancellerUnit* canceller_ = nullptr;
  cia407::TicketPrinterUnit* printer_ = nullptr;
  bool paper_is_out_ = false;
};

}  // namespace canvoy::bus_line
