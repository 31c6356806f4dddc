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
  std::string key = {};    ///< as written, without blanks around it
  std::string value = {};  ///< as written, without blanks around it
  std::size_t number = 0;  ///< line in the file, from 1; 0: not from a file
};

/// A section with its lines.
struct IniSection {
  std::string name;            ///< empty: the lines before the first section
  std::size_t number = 0;      ///< line of the head, from 1; 0: not from a file
  std::vector<IniLine> lines;  ///< comments included

  /// The first line that sets a key, or null.
  const IniLine* find(std::string_view key) const;
  /// The value of a key, case ignored; nothing if no line sets it.
  std::optional<std::string_view> value(std::string_view key) const;
  /// Adds a line at the end.
  void add(std::string key, std::string value) {
    lines.push_back({std::move(key), std::move(value), 0});
  }
};

struct Ini {
  std::vector<IniSection> sections;  ///< in order; the first may have no name

  /// The first section with this name, or null.
  const IniSection* find(std::string_view name) const;
};

/// True if two names are equal, ignoring case.
bool same_letters(std::string_view a, std::string_view b);
/// True for a line that starts with `;` or `#`.
bool is_comment(const IniLine& line);

/// Reads any text. Ignores a byte order mark and blanks around names, keys and values; accepts
/// either kind of line ends.
Ini parse_ini(std::string_view text);
/// Writes sections and lines in their order, with CR LF at the ends of lines and an empty line
/// between sections.
std::string write_ini(const Ini& file);

}  // namespace canvoy::formats
