// Addresses, node-IDs and answers of LSS as text.
//
//     const LssAddress address = parse_lss_address("0x2F0:419:1:77");
//     fmt::print("{}\n", lss_address_text(address));
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/lss/lss_fastscan.hpp"

namespace canvoy::tools {

/// Text of an address: `vendor 2F0h, product 1A3h, revision 10001h, serial 4Dh`.
std::string lss_address_text(const LssAddress& address);
/// Text of a refusal: the meaning of the error code for this service.
std::string lss_error_text(lss::Command command, LssError error);
/// Text of a bit rate: `125000 bit/s`, `automatic`.
std::string bit_timing_text(std::uint8_t index);

/// Reads VENDOR:PRODUCT:REVISION:SERIAL, each as 419 or 0x1A3. All these functions throw UsageError
/// if they cannot read the text.
LssAddress parse_lss_address(std::string_view text);
/// Reads an address of which the last parts may be missing.
LssPattern parse_lss_pattern(std::string_view text);
/// Reads `10`, `10-20`, `10,12,0x20-0x2F`, in this order.
std::vector<NodeId> parse_node_ids(std::string_view text);
/// Reads `125000`, `125k`, `1M`, `auto`: the index of table selector 0.
std::uint8_t parse_bit_timing(std::string_view text);

}  // namespace canvoy::tools
