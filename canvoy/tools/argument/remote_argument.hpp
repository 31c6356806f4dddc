// A device on a bus behind a node: `2:7` is node 7 of network 2 (canopen/remote/remote_access.hpp),
// and `read can0/2:7 ...` is `read can0 2:7 ...`.
//
//     const RemotePlace place = parse_remote_place("2:7");
//     if (place.network != 0) session.reach_behind(module, settings);
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

struct RemotePlace {
  std::uint16_t network = 0;  ///< 0: the bus itself
  NodeId node = 0;
};

/// Reads `2:7`, or a node as parse_node_id() does. Throws UsageError if it is neither.
RemotePlace parse_remote_place(std::string_view text);

/// Splits the words after a verb if the bus includes the node: `can0/2:7 6401` is `can0 2:7 6401`.
/// Throws UsageError if the text after the slash is no network and node.
void split_remote_bus(std::vector<std::string>& words);

/// The gateway node, and which number of CiA 302-7 is used.
struct RemoteOptions {
  std::string through = "10";
  unsigned indication = RemoteSettings{}.indication;

  void add_to(Verb& command);
};

}  // namespace canvoy::tools
