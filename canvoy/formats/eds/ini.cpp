#include "canvoy/formats/eds/ini.hpp"

#include <algorithm>

#include "canvoy/formats/plain_text.hpp"

namespace canvoy::formats {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::optional<std::string_view> section_name(std::string_view line) {
  if (!line.starts_with('[')) return std::nullopt;
  const std::size_t end = line.find(']');
  if (end == std::string_view::npos) return std::nullopt;
  return trimmed(line.substr(1, end - 1));
}

IniLine parse_line(std::string_view line, std::size_t number) {
  const std::size_t equals = line.find('=');
  const bool sets = equals != std::string_view::npos && !line.starts_with(';');
  const std::string_view key = sets ? trimmed(line.substr(0, equals)) : std::string_view{};
  // Without a key, `=[1000]` is a line of its own: written as `[1000]`, it would begin a section.
  if (key.empty()) return {"", std::string(line), number};
  return {std::string(key), std::string(trimmed(line.substr(equals + 1))), number};
}

}  // namespace

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lower, lower);
}

bool is_comment(const IniLine& line) {
  return line.key.empty() && (line.value.starts_with(';') || line.value.starts_with('#'));
}

const IniLine* IniSection::find(std::string_view key) const {
  const auto found = std::ranges::find_if(
      lines, [key](const IniLine& line) { return !key.empty() && same_letters(line.key, key); });
  return found == lines.end() ? nullptr : &*found;
}

std::optional<std::string_view> IniSection::value(std::string_view key) const {
  const IniLine* line = find(key);
  return line == nullptr ? std::nullopt : std::optional<std::string_view>(line->value);
}

const IniSection* Ini::find(std::string_view name) const {
  const auto found = std::ranges::find_if(
      sections, [name](const IniSection& section) { return same_letters(section.name, name); });
  return found == sections.end() ? nullptr : &*found;
}

Ini parse_ini(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Ini file;
  file.sections.emplace_back();
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    if (line.empty()) continue;
    if (const auto name = section_name(line)) {
      file.sections.push_back({std::string(*name), number, {}});
    } else {
      file.sections.back().lines.push_back(parse_line(line, number));
    }
  }
  if (file.sections.front().lines.empty()) file.sections.erase(file.sections.begin());
  return file;
}

std::string write_ini(const Ini& file) {
  std::string text;
  for (const IniSection& section : file.sections) {
    if (!section.name.empty()) text += (text.empty() ? "[" : "\r\n[") + section.name + "]\r\n";
    for (const IniLine& line : section.lines) {
      text += line.key.empty() ? line.value : line.key + '=' + line.value;
      text += "\r\n";
    }
  }
  return text;
}

}  // namespace canvoy::formats
