// The configuration of a node in a file: a concise DCF as CiA 302-3 has it, or text with one entry
// a line.
//
//     # index sub type value
//     1017 0 u16 500
//     1800 1 u32 0x80000185
//     2000 3 vs  "front left"
//     6423 0 b   1
//
//     std::vector<ConfigurationEntry> entries = read_configuration("charger.cdcf");
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

struct ConfigurationEntry {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::vector<std::uint8_t> value;
};

/// Throws Failure with file and reason, and of a text with the line: it cannot be read, it is
/// longer than 16 MiB, it is malformed, it has no entry.
std::vector<ConfigurationEntry> read_configuration(const std::string& path);

/// The contents of a file; `name` is how errors call it. A file with a zero byte in it is a concise
/// DCF, all others are text.
std::vector<ConfigurationEntry> parse_configuration(std::string_view name,
                                                    std::span<const std::uint8_t> content);

/// The same as a concise DCF (CiA 302-3, 1F22h).
std::vector<std::uint8_t> to_concise_dcf(const std::vector<ConfigurationEntry>& entries);

}  // namespace canvoy::tools
