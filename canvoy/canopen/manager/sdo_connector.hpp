// Opens and closes an SDO connection for the SDO manager (CiA 302-5): looks for a free channel of
// the server, writes the SDO parameters of both ends, the server's first, and tells the client by
// its 1F10h.
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
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// One at a time.
class SdoConnector {
 public:
  struct Settings {
    Duration time_out = 250ms;  ///< for one answer
    unsigned tries = 3;         ///< of each request
  };
  /// It is done with one. Null: with a device that has none.
  using Ended = Callback<void(const SdoConnection*)>;

  /// All must outlive this. The client is used by nobody else while this is busy.
  SdoConnector(Node& node, SdoClient& client, const SdoCobIds& cob_ids, const Settings& settings,
               Ended ended);
  SdoConnector(const SdoConnector&) = delete;
  SdoConnector& operator=(const SdoConnector&) = delete;

  /// A connection is open, or about to be closed, for as long as this is busy, even if it is said
  /// to end meanwhile.
  void open(SdoConnection& connection);
  void close(SdoConnection& connection);
  /// Tells a device that it is given none, with the error of `wanted`.
  void refuse(const SdoConnection& wanted);
  bool busy() const { return busy_; }
  /// Leaves everything as it is. The owner cancels the client.
  void reset();

  /// SDO is spoken in NMT states pre-operational and operational.
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
  void tell(const SdoConnection& connection, DynamicSdoState::Status status);

  Node& node_;
  SdoClient& client_;
  const SdoCobIds& cob_ids_;
  Settings settings_;
  Ended ended_;
  SdoWriteList writes_;
  SdoConnection* current_ = nullptr;
  std::array<std::uint8_t, 4> buffer_{};
  unsigned tries_left_ = 0;
  std::uint8_t channel_ = 0;  ///< of the server, that is looked at
  bool busy_ = false;
};

}  // namespace canvoy
