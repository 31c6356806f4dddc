#include "canvoy/tools/network/lss_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "canvoy/tools/cli/bit_rate_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

namespace {

/// `419`, `0x1A3`, `1A3h`
std::optional<std::uint32_t> parse_number(std::string_view text) {
  const bool has_prefix = text.starts_with("0x") || text.starts_with("0X");
  const bool has_suffix = text.ends_with('h') || text.ends_with('H');
  const bool hexadecimal = has_prefix || has_suffix;
  const std::string_view digits =
      text.substr(has_prefix ? 2 : 0, text.size() - (hexadecimal ? (has_prefix ? 2 : 1) : 0));
  std::uint32_t number = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// The numbers of `1:2:3:4`, and of a printed address.
std::vector<std::string_view> address_parts(std::string_view text) {
  constexpr std::array<std::string_view, 4> names = {"vendor ", " product ", " revision ",
                                                     " serial "};
  if (!text.starts_with(names.front())) return split(text, ':');
  std::vector<std::string_view> parts = split(text, ',');
  for (std::size_t i = 0; i < std::min(parts.size(), names.size()); ++i) {
    if (parts[i].starts_with(names.at(i))) parts[i].remove_prefix(names.at(i).size());
  }
  return parts;
}

}  // namespace

std::string lss_address_text(const LssAddress& address) {
  return fmt::format("vendor {:X}h, product {:X}h, revision {:X}h, serial {:X}h",
                     address.parts[LssAddress::vendor], address.parts[LssAddress::product],
                     address.parts[LssAddress::revision], address.parts[LssAddress::serial]);
}

std::string lss_error_text(lss::Command command, LssError error) {
  if (error.code == LssError::manufacturer) {
    return fmt::format("refused for a reason of the manufacturer, {:02X}h", error.specific);
  }
  const bool stores = command == lss::Command::store;
  if (stores && error.code == LssError::store_unsupported) return "the node cannot store";
  if (stores && error.code == LssError::store_failed) return "its storage does not work";
  if (!stores && error.code == LssError::out_of_range) {
    return command == lss::Command::configure_node_id ? "the node does not take this node-ID"
                                                      : "the node does not have this bit rate";
  }
  return fmt::format("refused with error {:02X}h", error.code);
}

std::string bit_timing_text(std::uint8_t index) {
  return index == lss_bit_timing::automatic
             ? "automatic"
             : fmt::format("{} bit/s", lss_bit_timing::bit_rate(index));
}

LssPattern parse_lss_pattern(std::string_view text) {
  const std::vector<std::string_view> parts = address_parts(text);
  LssPattern pattern;
  bool good = parts.size() <= pattern.known.size();
  for (std::size_t i = 0; good && i < parts.size(); ++i) {
    const std::optional<std::uint32_t> number = parse_number(parts[i]);
    good = number.has_value();
    pattern.address.parts[i] = number.value_or(0);
    pattern.known[i] = good;
  }
  if (good) return pattern;
  throw UsageError(fmt::format(
      "'{}' is no LSS address: write VENDOR:PRODUCT:REVISION:SERIAL, as 0x2F0:419:1:77", text));
}

LssAddress parse_lss_address(std::string_view text) {
  const LssPattern pattern = parse_lss_pattern(text);
  if (pattern.known[LssAddress::serial]) return pattern.address;
  throw UsageError(fmt::format(
      "'{}' is not all of an LSS address: write VENDOR:PRODUCT:REVISION:SERIAL, as 0x2F0:419:1:77",
      text));
}

std::vector<NodeId> parse_node_ids(std::string_view text) {
  std::vector<NodeId> ids;
  for (const std::string_view part : split(text, ',')) {
    const auto dash = part.find('-');
    const NodeId first = parse_node_id(part.substr(0, dash));
    const NodeId last =
        dash == std::string_view::npos ? first : parse_node_id(part.substr(dash + 1));
    if (last < first) {
      throw UsageError(fmt::format("'{}' begins with its end: write {}-{}", part, last, first));
    }
    for (unsigned id = first; id <= last; ++id) {
      if (std::ranges::find(ids, id) != ids.end()) {
        throw UsageError(fmt::format("'{}' has node-ID {} twice", text, id));
      }
      ids.push_back(static_cast<NodeId>(id));
    }
  }
  return ids;
}

std::uint8_t parse_bit_timing(std::string_view text) {
  if (text == "auto") return lss_bit_timing::automatic;
  const std::optional<std::uint32_t> bit_rate = parse_bit_rate(text);
  const std::uint8_t index =
      bit_rate ? lss_bit_timing::index(*bit_rate) : std::uint8_t{lss_bit_timing::unknown};
  if (index != lss_bit_timing::unknown) return index;
  throw UsageError(fmt::format(
      "'{}' is no bit rate of CiA 305: 10k, 20k, 50k, 125k, 250k, 500k, 800k, 1M or auto", text));
}

}  // namespace canvoy::tools
