// Nodes as people name them where no bus is needed: a data sheet, a device of the catalogue, or all
// nodes of a network file.
//
//     describe_nodes("10=battery.eds");  // one, with node-ID 10
//     describe_nodes("lift.toml");       // as many as the file has
#pragma once

#include <string>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::tools {

struct DescribedNode {
  std::string bus = {};  ///< empty: not said
  std::string name = {};
  NodeId id = 0;
  formats::DataSheet sheet = {};
};

/// `charger`, `taximeter+printer`, `pump.eds`, `10=pump.eds`, `network.toml`. Throws UsageError for
/// what is none of them, Failure for a file that cannot be read.
std::vector<DescribedNode> describe_nodes(const std::string& text);

/// One that is_device_name(). With node-ID 0 it has that of its first virtual device.
DescribedNode describe_device(const std::string& name, NodeId id);

/// One of the catalogue, or several on one node: `charger`, `taximeter+printer`.
bool is_device_name(const std::string& name);

/// The same names are told apart by the node-IDs. Throws UsageError where two nodes of one bus have
/// one node-ID.
void tell_apart(std::vector<DescribedNode>& nodes);

}  // namespace canvoy::tools
