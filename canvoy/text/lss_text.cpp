#include "canvoy/text/lss_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

using lss::Command;

constexpr std::array<std::string_view, 4> identity_names = {"vendor-ID", "product code",
                                                            "revision number", "serial number"};
constexpr std::array<std::string_view, 6> range_names = {
    "vendor-ID",          "product code",       "revision number from",
    "revision number to", "serial number from", "serial number to"};
constexpr std::uint8_t no_node_id = node_id_unconfigured;

std::uint32_t number_in(const Frame& frame) {
  return load<std::uint32_t>(&frame.data[1]);
}

std::string_view identity_name(std::uint8_t position) {
  return position < identity_names.size() ? identity_names.at(position) : "unknown number";
}

std::string node_id_text(std::uint8_t node_id) {
  return node_id == no_node_id ? "node-ID none" : fmt::format("node-ID {}", node_id);
}

std::string switch_text(std::uint8_t state) {
  if (state == static_cast<std::uint8_t>(LssState::waiting)) return "switch all to waiting";
  if (state == static_cast<std::uint8_t>(LssState::configuration)) {
    return "switch all to configuration";
  }
  return fmt::format("switch all to unknown state {:02X}h", state);
}

std::string bit_timing_text(const Frame& frame) {
  const std::uint8_t table = frame.data[1];
  const std::uint8_t index = frame.data[2];
  if (table == 0 && index == lss_bit_timing::automatic) return "set bit rate by detection";
  const std::uint32_t bit_rate = table == 0 ? lss_bit_timing::bit_rate(index) : 0;
  if (bit_rate != 0) return fmt::format("set bit rate {} kbit/s", bit_rate / 1000);
  return fmt::format("set bit rate of index {} in table {}", index, table);
}

std::string fastscan_text(const Frame& frame) {
  const std::uint8_t bit = frame.data[5];
  if (bit == lss::FastscanRequest::anybody) return "Fastscan, who has no node-ID?";
  const std::string_view name = identity_name(frame.data[6]);
  const bool selects = bit == 0 && frame.data[7] < frame.data[6];
  if (selects) return fmt::format("Fastscan, {} {:08X}h: be selected", name, number_in(frame));
  const std::string_view next = frame.data[6] == frame.data[7] ? "" : identity_name(frame.data[7]);
  return fmt::format("Fastscan, {} {:08X}h down to bit {}{}{}", name, number_in(frame), bit,
                     next.empty() ? "" : ", then ", next);
}

/// The meaning of codes 1 and 2 depends on the service.
std::string result_text(std::string_view what, const Frame& frame,
                        std::initializer_list<std::string_view> reasons) {
  const std::uint8_t error = frame.data[1];
  if (error == LssError::none) return fmt::format("{} done", what);
  std::string refused = fmt::format("{} refused, error {:02X}h", what, error);
  if (error == LssError::manufacturer) {
    return fmt::format("{}: the manufacturer's {:02X}h", refused, frame.data[2]);
  }
  if (error > reasons.size()) return refused;
  return fmt::format("{}: {}", refused, reasons.begin()[error - 1]);
}

/// Position of `command` in a row of commands that begins with `first`; nothing if it is not in it.
std::optional<std::size_t> position_in(Command first, std::size_t count, Command command) {
  const auto position = static_cast<std::size_t>(command) - static_cast<std::size_t>(first);
  return position < count ? std::optional(position) : std::nullopt;
}

}  // namespace

std::string identity_text(const decoder::Identity& identity) {
  std::string text;
  for (std::size_t part = 0; part < identity_names.size(); ++part) {
    if (!identity.has(part)) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {:08X}h", identity_names.at(part), identity.part(part));
  }
  return text;
}

std::string lss_device_text(const decoder::LssFollower::Device& device) {
  std::string identity = identity_text(device.identity);
  if (device.node == 0) return identity;
  const std::string node = node_text(device.node);
  return identity.empty() ? node : fmt::format("{} is {}", node, identity);
}

std::string lss_master_text(const Frame& frame) {
  const auto command = static_cast<Command>(frame.data[0]);
  if (const auto part = position_in(Command::select_vendor, identity_names.size(), command)) {
    return fmt::format("select {} {:08X}h", identity_names.at(*part), number_in(frame));
  }
  if (const auto part = position_in(Command::identify_vendor, range_names.size(), command)) {
    return fmt::format("identify {} {:08X}h", range_names.at(*part), number_in(frame));
  }
  if (const auto part = position_in(Command::inquire_vendor, identity_names.size(), command)) {
    return fmt::format("inquire {}", identity_names.at(*part));
  }
  switch (command) {
    case Command::switch_global:
      return switch_text(frame.data[1]);
    case Command::configure_node_id:
      return "set " + node_id_text(frame.data[1]);
    case Command::configure_bit_timing:
      return bit_timing_text(frame);
    case Command::activate_bit_timing:
      return fmt::format("activate the bit rate after {} ms", load<std::uint16_t>(&frame.data[1]));
    case Command::store:
      return "store";
    case Command::identify_unconfigured:
      return "identify who has no node-ID";
    case Command::fastscan:
      return fastscan_text(frame);
    case Command::inquire_node_id:
      return "inquire node-ID";
    default:
      return fmt::format("unknown command {:02X}h", frame.data[0]);
  }
}

std::string lss_slave_text(const Frame& frame) {
  const auto command = static_cast<Command>(frame.data[0]);
  if (const auto part = position_in(Command::inquire_vendor, identity_names.size(), command)) {
    return fmt::format("{} {:08X}h", identity_names.at(*part), number_in(frame));
  }
  switch (command) {
    case Command::configure_node_id:
      return result_text("node-ID", frame, {"out of range"});
    case Command::configure_bit_timing:
      return result_text("bit rate", frame, {"not supported"});
    case Command::store:
      return result_text("storing", frame, {"not supported", "the storage medium does not work"});
    case Command::selected:
      return "selected";
    case Command::identified:
      return "identified";
    case Command::unconfigured:
      return "has no node-ID";
    case Command::inquire_node_id:
      return node_id_text(frame.data[1]);
    default:
      return fmt::format("unknown command {:02X}h", frame.data[0]);
  }
}

}  // namespace canvoy::text
