// One CANopen network behind the gateway: carries commands out and reports events. The gateway is
// the NMT master (CiA 309-1, class 3).
//
//     Network network(1, attachment.port(), {.node_id = 126});
//     network.on_event([](const Event& event) { ... });
//     network.start(now);
//     network.begin(operation, now);
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <memory>
#include <optional>

#include "canvoy/canopen/nmt/node_guarding_master.hpp"
#include "canvoy/gateway/answer.hpp"
#include "canvoy/gateway/gateway_device.hpp"
#include "canvoy/gateway/lss_access.hpp"
#include "canvoy/gateway/operation.hpp"
#include "canvoy/gateway/pdo_access.hpp"
#include "canvoy/gateway/sdo_access.hpp"

namespace canvoy::gateway {

// Monitors the nodes of a network by heartbeat and node guarding (CiA 309-1, enable and disable
// guarding, start and disable heartbeat consumer).
//
//     Supervision supervision(device, [](NodeId node, ErrorCode error) { ... });
//     supervision.watch_heartbeat(5, 100ms);

/// Monitors nodes. Reports heartbeat_started and heartbeat_lost, guarding_lost and wrong_nmt_state.
/// Answers unknown_node for a number that is not a node-ID.
class Supervision {
 public:
  /// Called with a node and what has happened to it.
  using Report = std::function<void(NodeId, ErrorCode)>;

  /// Makes the service; `device` must outlive it.
  Supervision(GatewayDevice& device, Report report);

  /// Starts monitoring of a heartbeat; a time of zero ends it.
  Answer watch_heartbeat(std::uint32_t node, Duration time);
  /// Starts node guarding, which needs a node-ID of the gateway; a guard time or life time factor
  /// of zero ends it.
  Answer guard(std::uint32_t node, Duration guard_time, std::uint8_t life_time_factor);
  /// Notes that a node, or all nodes (0), received an NMT command.
  void commanded(NodeId node, NmtCommand command);

 private:
  AbortCode set_time(std::uint32_t node, Duration time);
  void heartbeat_changed(NodeId node, RemoteState state);
  void guarding_event(NodeId node, NodeGuardingEvent event, bool occurs);

  GatewayDevice& device_;
  Report report_;
  std::bitset<node_id_max + 1> heard_;  ///< nodes with a heartbeat
  std::array<NodeGuardingMaster::Slot, node_id_max> slots_;
  NodeGuardingMaster guarding_;
};

/// Settings of a network.
struct NetworkSettings {
  /// Node-ID of the gateway. Without one it reads and writes objects, commands and monitors the
  /// other nodes; PDOs, node guarding and its own heartbeat need one.
  NodeId node_id = node_id_unconfigured;
  Version version = Version::v3_0;  ///< of the answers
  /// Sets the bit rate of the bus, by its index in CiA 305 (0 to 9); returns false if it cannot.
  /// Without this function, every bit rate counts as set: for a bus that has none.
  std::function<bool(unsigned index)> set_bit_rate = {};
};

/// A network behind the gateway. It owns no socket, thread or clock: its owner hands in frames and
/// time, and calls again at deadline(). Callbacks are called from within these calls; they must not
/// begin operations.
class Network {
 public:
  /// Makes the network with this number, 1 to 65535.
  Network(std::uint16_t number, const Port& port, NetworkSettings settings = {});
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Number by which clients name it.
  std::uint16_t number() const { return number_; }
  /// Sets the handler of events; called from within calls of this object.
  void on_event(std::function<void(const Event&)> handler) { event_ = std::move(handler); }
  /// Sets the handler that is called after a frame from the bus or the end of a timer: operations
  /// may have been answered.
  void on_progress(std::function<void(Time)> handler) { progress_ = std::move(handler); }

  /// Starts the gateway's node. See Node::start().
  void start(Time now);
  /// Takes a frame from the bus.
  void receive(const Frame& frame, Time now);
  /// Does what is due. Call it at deadline().
  void advance(Time now);
  /// Notes that the controller has room for frames again.
  void tx_ready(Time now);
  /// Notes a new state of the controller.
  void bus_state(BusState state, Time now);
  /// Reports that the controller or the operating system has lost frames.
  void overrun(Time now);
  /// Reports that an NMT master beside the gateway has booted a slave, or failed to. `state` is the
  /// NMT state of a slave that is up.
  void boot_ended(NodeId slave, BootError error, NmtState state) const {
    emit(Event::booted(number_, slave, error, state));
  }
  /// Time of the next call of advance().
  Time deadline() const { return core_->device.node().deadline(); }

  /// Carries out a command for networks or nodes; the answer may be ready when it returns.
  void begin(Operation& operation, Time now);
  /// Cancels an operation: it gets no answer. No effect on an operation that is answered.
  void cancel(Operation& operation, Time now);
  /// Like cancel(), but at the time of the last call.
  void abandon(Operation& operation);

 private:
  /// The part of a network that `init` makes again.
  struct Core {
    Core(Network& network, const Port& port);
    GatewayDevice device;
    SdoAccess sdo;
    PdoAccess pdo;
    Supervision supervision;
    LssAccess lss;
  };

  std::optional<Answer> execute(Operation& operation);
  std::optional<Answer> access(Operation& operation);
  Answer access_own(Operation& operation);
  Answer command(NmtCommand command, const Request& request);
  Answer produce_heartbeat(Duration period);
  Answer set_id(const Request& request);
  Answer initialise(const Request& request);
  Answer version() const;

  void observe(const Frame& frame);
  void emit(const Event& event) const {
    if (event_) event_(event);
  }
  void report(NodeId node, ErrorCode error) const { emit(Event::of(number_, node, error)); }
  void progress(Time now);
  void watch_connection();
  Node& node() { return core_->device.node(); }

  std::uint16_t number_;
  Port port_;
  NetworkSettings settings_;
  NodeId pending_id_;
  Duration sdo_time_out_ = SdoClient::default_time_out;
  std::function<void(const Event&)> event_;
  std::function<void(Time)> progress_;
  std::unique_ptr<Core> core_;
  bool connection_lost_ = false;  ///< connection lost to a master that guards the gateway
};

}  // namespace canvoy::gateway
