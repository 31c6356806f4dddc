// Base64 on one line, as CiA 309-3 writes octet strings and domains (RFC 2045, 6.8).
//
//     to_base64(bytes);            // ASNFZ4mrze8=
//     from_base64("ASNFZ4mrze8=")
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::gateway {

/// Text of any bytes, padded, without line breaks: four characters for three bytes.
std::string to_base64(std::span<const std::uint8_t> bytes);

/// Bytes of a base64 text. Nothing if the text is not base64: it has other characters, padding that
/// is missing or in the middle, or bits behind the last byte that are not zero. Each sequence of
/// bytes thus has one text.
std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

}  // namespace canvoy::gateway
