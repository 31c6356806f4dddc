// The configuration of a node in a file: a DCF or XDC, a concise DCF as CiA 302-3 has it, or text
// with one entry a line.
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

/// For the node `node_id`: values of a DCF of another node that go with its node-ID are moved.
/// Throws Failure with file and reason, and of a text with the line: it cannot be read, it is
/// longer than 16 MiB, it is malformed, it has no entry.
Configuration read_configuration(const std::string& path, NodeId node_id);

/// The contents of a file; `name` is how errors call it. A file that begins with `[`, `;` or `<` is
/// a data sheet, one with a zero byte in it a concise DCF, all others are text.
Configuration parse_configuration(std::string_view name, std::span<const std::uint8_t> content,
                                  NodeId node_id);

/// What is there in the end: a PDO is made invalid, mapped anew and made valid again, and its
/// COB-ID is written twice (CiA 301, 7.5.2.36).
std::vector<ConfigurationEntry> final_entries(const std::vector<ConfigurationEntry>& entries);

}  // namespace canvoy::tools
