#include "canvoy/text/car_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

using cia447::SleepCommand;

std::string objection_text(const Frame& frame) {
  // A device without a node-ID may only wake the others.
  if (frame.id == cia447::sleep_can_id(0)) return "wake-up by a device without a node-ID";
  if (frame.data[1] == cia447::no_reason) return "objection to sleep, no reason";
  return fmt::format("objection to sleep, reason {:02X}h", frame.data[1]);
}

std::string single_frame_text(std::span<const std::uint8_t> payload) {
  const std::size_t length = std::min<std::size_t>(payload[0] & 0x0FU, payload.size() - 1);
  return fmt::format("single frame, {} bytes: {}", payload[0] & 0x0FU,
                     bytes_text(payload.subspan(1, length)));
}

std::string flow_control_text(std::span<const std::uint8_t> payload) {
  constexpr std::array<std::string_view, 3> states = {"continue", "wait", "overflow"};
  const unsigned state = payload[0] & 0x0FU;
  return fmt::format("flow control, {}", state < states.size() ? states.at(state) : "unknown");
}

}  // namespace

bool is_sleep_message(std::uint32_t can_id) {
  return can_id >= cia447::sleep_can_id(0) && can_id <= cia447::sleep_can_id(cia447::node_id_max);
}

NodeId sleeping_node(std::uint32_t can_id) {
  return static_cast<NodeId>(can_id - cia447::sleep_can_id(0));
}

std::string sleep_text(const Frame& frame) {
  switch (static_cast<SleepCommand>(frame.data[0])) {
    case SleepCommand::query_objection:
      return "does anybody object to sleep?";
    case SleepCommand::set_sleep_mode:
      return "go to sleep";
    case SleepCommand::request_sleep:
      return "request for sleep";
    case SleepCommand::objection:
      return objection_text(frame);
    case SleepCommand::wake_up:
      return "wake-up";
  }
  return fmt::format("unknown command {:02X}h", frame.data[0]);
}

NodeId iso_tp_node(std::uint32_t can_id) {
  for (NodeId node = cia447::gateway_node_id + 1; node <= cia447::node_id_max; ++node) {
    if (cia447::sdo_request(node, node) == can_id) return node;
  }
  return 0;
}

std::string iso_tp_text(const Frame& frame) {
  const auto payload = frame.payload();
  if (payload.empty()) return "empty";
  switch (payload[0] >> 4) {
    case 0:
      return single_frame_text(payload);
    case 1:
      if (payload.size() < 2) break;
      return fmt::format("first frame of {} bytes: {}", (payload[0] & 0x0FU) << 8 | payload[1],
                         bytes_text(payload.subspan(2)));
    case 2:
      return fmt::format("consecutive frame {}: {}", payload[0] & 0x0FU,
                         bytes_text(payload.subspan(1)));
    case 3:
      return flow_control_text(payload);
    default:
      break;
  }
  return "unknown: " + bytes_text(payload);
}

}  // namespace canvoy::text
