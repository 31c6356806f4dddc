// A device on a bus behind a node, as users say it: `2:7` is node 7 of network 2
// (canopen/remote/remote_access.hpp), and `read can0/2:7 ...` is `read can0 2:7 ...`.
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

/// `2:7`, or a node as parse_node_id() knows it. Throws UsageError where it is none.
RemotePlace parse_remote_place(std::string_view text);

/// The words behind a verb, where the bus says the node too: `can0/2:7 6401` is `can0 2:7 6401`.
/// Throws UsageError where what stands behind the slash is no network and node.
void split_remote_bus(std::vector<std::string>& words);

/// Through whom, and by which of the numbers that CiA 302-7 would say.
struct RemoteOptions {
  std::string through = "10";
  unsigned indication = RemoteSettings{}.indication;

  void add_to(Verb& command);
};

}  // namespace canvoy::tools
