// The client's part of remote_access.hpp: selects the device behind a node for the next transfer.
// After the confirmation, an SdoClient of the same node makes the transfer as if it were with the
// node itself.
//
//     RemoteIndication indication(host, {.network = 2});
//     indication.begin(10, 7, Callback<void(SdoEnd)>::to<&Host::may_ask>(*this), 100ms);
//     // may_ask: client.upload(10, 0x6000, 1, bytes, done);
#pragma once

#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/canopen/sdo/sdo_outcome.hpp"

namespace canvoy {

/// One selection at a time, from a node to any module on its bus.
class RemoteIndication {
 public:
  /// Called at the end: done, or the reason: aborted by the node, or no answer.
  using Done = Callback<void(SdoEnd)>;

  /// Makes the object; `node` must outlive it.
  RemoteIndication(Node& node, const RemoteSettings& settings) : node_(node), settings_(settings) {}
  RemoteIndication(const RemoteIndication&) = delete;
  RemoteIndication& operator=(const RemoteIndication&) = delete;

  /// Selects `device` behind `module`, on the default channel of `module`. With a result other than
  /// none it was not begun, and `done` is not called: device_state (another one is under way, or
  /// the frame was refused), no_sdo_connection (no such node-IDs), out_of_memory (the node has no
  /// free route).
  AbortCode begin(NodeId module, NodeId device, Done done, Duration time_out);
  /// Ends it without a call of `done`.
  void cancel();
  /// True while the confirmation is awaited.
  bool busy() const { return timer_.armed(); }

 private:
  void receive(const Frame& frame, Time now);
  void expired(Time now);
  void end(SdoEnd outcome);

  Node& node_;
  RemoteSettings settings_;
  SdoChannel channel_;
  sdo::Message said_{0};
  Done done_;
  Timer timer_{callback<&RemoteIndication::expired>(*this)};
};

}  // namespace canvoy
