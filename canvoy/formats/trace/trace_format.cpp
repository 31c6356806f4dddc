#include "canvoy/formats/trace/trace_format.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

constexpr std::string_view gzip_ending = ".gz";

constexpr auto table = std::to_array<const TraceFormat*>({
    &TraceFormat::candump,
    &TraceFormat::asc,
    &TraceFormat::blf,
    &TraceFormat::trc,
    &TraceFormat::pcapng,
    &TraceFormat::pcap,
    &TraceFormat::python_can_csv,
    &TraceFormat::savvycan_csv,
    &TraceFormat::mf4,
    &TraceFormat::sqlite,
});

/// The next of words separated by blanks; empty after the last one.
std::string_view take_ending(std::string_view& endings) {
  const std::size_t length = std::min(endings.find(' '), endings.size());
  const std::string_view ending = endings.substr(0, length);
  endings.remove_prefix(std::min(length + 1, endings.size()));
  return ending;
}

char small(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// Also matches `NIGHT.ASC`, as written by other systems.
bool ends_with(std::string_view path, std::string_view ending) {
  return path.size() > ending.size() &&
         std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, small);
}

void append_listed(std::string& text, std::string_view item) {
  if (!text.empty()) text += ", ";
  text += item;
}

}  // namespace

std::string trace_lack_text(std::uint8_t lacks) {
  constexpr auto texts = std::to_array<std::pair<std::uint8_t, std::string_view>>({
      {trace_lack::direction, "the direction of frames"},
      {trace_lack::bus_names, "names of buses"},
      {trace_lack::buses, "which bus a frame is of"},
      {trace_lack::comments, "comments"},
      {trace_lack::errors, "what error frames tell"},
  });
  std::string text;
  for (const auto& [lack, lack_text] : texts) {
    if ((lacks & lack) != 0) append_listed(text, lack_text);
  }
  return text;
}

std::span<const TraceFormat* const> trace_formats() {
  return table;
}

bool names_gzip(std::string_view path) {
  return ends_with(path, gzip_ending);
}

std::optional<TraceFormat> trace_format_of(std::string_view path) {
  if (names_gzip(path)) path.remove_suffix(gzip_ending.size());
  for (const TraceFormat* format : table) {
    std::string_view endings = format->endings;
    while (!endings.empty()) {
      if (ends_with(path, take_ending(endings))) return *format;
    }
  }
  return std::nullopt;
}

std::string trace_format_list(bool written_only) {
  std::string text;
  for (const TraceFormat* format : table) {
    if (written_only && !format->is_written()) continue;
    std::string_view endings = format->endings;
    append_listed(text, format->name);
    text += " (";
    text += take_ending(endings);
    text += ')';
  }
  return text;
}

std::string trace_ending_list(bool written_only) {
  std::string text;
  for (const TraceFormat* format : table) {
    if (written_only && !format->is_written()) continue;
    std::string_view endings = format->endings;
    const std::string_view first = take_ending(endings);
    if (!first.empty()) append_listed(text, first);
  }
  return text;
}

std::unique_ptr<TraceParser> recognize_trace(std::string_view head) {
  bool is_first = true;
  do {
    std::string_view line = head.substr(0, head.find('\n'));
    const std::size_t length = line.size();
    if (line.ends_with('\r')) line.remove_suffix(1);
    for (const TraceFormat* format : table) {
      auto parser = format->recognize({.line = line, .rest = head, .is_first = is_first});
      if (parser != nullptr) return parser;
    }
    head.remove_prefix(std::min(length + 1, head.size()));
    is_first = false;
  } while (!head.empty());
  return nullptr;
}

std::string_view looks_like(std::string_view head) {
  using Known = std::pair<std::string_view, std::string_view>;
  constexpr std::array known = {Known{"\xFF\xD8\xFF", "a JPEG picture"},
                                Known{"\x89PNG", "a PNG picture"},
                                Known{"GIF8", "a GIF picture"},
                                Known{"%PDF", "a PDF document"},
                                Known{"\x7F"
                                      "ELF",
                                      "an ELF program"},
                                Known{"MZ", "a Windows program"},
                                Known{"PK\x03\x04", "a zip archive"},
                                Known{"BZh", "a file that bzip2 has compressed"},
                                Known{"\xFD"
                                      "7zXZ",
                                      "a file that xz has compressed"},
                                Known{"\x28\xB5\x2F\xFD", "a file that zstd has compressed"}};
  for (const auto& [magic, name] : known) {
    if (head.starts_with(magic)) return name;
  }
  const bool is_binary = std::ranges::any_of(head, [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
  if (is_binary) return "binary data";
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  if (head.starts_with('{') || head.starts_with("[{") || head.starts_with("[\n")) return "JSON";
  if (head.starts_with("<?xml") || head.starts_with('<')) return "XML or HTML";
  if (head.starts_with('[')) return "a data sheet or settings (INI)";
  return "text without frames";
}

}  // namespace canvoy::formats
