// The SDO connections of a network as its SDO manager knows them (CiA 302-5): who asked for which,
// and how far each has come.
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

/// A connection that was asked for or given. One to the SDO manager itself is the registration of
/// a device.
struct SdoConnection {
  enum class State : std::uint8_t { unused, requested, given, ending };

  State state = State::unused;
  NodeId client = 0;
  std::uint8_t client_channel = 0;  ///< 1280h + this
  NodeId server = 0;
  std::uint8_t server_channel = 0;  ///< 1200h + this; 0 while there is none
  std::uint16_t request = 0;        ///< CAN-ID client to server; 0 while there is none
  std::uint16_t response = 0;
  bool wants_all = false;       ///< of a registration: all default SDO channels are the device's
  bool tell_client = false;     ///< ending: by 1F10h, with `error`
  bool client_is_gone = false;  ///< ending: its end needs not be closed
  bool server_is_gone = false;
  DynamicSdoError error = DynamicSdoError::none;
};

/// In memory of the owner, which bounds their number.
class SdoConnections {
 public:
  constexpr explicit SdoConnections(std::span<SdoConnection> memory) : all_(memory) {}

  std::span<const SdoConnection> all() const { return all_; }
  void clear() { std::ranges::fill(all_, SdoConnection{}); }

  /// Null where there is no room.
  SdoConnection* add(const SdoConnection& connection);
  /// The first in this state; null where there is none.
  SdoConnection* find(SdoConnection::State state);
  bool has(SdoConnection::State state) const {
    return std::ranges::find(all_, state, &SdoConnection::state) != all_.end();
  }
  const SdoConnection* find(NodeId client, std::uint8_t client_channel) const;
  /// That of the client with the SDO manager itself. One that is under way counts: a device that
  /// reads of it in its 1F10h may be faster with its first request than with its confirmation.
  const SdoConnection* registration(NodeId client, NodeId manager) const;
  /// A device has all default SDO channels.
  bool is_lent() const;
  /// To whichever of them, in either direction.
  bool is_given(std::uint32_t can_id) const;

  /// False where the client has no such connection; that is opened once more.
  bool request_again(NodeId client, std::uint8_t client_channel);
  /// Those that a device gives back end.
  void release(const DynamicSdoRequest& request);
  /// All of a client that begins anew.
  void end_all(NodeId client);
  /// All of a node that is gone, or has forgotten them.
  void lose(NodeId node);

 private:
  std::span<SdoConnection> all_;
};

}  // namespace canvoy
