// The configuration of a node in a file: a DCF or XDC, a concise DCF (CiA 302-3), or text with one
// entry per line.
//
//     # index sub type value
//     1017 0 u16 500
//     1800 1 u32 0x80000185
//     2000 3 vs  "front left"
//     6423 0 b   1
//
//     Configuration configuration = read_configuration("charger.cdcf", 5);
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/sheet/sheet_configuration.hpp"

namespace canvoy::tools {

using formats::Configuration;
using formats::ConfigurationEntry;

/// Reads it for the node `node_id`: node-ID-dependent values of a DCF of another node are
/// converted. Throws Failure with file and reason, for text with the line: the file cannot be read,
/// is longer than 16 MiB, is malformed, or has no entry.
Configuration read_configuration(const std::string& path, NodeId node_id);

/// Parses the content of a file; `name` is used in errors. A file that begins with `[`, `;` or `<`
/// is a data sheet, one with a zero byte a concise DCF, all others are text.
Configuration parse_configuration(std::string_view name, std::span<const std::uint8_t> content,
                                  NodeId node_id);

/// The final values: a PDO is made invalid, mapped and made valid, so that its COB-ID is written
/// twice (CiA 301, 7.5.2.36).
std::vector<ConfigurationEntry> final_entries(const std::vector<ConfigurationEntry>& entries);

}  // namespace canvoy::tools
