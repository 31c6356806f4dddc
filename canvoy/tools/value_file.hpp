// The bytes of a value in a file: what `canvoy read --out` writes and `canvoy write --file` reads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace canvoy::tools {

/// What a node can be asked to take or give at most, in bytes.
inline constexpr std::size_t value_max = 16 * 1024 * 1024;

/// Throws Failure where the file cannot be read, or is longer than value_max.
std::vector<std::uint8_t> read_value_file(const std::string& path);

/// Throws Failure where it cannot be written: then a file that was there before is as it was. When
/// it returns, the file is on the disk.
void write_value_file(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace canvoy::tools
