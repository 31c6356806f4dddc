// The ticket canceller and the ticket printer of a bus (CiA 407) that `canvoy device` runs, with
// slot, stamp and paper for passengers and the driver.
//
//     BusTickets tickets(output);
//     tickets.join(environment);
//     tickets.act(parse_bus_press(units, "ticket@2s"));
#pragma once

#include <string_view>

#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

class BusTickets {
 public:
  /// `output` must outlive this.
  explicit BusTickets(const DeviceOutput& output) : output_(output) {}
  BusTickets(const BusTickets&) = delete;
  BusTickets& operator=(const BusTickets&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `ticket` and `sell`, which need the device, and `paper` and `no-paper`; ignores
  /// others.
  void act(const BusPress& press);

 private:
  cia407::TicketCancellerHardware canceller_hardware();
  void stamp(const cia407::TicketData& ticket);
  void show_ready(bool is_ready);
  cia407::TicketPrinterHardware printer_hardware();
  bool print(const cia407::TicketData& ticket);
  bool has_paper() { return has_paper_; }
  void answer(cia407::TicketAnswer answer, std::string_view who);

  const DeviceOutput& output_;
  cia407::TicketCancellerUnit* canceller_ = nullptr;
  cia407::TicketPrinterUnit* printer_ = nullptr;
  bool has_paper_ = true;
};

}  // namespace canvoy::tools
