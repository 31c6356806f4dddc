// Contents of the clauses of a profile, typed by hand into a text table beside this folder
// (canvoy/profiles/clauses), for a test that compares them with the description. Nothing in these
// tables is derived from the description, so that an error in one of them shows up in the other.
//
//     complete objects entries figures
//     6007 VAR C (4.2.2.3) u8 ro/rw default =FFh : Ignition switch status
//       [7:6 ignition start] [5:4 ignition on] [3:2 accessory] [1:0 ignition lock]
//       ignition lock : Signal = 0 Ignition not locked | 1 Ignition locked (Key in)
//     6020 VAR O (4.2.2.18) u8 ro/rw no =FFh : Displayed outside air temperature  # errata A2
//       = 0 -> -50 °C | FDh -> 76.5 °C | FDh last
//     60A6 ARRAY C (4.2.9.29) : Icon display 1 command
//     .00 M u8 ro no =- : Highest sub-index supported
//     .02-04 O u16 rw no =FFFFh 1..9 : Icon # command
//     enum Signal = 0 no | 1 yes
//
// A line describes an object (its index, or those from one to another), an entry (its sub-index),
// fields (bits and names), or values: of a field, or, without a name, of the whole entry. Facts are
// in any order; omitted facts are not checked. Behind ` : ` is a name, in which `#` is the
// sub-index. VAR, ARRAY and RECORD are object codes; M, O and C categories; (4.2) the clause; vd an
// access that the virtual device decides; ro/rw the accesses of provider and consumer; =FFh the
// default, =- no default; 1..9 the allowed range. A value is a code, or several, and its name,
// preceded by its meaning where that is not a state; `->` a number with its unit, both ways; `last`
// the highest code that is a number, `valid` all codes that are numbers. Two blanks, `#` and
// another blank start a comment.
// A type before the values is the enumeration of their handle, and an `enum` gives the codes of its
// enumerators. `complete` names the kinds of which the table has all.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <istream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace canvoy::clauses {

struct Value {
  enum class Kind : std::uint8_t { named, number, last, valid };
  Kind kind = Kind::named;
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::string meaning = "state";
  std::string text;   ///< a name or the symbol of a unit
  double number = 0;  ///< in that unit
};
/// Values of a field, or, if that is empty, of the whole entry.
struct Values {
  std::string field;
  std::string enumeration;  ///< its name in C++
  std::vector<Value> values;
};
struct Field {
  unsigned first_bit = 0;
  unsigned last_bit = 0;
  std::string name;
};
struct EntryRow {
  unsigned line = 0;
  unsigned first = 0;
  unsigned last = 0;
  bool is_variable = false;  ///< it is on the line of its object
  std::string text;          ///< the facts, without the name
  std::string name;
  std::vector<Field> fields;
  std::vector<Values> values;
};
struct ObjectRow {
  unsigned line = 0;
  unsigned first = 0;
  unsigned last = 0;
  std::string text;
  std::string name;
  std::vector<EntryRow> entries;  ///< of a variable one, with the facts on the object's line
};
struct Enumeration {
  std::string name;
  std::vector<Value> values;
};
struct Table {
  std::string complete;
  std::vector<ObjectRow> objects;
  std::vector<Enumeration> enumerations;

  bool is_complete(std::string_view what) const { return complete.find(what) != std::string::npos; }
};

inline std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}
/// The parts of a text between `separator`, without blanks around them.
inline std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + separator.size());
  }
}
/// `12`, `-5`, `FFh`; with `base` 16 without the letter. Nothing if it is no number.
inline std::optional<std::int64_t> number_in(std::string_view text, int base = 10) {
  if (text.ends_with('h')) {
    text.remove_suffix(1);
    base = 16;
  }
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}
/// One number, or two with `separator` between them.
inline std::optional<std::pair<std::int64_t, std::int64_t>> range_in(std::string_view text,
                                                                     std::string_view separator,
                                                                     int base = 10) {
  const std::size_t middle = text.find(separator);
  const auto first = number_in(text.substr(0, middle), base);
  if (middle == std::string_view::npos) {
    return first ? std::optional(std::pair(*first, *first)) : std::nullopt;
  }
  const auto last = number_in(text.substr(middle + separator.size()), base);
  if (!first || !last) return std::nullopt;
  return std::pair(*first, *last);
}

/// Reads a table line by line. An unknown line is a failure of the test.
class Reader {
 public:
  Table read(std::istream& file) {
    for (std::string line; std::getline(file, line);) {
      ++line_;
      if (line.starts_with('#')) continue;
      const std::string text = trimmed(line.substr(0, line.find("  # ")));
      if (!text.empty() && !read_line(text)) ADD_FAILURE() << "line " << line_ << ": " << line;
    }
    return std::move(table_);
  }

 private:
  bool read_line(const std::string& line) {
    constexpr std::string_view complete = "complete ";
    if (line.starts_with(complete)) {
      table_.complete = line.substr(complete.size());
      return true;
    }
    if (line.starts_with('[')) return read_fields(line);
    if (line.starts_with('|')) return values_ != nullptr && read_values(line.substr(1));
    if (line.starts_with('.')) return read_entry(line);
    if (line.starts_with("= ")) return begin_values("") && read_values(line.substr(2));
    if (const std::size_t sign = line.find(" = "); sign != std::string::npos) {
      const std::string what = line.substr(0, sign);
      const bool begun = what.starts_with("enum ") ? begin_enumeration(what) : begin_values(what);
      return begun && read_values(line.substr(sign + 3));
    }
    return read_object(line);
  }
  /// The facts of a line, and its name.
  static std::pair<std::string, std::string> facts_in(const std::string& line) {
    const std::size_t sign = line.find(" : ");
    const std::size_t first = line.find(' ');
    if (first == std::string::npos) return {};
    const std::size_t length = sign == std::string::npos ? sign : sign - first;
    return {trimmed(line.substr(first, length)),
            sign == std::string::npos ? "" : trimmed(line.substr(sign + 3))};
  }
  bool read_object(const std::string& line) {
    const auto range = range_in(line.substr(0, line.find(' ')), "-", 16);
    if (!range || range->second < range->first) return false;
    const auto [text, name] = facts_in(line);
    table_.objects.push_back({line_,
                              static_cast<unsigned>(range->first),
                              static_cast<unsigned>(range->second),
                              text,
                              name,
                              {}});
    if (text.starts_with("VAR")) add_entry({line_, 0, 0, true, text, "", {}, {}});
    return true;
  }
  bool read_entry(const std::string& line) {
    const auto range = range_in(line.substr(1, line.find(' ') - 1), "-", 16);
    if (!range || table_.objects.empty()) return false;
    const auto [text, name] = facts_in(line);
    EntryRow row{.line = line_, .text = text, .name = name, .fields = {}, .values = {}};
    row.first = static_cast<unsigned>(range->first);
    row.last = static_cast<unsigned>(range->second);
    add_entry(std::move(row));
    return true;
  }
  void add_entry(EntryRow row) {
    table_.objects.back().entries.push_back(std::move(row));
    values_ = nullptr;
  }
  EntryRow* entry() {
    if (table_.objects.empty() || table_.objects.back().entries.empty()) return nullptr;
    return &table_.objects.back().entries.back();
  }
  /// `[7:6 ignition start] [5 lock]`
  bool read_fields(std::string_view text) {
    while (text.starts_with('[')) {
      const std::size_t end = text.find(']');
      const std::string one(text.substr(1, end - 1));
      const std::size_t blank = one.find(' ');
      if (end == std::string::npos || blank == std::string::npos || entry() == nullptr)
        return false;
      const auto bits = range_in(one.substr(0, blank), ":");
      if (!bits) return false;
      entry()->fields.push_back({static_cast<unsigned>(bits->second),
                                 static_cast<unsigned>(bits->first), one.substr(blank + 1)});
      text.remove_prefix(end + 1);
      text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    }
    return text.empty();
  }
  /// `sound volume : Volume`
  bool begin_values(const std::string& what) {
    if (entry() == nullptr) return false;
    const std::size_t colon = what.find(": ");
    const std::string field = trimmed(what.substr(0, colon));
    const std::string type = colon == std::string::npos ? "" : what.substr(colon + 2);
    entry()->values.push_back({field, type, {}});
    values_ = &entry()->values.back().values;
    return true;
  }
  bool begin_enumeration(const std::string& what) {
    table_.enumerations.push_back({what.substr(what.find(' ') + 1), {}});
    values_ = &table_.enumerations.back().values;
    return true;
  }
  bool read_values(std::string_view text) {
    for (const std::string& one : split(text, " | ")) {
      if (!read_value(one)) return false;
    }
    return true;
  }
  bool read_value(const std::string& text) {
    const std::size_t blank = text.find(' ');
    const auto range = range_in(text.substr(0, blank), "..");
    if (!range || blank == std::string::npos) return false;
    Value value;
    value.first = range->first;
    value.last = range->second;
    value.text = text.substr(blank + 1);
    if (value.text.starts_with("-> ")) {
      value.kind = Value::Kind::number;
      std::istringstream number(value.text.substr(3));
      number >> value.number;
      value.text.clear();
      std::getline(number, value.text);
      value.text = trimmed(value.text);
    } else if (value.text == "last") {
      value.kind = Value::Kind::last;
    } else if (value.text == "valid") {
      value.kind = Value::Kind::valid;
    } else {
      take_meaning(value);
    }
    values_->push_back(value);
    return true;
  }
  static void take_meaning(Value& value) {
    for (const char* meaning : {"invalid", "failure", "not_implemented", "do_not_care",
                                "manufacturer", "reserved", "padding"}) {
      const std::string front = std::string(meaning) + ":";
      if (!value.text.starts_with(front)) continue;
      value.meaning = meaning;
      value.text = trimmed(value.text.substr(front.size()));
      return;
    }
  }

  unsigned line_ = 0;
  Table table_;
  std::vector<Value>* values_ = nullptr;
};

/// The table canvoy/profiles/clauses/`name`.txt; clauses_test.cpp opens it.
Table read_table(std::string_view name);

}  // namespace canvoy::clauses
