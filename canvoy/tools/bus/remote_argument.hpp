// A device on a bus behind a node, as users say it: `can0/2:7` is node 7 of network 2, behind a
// node on can0 (canopen/remote/remote_access.hpp).
//
//     const BusArgument bus = parse_bus_argument("can0/2:7");
//     if (bus.is_remote()) session.reach_behind(module, bus.network);
#pragma once

#include <string>
#include <string_view>

#include "canvoy/canopen/remote/remote_access.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

class Session;

struct BusArgument {
  std::string bus;
  std::uint16_t network = 0;
  NodeId device = 0;  ///< behind a node; 0: the bus itself

  bool is_remote() const { return device != 0; }
};

/// Throws UsageError where what stands behind a slash is no network and node.
BusArgument parse_bus_argument(std::string_view text);

/// Through whom, and by which of the numbers that CiA 302-7 would say.
struct RemoteOptions {
  std::string through = "10";
  unsigned indication = RemoteSettings{}.indication;
};
void add_remote_options(CLI::App& command, RemoteOptions& options);
/// To be called before the session is used. Throws UsageError.
void reach(Session& session, const BusArgument& bus, const RemoteOptions& options);

}  // namespace canvoy::tools
