// Starts the other nodes of a segment, for the NMT master: a main on-board computer, or a train bus
// gateway in its place (CiA 407, 8.1.4.3, leaves the choice open; CiA 301, 7.2.8.2).
//
//     NetworkStart start(device.node());     // before the node starts
//
// Starts a node when its heartbeat or boot-up shows that it is not operational. The values that the
// others have received before are not known. Therefore all enter pre-operational at first, so that
// each sends its values when it is operational (8.1.4.3).
#pragma once

#include <array>

#include "canvoy/canopen/nmt/nmt_master.hpp"

namespace canvoy::cia407 {

class NetworkStart {
 public:
  /// Number of CAN-IDs that it receives.
  static constexpr std::size_t routes = node_id_max;
  /// Period after which a waiting node is started again.
  static constexpr Duration period = 1s;

  /// It must outlive the node.
  explicit NetworkStart(Node& node);

 private:
  void reset(ResetScope scope);
  void look(Time now);
  void changed(NodeId id, RemoteState state);

  Node& node_;
  std::array<NmtMaster::RemoteNode, node_id_max> remotes_;
  NmtMaster master_;
  Timer timer_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia407
