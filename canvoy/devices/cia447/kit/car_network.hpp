// Common duties of all devices of CiA 447 in their network: the CAN-IDs that follow from the
// node-ID, PDOs that may come from any node, and the identity of the SDO clients (CiA 447-1 and -4
// are not at hand: for the sources, see canvoy/profiles/cia447/network.hpp).
//
//     DeviceNode<layout, CarNetwork::routes> device(port, 5);
//     CarNetwork network(device.node());
//     network.client()      // while a write is under way: the node-ID of who writes
//     network.watch(7);     // on_lost() is called when node 7 falls silent
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <utility>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_channel.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/cia447/pdos.hpp"

namespace canvoy::cia447 {

/// As TPDOs; RPDOs have the same numbers.
inline constexpr auto predefined = pdos_of(PdoInfo::Direction::transmit);

/// Position of each pre-defined PDO in the 32 CAN-IDs of its sender. Part 4 defines it and is not
/// at hand: by default, they follow each other in the order of the list (grade C of our facts).
using PdoOffsets = std::array<std::uint8_t, predefined.size()>;
/// Offsets of CAN-IDs as the profile lists them.
constexpr PdoOffsets listed_offsets() {
  PdoOffsets offsets{};
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::uint8_t>(i);
  return offsets;
}

/// CAN-IDs and heartbeat.
struct CarNetworkSettings {
  PdoOffsets pdo_offsets = listed_offsets();  ///< from the node-ID to CAN-IDs
  Duration heartbeat = 1s;  ///< default of 1017h: in whole milliseconds, 0 to 65.535 s
  /// A monitored node that is not received for this time is lost.
  Duration time_out = 3s;
};

/// Number of the SdoClient that accesses this node on the mesh: 1280h + server - 1. For 0 (none),
/// it is that of node 1.
constexpr std::uint8_t mesh_channel_to(NodeId server) {
  return static_cast<std::uint8_t>(server == 0 ? 0 : server - 1);
}

/// For DictionaryTables::check_number: a code that an object of the profile does not have is
/// reserved according to CiA 447-3, whether it is too high or too low: it is refused like any other
/// one (4.2), with value_range.
AbortCode check_car_number(const DictionaryTables& tables, const EntryShape& row,
                           const std::uint8_t* value);

/// Construct it before the node starts. Constant time for each frame that concerns it; no
/// allocation.
class CarNetwork {
 public:
  /// Number of routes that it needs: one for each node and PDO that any node may send, SDO requests
  /// of 16 clients and the default one, and heartbeats.
  static constexpr std::size_t routes = (predefined.size() + 2) * node_id_max + 1;

  /// Attaches to the node, which must outlive this.
  explicit CarNetwork(Node& node, const CarNetworkSettings& settings = {});

  /// The node of the device.
  Node& node() { return node_; }
  /// The node of the device.
  const Node& node() const { return node_; }

  /// Client of the present request: 1 to 16, by its SDO channel; the default channel belongs to the
  /// gateway. 0: none has come.
  NodeId client() const { return client_; }
  /// True if the present access is an SDO request, not a PDO.
  bool is_request() const { return is_request_; }
  /// Client of the request's channel in the mesh; 0: it came on the default channel, which any
  /// device that is plugged in can use.
  NodeId mesh_client() const { return mesh_client_; }
  /// Sender of the last RPDO with this number; 0: none.
  NodeId source_of(unsigned pdo_number) const;

  /// Objects to the gateway putting the network to sleep, with a reason; nothing: no objection. The
  /// codes of reasons are not known to us.
  void object_to_sleep(std::optional<std::uint8_t> reason) { sleep_objection_ = reason; }
  /// Reason why this device must not sleep; nothing: it may.
  const std::optional<std::uint8_t>& sleep_objection() const { return sleep_objection_; }

  /// Called for each boot-up message and heartbeat, with its state (00h: boot-up). Returns the
  /// former callback, like on_lost().
  Callback<void(NodeId, std::uint8_t)> on_heard(Callback<void(NodeId, std::uint8_t state)> heard) {
    return std::exchange(heard_, heard);
  }
  /// Monitors the heartbeats of a node, from its boot-up message on. A node that boots again was
  /// lost.
  void watch(NodeId node);
  /// Ends the monitoring of a node, without a report.
  void unwatch(NodeId node) { watched_[node] = false; }
  /// Called for each monitored node that is lost, which is then not monitored any more. Returns the
  /// former callback, which the new one has to call.
  Callback<void(NodeId)> on_lost(Callback<void(NodeId)> lost) { return std::exchange(lost_, lost); }
  /// Called after a sign that PDOs of a node, or of all (GapWatch::everyone), were lost. Returns
  /// the former callback, like on_lost().
  Callback<void(NodeId)> on_gap(Callback<void(NodeId)> gap) { return std::exchange(gap_, gap); }

 private:
  /// Applies also to channels on which this node sends no requests.
  AbortCode check_client(const Entry& entry, std::span<const std::uint8_t> value) {
    return check_sdo_parameter(entry, value);
  }
  void defaults_restored(ResetScope scope);
  void listen_to_pdos();
  void listen_to_requests();
  void set_pdo_ids();
  void set_sdo_ids();
  void pdo_came(const Frame& frame, Time now);
  void request_came(const Frame& frame, Time now);
  void error_control_came(const Frame& frame, Time now);
  void look(Time now);
  void lose(NodeId node);
  void missed(NodeId node) { gap_(node); }

  Node& node_;
  CarNetworkSettings settings_;
  Callback<void(ResetScope)> next_restored_;
  Callback<void(NodeId)> lost_;
  Callback<void(NodeId)> gap_;
  Callback<void(NodeId, std::uint8_t)> heard_;
  Timer timer_;
  std::array<Time, node_id_max + 1> last_heard_{};
  std::array<NodeId, predefined.size()> sources_{};
  std::bitset<node_id_max + 1> watched_;
  std::optional<std::uint8_t> sleep_objection_;
  NodeId client_ = 0;
  NodeId mesh_client_ = 0;
  bool is_request_ = false;
  NodeId listens_as_ = 0;  ///< node-ID for which the requests have routes
  bool listens_to_pdos_ = false;
  bool hands_on_ = false;  ///< an RPDO of a node other than the gateway
  std::array<GapWatch::Rhythm, node_id_max> rhythms_;
  GapWatch gaps_;
  static const AccessHandlers hook_calls;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia447
