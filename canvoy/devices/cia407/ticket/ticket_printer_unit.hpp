// The ticket printer: prints tickets with place and time, unless it is blocked; reports missing
// paper (FF01h; CiA 407, 6.6, 7.3).
//
//     TicketPrinterUnit printer(device, {.print = ...}, {});
//     printer.sell_ticket();
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/ticket/ticket_data.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The printer.
struct TicketPrinterHardware {
  /// Returns true if the ticket was printed, false without paper. Empty: there is always paper.
  Callback<bool(const TicketData&)> print = {};
  /// Returns true if there is paper; checked every second. Empty: there is always paper.
  Callback<bool()> has_paper = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TicketPrinterHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::print; } || requires { &Plain::has_paper; },
      "the class has no member function of TicketPrinterHardware: print or has_paper");
  if constexpr (requires { &Plain::print; }) hardware.print = callback<&Plain::print>(plain);
  if constexpr (requires { &Plain::has_paper; })
    hardware.has_paper = callback<&Plain::has_paper>(plain);
}

class TicketPrinterUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TicketPrinterUnit(VirtualDevice& device, const TicketPrinterHardware& hardware,
                    const NoSettings& settings);

  /// Prints a ticket with the present place and time, unless it is blocked or has no paper.
  TicketAnswer sell_ticket();

 private:
  static const AccessHandlers hook_calls[];

  void reset(ResetScope scope);
  void told(const Entry& entry) { place_.hear(entry); }
  void look(Time now);
  void report_paper(bool has_paper);

  VirtualDevice& device_;
  TicketPrinterHardware hardware_;
  ToldPlace place_;
  Timer timer_;
};

/// Catalogue row of the ticket printer (6.6); bus_unit makes it a part of a device.
struct TicketPrinterKind : BusKind<TicketPrinterUnit, TicketPrinterHardware> {
  static constexpr DeviceInfo info = {.name = "ticket-printer",
                                      .title = "ticket printer",
                                      .product = "Canvoy CiA 407 ticket printer",
                                      .product_code = 40705,
                                      .node_id = 7,
                                      .hardware = "a printer with paper or without"};
  static constexpr const VirtualDeviceInfo& provides = ticket_printer;
};

}  // namespace canvoy::cia407
