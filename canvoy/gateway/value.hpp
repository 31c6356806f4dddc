// Values as CiA 309-3 writes them: a type by its short name, and a text for each type.
//
//     std::optional<ValueType> type = parse_type("u16");
//     std::optional<Bytes> bytes = parse_value(*type, words);      // 500 -> F4 01
//     std::optional<std::string> text = value_text(*type, *bytes, Version::v3_0);
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/data_type.hpp"
#include "canvoy/gateway/token.hpp"

namespace canvoy::gateway {

using Bytes = std::vector<std::uint8_t>;

/// Which edition of CiA 309-3 answers follow; commands of both are understood always.
enum class Version : std::uint8_t {
  v2_1,  ///< as Lely CANopen answers: unsigned integers in hexadecimal, `ERROR: 06020000 (text)`
  v3_0,  ///< as CANopenNode does: in decimal, `ERROR:0x06020000`
};

struct ValueType {
  /// How the value is written, beside what CiA 309-3 has for the type.
  enum class Notation : std::uint8_t {
    standard,
    hexadecimal,  ///< x8 to x64, as CANopenNode has them
    bytes,        ///< hex, as CANopenNode has it: any bytes, `01 02 AB`
  };
  DataType type = DataType::domain;
  Notation notation = Notation::bytes;

  friend bool operator==(const ValueType&, const ValueType&) = default;
};

/// b, i8 to i64, u8 to u64 (in steps of 8), r32, r64, t, td, vs, os, us, d; and the additions of
/// CANopenNode: x8, x16, x32, x64, hex.
std::optional<ValueType> parse_type(Token word);

/// The bytes that a value has on the bus. Nothing where the words are no value of the type, or one
/// that it has no room for. A visible string needs quotes only where it has blanks.
std::optional<Bytes> parse_value(ValueType type, Tokens words);

/// The other way round, on one line whatever the bytes are. Nothing where their number is not that
/// of the type.
std::optional<std::string> value_text(ValueType type, std::span<const std::uint8_t> bytes,
                                      Version version);

}  // namespace canvoy::gateway
