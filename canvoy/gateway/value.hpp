// Values as CiA 309-3 writes them: a short name for each type, and a text for each value.
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

using Bytes = std::vector<std::uint8_t>;  ///< as on the bus

/// Edition of CiA 309-3 that answers follow; commands of both editions are always accepted.
enum class Version : std::uint8_t {
  v2_1,  ///< like Lely CANopen: unsigned integers in hexadecimal, `ERROR: 06020000 (text)`
  v3_0,  ///< like CANopenNode: in decimal, `ERROR:0x06020000`
};

/// Type of a value, and its notation.
struct ValueType {
  /// Notation of a value, beside that of CiA 309-3 for its type.
  enum class Notation : std::uint8_t {
    standard,
    hexadecimal,  ///< x8 to x64, as in CANopenNode
    bytes,        ///< hex, as in CANopenNode: any bytes, `01 02 AB`
  };
  DataType type = DataType::domain;     ///< for numbers and texts
  Notation notation = Notation::bytes;  ///< see Notation

  friend bool operator==(const ValueType&, const ValueType&) = default;
};

/// Parses a type: b, i8 to i64, u8 to u64 (in steps of 8), r32, r64, t, td, vs, os, us, d; and the
/// additions of CANopenNode: x8, x16, x32, x64, hex.
std::optional<ValueType> parse_type(Token word);

/// Bytes of a value on the bus. Nothing if the words are not a value of the type, or are out of its
/// range. A visible string needs quotes only if it contains blanks.
std::optional<Bytes> parse_value(ValueType type, Tokens words);

/// Text of a value, on one line whatever the bytes are. Nothing if the number of bytes does not
/// match the type.
std::optional<std::string> value_text(ValueType type, std::span<const std::uint8_t> bytes,
                                      Version version);

}  // namespace canvoy::gateway
