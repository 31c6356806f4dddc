// Opens and closes an SDO connection for the SDO manager: finds a free channel of the server,
// writes the SDO parameters of both ends, the server's first, and notifies the client by its 1F10h
// (CiA 302-5).
//
//     SdoConnector connector(node, client, cob_ids, {.time_out = 250ms, .tries = 3}, ended);
//     connector.open(connection);   // then connection.state is given, or ending with an error
//     connector.close(connection);  // then it is unused
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/manager/sdo_cob_ids.hpp"
#include "canvoy/canopen/manager/sdo_connections.hpp"
#include "canvoy/canopen/manager/sdo_write_list.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// Handles one connection at a time.
class SdoConnector {
 public:
  /// Patience with the two ends.
  struct Settings {
    Duration time_out = 250ms;  ///< for one answer
    unsigned tries = 3;         ///< for each request
  };
  /// Called when a connection is finished. Null: for a device that has none.
  using Ended = Callback<void(const SdoConnection*)>;

  /// Makes the connector. All arguments must outlive it. The client must not be used otherwise
  /// while the connector is busy.
  SdoConnector(Node& node, SdoClient& client, const SdoCobIds& cob_ids, const Settings& settings,
               Ended ended);
  SdoConnector(const SdoConnector&) = delete;
  SdoConnector& operator=(const SdoConnector&) = delete;

  /// Opens a connection. It remains valid while this object is busy, even if it must end meanwhile.
  void open(SdoConnection& connection);
  /// Closes a connection at both ends, as far as they are not gone.
  void close(SdoConnection& connection);
  /// Notifies a device that it gets no connection, with the error of `wanted`.
  void refuse(const SdoConnection& wanted);
  /// True until the connection that was passed last is finished.
  bool busy() const { return busy_; }
  /// Stops without changing anything. The owner cancels the client.
  void reset();

  /// True in NMT states pre-operational and operational, which allow SDO.
  bool may_speak() const;

 private:
  bool allocate(SdoConnection& connection) const;
  std::uint8_t free_channel_here() const;
  void try_server_channel();
  void server_channel_read(SdoClient::Outcome outcome);
  void write_ends();
  void opened(const SdoWriteList::Outcome& outcome);
  void give_up(DynamicSdoError error);
  void closed(const SdoWriteList::Outcome& outcome);
  void notify(const SdoConnection& connection, DynamicSdoState::Status status);

  Node& node_;
  SdoClient& client_;
  const SdoCobIds& cob_ids_;
  Settings settings_;
  Ended ended_;
  SdoWriteList writes_;
  SdoConnection* current_ = nullptr;
  std::array<std::uint8_t, 4> buffer_{};
  unsigned tries_left_ = 0;
  std::uint8_t channel_ = 0;  ///< channel of the server being examined
  bool busy_ = false;
};

}  // namespace canvoy
