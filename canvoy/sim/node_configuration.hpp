// Writes values to a simulated node at each boot-up, one after the other, as a configuration tool
// would write them by SDO in pre-operational.
//
//     NodeConfiguration configuration(node, description.values);
//     node.start(now);
//     if (configuration.refusal()) ...   // the dictionary has no such object, or another range
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// A value, as SDO writes it.
struct NodeValue {
  std::uint16_t index = 0;            ///< of the object
  std::uint8_t sub = 0;               ///< sub-index
  std::vector<std::uint8_t> bytes{};  ///< little-endian

  friend bool operator==(const NodeValue&, const NodeValue&) = default;
};

class NodeConfiguration {
 public:
  /// A value that the node did not take.
  struct Refusal {
    NodeValue value{};   ///< as it was written
    AbortCode reason{};  ///< answer of the node
  };

  /// Both must outlive this object. A node that already runs is configured at its next boot-up.
  NodeConfiguration(Node& node, std::span<const NodeValue> values);
  NodeConfiguration(const NodeConfiguration&) = delete;
  NodeConfiguration& operator=(const NodeConfiguration&) = delete;

  /// The first value that the node refused at its last boot-up. Later values were still written.
  const std::optional<Refusal>& refusal() const { return refusal_; }

 private:
  void state_entered(NmtState state);

  Node& node_;
  std::span<const NodeValue> values_;
  bool boots_ = true;
  std::optional<Refusal> refusal_{};
  Service service_{};
};

}  // namespace canvoy
