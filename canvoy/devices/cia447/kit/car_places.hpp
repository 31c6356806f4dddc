// Node-IDs that are reserved for devices with a known identity: by the known part of their
// identity, or by the virtual device that they provide, whatever their maker.
//
//     const CarPlace places[] = {{.id = 3, .provides = &printer_device}};
//     CarMaster master(network, sleep, {}, {.places = places});
//     // a printer that Fastscan finds becomes node 3
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/lss/lss_fastscan.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::cia447 {
/// A reserved node-ID, and its device.
struct CarPlace {
  NodeId id = 0;  ///< 2 to 16
  /// The known part of the identity (1018h). Nothing: any device that provides the virtual device.
  LssPattern identity{};
  const VirtualDeviceInfo* provides = nullptr;  ///< not null if nothing of the identity is known
  /// True if nothing of the identity is known.
  bool is_of_anyone() const {
    return !identity.known[0] && !identity.known[1] && !identity.known[2] && !identity.known[3];
  }
  bool fits(const LssAddress& address) const;  ///< a known part exists and matches
};

/// An entry that providers of a virtual device have, and consumers of its objects do not: the
/// COB-ID of a TPDO that CiA 447-4 gives it, or the last of its objects if it has no TPDO.
struct DeviceMark {
  std::uint16_t index = 0;  ///< of its object
  std::uint8_t sub = 0;     ///< of the entry
};
DeviceMark mark_of(const VirtualDeviceInfo& device);  ///< `device`: of CiA 447-3
/// Node-IDs 1 to 16.
using NodeSet = std::bitset<node_id_max + 1>;

/// The reserved node-ID for an identity; nothing: for another device, or for any.
std::optional<NodeId> place_for(std::span<const CarPlace> places, const LssAddress& address,
                                const NodeSet& present);
/// The only node-ID reserved for any device, while it is free: a device gets it before its identity
/// is known. If there are several, the identity of a device is read first.
std::optional<NodeId> only_place(std::span<const CarPlace> places, const NodeSet& present);

}  // namespace canvoy::cia447
