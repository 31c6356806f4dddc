// A node given by the user: `10`, `0x0A`, `0Ah`, `10 (0Ah)` and `node 10 (0Ah)`, as printed, or a
// name from the network file.
//
//     use_network_file("network.toml");
//     parse_node_id("pump");  // 5
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::tools {

/// The node number as written or printed; nothing if the text is none.
std::optional<NodeId> find_node_id(std::string_view text);

/// A node of a network file, and its name in it.
struct NamedNode {
  std::string name;
  NodeId id = 0;
};
/// All tables with a `node` or `id` in any network file, as used by `canvoy boot`, `canvoy run` and
/// `canvoy scan`: by `name`, else by `device`, else by the name of the table. Throws Failure if the
/// file cannot be read.
std::vector<NamedNode> read_named_nodes(const std::string& path);

/// Sets the file for lookups of node names; the default is the environment variable CANVOY_NETWORK.
/// The file is read at the first lookup.
void use_network_file(const std::string& path);
/// The nodes of that file; empty without a file.
const std::vector<NamedNode>& named_nodes();

/// The nodes with this name, or else those with a name that contains it; each node-ID once.
std::vector<NamedNode> nodes_called(std::string_view text);
/// True if the text is the number of a node, or the name of one or more.
bool names_node(std::string_view text);
/// `pump left: node 5 (05h)` for each node, separated by commas; limited to a readable number.
std::string choices_text(const std::vector<NamedNode>& nodes);

/// Reads a number, a name, or an unambiguous part of a name. Throws UsageError with the choices if
/// it is no node, or several.
NodeId parse_node_id(std::string_view text);

}  // namespace canvoy::tools
