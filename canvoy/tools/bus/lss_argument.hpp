// Addresses, node-IDs and answers of LSS, as people write and read them.
//
//     const LssAddress address = parse_lss_address("0x2F0:419:1:77");
//     fmt::print("{}\n", lss_address_text(address));
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/lss/lss_fastscan.hpp"

namespace canvoy::tools {

/// `vendor 2F0h, product 1A3h, revision 10001h, serial 4Dh`
std::string lss_address_text(const LssAddress& address);
/// Why a slave refused: what its error code means for this service.
std::string lss_error_text(lss::Command command, LssError error);
/// `125000 bit/s`, `automatic`
std::string bit_timing_text(std::uint8_t index);

/// VENDOR:PRODUCT:REVISION:SERIAL, each as 419 or 0x1A3. All throw UsageError where they cannot
/// read the text.
LssAddress parse_lss_address(std::string_view text);
/// The same, of which any part at the end may be missing.
LssPattern parse_lss_pattern(std::string_view text);
/// `10`, `10-20`, `10,12,0x20-0x2F`: in this order.
std::vector<NodeId> parse_node_ids(std::string_view text);
/// `125000`, `125k`, `1M`, `auto`: the index of table selector 0.
std::uint8_t parse_bit_timing(std::string_view text);

}  // namespace canvoy::tools
