#include "canvoy/formats/sheet/sheet_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "canvoy/can/real_text.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/formats/terms.hpp"

namespace canvoy::formats {

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes number_bytes(std::uint64_t number, unsigned length) {
  Bytes bytes(8);
  store(bytes.data(), number);
  bytes.resize(length);
  return bytes;
}

/// True if a number, or the pattern of one, fits the type. Tools write -1 for FFh and FFh for -1.
bool fits(const SheetNumber& sheet_number, std::uint8_t node_id, unsigned bits) {
  if (bits >= 64) return true;
  if (sheet_number.is_pattern) return false;
  const std::int64_t number = sheet_number.at(node_id);
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return number >= -half && number < 2 * half;
}

std::optional<Bytes> integer_bytes(DataType type, std::string_view text, std::uint8_t node_id) {
  const auto number = sheet_number(text.empty() ? "0" : text);
  const unsigned bits = bit_length(type);
  if (!number || !fits(*number, node_id, bits)) return std::nullopt;
  return number_bytes(static_cast<std::uint64_t>(number->at(node_id)), byte_length(type));
}

/// Some tools write a real as its bits.
std::optional<Bytes> pattern_bytes(DataType type, std::string_view text) {
  const auto pattern = sheet_number(text);
  if (!pattern || pattern->plus_node_id) return std::nullopt;
  if (pattern->number < 0 && !pattern->is_pattern) return std::nullopt;
  const auto bits = static_cast<std::uint64_t>(pattern->number);
  const bool is_too_long = type == DataType::real32 && bits > 0xFFFF'FFFF;
  return is_too_long ? std::nullopt : std::optional(number_bytes(bits, byte_length(type)));
}

std::optional<Bytes> real_bytes(DataType type, std::string_view text) {
  double number = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = real_from_chars(text.data(), last, number);
  if (!text.empty() && (error != std::errc{} || end != last)) return pattern_bytes(type, text);
  if (type == DataType::real64) return number_bytes(std::bit_cast<std::uint64_t>(number), 8);
  // Greater values would become infinite without notice.
  constexpr double greatest = std::numeric_limits<float>::max();
  if (std::isfinite(number) && std::abs(number) > greatest) return std::nullopt;
  return number_bytes(std::bit_cast<std::uint32_t>(static_cast<float>(number)), 4);
}

/// Reads pairs of hexadecimal digits, with or without blanks between them.
std::optional<Bytes> octets(std::string_view text) {
  Bytes bytes;
  while (true) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    if (text.empty()) return bytes;
    std::uint8_t byte = 0;
    const char* last = text.data() + std::min<std::size_t>(2, text.size());
    const auto [end, error] = std::from_chars(text.data(), last, byte, 16);
    if (error != std::errc{} || end != text.data() + 2) return std::nullopt;
    bytes.push_back(byte);
    text.remove_prefix(2);
  }
}

/// The text without padding zeros, if a line of a file can hold it.
std::optional<std::string> line_text(std::span<const std::uint8_t> bytes) {
  std::string text(bytes.begin(), bytes.end());
  text.resize(text.find_last_not_of('\0') + 1);
  const bool is_plain = std::ranges::none_of(
      text, [](unsigned char character) { return character < ' ' || character == 0x7F; });
  const bool is_trimmed = !text.starts_with(' ') && !text.ends_with(' ');
  return is_plain && is_trimmed ? std::optional(text) : std::nullopt;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> sheet_bytes(DataType type, std::string_view text,
                                                     std::uint8_t node_id) {
  if (type == DataType::octet_string) return octets(text);
  if (is_string(type)) return Bytes(text.begin(), text.end());
  if (type == DataType::domain) return text.empty() ? std::optional(Bytes()) : std::nullopt;
  if (is_real(type)) return real_bytes(type, text);
  return integer_bytes(type, text, node_id);
}

std::optional<std::string> sheet_value_text(DataType type, std::span<const std::uint8_t> bytes) {
  if (type == DataType::octet_string) return fmt::format("{:02X}", fmt::join(bytes, " "));
  if (is_string(type)) return line_text(bytes);
  if (type == DataType::domain || bytes.size() != byte_length(type)) return std::nullopt;
  return sheet_number_text(static_cast<std::int64_t>(load_unsigned(bytes)), type);
}

std::string sheet_number_text(std::int64_t number, DataType type) {
  if (type == DataType::real32) {
    return fmt::format("{}", static_cast<float>(real_value(number, type)));
  }
  if (type == DataType::real64) return fmt::format("{}", real_value(number, type));
  const unsigned bits = bit_length(type);
  if (is_signed(type)) {
    return fmt::format("{}", sign_extend(static_cast<std::uint64_t>(number), bits));
  }
  const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (1ULL << bits) - 1;
  return fmt::format("0x{:0{}X}", static_cast<std::uint64_t>(number) & mask, (bits + 7) / 8 * 2);
}

std::optional<DataType> sheet_type(unsigned data_type) {
  const auto type = static_cast<DataType>(data_type);
  if (data_type > 0xFF || data_type_name(type).empty()) return std::nullopt;
  return type;
}

bool same_value(unsigned data_type, std::string_view a, std::string_view b) {
  if (a == b) return true;
  const auto type = sheet_type(data_type);
  if (!type) return false;
  const auto number_a = sheet_number(a);
  const auto number_b = sheet_number(b);
  if (number_a && number_b && number_a->plus_node_id != number_b->plus_node_id) return false;
  const auto bytes_a = sheet_bytes(*type, a, 0);
  return bytes_a && bytes_a == sheet_bytes(*type, b, 0);
}

}  // namespace canvoy::formats
