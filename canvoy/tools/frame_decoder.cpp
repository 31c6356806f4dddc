#include "canvoy/tools/frame_decoder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/canopen/manager/dynamic_sdo.hpp"
#include "canvoy/canopen/manager/flying_master.hpp"
#include "canvoy/canopen/nmt.hpp"
#include "canvoy/tools/lss_text.hpp"
#include "canvoy/tools/object_words.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/time_text.hpp"

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

/// By the profile of the node where it gives the code a meaning, else by CiA 301.
std::string_view error_code_text(const Profile& profile, std::uint16_t code) {
  for (const Profile* candidate : {&profile, profile.base}) {
    if (candidate == nullptr) continue;
    for (const ErrorCodeInfo& error : candidate->error_codes) {
      if (error.code == code) return error.text;
    }
  }
  return emergency_text(code);
}

std::string emergency_message_text(const Frame& frame, const Profile& profile) {
  if (frame.length != 8) return "malformed: " + bytes_text(frame.payload());
  const auto code = load<std::uint16_t>(frame.data.data());
  return fmt::format("{:04X}h {}, error register {:02X}h, {}", code, error_code_text(profile, code),
                     frame.data[2], bytes_text(frame.payload().subspan(3)));
}

std::string time_stamp_text(const Frame& frame) {
  const auto bytes = std::span(frame.data).first<time_of_day_bytes>();
  const auto time = decode_time<TimeOfDay>(bytes);
  const bool good = frame.length == time_of_day_bytes && time.valid();
  return good ? time_text(time) : "malformed: " + bytes_text(frame.payload());
}

constexpr std::uint16_t flying_master_first = FlyingMaster::Options{}.active_master;

/// Of the negotiation who is the NMT master, from CAN-ID 071h on (CiA 302-2).
constexpr std::array<std::string_view, 6> flying_master_names = {
    "active NMT master",
    "negotiation of the NMT master",
    "who is the active NMT master?",
    "capable of being NMT master",
    "who is capable of being NMT master?",
    "force a negotiation"};

std::string flying_master_text(const Frame& frame) {
  if (frame.id == flying_master_first && frame.length == 2) {
    return fmt::format("the active NMT master is {}, priority {}", node_text(frame.data[1]),
                       frame.data[0]);
  }
  const std::string name(flying_master_names.at(frame.id - flying_master_first));
  return frame.length == 0 ? name : name + ": " + bytes_text(frame.payload());
}

/// Those that name a node, by function code (CAN-ID without node-ID).
constexpr std::array<std::string_view, 16> service_names = {
    "",      "EMCY",  "",      "TPDO1",        "RPDO1",       "TPDO2", "RPDO2",         "TPDO3",
    "RPDO3", "TPDO4", "RPDO4", "SDO response", "SDO request", "",      "error control", ""};

/// Service and node, as far as the CAN-ID tells.
FrameWords service_of(std::uint16_t id) {
  if (id == can_id::nmt) return {"NMT", 0, ""};
  if (id == can_id::sync) return {"SYNC", 0, ""};
  if (id == can_id::time) return {"TIME", 0, ""};
  if (id == can_id::lss_response || id == can_id::lss_request) return {"LSS", 0, ""};
  if (id == can_id::dynamic_sdo_request) return {"SDO manager", 0, ""};
  const bool flying =
      id >= flying_master_first && id < flying_master_first + flying_master_names.size();
  if (flying) return {"flying master", 0, ""};
  const std::string_view service = service_names[id >> 7];
  const auto node = static_cast<NodeId>(id & node_id_max);
  if (service.empty() || node == 0) return {"other", 0, ""};
  return {std::string(service), node, ""};
}

}  // namespace

FrameWords FrameDecoder::decode(const Frame& frame) {
  if (frame.is_error()) return {"error frame", 0, ""};
  if (frame.is_extended()) return {"29-bit frame", 0, ""};
  const decoder::Decoded& decoded = objects_.decode(frame);
  if (decoded.pdo != nullptr) return pdo(decoded);
  const auto id = static_cast<std::uint16_t>(frame.id);
  if (decoded.service != decoder::Decoded::Service::other) return sdo(frame, decoded);
  FrameWords words = service_of(id);
  if (id > can_id::error_control && words.node != 0) return error_control(frame, words.node);
  words.text = frame.is_remote() ? "remote request" : content(frame, words);
  return words;
}

FrameWords FrameDecoder::sdo(const Frame& frame, const decoder::Decoded& decoded) {
  const bool asks = decoded.service == decoder::Decoded::Service::sdo_request;
  FrameWords words;
  words.service = asks ? "SDO request" : "SDO response";
  words.node = decoded.node;
  words.client = decoded.client;
  if (frame.length != Frame::length_max) {
    words.text = "malformed: " + bytes_text(frame.payload());
    return words;
  }
  words.text = asks ? sdo_.request(frame, words.node, decoded.channel)
                    : sdo_.response(frame, words.node, decoded.channel);
  words.is_middle = decoded.transfer == nullptr && !words.text.starts_with("abort");
  if (decoded.transfer != nullptr) add_transfer(decoded, words);
  return words;
}

FrameWords FrameDecoder::pdo(const decoder::Decoded& decoded) {
  const decoder::PdoPlan& plan = *decoded.pdo;
  const char* direction = plan.direction == PdoInfo::Direction::transmit ? "TPDO" : "RPDO";
  FrameWords words;
  words.service = plan.number == 0 ? "PDO" : direction + std::to_string(plan.number);
  words.node = plan.node;
  words.text = values_text(decoded.values);
  words.values = decoded.values;
  words.marks = decoded.marks;
  if (!plan.name.empty()) words.text = fmt::format("{}: {}", plan.name, words.text);
  return words;
}

/// An expedited message shows its value itself; the last message of others shows that of all.
void FrameDecoder::add_transfer(const decoder::Decoded& decoded, FrameWords& words) {
  const decoder::SdoTransfer& transfer = *decoded.transfer;
  words.values = decoded.values;
  words.marks = decoded.marks;
  const std::string rest = transfer.size > transfer.bytes.size()
                               ? fmt::format(" ... ({} bytes)", transfer.size)
                               : std::string{};
  const std::string_view name = transfer.is_write ? "written" : "read";
  const bool is_named = decoded.values.front().object != nullptr;
  const std::string address = is_named ? object_text(transfer.index, transfer.sub) + " " : "";
  words.transfer = fmt::format("{} {}{}{}", name, address, values_text(decoded.values), rest);
  const bool shows_itself = transfer.kind == decoder::SdoTransfer::Kind::expedited;
  if (!shows_itself) words.text += ": " + words.transfer;
}

/// An answer to a remote frame is node guarding, all else a heartbeat.
FrameWords FrameDecoder::error_control(const Frame& frame, NodeId node) {
  const bool asked = asked_.test(node);
  asked_.set(node, frame.is_remote());
  if (frame.is_remote()) return {"guarding request", node, ""};
  if (frame.length != 1) {
    return {"error control", node, "malformed: " + bytes_text(frame.payload())};
  }
  if (frame.data[0] == 0) return {"boot-up", node, ""};
  const auto state = nmt_state_text(static_cast<NmtState>(frame.data[0] & 0x7F));
  if (!asked) return {"heartbeat", node, std::string(state)};
  return {"guarding answer", node, fmt::format("{}, toggle bit {}", state, frame.data[0] >> 7)};
}

std::string FrameDecoder::content(const Frame& frame, const FrameWords& words) {
  const auto id = static_cast<std::uint16_t>(frame.id);
  std::string malformed = "malformed: " + bytes_text(frame.payload());
  if (id == can_id::nmt) return nmt_text(frame);
  if (id == can_id::sync) return frame.length == 1 ? fmt::format("counter {}", frame.data[0]) : "";
  if (id == can_id::time) return time_stamp_text(frame);
  if (words.service == "flying master") return flying_master_text(frame);
  if (id == can_id::dynamic_sdo_request) return "dynamic SDO request";
  if (words.service == "LSS") {
    if (frame.length != 8) return malformed;
    return id == can_id::lss_request ? lss_master_text(frame) : lss_slave_text(frame);
  }
  if (words.node == 0) return bytes_text(frame.payload());
  return id < can_id::time ? emergency_message_text(frame, network().profile(words.node))
                           : bytes_text(frame.payload());
}

}  // namespace canvoy::tools
