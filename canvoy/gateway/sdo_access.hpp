// Reads and writes the objects of other nodes: one request at a time for each node, any number of
// nodes at once (CiA 309-1, SDO access services).
//
//     SdoAccess sdo(node, version);
//     sdo.begin(operation, 1s);
#pragma once

#include <array>
#include <deque>
#include <memory>

#include "canvoy/canopen/sdo_client.hpp"
#include "canvoy/gateway/operation.hpp"

namespace canvoy::gateway {

class SdoAccess {
 public:
  SdoAccess(Node& node, Version version) : node_(node), version_(version) {}
  SdoAccess(const SdoAccess&) = delete;
  SdoAccess& operator=(const SdoAccess&) = delete;

  /// Requests to one node are served in the order in which they begin. `time_out` is for each
  /// single answer of the server. `operation` must be cancelled before its life ends, unless it is
  /// answered.
  void begin(Operation& operation, Duration time_out);
  /// False where the operation is none of those under way.
  bool cancel(Operation& operation);
  /// Answers all that are under way.
  void fail_all(const Answer& answer);

 private:
  struct Waiting {
    Operation* operation;
    Duration time_out;
  };
  /// Everything that concerns one server.
  class Lane {
   public:
    Lane(Node& node, Version version) : client_(node), version_(version) {}
    void add(const Waiting& waiting);
    bool cancel(Operation& operation);
    void fail_all(const Answer& answer);

   private:
    void begin_next();
    AbortCode begin(const Waiting& waiting);
    AbortCode received(std::span<const std::uint8_t> bytes);
    void finished(SdoClient::Outcome outcome);

    SdoClient client_;
    Version version_;
    std::deque<Waiting> waiting_;
    Operation* current_ = nullptr;
  };

  Node& node_;
  Version version_;
  std::array<std::unique_ptr<Lane>, node_id_max + 1> lanes_;
};

/// What a client answers for the outcome of a transfer.
Answer sdo_answer(const Operation& operation, AbortCode outcome, Version version);

}  // namespace canvoy::gateway
