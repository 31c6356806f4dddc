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
#include <string_view>

#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia407/kit/messages.hpp"
#include "canvoy/profiles/cia407.hpp"

namespace canvoy::cia407 {

template <class UnitType, class HardwareType, class SettingsType = NoSettings>
struct BusKind : UnitKind<UnitType, HardwareType, SettingsType> {
  static constexpr std::array<OwnPdo, 0> pdos{};  ///< that the unit adds to those of the profile
  /// Of objects with a size of the maker's choice.
  static constexpr std::array<WantedObject, 0> sizes{};
  static constexpr std::size_t routes = 0;  ///< CAN-IDs that the unit itself receives
};

/// The kind as a part of a BusDevice: `&bus_unit<Kind>`.
template <class Kind>
inline constexpr BusUnit bus_unit = {.info = Kind::info,
                                     .provides = &Kind::provides,
                                     .pdos = Kind::pdos,
                                     .sizes = Kind::sizes,
                                     .routes = Kind::routes,
                                     .unit = unit_maker<Kind, VirtualDevice>};

/// The same as a list of one.
template <class Kind>
inline constexpr const BusUnit* only_bus_unit[1] = {&bus_unit<Kind>};

/// The row of the catalogue: the kind as a device by itself, and as a part of others.
template <class Kind>
constexpr DeviceKind bus_device_kind() {
  static_assert(std::string_view(Kind::info.product).size() <= cia301::name_capacity,
                "1008h of a board has no room for the name of the product");
  return {.info = Kind::info,
          .profile = &profile,
          .forms = composed_form<BusDevice, only_bus_unit<Kind>>,
          .bus_unit = &bus_unit<Kind>};
}

}  // namespace canvoy::cia407
