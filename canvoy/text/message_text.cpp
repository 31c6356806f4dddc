#include "canvoy/text/message_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>
#include <vector>

#include "canvoy/canopen/manager/flying_master.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

/// The bits of the error register (CiA 301, 7.5.2.2).
constexpr std::array<std::string_view, 8> error_register_names = {
    "generic",       "current",          "voltage",  "temperature",
    "communication", "profile-specific", "reserved", "manufacturer-specific"};

std::string error_register_text(std::uint8_t error_register) {
  std::vector<std::string_view> names;
  for (std::size_t bit = 0; bit < error_register_names.size(); ++bit) {
    if ((error_register >> bit & 1U) != 0) names.push_back(error_register_names.at(bit));
  }
  if (names.empty()) return "00h";
  return fmt::format("{:02X}h ({})", error_register, fmt::join(names, ", "));
}

std::string_view error_code_text(const Profile& profile, std::uint16_t code) {
  for (const Profile* candidate : {&profile, profile.base}) {
    if (candidate == nullptr) continue;
    for (const ErrorCodeInfo& error : candidate->error_codes) {
      if (error.code == code) return error.text;
    }
  }
  return emergency_text(code);
}

constexpr std::uint16_t flying_master_first = FlyingMaster::Options{}.active_master;
constexpr std::array<std::string_view, 6> flying_master_names = {
    "active NMT master",
    "negotiation of the NMT master",
    "who is the active NMT master?",
    "capable of being NMT master",
    "who is capable of being NMT master?",
    "force a negotiation"};

}  // namespace

std::string malformed_text(const Frame& frame) {
  return "malformed: " + bytes_text(frame.payload());
}

std::string nmt_text(const Frame& frame) {
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

std::string emergency_message_text(const Frame& frame, const Profile& profile) {
  const auto code = load<std::uint16_t>(frame.data.data());
  return fmt::format("{:04X}h {}, error register {}, {}", code, error_code_text(profile, code),
                     error_register_text(frame.data[2]), bytes_text(frame.payload().subspan(3)));
}

bool is_flying_master(std::uint32_t can_id) {
  return can_id >= flying_master_first && can_id < flying_master_first + flying_master_names.size();
}

std::string flying_master_text(const Frame& frame) {
  if (frame.id == flying_master_first && frame.length == 2) {
    return fmt::format("the active NMT master is {}, priority {}", node_text(frame.data[1]),
                       frame.data[0]);
  }
  const std::string name(flying_master_names.at(frame.id - flying_master_first));
  return frame.length == 0 ? name : name + ": " + bytes_text(frame.payload());
}

}  // namespace canvoy::text
