// Oddities of real data sheets, from the tables in tests/sheets: a few lines each, and the correct
// value by CiA 306. A row of entries.txt is `title | KEY=VALUE; -KEY | check; check`, and stands
// for the section [2000]; `\;` is a semicolon. A block of sheets.txt is `## title`, the lines of a
// sheet, and `? ` before each check.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/sheet/sheet_check.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"

namespace canvoy::formats::sheet_oddities_test {
namespace {

constexpr NodeId node_id = 5;

std::vector<std::string> lines_of(const char* path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Splits at separators, but not at `\;`.
std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\' && at + 1 < text.size() && text[at + 1] == separator) {
      parts.back() += text[++at];
    } else if (text[at] == separator) {
      parts.emplace_back();
    } else {
      parts.back() += text[at];
    }
  }
  return parts;
}

std::string bytes_text(const SheetEntry& entry) {
  const auto type = sheet_type(entry.data_type);
  const auto bytes = type ? sheet_bytes(*type, entry.default_value, node_id) : std::nullopt;
  return bytes ? fmt::format("{:02X}", fmt::join(*bytes, " ")) : "bad";
}

std::string number_text(const SheetEntry& entry, const std::string& text) {
  const auto number = sheet_number(text);
  const auto type = sheet_type(entry.data_type);
  if (!number || !type) return text;
  return fmt::format("{}", number_of(static_cast<std::uint64_t>(number->at(node_id)),
                                     bit_length(*type), is_signed(*type)));
}

/// The item of an entry that a check names, as in the sheet.
std::string said(const SheetEntry& entry, std::string_view what) {
  if (what == "bytes") return bytes_text(entry);
  if (what == "type") return fmt::format("{:04X}", entry.data_type);
  if (what == "object") return fmt::format("{:X}", entry.object_type);
  if (what == "access") return entry.access;
  if (what == "name") return entry.name;
  if (what == "mapping") return entry.pdo_mapping ? "1" : "0";
  if (what == "low") return number_text(entry, entry.low_limit);
  if (what == "high") return number_text(entry, entry.high_limit);
  if (what == "value") return entry.value;
  if (what == "flags") return entry.obj_flags;
  if (what == "denotation") return entry.denotation;
  if (what == "others") return entry.others.empty() ? "" : entry.others.front().key;
  return "no such check";
}

bool is_found(const Findings& findings, Finding::Weight weight, std::string_view text) {
  return std::ranges::any_of(findings, [&](const Finding& each) {
    return each.weight == weight &&
           (each.text + "; " + each.expected).find(text) != std::string::npos;
  });
}

struct Sheet {
  Findings findings;  // filled while the sheet is read
  DataSheet sheet;

  explicit Sheet(std::string_view text) : sheet(read_eds(text, findings)) {
    check_sheet(sheet, nullptr, findings);
  }
  std::string told() const {
    std::string text;
    for (const Finding& each : findings) text += each.text + "; " + each.expected + "\n";
    return text;
  }
};

void expect_found(const Sheet& read, std::string_view weight, std::string_view text) {
  const auto kind = weight == "warn" ? Finding::Weight::warning : Finding::Weight::error;
  EXPECT_TRUE(is_found(read.findings, kind, text)) << text << "\n" << read.told();
}

std::string section_of(const std::string& keys) {
  std::vector<std::string> lines = {"ParameterName=Speed", "ObjectType=0x7", "DataType=0x0006",
                                    "AccessType=rw"};
  const auto key_of = [](std::string_view line) { return trimmed(line.substr(0, line.find('='))); };
  std::vector<std::string> given;
  for (const std::string& part : parts_of(keys, ';')) {
    const std::string line(trimmed(part));
    const bool is_without = line.starts_with('-') && line.find('=') == std::string::npos;
    const std::string key(key_of(is_without ? line.substr(1) : line));
    std::erase_if(lines, [&](const std::string& each) { return same_letters(key_of(each), key); });
    // Blanks around the value are part of the case.
    if (!is_without) given.push_back(part.substr(part.find_first_not_of(' ')));
  }
  std::string text = "[2000]\n";
  for (const std::string& line : lines) text += line + "\n";
  for (const std::string& line : given) text += line + "\n";
  return text;
}

void check_entry(const Sheet& read, const std::string& check) {
  if (check.starts_with("python-differs")) return;
  const std::size_t sign = check.find('=');
  const std::string what = check.substr(0, sign);
  const std::string right = sign == std::string::npos ? "" : check.substr(sign + 1);
  if (what == "warn" || what == "error") return expect_found(read, what, right);
  const SheetEntry* entry = read.sheet.find(0x2000, 0);
  ASSERT_NE(entry, nullptr);
  if (what == "bad") {
    EXPECT_EQ(bytes_text(*entry), "bad");
  } else {
    EXPECT_EQ(said(*entry, what), right) << check;
  }
}

TEST(SheetOddities, EntriesHaveTheValueThatIsRightByCia306) {
  std::size_t cases = 0;
  for (const std::string& line : lines_of("tests/sheets/entries.txt")) {
    if (line.empty() || line.starts_with('#')) continue;
    SCOPED_TRACE(line);
    const std::vector<std::string> columns = parts_of(line, '|');
    ASSERT_GE(columns.size(), 3U);
    const Sheet read(section_of(columns[1]));
    for (const std::string& check : parts_of(columns[2], ';')) {
      check_entry(read, std::string(trimmed(check)));
    }
    ++cases;
  }
  EXPECT_GE(cases, 90U);
}

/// `\xHH` is a byte; a backslash at the end of a line joins it with the next one.
std::string unescaped(std::string_view text) {
  std::string made;
  while (!text.empty()) {
    const auto byte = text.starts_with("\\x") ? parse_hex(text.substr(2, 2), 2) : std::nullopt;
    if (byte) {
      made += static_cast<char>(*byte);
      text.remove_prefix(4);
    } else if (text == "\\\n") {
      break;
    } else {
      made += text.front();
      text.remove_prefix(1);
    }
  }
  return made;
}

void check_place(const Sheet& read, std::string_view place, std::string_view check) {
  const auto index = parse_hex(place.substr(0, 4), 4);
  ASSERT_TRUE(index) << place;
  const auto object = read.sheet.objects.find(static_cast<std::uint16_t>(*index));
  const bool has_sub = place.size() > 5;
  if (!has_sub) {
    EXPECT_EQ(check, "absent") << place;
    EXPECT_EQ(object, read.sheet.objects.end()) << place;
    return;
  }
  const auto sub = parse_hex(place.substr(5), 2);
  const SheetEntry* entry = read.sheet.find(*index, *sub);
  if (check == "absent") {
    EXPECT_EQ(entry, nullptr) << place;
    return;
  }
  ASSERT_NE(entry, nullptr) << place << "\n" << read.told();
  const std::size_t sign = check.find('=');
  ASSERT_NE(sign, std::string_view::npos) << check;
  EXPECT_EQ(said(*entry, check.substr(0, sign)), check.substr(sign + 1)) << place;
}

void check_line(const Sheet& read, std::string_view line) {
  const std::size_t blank = std::min(line.find(' '), line.size());
  const std::string_view what = line.substr(0, blank);
  const std::string rest(trimmed(line.substr(blank)));
  if (what.starts_with("python-differs")) return;
  if (what == "warn" || what == "error") return expect_found(read, what, rest);
  if (what == "objects") {
    EXPECT_EQ(fmt::format("{}", read.sheet.objects.size()), rest);
  } else if (what == "node") {
    EXPECT_EQ(fmt::format("{}", read.sheet.node_id()), rest);
  } else if (what == "dummy") {
    const auto index = static_cast<std::uint16_t>(*parse_hex(rest.substr(0, 4), 4));
    EXPECT_EQ(read.sheet.dummies.at(index), rest.ends_with('1'));
  } else {
    check_place(read, what, rest);
  }
}

TEST(SheetOddities, SheetsHaveTheObjectsThatAreRightByCia306) {
  std::string title;
  std::string text;
  std::vector<std::string> checks;
  std::size_t cases = 0;
  const auto finish = [&] {
    if (title.empty()) return;
    SCOPED_TRACE(title);
    const Sheet read(text);
    for (const std::string& check : checks) check_line(read, check);
    EXPECT_FALSE(checks.empty());
    ++cases;
  };
  for (const std::string& line : lines_of("tests/sheets/sheets.txt")) {
    if (line.starts_with("## ")) {
      finish();
      title = line;
      text.clear();
      checks.clear();
    } else if (line.starts_with("? ")) {
      checks.push_back(line.substr(2));
    } else if (!title.empty() && !line.empty()) {
      text += unescaped(line + "\n");
    }
  }
  finish();
  EXPECT_GE(cases, 40U);
}

}  // namespace
}  // namespace canvoy::formats::sheet_oddities_test
