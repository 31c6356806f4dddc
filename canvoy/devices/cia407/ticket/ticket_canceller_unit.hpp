// The ticket canceller: stamps a ticket with place and time, unless it is blocked (CiA 407, 6.5).
//
//     TicketCancellerUnit canceller(device, {.stamp = ...}, {});
//     canceller.insert_ticket();   // a passenger did
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/state_answer.hpp"
#include "canvoy/devices/cia407/ticket/ticket_data.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The stamp.
struct TicketCancellerHardware {
  Callback<void(const TicketData&)> stamp = {};  ///< a ticket that is inserted
  /// Switches the lamp that shows whether tickets are accepted.
  Callback<void(bool)> show_ready = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TicketCancellerHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::stamp; } || requires { &Plain::show_ready; },
      "the class has no member function of TicketCancellerHardware: stamp or show_ready");
  if constexpr (requires { &Plain::stamp; }) hardware.stamp = callback<&Plain::stamp>(plain);
  if constexpr (requires { &Plain::show_ready; })
    hardware.show_ready = callback<&Plain::show_ready>(plain);
}

class TicketCancellerUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TicketCancellerUnit(VirtualDevice& device, const TicketCancellerHardware& hardware,
                      const NoSettings& settings);

  /// Stamps a ticket with the present place and time, unless it is blocked.
  TicketAnswer insert_ticket();
  /// Number of tickets since the last NMT reset; it is the state information of its events.
  std::uint16_t cancelled() const { return cancelled_; }

 private:
  static const AccessHandlers hook_calls[];

  void reset(ResetScope scope);
  void told(const Entry& entry);
  void look();
  void state_entered(NmtState /*state*/) { look(); }

  VirtualDevice& device_;
  TicketCancellerHardware hardware_;
  StateAnswer state_;
  ToldPlace place_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  std::uint16_t cancelled_ = 0;
  std::optional<bool> is_ready_;
};

/// Catalogue row of the ticket canceller (6.5); bus_unit makes it a part of a device.
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
