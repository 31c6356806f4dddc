// The bytes of a value in a file: `canvoy read --out` writes it, `canvoy write --file` reads it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace canvoy::tools {

/// Maximum size of a value that a node takes or gives, in bytes.
inline constexpr std::size_t value_max = 16 * 1024 * 1024;

/// Throws Failure if the file cannot be read, or is longer than value_max.
std::vector<std::uint8_t> read_value_file(const std::string& path);

/// Throws Failure if the file cannot be written; an existing file is then unchanged. On return, the
/// file is on the disk.
void write_value_file(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace canvoy::tools
