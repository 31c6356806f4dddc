// The client's half of remote_access.hpp: says to a node with which of the devices behind it the
// next transfer is. When that is confirmed, an SdoClient of the same node makes the transfer as if
// it were with the node itself.
//
//     RemoteIndication indication(host, {.network = 2});
//     indication.begin(10, 7, Callback<void(SdoEnd)>::to<&Host::may_ask>(*this), 100ms);
//     // may_ask: client.upload(10, 0x6000, 1, bytes, done);
#pragma once

#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/canopen/sdo/sdo_outcome.hpp"

namespace canvoy {

class RemoteIndication {
 public:
  /// Done, or why it is not confirmed: aborted by the node, or no answer.
  using Done = Callback<void(SdoEnd)>;

  /// `node` must outlive this.
  RemoteIndication(Node& node, const RemoteSettings& settings) : node_(node), settings_(settings) {}
  RemoteIndication(const RemoteIndication&) = delete;
  RemoteIndication& operator=(const RemoteIndication&) = delete;

  /// To `module`, on its default channel, of `device` behind it. Otherwise than none it was not
  /// begun, and `done` is not called: device_state (another one is under way, or the frame was
  /// refused), no_sdo_connection (no such node-IDs), out_of_memory (the node has no route left).
  AbortCode begin(NodeId module, NodeId device, Done done, Duration time_out);
  /// `done` is not called.
  void cancel();
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
  Timer timer_{Callback<void(Time)>::to<&RemoteIndication::expired>(*this)};
};

}  // namespace canvoy
