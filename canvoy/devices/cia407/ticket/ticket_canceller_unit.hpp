// The ticket canceller: stamps a ticket with where and when, unless it is blocked (CiA 407, 6.5).
//
//     TicketCancellerUnit canceller(device, {.stamp = ...}, {});
//     canceller.insert_ticket();   // a passenger did
#pragma once

#include "canvoy/devices/cia407/bus_kind.hpp"
#include "canvoy/devices/cia407/state_answer.hpp"
#include "canvoy/devices/cia407/ticket/ticket_data.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

struct TicketCancellerHardware {
  Callback<void(const TicketData&)> stamp = {};
  /// The lamp that says whether tickets are taken.
  Callback<void(bool)> show_ready = {};
};

class TicketCancellerUnit {
 public:
  /// What `hardware` refers to must outlive this.
  TicketCancellerUnit(VirtualDevice& device, const TicketCancellerHardware& hardware,
                      const NoSettings& settings);
  TicketCancellerUnit(const TicketCancellerUnit&) = delete;
  TicketCancellerUnit& operator=(const TicketCancellerUnit&) = delete;

  TicketAnswer insert_ticket();
  /// Tickets since the last NMT reset; it is the state information of its events.
  std::uint16_t cancelled() const { return cancelled_; }

 private:
  static const HookCalls hook_calls[];

  void reset(ResetScope scope);
  void look();
  void state_entered(NmtState /*state*/) { look(); }

  VirtualDevice& device_;
  TicketCancellerHardware hardware_;
  StateAnswer state_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  std::uint16_t cancelled_ = 0;
  std::optional<bool> is_ready_;
};

struct TicketCancellerKind : BusKind<TicketCancellerUnit, TicketCancellerHardware> {
  static constexpr DeviceInfo info = {.name = "ticket-canceller",
                                      .title = "ticket canceller",
                                      .product = "Canvoy CiA 407 ticket canceller",
                                      .product_code = 40704,
                                      .node_id = 6,
                                      .hardware = "a slot for tickets, a stamp, a lamp"};
  static constexpr const VirtualDeviceInfo& provides = ticket_canceller;
  static constexpr auto pdos = event_pdos;
};

}  // namespace canvoy::cia407
