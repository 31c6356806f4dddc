// Which device each node of a bus is: its identity (1018h), and the profile that it has, by whoever
// knows best: the device type (1000h), a data sheet, another device of the kind, or somebody who
// says so.
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

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/identity.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::decoder {

/// What is known beforehand of all devices of one kind: from their data sheet.
struct DeviceSheet {
  struct Parameter {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::uint32_t value = 0;
    bool plus_node_id = false;
  };
  Identity identity = {};
  const Profile* profile = nullptr;
  std::vector<Parameter> parameters = {};  ///< of PDOs, and what tells units
};

/// How it is known which profile a node has; what comes later goes before what comes earlier.
enum class KnownBy : std::uint8_t {
  nothing,
  assumed,      ///< it is that of the whole network
  product,      ///< another device of this vendor-ID and product code has it
  device_type,  ///< 1000h
  sheet,        ///< there is a data sheet of this vendor-ID and product code
  given,        ///< somebody who knows says so
};

/// Nodes are 0 to 127; what is given by reference has to outlive this.
class KnownDevices {
 public:
  /// Wherever a device type names that profile, it is to be read so.
  void replace_profile(const Profile& profile, const Profile& reading) {
    readings_[&profile] = &reading;
  }
  const Profile& reading_of(const Profile& profile) const;
  void add_sheet(const DeviceSheet& sheet) { sheets_.push_back(&sheet); }

  /// CiA 301 where nothing else is known.
  const Profile& profile(NodeId node) const;
  /// The same, null where nothing else is known.
  const Profile* known_profile(NodeId node) const { return nodes_.at(node).profile; }
  KnownBy known_by(NodeId node) const { return nodes_.at(node).by; }
  const Identity& identity(NodeId node) const { return nodes_.at(node).identity; }

  /// Where nobody knows better. True where it is another one than before.
  bool use_profile(NodeId node, const Profile& profile, KnownBy by);
  /// True where a part of it was not known before.
  bool add_identity(NodeId node, const Identity& identity);
  /// Another device has its node-ID now: what was heard of that one is gone, what was given stays.
  /// True where the profile was one of what was heard.
  bool forget(NodeId node);

  /// What another device of this vendor-ID and product code has told; null: none has.
  const Profile* product_of(NodeId node) const;
  /// That of this vendor-ID and product code; null where there is none, or somebody knows better.
  const DeviceSheet* sheet_of(NodeId node) const;
  /// For other devices of the kind.
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
  /// By vendor-ID and product code, as far as devices have told both.
  std::map<std::pair<std::uint32_t, std::uint32_t>, const Profile*> products_;
};

}  // namespace canvoy::decoder
