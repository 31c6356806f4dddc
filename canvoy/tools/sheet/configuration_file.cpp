#include "canvoy/tools/sheet/configuration_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>

#include "canvoy/canopen/manager/concise_dcf.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"

namespace canvoy::tools {

namespace {

constexpr std::size_t file_bytes_max = 16 * 1024 * 1024;

/// A span as the source of a concise DCF.
class Content {
 public:
  explicit Content(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  ByteSource source() {
    return {static_cast<std::uint32_t>(bytes_.size()),
            decltype(ByteSource::read)::to<&Content::read>(*this)};
  }

 private:
  AbortCode read(std::uint32_t offset, std::span<std::uint8_t> to) {
    std::copy_n(bytes_.begin() + offset, to.size(), to.begin());
    return AbortCode::none;
  }
  std::span<const std::uint8_t> bytes_;
};

[[noreturn]] void refuse_concise(std::string_view name, AbortCode reason, std::uint32_t good) {
  throw Failure(
      reason == AbortCode::length_too_high
          ? fmt::format("{}: something follows its last entry; is its count right?", name)
          : fmt::format("{}: the concise DCF ends in its entry {}, or counts too many; is "
                        "it whole?",
                        name, good + 1));
}

std::vector<ConfigurationEntry> parse_concise(std::string_view name,
                                              std::span<const std::uint8_t> bytes) {
  Content content(bytes);
  ConciseDcf dcf;
  const AbortCode bad = dcf.open(content.source());
  if (bad != AbortCode::none) refuse_concise(name, bad, 0);
  std::vector<ConfigurationEntry> entries;
  while (!dcf.at_end()) {
    const auto item = dcf.next();
    if (!item) refuse_concise(name, item.abort(), dcf.position());
    ConfigurationEntry entry{item->index, item->sub, std::vector<std::uint8_t>(item->size)};
    static_cast<void>(dcf.read(*item, 0, entry.value));
    entries.push_back(std::move(entry));
  }
  return entries;
}

constexpr std::string_view blanks = " \t\r";

/// Takes the next word from the front of a line, with its separator.
std::string_view next_word(std::string_view& line, std::string_view ends = blanks) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(ends));
  line.remove_prefix(std::min(word.size() + 1, line.size()));
  return word;
}

std::optional<unsigned> parse_hex(std::string_view text, unsigned highest) {
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  if (text.ends_with('h')) text.remove_suffix(1);
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (error != std::errc{} || end != text.data() + text.size() || number > highest) {
    return std::nullopt;
  }
  return number;
}

/// The rest of a line is the value; a text may be quoted.
std::string_view value_of(std::string_view rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  rest = rest.substr(0, rest.find_last_not_of(blanks) + 1);
  if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"') {
    return rest.substr(1, rest.size() - 2);
  }
  return rest;
}

ConfigurationEntry parse_line(std::string_view line) {
  const std::string_view index_text = next_word(line, " \t\r:");  // 1017 0, and 1017:0
  const std::string_view sub_text = next_word(line);
  const std::string_view type_text = next_word(line);
  const std::string_view value = value_of(line);
  const auto index = parse_hex(index_text, 0xFFFF);
  const auto sub = parse_hex(sub_text, 0xFF);
  if (!index || !sub || type_text.empty()) {
    throw UsageError("an entry is: index sub type value, as 1017 0 u16 500");
  }
  const auto type = parse_type(type_text);
  if (!type) {
    throw UsageError(fmt::format(
        "'{}' is no data type: b, i8 to i64, u8 to u64, r32, r64, vs, os, us, d", type_text));
  }
  if (value.empty() && !is_string(*type)) throw UsageError("the value is missing");
  return {static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub),
          parse_value(EntryInfo{.type = *type}, value)};
}

std::vector<ConfigurationEntry> parse_text(std::string_view name, std::string_view text) {
  std::vector<ConfigurationEntry> entries;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos || line[first] == '#') continue;
    try {
      entries.push_back(parse_line(line));
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{} line {}: {}", name, number, failure.what()));
    }
  }
  return entries;
}

bool is_sheet(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && std::string_view("[;<").find(text[first]) != text.npos;
}

Configuration parse_sheet(std::string_view name, std::string_view text, NodeId node_id) {
  formats::Findings findings;
  const formats::DataSheet sheet = parse_sheet_text(text, findings);
  Configuration configuration = formats::configuration_of(sheet, node_id);
  if (!configuration.bad.empty()) {
    throw Failure(finding_text(std::string(name), configuration.bad.front()));
  }
  if (!configuration.entries.empty()) return configuration;
  throw Failure(
      fmt::format("{}: no parameter has a ParameterValue: is it the DCF or XDC of a node?", name));
}

}  // namespace

Configuration parse_configuration(std::string_view name, std::span<const std::uint8_t> content,
                                  NodeId node_id) {
  const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
  if (is_sheet(text)) return parse_sheet(name, text, node_id);
  const bool is_concise = std::ranges::find(content, std::uint8_t{0}) != content.end();
  Configuration configuration;
  configuration.entries = is_concise ? parse_concise(name, content) : parse_text(name, text);
  if (!configuration.entries.empty()) return configuration;
  throw Failure(fmt::format("{}: there is no entry in it", name));
}

Configuration read_configuration(const std::string& path, NodeId node_id) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> content(file_bytes_max + 1);
  file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
  if (!file.is_open() || file.bad()) {
    throw Failure(fmt::format("{}: {}; check the path", path, std::strerror(errno)));
  }
  const auto size = static_cast<std::size_t>(file.gcount());
  if (size > file_bytes_max) {
    throw Failure(fmt::format("{}: longer than 16 MiB; is it a configuration?", path));
  }
  return parse_configuration(path, std::span(content).first(size), node_id);
}

std::vector<ConfigurationEntry> final_entries(const std::vector<ConfigurationEntry>& entries) {
  std::vector<ConfigurationEntry> made;
  for (const ConfigurationEntry& entry : entries) {
    const auto same = std::ranges::find_if(made, [&entry](const ConfigurationEntry& other) {
      return other.index == entry.index && other.sub == entry.sub;
    });
    if (same == made.end()) {
      made.push_back(entry);
    } else {
      same->value = entry.value;
    }
  }
  return made;
}

}  // namespace canvoy::tools
