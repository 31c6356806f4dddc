// Base64 in one line (RFC 2045, 6.8), as CiA 309-3 writes octet strings and domains.
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

std::string to_base64(std::span<const std::uint8_t> bytes);

/// Nothing where the text is not base64: other characters, padding missing or in the middle, or
/// bits behind the last byte that are not zero. So each sequence of bytes has one text.
std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

}  // namespace canvoy::gateway
