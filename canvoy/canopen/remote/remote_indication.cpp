#include "canvoy/canopen/remote/remote_indication.hpp"

namespace canvoy {

AbortCode RemoteIndication::begin(NodeId module, NodeId device, Done done, Duration time_out) {
  if (busy()) return AbortCode::device_state;
  if (!is_node_id(module) || !is_node_id(device)) return AbortCode::no_sdo_connection;
  channel_ = default_sdo_channel(module);
  said_ = remote_indication(settings_, settings_.network, device);
  const auto receiver = Router::Receiver::to<&RemoteIndication::receive>(*this);
  if (!node_.router().add(channel_.response, receiver)) return AbortCode::out_of_memory;
  done_ = done;
  node_.timers().arm(timer_, node_.now() + time_out);
  if (node_.transmitter().send(said_.frame(channel_.request))) return AbortCode::none;
  cancel();
  return AbortCode::device_state;
}

void RemoteIndication::cancel() {
  if (!busy()) return;
  node_.timers().disarm(timer_);
  node_.router().remove(channel_.response, Router::Receiver::to<&RemoteIndication::receive>(*this));
}

void RemoteIndication::receive(const Frame& frame, Time /*now*/) {
  if (frame.length != Frame::length_max) return;
  const sdo::Message answer(frame);
  if (answer == said_) return end({});
  if (answer.first_byte() == sdo::command(sdo::Response::abort))
    end(SdoEnd::by_server(answer.abort_code()));
}

void RemoteIndication::expired(Time /*now*/) {
  node_.router().remove(channel_.response, Router::Receiver::to<&RemoteIndication::receive>(*this));
  done_(SdoEnd::no_answer());
}

void RemoteIndication::end(SdoEnd outcome) {
  cancel();
  done_(outcome);
}

}  // namespace canvoy
