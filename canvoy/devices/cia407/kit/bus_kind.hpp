// A kind of virtual device of CiA 407, and its entry in the catalogue.
//
//     struct TicketCancellerKind
//         : BusKind<TicketCancellerUnit, TicketCancellerHardware, TicketCancellerSettings> {
//       static constexpr DeviceInfo info = {.name = "ticket-canceller", ...};
//       static constexpr const VirtualDeviceInfo& provides = ticket_canceller;
//     };
//     const DeviceKind ticket_canceller_kind = bus_device_kind<TicketCancellerKind>();
//
// A unit is constructed with its VirtualDevice, its hardware and its settings. Hardware that is not
// offered at the environment is absent.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia407/kit/messages.hpp"
#include "canvoy/devices/kit/device_kind.hpp"
#include "canvoy/profiles/cia407.hpp"

namespace canvoy::cia407 {

/// For units without settings.
struct NoSettings {};

template <class UnitType, class HardwareType, class SettingsType = NoSettings>
struct BusKind {
  using Unit = UnitType;                          ///< behaviour of the virtual device
  using Hardware = HardwareType;                  ///< what the unit senses and drives
  using Settings = SettingsType;                  ///< what no object of the dictionary sets
  static constexpr std::array<OwnPdo, 0> pdos{};  ///< that the unit adds to those of the profile
  /// Of objects with a size of the maker's choice.
  static constexpr std::array<WantedObject, 0> sizes{};
  static constexpr std::size_t routes = 0;  ///< CAN-IDs that the unit itself receives
};

/// Constructs a unit with what its environment offers.
template <class Kind>
void make_bus_unit(void* memory, VirtualDevice& device, const Environment& environment) {
  using Unit = typename Kind::Unit;
  static_assert(alignof(Unit) <= alignof(std::max_align_t));
  Unit* const unit = std::construct_at(static_cast<Unit*>(memory), device,
                                       environment.get<typename Kind::Hardware>(),
                                       environment.get<typename Kind::Settings>());
  environment.made<Unit>(*unit, device.node());
}

/// The kind as a part of a BusDevice: `&bus_unit<Kind>`.
template <class Kind>
inline constexpr BusUnit bus_unit = {
    .info = Kind::info,
    .provides = &Kind::provides,
    .pdos = Kind::pdos,
    .sizes = Kind::sizes,
    .routes = Kind::routes,
    .bytes = sizeof(typename Kind::Unit),
    .make = make_bus_unit<Kind>,
    .end = [](void* memory) { std::destroy_at(static_cast<typename Kind::Unit*>(memory)); }};

/// The same as a list of one.
template <class Kind>
inline constexpr const BusUnit* only_bus_unit[1] = {&bus_unit<Kind>};

/// A physical device of one virtual device, in the catalogue.
template <class Kind>
inline constexpr DeviceForm bus_form[1] = {
    {.parts =
         [] {
           // They live as long as the program.
           static const auto& parts = *new std::vector<Part>(bus_parts(only_bus_unit<Kind>));
           return std::span<const Part>(parts);
         },
     .bytes = sizeof(BusDevice),
     .make = [](void* memory, const Port& port, NodeId node_id,
                const Environment& environment) -> MadeDevice {
       auto* const made = std::construct_at(static_cast<BusDevice*>(memory), only_bus_unit<Kind>,
                                            port, node_id, environment);
       return {&made->node(), &made->emergency_producer()};
     },
     .end = [](void* memory) { std::destroy_at(static_cast<BusDevice*>(memory)); }}};

/// The row of the catalogue: the kind as a device by itself (bus_form), and as a part of others.
template <class Kind>
constexpr DeviceKind bus_device_kind() {
  return {.info = Kind::info,
          .profile = &profile,
          .forms = bus_form<Kind>,
          .bus_unit = &bus_unit<Kind>};
}

}  // namespace canvoy::cia407
