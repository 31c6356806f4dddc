#include "canvoy/tools/bus/node_sweep.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/tools/bus/unknown_nodes.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

NodeSweep::NodeSweep(Session& session) : session_(session) {
  for (NodeId id = 1; id <= node_id_max; ++id) nodes_.at(id).id = id;
  for (std::size_t i = 0; i < requests_max; ++i) {
    requests_.push_back(std::make_unique<Request>(*this, session.node()));
  }
  session.bus().on_frame([this](const host::BusFrame& heard) {
    if (heard.origin == host::Origin::elsewhere) hear(heard.frame);
  });
}

void NodeSweep::hear(const Frame& frame) {
  constexpr std::uint8_t toggle_bit = 0x80;
  const NodeId node = sender_of(frame);
  if (node == 0) return;
  Found& found = nodes_.at(node);
  if (frame.id != can_id::sdo_response + unsigned{node}) found.is_heard = true;
  if (frame.id == can_id::error_control + unsigned{node} && frame.length == 1) {
    const unsigned state = frame.data[0] & ~unsigned{toggle_bit};
    // A boot-up says that it is on its way to pre-operational (CiA 301, 7.2.8.3.3).
    found.state = state == 0 ? NmtState::pre_operational : static_cast<NmtState>(state);
  }
}

void NodeSweep::run_for(Duration duration) {
  session_.loop().run_until(session_.loop().now() + duration);
  if (session_.loop().signal() != 0) throw Failure("interrupted");
}

void NodeSweep::listen(Duration duration) {
  run_for(duration);
}

void NodeSweep::ask_all(Duration time_out) {
  constexpr Duration step = 2ms;
  const auto is_idle = [](const std::unique_ptr<Request>& request) { return request->idle(); };
  for (NodeId id = 1; id <= node_id_max;) {
    const auto free = std::ranges::find_if(requests_, is_idle);
    session_.node().advance(session_.loop().now());
    if (free != requests_.end() && (*free)->ask(id, time_out)) {
      ++id;
    } else {
      run_for(step);
    }
  }
  while (!std::ranges::all_of(requests_, is_idle)) run_for(step);
}

std::vector<NodeSweep::Found> NodeSweep::found() const {
  std::vector<Found> found;
  for (const Found& node : nodes_) {
    if (node.is_heard || node.answers) found.push_back(node);
  }
  return found;
}

bool NodeSweep::Request::ask(NodeId server, Duration time_out) {
  server_ = server;
  const AbortCode refused =
      client_.upload(server, object_index::device_type, 0, std::span<std::uint8_t>(bytes_),
                     SdoClient::Done::to<&Request::answered>(*this), time_out);
  if (refused != AbortCode::none) server_ = 0;
  return refused == AbortCode::none;
}

void NodeSweep::Request::answered(SdoClient::Outcome outcome) {
  Found& found = sweep_.nodes_.at(std::exchange(server_, NodeId{0}));
  found.answers = outcome.abort() != AbortCode::time_out;
  if (outcome && *outcome == bytes_.size()) found.device_type = load<std::uint32_t>(bytes_.data());
}

}  // namespace canvoy::tools
