// Contents of the PDOs on a bus, by CAN-ID: those of the profiles of the nodes, and with precedence
// those of PDO parameters that SDO transfers write or read (CiA 301, 7.5.2.33 to 7.5.2.38).
//
//     PdoPlans plans;
//     plans.use_profile(10, cia419::profile);
//     plans.learn(10, 0x1800, 1, 0x18A, cia419::profile);
//     if (const PdoPlan* plan = plans.find(0x18A)) show(plan->mapping);
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::decoder {

/// Content of the PDO with a CAN-ID.
struct PdoPlan {
  NodeId node = 0;  ///< 0: the profile assigns the CAN-ID to a message, whichever node sends it
  PdoInfo::Direction direction = PdoInfo::Direction::transmit;  ///< as `node` sees it
  std::uint16_t number = 0;                                     ///< 0: unknown
  MpdoKind multiplexed = MpdoKind::no;                          ///< the mapping then does not count
  std::vector<std::uint32_t> mapping;  ///< entries of the mapping record, in their order
  std::string_view name = {};          ///< of the message, if the profile names it
  const Profile* profile = nullptr;    ///< of `node`, for the names of the objects
};

class PdoPlans {
 public:
  /// Range of the PDO parameters: 1400h to 1BFFh.
  static constexpr std::uint16_t index_first = object_index::rpdo_parameter;
  static constexpr std::uint16_t index_last = 0x1BFF;  ///< the last TPDO mapping

  /// Sets the profile of a node: discards what the previous profile gave, keeps what was heard.
  void use_profile(NodeId node, const Profile& profile);
  /// Takes a PDO parameter of a node with this profile.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t value,
             const Profile& profile);
  /// Another, unknown device has this node-ID.
  void forget(NodeId node, const Profile& profile);

  /// The plan of the sender of the PDO with this CAN-ID, or else of a receiver; null if there is
  /// none. Valid until something is learned.
  const PdoPlan* find(std::uint32_t can_id) const;
  /// Changes whenever a plan may have changed.
  std::uint32_t generation() const { return generation_; }

 private:
  struct Key {
    NodeId node;
    PdoInfo::Direction direction;
    std::uint16_t number;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// The known parameters of a PDO.
  struct Parameters {
    void map(std::uint8_t sub, std::uint32_t value);

    CobId cob_id;
    bool learned_cob_id = false;
    bool learned_mapping = false;
    std::uint8_t count = 0;  ///< sub-index 00h of the mapping parameter
    std::vector<std::uint32_t> mapping;
    std::optional<std::uint16_t> placed;  ///< the CAN-ID under which the plan is stored
    const Profile* profile = nullptr;     ///< of its node
  };
  struct Plans {
    std::optional<PdoPlan> transmit;
    std::optional<PdoPlan> receive;
  };

  /// Number of PDOs beside those of profiles. A bus has room for a quarter of them: one for each
  /// direction on each CAN-ID.
  static constexpr std::size_t learned_max = 16384;

  void forget_defaults(NodeId node, const Profile& profile);
  void add_default(NodeId node, const Profile& profile, const PdoInfo& pdo, bool is_message);
  void add_car_pdo(NodeId node, const Profile& profile, const PdoInfo& pdo);
  void add_message(NodeId node, const Profile& profile, const PdoInfo& pdo, CobId cob_id);
  void add_parameters(const Key& key, const Profile& profile, const PdoInfo& pdo, CobId cob_id);
  Parameters& parameters(const Key& key);
  Parameters* learned_parameters(const Key& key);
  void place(const Key& key, const Profile& profile, Parameters& own);
  static PdoPlan plan_of(const Key& key, const Parameters& own);
  void take_away(const Key& key, std::uint16_t can_id);
  std::optional<PdoPlan>& plan(std::uint32_t can_id, PdoInfo::Direction direction);

  std::map<Key, Parameters> parameters_;
  std::size_t learned_ = 0;  ///< number of `parameters_` that no profile gives
  ByCanId<Plans> plans_;
  std::uint32_t generation_ = 0;
};

}  // namespace canvoy::decoder
