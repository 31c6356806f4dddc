#include "canvoy/gateway/value.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstdio>
#include <string_view>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/gateway/base64.hpp"
#include "canvoy/gateway/number.hpp"

namespace canvoy::gateway {

namespace {

// A visible string in quotes, on one line: "Hello, ""World""!"
//
//     quote(bytes);  unquote("\"a\\n\"");

/// Letter after the backslash, and the byte that it represents.
constexpr std::string_view escape_letters = "abtnvfr\\\"'?";
constexpr std::string_view escaped_bytes = "\a\b\t\n\v\f\r\\\"'?";
/// The letters that are written; a quote is doubled instead.
constexpr std::string_view written_letters = escape_letters.substr(0, 8);

void append_escaped(std::string& text, std::uint8_t byte) {
  const std::size_t known =
      escaped_bytes.substr(0, written_letters.size()).find(static_cast<char>(byte));
  text += '\\';
  if (known != std::string_view::npos) {
    text += written_letters[known];
    return;
  }
  char octal[4];
  std::snprintf(octal, sizeof octal, "%03o", unsigned{byte});
  text += octal;
}

/// Takes a number of at most `digits_max` digits from the start of `text`.
std::optional<std::uint8_t> take_number(std::string_view& text, std::size_t digits_max, int base) {
  unsigned number = 0;
  const char* last = text.data() + std::min(digits_max, text.size());
  const auto [end, error] = std::from_chars(text.data(), last, number, base);
  if (error != std::errc{} || number > UINT8_MAX) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return static_cast<std::uint8_t>(number);
}

/// Byte of the escape sequence at the start of `text`, after its backslash.
std::optional<std::uint8_t> take_escape(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const char letter = text.front();
  if (letter >= '0' && letter <= '7') return take_number(text, 3, 8);
  text.remove_prefix(1);
  if (letter == 'x') return take_number(text, 2, 16);
  const std::size_t known = escape_letters.find(letter);
  if (known == std::string_view::npos) return std::nullopt;
  return static_cast<std::uint8_t>(escaped_bytes[known]);
}

/// Quotes a string. A quote becomes two, a backslash or an unprintable character an escape sequence
/// of C. Bytes from 80h on stay as they are, since many devices send ISO 8859-1 or UTF-8.
std::string quote(std::span<const std::uint8_t> bytes) {
  std::string text = "\"";
  for (const std::uint8_t byte : bytes) {
    if (byte < 0x20 || byte == 0x7F || byte == '\\') {
      append_escaped(text, byte);
    } else {
      if (byte == '"') text += '"';
      text += static_cast<char>(byte);
    }
  }
  return text + '"';
}

/// Reads a string with quotes, or a word without. Nothing if an escape sequence is not one of C.
std::optional<std::vector<std::uint8_t>> unquote(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  if (!quoted) return std::vector<std::uint8_t>(text.begin(), text.end());
  text = text.substr(1, text.size() - 2);
  std::vector<std::uint8_t> bytes;
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '\\') {
      const std::optional<std::uint8_t> byte = take_escape(text);
      if (!byte) return std::nullopt;
      bytes.push_back(*byte);
      continue;
    }
    if (c == '"') {
      if (!text.starts_with('"')) return std::nullopt;
      text.remove_prefix(1);
    }
    bytes.push_back(static_cast<std::uint8_t>(c));
  }
  return bytes;
}

using enum DataType;
using Notation = ValueType::Notation;

struct TypeName {
  std::string_view name;
  ValueType type;
};
constexpr auto type_names = std::to_array<TypeName>({
    {"b", {boolean, Notation::standard}},          {"i8", {integer8, Notation::standard}},
    {"i16", {integer16, Notation::standard}},      {"i24", {integer24, Notation::standard}},
    {"i32", {integer32, Notation::standard}},      {"i40", {integer40, Notation::standard}},
    {"i48", {integer48, Notation::standard}},      {"i56", {integer56, Notation::standard}},
    {"i64", {integer64, Notation::standard}},      {"u8", {unsigned8, Notation::standard}},
    {"u16", {unsigned16, Notation::standard}},     {"u24", {unsigned24, Notation::standard}},
    {"u32", {unsigned32, Notation::standard}},     {"u40", {unsigned40, Notation::standard}},
    {"u48", {unsigned48, Notation::standard}},     {"u56", {unsigned56, Notation::standard}},
    {"u64", {unsigned64, Notation::standard}},     {"x8", {unsigned8, Notation::hexadecimal}},
    {"x16", {unsigned16, Notation::hexadecimal}},  {"x32", {unsigned32, Notation::hexadecimal}},
    {"x64", {unsigned64, Notation::hexadecimal}},  {"r32", {real32, Notation::standard}},
    {"r64", {real64, Notation::standard}},         {"t", {time_of_day, Notation::standard}},
    {"td", {time_difference, Notation::standard}}, {"vs", {visible_string, Notation::standard}},
    {"os", {octet_string, Notation::standard}},    {"us", {unicode_string, Notation::standard}},
    {"d", {domain, Notation::standard}},           {"hex", {domain, Notation::bytes}},
});

constexpr bool is_time(DataType type) {
  return type == time_of_day || type == time_difference;
}

Bytes bytes_of(std::uint64_t number, unsigned size) {
  Bytes bytes(8);
  store(bytes.data(), number);
  bytes.resize(size);
  return bytes;
}

constexpr std::uint64_t unsigned_max(unsigned bits) {
  return ~std::uint64_t{0} >> (64 - bits);
}

std::optional<std::uint64_t> parse_integer(DataType type, Token word) {
  const unsigned bits = bit_length(type);
  if (!is_signed(type)) return parse_unsigned(word, unsigned_max(bits));
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  const std::uint64_t low = std::uint64_t{1} << (bits - 1);
  const auto magnitude = parse_unsigned(word, negative ? low : low - 1);
  if (!magnitude) return std::nullopt;
  return negative ? 0 - *magnitude : *magnitude;
}

template <class Real, class Bits>
std::optional<std::uint64_t> parse_real(Token word) {
  Real number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return std::bit_cast<Bits>(number);
}

std::optional<std::uint64_t> parse_number(DataType type, Token word) {
  if (type == real32) return parse_real<float, std::uint32_t>(word);
  if (type == real64) return parse_real<double, std::uint64_t>(word);
  return parse_integer(type, word);
}

/// Parses days, and milliseconds after midnight: 16 bits above 28 and 4 reserved ones (CiA 301,
/// 7.1.6.6).
std::optional<Bytes> parse_time(Tokens words) {
  if (words.size() != 2) return std::nullopt;
  const auto days = parse_unsigned(words[0], UINT16_MAX);
  const auto milliseconds = parse_unsigned(words[1], unsigned_max(28));
  if (!days || !milliseconds) return std::nullopt;
  return bytes_of(*days << 32 | *milliseconds, byte_length(time_of_day));
}

std::optional<Bytes> parse_hex(Tokens words) {
  Bytes bytes;
  for (const Token word : words) {
    if (word.size() % 2 != 0) return std::nullopt;
    for (std::size_t i = 0; i < word.size(); i += 2) {
      std::uint8_t byte = 0;
      const char* last = word.data() + i + 2;
      const auto [end, error] = std::from_chars(word.data() + i, last, byte, 16);
      if (error != std::errc{} || end != last) return std::nullopt;
      bytes.push_back(byte);
    }
  }
  return bytes.empty() ? std::nullopt : std::optional(bytes);
}

std::string hex_text(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  text.reserve(bytes.size() * 3);
  for (const std::uint8_t byte : bytes) {
    if (!text.empty()) text += ' ';
    text += digits[byte >> 4];
    text += digits[byte & 0xF];
  }
  return text;
}

template <class Number>
std::string number_text(Number number) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number);
  return {text, end};
}

std::string hexadecimal_text(std::uint64_t number, unsigned digits) {
  char text[24];
  std::snprintf(text, sizeof text, "0x%0*llx", static_cast<int>(digits),
                static_cast<unsigned long long>(number));
  return text;
}

std::string integer_text(ValueType type, std::uint64_t number, Version version) {
  const unsigned bits = bit_length(type.type);
  if (is_signed(type.type)) return number_text(sign_extend(number, bits));
  const bool as_hexadecimal = version == Version::v2_1 && type.type != boolean;
  if (as_hexadecimal || type.notation == Notation::hexadecimal) {
    return hexadecimal_text(number, bits / 4);
  }
  return number_text(number);
}

std::string fixed_size_text(ValueType type, std::uint64_t number, Version version) {
  if (type.type == real32) {
    return number_text(std::bit_cast<float>(static_cast<std::uint32_t>(number)));
  }
  if (type.type == real64) return number_text(std::bit_cast<double>(number));
  if (is_time(type.type)) {
    return number_text(number >> 32) + " " + number_text(number & unsigned_max(28));
  }
  return integer_text(type, number, version);
}

}  // namespace

std::optional<ValueType> parse_type(Token word) {
  for (const TypeName& known : type_names) {
    if (matches(known.name, word)) return known.type;
  }
  return std::nullopt;
}

std::optional<Bytes> parse_value(ValueType type, Tokens words) {
  if (type.notation == Notation::bytes) return parse_hex(words);
  if (is_time(type.type)) return parse_time(words);
  if (words.size() != 1) return std::nullopt;
  if (type.type == visible_string) return unquote(words[0]);
  if (byte_length(type.type) == 0) return from_base64(words[0]);
  const auto number = parse_number(type.type, words[0]);
  return number ? std::optional(bytes_of(*number, byte_length(type.type))) : std::nullopt;
}

std::optional<std::string> value_text(ValueType type, std::span<const std::uint8_t> bytes,
                                      Version version) {
  if (type.notation == Notation::bytes) return hex_text(bytes);
  if (type.type == visible_string) return quote(bytes);
  const unsigned size = byte_length(type.type);
  if (size == 0) return to_base64(bytes);
  if (bytes.size() != size) return std::nullopt;
  return fixed_size_text(type, load_unsigned(bytes), version);
}

}  // namespace canvoy::gateway
