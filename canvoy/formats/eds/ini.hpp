// INI files as EDS and DCF are (CiA 306): sections of keys and values, read so that all of it can
// be written again: order, comments and what nobody knows included.
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

/// A line that sets a key. Of a comment or of a line that is neither, the key is empty, and the
/// value is the whole line.
struct IniLine {
  std::string key = {};
  std::string value = {};
  std::size_t number = 0;  ///< in the file, from 1 on; 0: it is not from a file
};

struct IniSection {
  std::string name;  ///< empty: what stands before the first section
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

  /// The first section of this name, or null.
  const IniSection* find(std::string_view name) const;
};

/// Whether two names are the same but for the case of their letters.
bool same_letters(std::string_view a, std::string_view b);
bool is_comment(const IniLine& line);

/// Reads any text: a byte order mark, either kind of line ends, blanks around names, keys and
/// values do not matter.
Ini parse_ini(std::string_view text);
std::string write_ini(const Ini& file);

}  // namespace canvoy::formats
