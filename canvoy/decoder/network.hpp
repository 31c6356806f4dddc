// What a listener knows of the nodes on a bus: their profiles, which objects their PDOs carry, and
// their SDO channels.
// A profile says that beforehand; what SDO transfers write to the PDO parameters (CiA 301, 7.5.2.33
// to 7.5.2.38), or read from them, goes before it.
//
//     Network network;
//     network.set_profile(10, cia419::profile);
//     network.learn(10, 0x1800, 1, cob_id_bytes);
//     if (const PdoPlan* plan = network.pdo(0x18A)) show(plan->mapping);
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
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

class Network {
 public:
  /// Somebody who knows says so: what is heard on the bus does not change it.
  void set_profile(NodeId node, const Profile& profile);

  /// Takes the value of an object of a node, as it was written or read.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> bytes);

  /// CiA 301 where nothing else is known.
  const Profile& profile(NodeId node) const;
  /// The plan of the PDO with this CAN-ID, or null: that of who sends it, or else of a receiver.
  const PdoPlan* pdo(std::uint32_t can_id) const;

  /// The SDO channel that has this CAN-ID: the default one of a node, one that the SDO parameters
  /// of a node say (1200h to 12FFh), or one of the mesh of a car (CiA 447-4).
  std::optional<SdoRoute> sdo(std::uint32_t can_id) const;

 private:
  static constexpr std::size_t can_ids = 0x800;

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
    bool given = false;
  };
  struct Plans {
    std::optional<PdoPlan> transmit;
    std::optional<PdoPlan> receive;
  };

  void use_profile(NodeId node, const Profile& profile);
  void add_default(NodeId node, const Profile& profile, const PdoInfo& pdo, bool is_message);
  void add_message(NodeId node, const Profile& profile, const PdoInfo& pdo, CobId cob_id);
  void add_parameters(const Key& key, const PdoInfo& pdo, CobId cob_id);
  Parameters& parameters(const Key& key);
  void learn_communication(const Key& key, std::uint8_t sub, std::uint64_t value);
  void learn_mapping(const Key& key, std::uint8_t sub, std::uint64_t value);
  void learn_channel(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint64_t value);
  void place_channel(NodeId node, std::uint16_t index, SdoParameters& own);
  void place(const Key& key, Parameters& parameters);
  std::optional<PdoPlan>& plan(std::uint32_t can_id, PdoInfo::Direction direction);

  std::array<Node, node_id_max + 1> nodes_{};
  bool has_car_ = false;  ///< a node of CiA 447
  std::map<Key, Parameters> parameters_;
  std::vector<Plans> plans_{can_ids};
  std::map<std::pair<NodeId, std::uint16_t>, SdoParameters> sdo_parameters_;
  std::map<std::uint16_t, SdoRoute> sdo_routes_;
};

}  // namespace canvoy::decoder
