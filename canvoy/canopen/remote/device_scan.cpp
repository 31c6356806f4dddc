#include "canvoy/canopen/remote/device_scan.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

DeviceScan::DeviceScan(Node& node, const Options& options)
    : node_(node),
      options_(options),
      pool_{Request{*this, node}, Request{*this, node}, Request{*this, node}, Request{*this, node}},
      timer_(callback<&DeviceScan::next>(*this)) {}

void DeviceScan::start(Duration later) {
  running_ = true;
  position_ = 0;
  node_.timers().arm(timer_, node_.now() + later);
}

void DeviceScan::go_on() {
  running_ = true;
  node_.timers().arm(timer_, node_.now() + options_.interval);
}

void DeviceScan::stop() {
  running_ = false;
  node_.timers().disarm(timer_);
  for (Request& request : pool_) request.cancel();
}

void DeviceScan::next(Time now) {
  const Duration wait = ask_next();
  if (running_) node_.timers().arm(timer_, now + wait);
}

/// Asks one node, if possible, and returns the time to wait for the next.
Duration DeviceScan::ask_next() {
  const auto request = std::ranges::find_if(pool_, &Request::idle);
  const bool sent_the_last = node_.transmitter().idle();
  if (request == pool_.end() || !sent_the_last) return options_.interval;
  const NodeId id = choose();
  if (id == 0) {
    position_ = 0;
    return options_.pause;
  }
  if (request->ask(id, options_.time_out)) ++requests_;
  return options_.interval;
}

/// Next node to ask; 0 at the end of a round.
NodeId DeviceScan::choose() {
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    if (!preferred_[id]) continue;
    preferred_[id] = false;
    if (id != node_.id()) return id;
  }
  do {
    if (position_ == node_id_max) return 0;
    ++position_;
  } while (position_ == node_.id());
  return position_;
}

void DeviceScan::found(NodeId id) {
  stop();
  found_(id);
}

bool DeviceScan::Request::ask(NodeId server, Duration time_out) {
  server_ = server;  // before the answer, which may come at once
  const AbortCode refused =
      client_.upload(server, object_index::device_type, 0, std::span<std::uint8_t>(device_type_),
                     SdoClient::Done::to<&Request::answered>(*this), time_out);
  if (refused != AbortCode::none) server_ = 0;
  return refused == AbortCode::none;
}

void DeviceScan::Request::cancel() {
  client_.cancel();
  server_ = 0;
}

void DeviceScan::Request::answered(SdoClient::Outcome outcome) {
  const NodeId server = std::exchange(server_, NodeId{0});
  const auto profile = load<std::uint16_t>(device_type_.data());
  if (outcome && *outcome == device_type_.size() && profile == scan_.options_.profile) {
    scan_.found(server);
  }
}

}  // namespace canvoy
