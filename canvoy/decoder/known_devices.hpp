// Identity (1018h) and profile of each node of a bus. The profile comes from the best source: the
// device type (1000h), a data sheet, another device of the same kind, or the caller.
//
//     KnownDevices devices;
//     devices.add_sheet(sheet);
//     if (devices.add_identity(10, identity)) use(devices.sheet_of(10));
//     show(devices.profile(10).title);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/identity.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::decoder {

/// What the data sheet says about all devices of one kind.
struct DeviceSheet {
  /// A parameter of the sheet, with its value in the device.
  struct Parameter {
    std::uint16_t index = 0;    ///< of the object
    std::uint8_t sub = 0;       ///< sub-index
    std::uint32_t value = 0;    ///< number, without the node-ID
    bool plus_node_id = false;  ///< the node-ID is added to it
  };
  Identity identity = {};                  ///< vendor-ID and product code at least
  const Profile* profile = nullptr;        ///< null: the sheet gives none
  std::vector<Parameter> parameters = {};  ///< of PDOs, and of the entries that give units
};

/// Source of the profile of a node; a later enumerator takes precedence over an earlier one.
enum class KnownBy : std::uint8_t {
  nothing,
  assumed,      ///< the profile of the whole network
  product,      ///< another device with this vendor-ID and product code has it
  device_type,  ///< 1000h
  sheet,        ///< a data sheet exists for this vendor-ID and product code
  given,        ///< set by the caller
};

/// Node-IDs are 0 to 127. Objects passed by reference must outlive this.
class KnownDevices {
 public:
  /// Uses `reading` wherever a device type names `profile`.
  void replace_profile(const Profile& profile, const Profile& reading) {
    readings_[&profile] = &reading;
  }
  /// The reading that is used for a profile; the profile itself if none was chosen.
  const Profile& reading_of(const Profile& profile) const;
  /// Adds a sheet; of two for one product the first counts.
  void add_sheet(const DeviceSheet& sheet) { sheets_.push_back(&sheet); }

  /// The profile of a node; CiA 301 if nothing else is known.
  const Profile& profile(NodeId node) const;
  /// Like profile(), but null if nothing else is known.
  const Profile* known_profile(NodeId node) const { return nodes_.at(node).profile; }
  /// Source of the profile of a node.
  KnownBy known_by(NodeId node) const { return nodes_.at(node).by; }
  /// Identity of a node as far as it was heard.
  const Identity& identity(NodeId node) const { return nodes_.at(node).identity; }

  /// Sets the profile unless a better source has set it. True if the profile has changed.
  bool use_profile(NodeId node, const Profile& profile, KnownBy by);
  /// Adds what is known of the identity. True if a part of it is new.
  bool add_identity(NodeId node, const Identity& identity);
  /// Another device has this node-ID: discards what was heard, keeps what was given. True if the
  /// profile was among what was heard.
  bool forget(NodeId node);

  /// The profile reported by another device with this vendor-ID and product code; null: none.
  const Profile* product_of(NodeId node) const;
  /// The data sheet for the vendor-ID and product code of the node; null if there is none, or if a
  /// better source has set the profile.
  const DeviceSheet* sheet_of(NodeId node) const;
  /// Remembers the profile of this node for other devices of the same kind.
  void remember_product(NodeId node);

 private:
  struct Node {
    const Profile* profile = nullptr;
    KnownBy by = KnownBy::nothing;
    Identity identity;
  };
  static constexpr std::size_t products_max = 1024;

  std::array<Node, node_id_max + 1> nodes_{};
  std::map<const Profile*, const Profile*> readings_;
  std::vector<const DeviceSheet*> sheets_;
  /// By vendor-ID and product code, of devices that have reported both.
  std::map<std::pair<std::uint32_t, std::uint32_t>, const Profile*> products_;
};

}  // namespace canvoy::decoder
