// Knowledge of a listener about the nodes on one bus: profiles, identities, contents of PDOs, SDO
// channels, and units of values where nodes choose them. PDO parameters that SDO transfers write or
// read take precedence over those of the profile (CiA 301, 7.5.2.33 to 7.5.2.38). The profile or
// data sheet of a node follows from its device type (1000h) or its identity (1018h), read by SDO or
// selected by LSS.
//
//     Network network;
//     network.set_profile(10, cia419::profile);
//     network.learn(10, 0x1800, 1, cob_id_bytes);
//     if (const PdoPlan* plan = network.pdo(0x18A)) show(plan->mapping);
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/identity.hpp"
#include "canvoy/decoder/known_devices.hpp"
#include "canvoy/decoder/known_units.hpp"
#include "canvoy/decoder/pdo_plans.hpp"
#include "canvoy/decoder/sdo_channels.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::decoder {

/// News about a node from a frame.
struct NodeNews {
  NodeId node = 0;                        ///< node-ID, 1 to 127
  bool has_identity = false;              ///< a part of it was not known before
  KnownBy profile_by = KnownBy::nothing;  ///< source from which the profile has become known
};

class Network {
 public:
  /// Sets the profile of a node. Traffic on the bus does not change it.
  void set_profile(NodeId node, const Profile& profile);
  /// Sets the data sheet of one node, whatever its identity; it must outlive the network.
  void set_sheet(NodeId node, const DeviceSheet& sheet);
  /// Sets the profile of all nodes without a better source.
  void assume_profile(const Profile& profile);
  /// Uses `reading` wherever a device type names `profile`. `reading` must outlive the network; to
  /// be called before all other functions.
  void replace_profile(const Profile& profile, const Profile& reading) {
    devices_.replace_profile(profile, reading);
  }
  /// The reading that is used for a profile.
  const Profile& reading_of(const Profile& profile) const { return devices_.reading_of(profile); }
  /// Adds the data sheet of nodes with this vendor-ID and product code. It must outlive the
  /// network.
  void add_sheet(const DeviceSheet& sheet) { devices_.add_sheet(sheet); }

  /// Takes the value of an object of a node, as written or read.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> bytes);
  /// Takes the identity of the device with this node-ID. If it is another device than before, what
  /// was heard is discarded.
  void learn_identity(NodeId node, const Identity& identity);

  /// The profile of a node; CiA 301 if nothing else is known.
  const Profile& profile(NodeId node) const { return devices_.profile(node); }
  /// Identity of a node as far as it was heard.
  const Identity& identity(NodeId node) const { return devices_.identity(node); }
  /// The plan of the PDO with this CAN-ID: that of the sender, or else of a receiver; null if there
  /// is none. Valid until the network learns more.
  const PdoPlan* pdo(std::uint32_t can_id) const { return pdos_.find(can_id); }
  /// True if one of the nodes has CiA 447.
  bool has_car() const { return has_car_; }

  /// The SDO channel with this CAN-ID: the default channel of a node, one from the SDO parameters
  /// of a node (1200h to 12FFh), or one of the mesh of a car (CiA 447-4).
  std::optional<SdoRoute> sdo(std::uint32_t can_id) const {
    return channels_.find(can_id, has_car_);
  }

  /// The description of an entry with the unit or step that the node gives in another entry
  /// (told_unit.hpp), by SDO or in a data sheet; the same description if it gives none. Node 0: of
  /// any node, if all nodes that reported agree. The result lives as long as the network.
  const EntryInfo* as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                           unsigned index, unsigned sub) {
    return units_.as_told(node, profile, entry, index, sub);
  }

  /// News since the last clear_news(), or null.
  const NodeNews* news() const { return news_.node == 0 ? nullptr : &news_; }
  /// Discards the news, once a caller has taken them.
  void clear_news() { news_ = {}; }
  /// Changes whenever profiles, PDOs or units change.
  std::uint32_t generation() const { return 1 + pdos_.generation() + units_.generation(); }

 private:
  void use_profile(NodeId node, const Profile& profile, KnownBy by);
  void use_sheet(NodeId node, const DeviceSheet& sheet, KnownBy by);
  void assume_car(const Profile& profile);
  void learn_device_type(NodeId node, std::uint32_t value);
  void recognize(NodeId node);
  void forget_device(NodeId node);
  NodeNews& tell_of(NodeId node);

  KnownDevices devices_;
  PdoPlans pdos_;
  SdoChannels channels_;
  KnownUnits units_;
  bool has_car_ = false;
  const Profile* assumed_ = nullptr;  ///< of all nodes without a better source
  NodeNews news_;
};

}  // namespace canvoy::decoder
