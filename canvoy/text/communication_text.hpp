// Communication parameters as text: the bits of a COB-ID, a mapping or a consumer heartbeat time
// (CiA 301, 7.5.2).
//
//     communication_text(0x1016, 1, bytes);  // "node 10 (0Ah), within 1500 ms"
//     communication_text(0x1400, 1, bytes);  // "20Ah, in use"
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace canvoy::text {

/// Text of a value of four bytes: COB-IDs (1005h, 1012h, 1014h, 1028h, 1200h to 12FFh, 1400h to
/// 15FFh, 1800h to 19FFh), consumer heartbeat times (1016h) and mapped objects (1600h to 17FFh,
/// 1A00h to 1BFFh). Empty for other objects, which value_text() covers.
std::string communication_text(std::uint16_t index, std::uint8_t sub,
                               std::span<const std::uint8_t> bytes);

}  // namespace canvoy::text
