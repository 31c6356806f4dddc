#include "canvoy/tools/lss_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/little_endian.hpp"

namespace canvoy::tools {

namespace {

/// Command specifiers, where both sides use them or they stand in a row.
namespace specifier {
constexpr unsigned switch_global = 0x04;
constexpr unsigned node_id = 0x11;
constexpr unsigned bit_timing = 0x13;
constexpr unsigned activate = 0x15;
constexpr unsigned store = 0x17;
constexpr unsigned select_first = 0x40;
constexpr unsigned select_last = 0x43;
constexpr unsigned selected = 0x44;
constexpr unsigned identify_first = 0x46;
constexpr unsigned identify_last = 0x4B;
constexpr unsigned identify_unconfigured = 0x4C;
constexpr unsigned identified = 0x4F;
constexpr unsigned unconfigured_there = 0x50;
constexpr unsigned fastscan = 0x51;
constexpr unsigned inquire_first = 0x5A;
constexpr unsigned inquire_last = 0x5D;
constexpr unsigned inquire_node_id = 0x5E;
}  // namespace specifier

constexpr std::array<std::string_view, 4> identity_names = {"vendor-ID", "product code",
                                                            "revision number", "serial number"};
constexpr std::array<std::string_view, 6> range_names = {
    "vendor-ID",          "product code",       "revision number from",
    "revision number to", "serial number from", "serial number to"};
constexpr std::uint8_t any_bit_rate = 9;
constexpr std::array<int, any_bit_rate> kilobits = {1000, 800, 500, 250, 125, 0, 50, 20, 10};
constexpr std::uint8_t scan_reset = 0x80;
constexpr std::uint8_t no_node_id = 0xFF;

std::uint32_t number_in(const Frame& frame) {
  return load<std::uint32_t>(&frame.data[1]);
}

std::string_view identity_name(std::uint8_t position) {
  return position < identity_names.size() ? identity_names.at(position) : "unknown number";
}

std::string node_id_text(std::uint8_t node_id) {
  return node_id == no_node_id ? "node-ID none" : fmt::format("node-ID {}", node_id);
}

std::string bit_timing_text(const Frame& frame) {
  const std::uint8_t table = frame.data[1];
  const std::uint8_t index = frame.data[2];
  if (table == 0 && index == any_bit_rate) return "set bit rate by detection";
  if (table == 0 && index < kilobits.size() && kilobits.at(index) != 0) {
    return fmt::format("set bit rate {} kbit/s", kilobits.at(index));
  }
  return fmt::format("set bit rate of index {} in table {}", index, table);
}

std::string fastscan_text(const Frame& frame) {
  const std::uint8_t bit = frame.data[5];
  if (bit == scan_reset) return "Fastscan, who has no node-ID?";
  const std::string_view name = identity_name(frame.data[6]);
  const std::string_view next = frame.data[6] == frame.data[7] ? "" : identity_name(frame.data[7]);
  return fmt::format("Fastscan, {} {:08X}h down to bit {}{}{}", name, number_in(frame), bit,
                     next.empty() ? "" : ", then ", next);
}

std::string result_text(std::string_view what, const Frame& frame) {
  const std::uint8_t error = frame.data[1];
  if (error == 0) return fmt::format("{} done", what);
  return fmt::format("{} refused, error {:02X}h", what, error);
}

}  // namespace

std::string lss_master_text(const Frame& frame) {
  const unsigned command = frame.data[0];
  if (command >= specifier::select_first && command <= specifier::select_last) {
    const std::string_view name = identity_names.at(command - specifier::select_first);
    return fmt::format("select {} {:08X}h", name, number_in(frame));
  }
  if (command >= specifier::identify_first && command <= specifier::identify_last) {
    const std::string_view name = range_names.at(command - specifier::identify_first);
    return fmt::format("identify {} {:08X}h", name, number_in(frame));
  }
  if (command >= specifier::inquire_first && command <= specifier::inquire_last) {
    return fmt::format("inquire {}", identity_names.at(command - specifier::inquire_first));
  }
  switch (command) {
    case specifier::switch_global:
      return frame.data[1] == 0 ? "switch all to waiting" : "switch all to configuration";
    case specifier::node_id:
      return "set " + node_id_text(frame.data[1]);
    case specifier::bit_timing:
      return bit_timing_text(frame);
    case specifier::activate:
      return fmt::format("activate the bit rate after {} ms", load<std::uint16_t>(&frame.data[1]));
    case specifier::store:
      return "store";
    case specifier::identify_unconfigured:
      return "identify who has no node-ID";
    case specifier::fastscan:
      return fastscan_text(frame);
    case specifier::inquire_node_id:
      return "inquire node-ID";
    default:
      return fmt::format("unknown command {:02X}h", command);
  }
}

std::string lss_slave_text(const Frame& frame) {
  const unsigned command = frame.data[0];
  if (command >= specifier::inquire_first && command <= specifier::inquire_last) {
    const std::string_view name = identity_names.at(command - specifier::inquire_first);
    return fmt::format("{} {:08X}h", name, number_in(frame));
  }
  switch (command) {
    case specifier::node_id:
      return result_text("node-ID", frame);
    case specifier::bit_timing:
      return result_text("bit rate", frame);
    case specifier::store:
      return result_text("storing", frame);
    case specifier::selected:
      return "selected";
    case specifier::identified:
      return "identified";
    case specifier::unconfigured_there:
      return "has no node-ID";
    case specifier::inquire_node_id:
      return node_id_text(frame.data[1]);
    default:
      return fmt::format("unknown command {:02X}h", command);
  }
}

}  // namespace canvoy::tools
