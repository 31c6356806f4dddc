// The SDO connections of a network as recorded by its SDO manager: the requesting device, and the
// progress of each (CiA 302-5).
//
//     SdoConnections connections(memory);
//     connections.add({.state = SdoConnection::State::requested, .client = 5, .server = 9});
//     if (SdoConnection* wanted = connections.find(SdoConnection::State::requested)) open(*wanted);
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/dynamic_sdo.hpp"

namespace canvoy {

/// A connection, requested or assigned. A connection to the SDO manager itself is the registration
/// of a device.
struct SdoConnection {
  /// Progress: not in use, waits to be opened, open, or waits to be closed.
  enum class State : std::uint8_t { unused, requested, given, ending };

  State state = State::unused;      ///< see State
  NodeId client = 0;                ///< node-ID of the requesting device
  std::uint8_t client_channel = 0;  ///< 1280h + this
  NodeId server = 0;                ///< node-ID; the manager's own for a registration
  std::uint8_t server_channel = 0;  ///< 1200h + this; 0 if there is none
  std::uint16_t request = 0;        ///< CAN-ID client to server; 0 if there is none
  std::uint16_t response = 0;       ///< server to client
  bool wants_all = false;           ///< for a registration: the device has all default SDO channels
  bool tell_client = false;         ///< ending: notify by 1F10h, with `error`
  bool client_is_gone = false;      ///< ending: its end need not be closed
  bool server_is_gone = false;      ///< ending: its end need not be closed
  DynamicSdoError error = DynamicSdoError::none;  ///< reason that the client is told
};

/// List of connections, in memory of the owner, which limits their number.
class SdoConnections {
 public:
  /// Makes an empty list; `memory` must outlive it.
  constexpr explicit SdoConnections(std::span<SdoConnection> memory) : all_(memory) {}

  /// All places, the unused ones included.
  std::span<const SdoConnection> all() const { return all_; }
  /// Discards all connections, without closing them.
  void clear() { std::ranges::fill(all_, SdoConnection{}); }

  /// Adds a connection; null if there is no room.
  SdoConnection* add(const SdoConnection& connection);
  /// First connection in this state; null if there is none.
  SdoConnection* find(SdoConnection::State state);
  /// True if a connection is in this state.
  bool has(SdoConnection::State state) const {
    return std::ranges::find(all_, state, &SdoConnection::state) != all_.end();
  }
  /// Connection of a client's channel; null if there is none.
  const SdoConnection* find(NodeId client, std::uint8_t client_channel) const;
  /// Connection of the client with the SDO manager itself. One in progress counts: a device that
  /// reads it in its 1F10h may send its first request before its confirmation.
  const SdoConnection* registration(NodeId client, NodeId manager) const;
  /// True if a device has all default SDO channels.
  bool is_lent() const;
  /// True if a connection has this CAN-ID, in either direction.
  bool is_given(std::uint32_t can_id) const;

  /// Opens a connection once more. False if the client has no such connection.
  bool request_again(NodeId client, std::uint8_t client_channel);
  /// Ends the connections that a device returns.
  void release(const DynamicSdoRequest& request);
  /// Ends all connections of a client that restarts.
  void end_all(NodeId client);
  /// Ends all connections of a node that is lost, or has restarted.
  void lose(NodeId node);

 private:
  std::span<SdoConnection> all_;
};

}  // namespace canvoy
