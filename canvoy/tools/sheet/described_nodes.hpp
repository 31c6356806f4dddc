// Nodes given by the user without a bus: a data sheet, a device of the catalogue, or all nodes of a
// network file.
//
//     describe_nodes("10=battery.eds");  // one, with node-ID 10
//     describe_nodes("lift.toml");       // as many as the file has
#pragma once

#include <string>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::tools {

struct DescribedNode {
  std::string bus = {};  ///< empty: not given
  std::string name = {};
  NodeId id = 0;
  formats::DataSheet sheet = {};
};

/// Reads `charger`, `taximeter+printer`, `pump.eds`, `10=pump.eds`, `network.toml`. Throws
/// UsageError for other texts, Failure for a file that cannot be read.
std::vector<DescribedNode> describe_nodes(const std::string& text);

/// A device with is_device_name(). Node-ID 0: that of its first virtual device.
DescribedNode describe_device(const std::string& name, NodeId id);

/// True for a device of the catalogue, or several on one node: `charger`, `taximeter+printer`.
bool is_device_name(const std::string& name);

/// Makes equal names unique by adding the node-IDs. Throws UsageError if two nodes of one bus have
/// one node-ID.
void tell_apart(std::vector<DescribedNode>& nodes);

}  // namespace canvoy::tools
