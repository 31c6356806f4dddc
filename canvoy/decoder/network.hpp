// What a listener knows of the nodes on one bus: their profiles and identities, which objects their
// PDOs carry, their SDO channels, and the units of values where nodes choose them.
// A profile says that beforehand; what SDO transfers write to the PDO parameters (CiA 301, 7.5.2.33
// to 7.5.2.38), or read from them, goes before it. Which profile, or data sheet, a node has, its
// device type (1000h) tells, or its identity (1018h), whether others read it or LSS selects by it.
//
//     Network network;
//     network.set_profile(10, cia419::profile);
//     network.learn(10, 0x1800, 1, cob_id_bytes);
//     if (const PdoPlan* plan = network.pdo(0x18A)) show(plan->mapping);
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/identity.hpp"
#include "canvoy/decoder/known_devices.hpp"
#include "canvoy/decoder/known_units.hpp"
#include "canvoy/decoder/pdo_plans.hpp"
#include "canvoy/decoder/sdo_channels.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::decoder {

/// What a frame has told of a node.
struct NodeNews {
  NodeId node = 0;
  bool has_identity = false;              ///< a part of it was not known before
  KnownBy profile_by = KnownBy::nothing;  ///< the profile has become known, in this way
};

class Network {
 public:
  /// Somebody who knows says so: what is heard on the bus does not change it.
  void set_profile(NodeId node, const Profile& profile);
  void set_sheet(NodeId node, const DeviceSheet& sheet);
  /// Of all nodes of which nothing else is known.
  void assume_profile(const Profile& profile);
  /// Takes another reading of a profile wherever a device type names that profile; it has to
  /// outlive the network, and is to be set before all else.
  void replace_profile(const Profile& profile, const Profile& reading) {
    devices_.replace_profile(profile, reading);
  }
  /// The profile as it is to be read.
  const Profile& reading_of(const Profile& profile) const { return devices_.reading_of(profile); }
  /// Of nodes with this vendor-ID and product code. It has to outlive the network.
  void add_sheet(const DeviceSheet& sheet) { devices_.add_sheet(sheet); }

  /// Takes the value of an object of a node, as it was written or read.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> bytes);
  /// Takes what is known of the device with this node-ID. Where it is another one than before, what
  /// was heard of that one is forgotten.
  void learn_identity(NodeId node, const Identity& identity);

  /// CiA 301 where nothing else is known.
  const Profile& profile(NodeId node) const { return devices_.profile(node); }
  const Identity& identity(NodeId node) const { return devices_.identity(node); }
  /// The plan of the PDO with this CAN-ID, or null: that of who sends it, or else of a receiver.
  /// Until the network learns more.
  const PdoPlan* pdo(std::uint32_t can_id) const { return pdos_.find(can_id); }
  /// Whether one of the nodes has CiA 447.
  bool has_car() const { return has_car_; }

  /// The SDO channel that has this CAN-ID: the default one of a node, one that the SDO parameters
  /// of a node say (1200h to 12FFh), or one of the mesh of a car (CiA 447-4).
  std::optional<SdoRoute> sdo(std::uint32_t can_id) const {
    return channels_.find(can_id, has_car_);
  }

  /// The description of an entry with what the node has told in another one of its unit, or of how
  /// much one count is (told_unit.hpp), by SDO or in a data sheet; the same one where it has not.
  /// Node 0: of whichever node it is, as far as those that have told agree. What is returned lives
  /// as long as the network.
  const EntryInfo* as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                           unsigned index, unsigned sub) {
    return units_.as_told(node, profile, entry, index, sub);
  }

  /// What was told since the last clear_news(), or null.
  const NodeNews* news() const { return news_.node == 0 ? nullptr : &news_; }
  void clear_news() { news_ = {}; }
  /// Another number whenever profiles, PDOs or units have changed.
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
  const Profile* assumed_ = nullptr;  ///< of all nodes of which nothing else is known
  NodeNews news_;
};

}  // namespace canvoy::decoder
