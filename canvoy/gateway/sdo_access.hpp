// Reads and writes the objects of other nodes: one request at a time for each node, many nodes at
// once (CiA 309-1, SDO access services).
//
//     SdoAccess sdo(node, version);
//     sdo.begin(operation, 1s);
#pragma once

#include <memory>
#include <vector>

#include "canvoy/canopen/sdo/sdo_queue.hpp"
#include "canvoy/gateway/operation.hpp"

namespace canvoy::gateway {

class SdoAccess {
 public:
  /// Makes the service; `node` must outlive it. `version` is that of the values in answers.
  SdoAccess(Node& node, Version version)
      : node_(node), version_(version), workers_(node), queue_(node, workers_.all()) {}

  /// Uses block transfer for long values if the server supports it; otherwise segmented transfer.
  void use_blocks(bool use) { transfer_ = use ? SdoTransfer::automatic : SdoTransfer::segmented; }

  /// Begins a request. Requests to one node are served in the order in which they begin. `time_out`
  /// applies to each single answer of the server. `operation` must be answered or cancelled before
  /// its life ends.
  void begin(Operation& operation, Duration time_out);
  /// Cancels an operation. False if it is not under way.
  bool cancel(Operation& operation);
  /// Answers all operations that are under way.
  void fail_all(const Answer& answer);

 private:
  /// Number of nodes that are served at a time; the backlog of the gateway's node has room for a
  /// frame of each.
  static constexpr std::size_t workers_max = 16;

  /// An operation in the queue.
  struct Job {
    AbortCode receive(std::span<const std::uint8_t> bytes) { return operation->receive(bytes); }
    void done(SdoRequest&) { access->finished(*this); }

    SdoAccess* access;
    Operation* operation;
    SdoRequest request = {};
  };
  void finished(Job& job);
  bool is_stopped() const;

  Node& node_;
  Version version_;
  SdoTransfer transfer_ = SdoTransfer::segmented;
  SdoBlockWorkers<workers_max> workers_;
  SdoQueue queue_;
  std::vector<std::unique_ptr<Job>> jobs_;
};

/// Answer to a client for the outcome of a transfer.
Answer sdo_answer(const Operation& operation, AbortCode outcome, Version version);

}  // namespace canvoy::gateway
