// INI files in the form of EDS and DCF: sections of keys and values (CiA 306). Everything read can
// be written again, including order, comments and unknown keys.
//
//     const Ini file = parse_ini(text);
//     file.find("DeviceInfo")->value("vendornumber");  // case does not count
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::formats {

/// A line that sets a key. Comments and other lines have an empty key; their value is the whole
/// line.
struct IniLine {
  std::string key = {};
  std::string value = {};
  std::size_t number = 0;  ///< line in the file, from 1; 0: not from a file
};

struct IniSection {
  std::string name;  ///< empty: the lines before the first section
  std::size_t number = 0;
  std::vector<IniLine> lines;

  /// The first line that sets a key, or null.
  const IniLine* find(std::string_view key) const;
  std::optional<std::string_view> value(std::string_view key) const;
  /// Adds a line at the end.
  void add(std::string key, std::string value) {
    lines.push_back({std::move(key), std::move(value), 0});
  }
};

struct Ini {
  std::vector<IniSection> sections;

  /// The first section with this name, or null.
  const IniSection* find(std::string_view name) const;
};

/// True if two names are equal, ignoring case.
bool same_letters(std::string_view a, std::string_view b);
bool is_comment(const IniLine& line);

/// Reads any text. Ignores a byte order mark and blanks around names, keys and values; accepts
/// either kind of line ends.
Ini parse_ini(std::string_view text);
std::string write_ini(const Ini& file);

}  // namespace canvoy::formats
