#include "canvoy/tools/frame_decoder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "canvoy/canopen/nmt.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/value.hpp"

namespace canvoy::tools {

namespace {

std::string bytes_text(std::span<const std::uint8_t> bytes) {
  return fmt::format("{:02X}", fmt::join(bytes, " "));
}

std::string nmt_text(const Frame& frame) {
  if (frame.length != 2) return "malformed: " + bytes_text(frame.payload());
  const std::string who = frame.data[1] == 0 ? "all nodes" : node_text(frame.data[1]);
  switch (static_cast<NmtCommand>(frame.data[0])) {
    case NmtCommand::start:
      return "start " + who;
    case NmtCommand::stop:
      return "stop " + who;
    case NmtCommand::enter_pre_operational:
      return "pre-operational " + who;
    case NmtCommand::reset_node:
      return "reset " + who;
    case NmtCommand::reset_communication:
      return "reset communication of " + who;
  }
  return fmt::format("unknown command {:02X}h", frame.data[0]);
}

std::string emergency_message_text(const Frame& frame) {
  if (frame.length != 8) return "malformed: " + bytes_text(frame.payload());
  const auto code = load<std::uint16_t>(frame.data.data());
  return fmt::format("{:04X}h {}, error register {:02X}h, {}", code, emergency_text(code),
                     frame.data[2], bytes_text(frame.payload().subspan(3)));
}

FrameWords error_control(const Frame& frame, NodeId node) {
  if (frame.is_remote()) return {"guarding request", node, ""};
  if (frame.length != 1)
    return {"error control", node, "malformed: " + bytes_text(frame.payload())};
  if (frame.data[0] == 0) return {"boot-up", node, ""};
  return {"heartbeat", node,
          std::string(nmt_state_text(static_cast<NmtState>(frame.data[0] & 0x7F)))};
}

constexpr std::uint16_t lss_slave_id = 0x7E4;
constexpr std::uint16_t lss_master_id = 0x7E5;

/// Those that name a node, by function code (CAN-ID without node-ID).
constexpr std::array<std::string_view, 16> service_names = {
    "",      "EMCY",  "",      "TPDO1",        "RPDO1",       "TPDO2", "RPDO2",         "TPDO3",
    "RPDO3", "TPDO4", "RPDO4", "SDO response", "SDO request", "",      "error control", ""};

/// Service and node, as far as the CAN-ID tells.
FrameWords service_of(std::uint16_t id) {
  if (id == can_id::nmt) return {"NMT", 0, ""};
  if (id == can_id::sync) return {"SYNC", 0, ""};
  if (id == can_id::time) return {"TIME", 0, ""};
  if (id == lss_slave_id || id == lss_master_id) return {"LSS", 0, ""};
  const std::string_view service = service_names[id >> 7];
  const auto node = static_cast<NodeId>(id & node_id_max);
  if (service.empty() || node == 0) return {"other", 0, ""};
  return {service, node, ""};
}

}  // namespace

FrameWords FrameDecoder::decode(const Frame& frame) {
  if (frame.is_error()) return {"error frame", 0, ""};
  if (frame.is_extended()) return {"29-bit frame", 0, ""};
  const auto id = static_cast<std::uint16_t>(frame.id);
  FrameWords words = service_of(id);
  if (id > can_id::error_control && words.node != 0) return error_control(frame, words.node);
  words.text = frame.is_remote() ? "remote request" : content(frame, words);
  return words;
}

std::string FrameDecoder::content(const Frame& frame, const FrameWords& words) {
  const auto id = static_cast<std::uint16_t>(frame.id);
  if (id == can_id::nmt) return nmt_text(frame);
  if (id == can_id::sync) return frame.length == 1 ? fmt::format("counter {}", frame.data[0]) : "";
  if (id == can_id::time) return "";
  if (words.node == 0) return bytes_text(frame.payload());
  if (id < can_id::time) return emergency_message_text(frame);
  if (id >= can_id::sdo_request) return sdo_request(frame, words.node);
  if (id >= can_id::sdo_response) return sdo_response(frame, words.node);
  return bytes_text(frame.payload());
}

std::string FrameDecoder::sdo_request(const Frame& frame, NodeId node) {
  if (frame.length != 8) return "malformed: " + bytes_text(frame.payload());
  const sdo::Message message(frame);
  switch (message.request()) {
    case sdo::Request::initiate_upload:
      return "read " + object(node, message.multiplexer());
    case sdo::Request::initiate_download:
      return "write " + object_with_value(node, message);
    case sdo::Request::download_segment:
      return "write a segment";
    case sdo::Request::upload_segment:
      return "read a segment";
    case sdo::Request::abort:
      return fmt::format("abort {}, {}", object(node, message.multiplexer()),
                         abort_text(message.abort_code()));
    case sdo::Request::block_upload:
      return "block upload";
    case sdo::Request::block_download:
      return "block download";
  }
  return "unknown command";
}

std::string FrameDecoder::sdo_response(const Frame& frame, NodeId node) {
  if (frame.length != 8) return "malformed: " + bytes_text(frame.payload());
  const sdo::Message message(frame);
  switch (message.response()) {
    case sdo::Response::initiate_upload:
      return object_with_value(node, message);
    case sdo::Response::initiate_download:
      return object(node, message.multiplexer()) + " written";
    case sdo::Response::download_segment:
      return "segment written";
    case sdo::Response::upload_segment:
      return "segment";
    case sdo::Response::abort:
      return fmt::format("abort {}, {}", object(node, message.multiplexer()),
                         abort_text(message.abort_code()));
    case sdo::Response::block_upload:
      return "block upload";
    case sdo::Response::block_download:
      return "block download";
  }
  return "unknown command";
}

std::string FrameDecoder::object(NodeId node, sdo::Multiplexer multiplexer) const {
  std::string text = object_text(multiplexer.index(), multiplexer.sub());
  const ObjectInfo* info = find_description(profile_of(node), multiplexer.index());
  if (info == nullptr) return text;
  const EntryInfo* entry = find_entry(*info, multiplexer.sub());
  if (entry == nullptr || entry->name.empty()) return fmt::format("{} {}", text, info->name);
  return fmt::format("{} {}, {}", text, info->name, entry->name);
}

std::string FrameDecoder::object_with_value(NodeId node, sdo::Message message) {
  const sdo::Multiplexer multiplexer = message.multiplexer();
  const std::string text = object(node, multiplexer);
  if (!message.is_expedited()) {
    if (!message.has_size()) return text + ", segmented";
    return fmt::format("{}, {} bytes in segments", text, message.value());
  }
  const std::size_t size = message.has_size() ? message.expedited_size() : sdo::expedited_max;
  learn_profile(node, multiplexer, message.value());
  std::array<std::uint8_t, sdo::expedited_max> bytes{};
  store(bytes.data(), message.value());
  const ObjectInfo* info = find_description(profile_of(node), multiplexer.index());
  const EntryInfo* entry = info == nullptr ? nullptr : find_entry(*info, multiplexer.sub());
  return fmt::format("{} = {}", text, value_text(entry, std::span(bytes).first(size)));
}

void FrameDecoder::learn_profile(NodeId node, sdo::Multiplexer multiplexer, std::uint32_t value) {
  constexpr sdo::Multiplexer device_type(0x1000, 0);
  if (multiplexer == device_type) profiles_.at(node) = find_profile(value);
}

const Profile& FrameDecoder::profile_of(NodeId node) const {
  const Profile* known = profiles_.at(node);
  return known == nullptr ? base_profile() : *known;
}

}  // namespace canvoy::tools
