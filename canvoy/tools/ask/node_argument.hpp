// The node that a user means: `10`, `0x0A`, `0Ah`, `10 (0Ah)` and `node 10 (0Ah)`, as they are
// printed, or a name out of the file of the network.
//
//     use_network_file("network.toml");
//     parse_node_id("pump");  // 5
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"

namespace canvoy::tools {

/// The number of a node as it is written or printed; nothing where it is none.
std::optional<NodeId> find_node_id(std::string_view text);

/// A node of a network file, and what it is called there.
struct NamedNode {
  std::string name;
  NodeId id = 0;
};
/// All tables with a `node` or `id` in any file of a network, as `canvoy boot`, `canvoy run` and
/// `canvoy scan` have it: by their `name`, else their `device`, else the name of the table. Throws
/// Failure where the file cannot be read.
std::vector<NamedNode> read_named_nodes(const std::string& path);

/// The file in which names of nodes are looked up; until then that of the environment's
/// CANVOY_NETWORK, if any. It is read when a name is first looked for.
void use_network_file(const std::string& path);
/// Those of that file; none where there is no file.
const std::vector<NamedNode>& named_nodes();

/// Those with this name, or else those that have it as a part of theirs: each node-ID once.
std::vector<NamedNode> nodes_called(std::string_view text);
/// Whether it is the number of a node, or the name of one or several.
bool names_node(std::string_view text);
/// `pump left: node 5 (05h)` each, with commas; as many as can be read.
std::string choices_text(const std::vector<NamedNode>& nodes);

/// A number, a name, or a part of one that no other has. Throws UsageError where it is no node, or
/// several: with the choices.
NodeId parse_node_id(std::string_view text);

}  // namespace canvoy::tools
