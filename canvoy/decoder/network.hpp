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

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/decoder/identity.hpp"
#include "canvoy/decoder/told_unit.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::decoder {

/// What a PDO with some CAN-ID carries.
struct PdoPlan {
  NodeId node = 0;  ///< 0: the profile gives the CAN-ID to a message, whichever node sends it
  PdoInfo::Direction direction = PdoInfo::Direction::transmit;
  std::uint16_t number = 0;  ///< 0: not known
  MpdoKind multiplexed = MpdoKind::no;
  std::vector<std::uint32_t> mapping;
  std::string_view name = {};  ///< of the message, where the profile gives it one
  const Profile* profile = nullptr;
};

/// Who talks to whom, by a CAN-ID of SDO.
struct SdoRoute {
  std::uint16_t channel = 0;  ///< CAN-ID of the requests
  NodeId client = 0;          ///< 0: not known
  NodeId server = 0;
  bool is_request = false;
};

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
    readings_[&profile] = &reading;
  }
  /// The profile as it is to be read.
  const Profile& reading_of(const Profile& profile) const;
  /// Of nodes with this vendor-ID and product code. It has to outlive the network.
  void add_sheet(const DeviceSheet& sheet) { sheets_.push_back(&sheet); }

  /// Takes the value of an object of a node, as it was written or read.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> bytes);
  /// Takes what is known of the device with this node-ID. Where it is another one than before, what
  /// was heard of that one is forgotten.
  void learn_identity(NodeId node, const Identity& identity);

  /// CiA 301 where nothing else is known.
  const Profile& profile(NodeId node) const;
  const Identity& identity(NodeId node) const { return nodes_.at(node).identity; }
  /// The plan of the PDO with this CAN-ID, or null: that of who sends it, or else of a receiver.
  /// Until the network learns more.
  const PdoPlan* pdo(std::uint32_t can_id) const;
  /// Whether one of the nodes has CiA 447.
  bool has_car() const { return has_car_; }

  /// The SDO channel that has this CAN-ID: the default one of a node, one that the SDO parameters
  /// of a node say (1200h to 12FFh), or one of the mesh of a car (CiA 447-4).
  std::optional<SdoRoute> sdo(std::uint32_t can_id) const;

  /// The description of an entry with what the node has told in another one of its unit, or of how
  /// much one count is (told_unit.hpp), by SDO or in a data sheet; the same one where it has not.
  /// Node 0: of whichever node it is, as far as those that have told agree. What is returned lives
  /// as long as the network.
  const EntryInfo* as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                           unsigned index, unsigned sub);

  /// What was told since the last clear_news(), or null.
  const NodeNews* news() const { return news_.node == 0 ? nullptr : &news_; }
  void clear_news() { news_ = {}; }
  /// Another number whenever profiles, PDOs or units have changed.
  std::uint32_t generation() const { return generation_; }

 private:
  struct Key {
    NodeId node;
    PdoInfo::Direction direction;
    std::uint16_t number;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// The parameters of a PDO, as far as they are known.
  struct Parameters {
    CobId cob_id;
    bool learned_cob_id = false;
    bool learned_mapping = false;
    std::uint8_t count = 0;  ///< sub-index 00h of the mapping parameter
    std::vector<std::uint32_t> mapping;
    std::optional<std::uint16_t> placed;  ///< the CAN-ID under which its plan stands
  };
  /// SDO parameters: of a server from 1200h on, of a client from 1280h on.
  struct SdoParameters {
    CobId to_server;
    CobId to_client;
    NodeId partner = 0;
    std::uint16_t placed_request = 0;  ///< 0: nowhere
    std::uint16_t placed_response = 0;
  };
  struct Node {
    const Profile* profile = nullptr;
    KnownBy by = KnownBy::nothing;
    Identity identity;
  };
  struct UnitKey {
    std::uint16_t index;
    std::uint8_t sub;
    NodeId node;
    friend auto operator<=>(const UnitKey&, const UnitKey&) = default;
  };
  /// What a told entry is a copy of, and what its teller holds; nothing: what nobody knows.
  using ToldKey = std::pair<const EntryInfo*, std::optional<std::uint32_t>>;
  struct Plans {
    std::optional<PdoPlan> transmit;
    std::optional<PdoPlan> receive;
  };

  static constexpr std::size_t products_max = 1024;
  /// Of PDOs, beside those that profiles tell of. A bus has room for a quarter of them: one of each
  /// direction on each CAN-ID.
  static constexpr std::size_t learned_max = 16384;
  static constexpr std::size_t channels_max = 4096;  ///< of SDO
  static constexpr std::size_t units_max = 4096;
  static constexpr std::size_t told_entries_max = 4096;

  void use_profile(NodeId node, const Profile& profile, KnownBy by);
  void assume_car(const Profile& profile);
  void use_sheet(NodeId node, const DeviceSheet& sheet, KnownBy by);
  void recognize(NodeId node);
  void remember_product(const Node& node);
  void forget_device(NodeId node);
  void forget_defaults(NodeId node);
  void forget_channels(NodeId node);
  NodeNews& tell_of(NodeId node);
  void add_default(NodeId node, const Profile& profile, const PdoInfo& pdo, bool is_message);
  void add_car_pdo(NodeId node, const Profile& profile, const PdoInfo& pdo);
  void add_message(NodeId node, const Profile& profile, const PdoInfo& pdo, CobId cob_id);
  void add_parameters(const Key& key, const PdoInfo& pdo, CobId cob_id);
  Parameters& parameters(const Key& key);
  Parameters* learned_parameters(const Key& key);
  void learn_device_type(NodeId node, std::uint64_t value);
  void learn_communication(const Key& key, std::uint8_t sub, std::uint64_t value);
  void learn_mapping(const Key& key, std::uint8_t sub, std::uint64_t value);
  void learn_channel(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint64_t value);
  void place_channel(NodeId node, std::uint16_t index, SdoParameters& own);
  void place(const Key& key, Parameters& parameters);
  void learn_unit(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint64_t value);
  void forget_units(NodeId node);
  std::optional<std::uint32_t> told_unit(NodeId node, const Teller& teller) const;
  std::optional<PdoPlan>& plan(std::uint32_t can_id, PdoInfo::Direction direction);

  std::array<Node, node_id_max + 1> nodes_{};
  bool has_car_ = false;
  const Profile* assumed_ = nullptr;
  std::map<const Profile*, const Profile*> readings_;
  std::vector<const DeviceSheet*> sheets_;
  /// By vendor-ID and product code, as far as devices have told both.
  std::map<std::pair<std::uint32_t, std::uint32_t>, const Profile*> products_;
  NodeNews news_;
  std::uint32_t generation_ = 1;
  std::map<Key, Parameters> parameters_;
  std::size_t learned_ = 0;  ///< of `parameters_`, those of which no profile had told
  ByCanId<Plans> plans_;
  std::map<std::pair<NodeId, std::uint16_t>, SdoParameters> sdo_parameters_;
  ByCanId<SdoRoute> sdo_routes_;            ///< those that were learned; channel 0: none
  std::map<UnitKey, std::uint32_t> units_;  ///< what tellers hold
  /// Those that were asked for; a copy of the network has the same ones.
  std::map<ToldKey, std::shared_ptr<const ToldEntry>> told_entries_;
};

}  // namespace canvoy::decoder
