#include "canvoy/tools/session/node_sweep.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/unknown_nodes.hpp"

namespace canvoy::tools {

namespace {

constexpr sdo::Multiplexer device_type_place(object_index::device_type, 0);

}  // namespace

NodeSweep::NodeSweep(Session& session) : session_(session) {
  for (NodeId id = 1; id <= node_id_max; ++id) nodes_.at(id).id = id;
  session.bus().on_frame([this](const host::BusFrame& heard) {
    if (heard.origin == host::Origin::elsewhere) hear(heard.frame);
  });
}

void NodeSweep::hear(const Frame& frame) {
  constexpr std::uint8_t toggle_bit = 0x80;
  const bool is_of_lss = !frame.is_extended() && frame.id == can_id::lss_response;
  const auto unconfigured = static_cast<std::uint8_t>(lss::Command::unconfigured);
  if (is_of_lss && frame.length == lss::length && frame.data[0] == unconfigured) {
    has_unconfigured_ = true;
  }
  const NodeId node = sender_of(frame);
  if (node == 0) return;
  Found& found = nodes_.at(node);
  if (frame.id == can_id::sdo_response + unsigned{node}) return take_answer(found, frame);
  found.is_heard = true;
  if (frame.id == can_id::error_control + unsigned{node} && frame.length == 1) {
    const unsigned state = frame.data[0] & ~unsigned{toggle_bit};
    // A boot-up precedes the state pre-operational (CiA 301, 7.2.8.3.3).
    found.state = state == 0 ? NmtState::pre_operational : static_cast<NmtState>(state);
  }
}

/// Answers to other clients, on other objects, do not show whether it would answer here.
void NodeSweep::take_answer(Found& found, const Frame& frame) {
  if (frame.length != Frame::length_max) return;
  const sdo::Message message(frame);
  if (message.multiplexer() != device_type_place) return;
  const bool is_value = message.response() == sdo::Response::initiate_upload;
  if (!is_value && message.response() != sdo::Response::abort) return;
  found.answers = true;
  const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
  if (is_value && message.is_expedited() && size == sdo::expedited_max) {
    found.device_type = message.value();
  }
}

/// Heartbeats of others lose arbitration to requests: the bus is left idle for the duration of each
/// request.
void NodeSweep::ask(NodeId node) {
  constexpr Duration pause_min = 1ms;
  const Time begin = session_.loop().now();
  const sdo::Message request(sdo::command(sdo::Request::initiate_upload), device_type_place);
  session_.send(request.frame(static_cast<std::uint16_t>(can_id::sdo_request + node)));
  const Time now = session_.loop().now();
  session_.run_for(std::max(pause_min, now - begin));
}

void NodeSweep::ask_all() {
  for (NodeId id = 1; id <= node_id_max; ++id) ask(id);
}

bool NodeSweep::ask_silent() {
  bool is_one_asked = false;
  for (NodeId id = 1; id <= node_id_max; ++id) {
    const Found& node = nodes_.at(id);
    if (!node.is_heard || node.answers) continue;
    ask(id);
    is_one_asked = true;
  }
  return is_one_asked;
}

void NodeSweep::ask_unconfigured() {
  session_.send(lss::frame(can_id::lss_request, lss::Command::identify_unconfigured));
}

void NodeSweep::listen_until(Time end) {
  session_.run_for(std::max(Duration{}, end - session_.loop().now()));
}

std::vector<NodeSweep::Found> NodeSweep::found() const {
  std::vector<Found> found;
  for (const Found& node : nodes_) {
    if (node.is_heard || node.answers) found.push_back(node);
  }
  return found;
}

}  // namespace canvoy::tools
