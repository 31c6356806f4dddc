// Each profile compared with the contents of its clauses: the tables in canvoy/profiles/clauses,
// typed from the text (see testing/clause_table.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <source_location>
#include <string>
#include <vector>

#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/profiles/testing/clause_table.hpp"

namespace canvoy::clauses {

Table read_table(std::string_view name) {
  const std::filesystem::path here(std::source_location::current().file_name());
  const auto path = here.parent_path() / "clauses" / (std::string(name) + ".txt");
  std::ifstream file(path);
  EXPECT_TRUE(file.is_open()) << path;
  SCOPED_TRACE(path);
  return Reader().read(file);
}

namespace {

// The description in the form of a table.

std::string numbered(std::string_view name, unsigned number) {
  std::string text(name);
  const std::size_t place = text.find('#');
  return place == std::string::npos ? text : text.replace(place, 1, std::to_string(number));
}
std::string name_at(const ObjectInfo& object, const EntryInfo& entry, unsigned sub) {
  if (entry.name.empty()) return numbered(object.name, object.first_number);
  return numbered(entry.name, entry.first_number + sub - entry.sub_first);
}
std::string name_of(const FieldInfo& field) {
  return numbered(field.name, field.number);
}
std::string text_of(DataType type) {
  switch (type) {
    case DataType::boolean:
      return "boolean";
    case DataType::real32:
      return "real32";
    case DataType::visible_string:
      return "visible";
    case DataType::octet_string:
      return "octets";
    case DataType::utf8_string:
      return "utf8";
    case DataType::domain:
      return "domain";
    case DataType::time_of_day:
      return "time_of_day";
    default:
      break;
  }
  if (is_signed(type)) return "i" + std::to_string(bit_length(type));
  return "u" + std::to_string(bit_length(type));
}
std::string text_of(Access access) {
  if (access == Access::const_) return "const";
  return access == Access::rw ? "rw" : access == Access::wo ? "wo" : "ro";
}
std::string access_of(const EntryInfo& entry) {
  if (entry.access_by_device) return "vd";
  if (entry.consumer_access != Access::rw) return text_of(entry.access);
  return text_of(entry.access) + "/" + text_of(entry.consumer_access);
}
std::string text_of(Mapping mapping) {
  return mapping == Mapping::by_default ? "default"
         : mapping == Mapping::optional ? "optional"
                                        : "no";
}
std::string text_of(Category category) {
  return category == Category::mandatory ? "M" : category == Category::optional ? "O" : "C";
}
std::string text_of(ObjectCode code) {
  constexpr const char* names[] = {"DOMAIN", "", "", "", "", "VAR", "ARRAY", "RECORD"};
  return names[static_cast<unsigned>(code) - static_cast<unsigned>(ObjectCode::domain)];
}
std::string text_of(Meaning meaning) {
  constexpr const char* names[] = {"state",       "invalid",      "failure",  "not_implemented",
                                   "do_not_care", "manufacturer", "reserved", "padding"};
  return names[static_cast<unsigned>(meaning)];
}
/// The printed default: that of the consumers of the object, if they have one.
std::optional<std::int64_t> initial_of(const EntryInfo& entry) {
  if (entry.consumer_initial) {
    EXPECT_FALSE(entry.initial) << "two defaults";
    return entry.consumer_initial.number;
  }
  const Default& initial = entry.initial;
  const bool is_printed = initial.kind == Default::Kind::number ||
                          (initial.kind == Default::Kind::highest_sub && initial.number != 0);
  return is_printed ? std::optional(initial.number) : std::nullopt;
}

/// Compares one word of a line with the object. False: the word has another subject.
bool is_of_object(const std::string& word, const ObjectInfo& object) {
  if (word == "VAR" || word == "ARRAY" || word == "RECORD") {
    EXPECT_EQ(text_of(object.code), word);
  } else if (word == "M" || word == "O" || word == "C") {
    EXPECT_EQ(text_of(object.category), word);
    EXPECT_EQ(object.condition.empty(), word != "C") << object.condition;
  } else if (word.starts_with('(')) {
    EXPECT_EQ("(" + std::string(object.clause) + ")", word);
  } else {
    return false;
  }
  return true;
}
void compare_with_entry(const std::string& word, const EntryInfo& entry) {
  constexpr std::array<std::string_view, 3> mappings = {"no", "optional", "default"};
  constexpr std::array<std::string_view, 6> accesses = {"ro", "wo", "rw", "const", "vd", "ro/rw"};
  if (word == "M" || word == "O" || word == "C") {
    EXPECT_EQ(text_of(entry.category), word);
  } else if (std::ranges::find(mappings, word) != mappings.end()) {
    EXPECT_EQ(text_of(entry.mapping), word);
  } else if (std::ranges::find(accesses, word) != accesses.end()) {
    EXPECT_EQ(access_of(entry), word);
  } else if (word.starts_with('=')) {
    EXPECT_EQ(initial_of(entry), number_in(word.substr(1))) << word;
  } else if (const auto range = range_in(word, ".."); range) {
    EXPECT_EQ(entry.value.limits.kind, Limits::Kind::absolute);
    EXPECT_EQ(entry.value.limits.low, range->first);
    EXPECT_EQ(entry.value.limits.high, range->second);
  } else {
    EXPECT_EQ(text_of(entry.type), word);
  }
}

/// The words of a line; a clause is one of them.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream rest(text);
  for (std::string word; rest >> word;) {
    if (!words.empty() && words.back().starts_with('(') && !words.back().ends_with(')')) {
      words.back() += " " + word;
    } else {
      words.push_back(word);
    }
  }
  return words;
}

struct Bits {
  const ValueInfo* value = nullptr;
  BitRange range;
};
std::optional<Bits> find_bits(const EntryInfo& entry, const std::string& name) {
  if (name.empty()) return Bits{&entry.value, bits_of(entry)};
  for (const FieldInfo& field : entry.fields) {
    if (name_of(field) == name) return Bits{&field.value, bits_of(field)};
  }
  return std::nullopt;
}

void compare_value(const Value& expected, const Bits& bits) {
  SCOPED_TRACE(testing::Message() << "code " << expected.first << " (" << std::hex << expected.first
                                  << "h) " << expected.text);
  const NumberRules rules(*bits.value, bits.range);
  if (expected.kind == Value::Kind::last) {
    EXPECT_TRUE(rules.is_value(expected.first));
    EXPECT_FALSE(rules.is_value(expected.first + 1));
    return;
  }
  if (expected.kind == Value::Kind::valid) {
    EXPECT_TRUE(rules.is_value(expected.first) && rules.is_value(expected.last));
    EXPECT_FALSE(rules.is_value(expected.first - 1) || rules.is_value(expected.last + 1));
    return;
  }
  if (expected.kind == Value::Kind::number) {
    EXPECT_EQ(symbol(bits.value->unit), expected.text);
    const std::optional<double> physical = rules.physical(expected.first);
    ASSERT_TRUE(physical);
    EXPECT_DOUBLE_EQ(*physical, expected.number);
    EXPECT_EQ(rules.nearest(expected.number), expected.first);
    return;
  }
  for (std::int64_t code = expected.first; code <= expected.last; ++code) {
    const NamedValue* named = find_name(*bits.value, code, bits.range.bits, bits.range.is_signed);
    ASSERT_NE(named, nullptr) << code;
    EXPECT_TRUE(expected.text.empty() || named->name == expected.text)
        << code << " " << named->name;
    EXPECT_EQ(text_of(named->meaning), expected.meaning) << code;
  }
}

void compare_fields(const EntryRow& row, const EntryInfo& entry, bool is_complete) {
  for (const Field& expected : row.fields) {
    const bool found = std::ranges::any_of(entry.fields, [&](const FieldInfo& field) {
      return name_of(field) == expected.name && field.first_bit == expected.first_bit &&
             field.first_bit + unsigned{field.bits} - 1 == expected.last_bit;
    });
    EXPECT_TRUE(found) << expected.name << ": bits " << expected.last_bit << " to "
                       << expected.first_bit;
  }
  if (is_complete) {
    EXPECT_EQ(row.fields.size(), entry.fields.size()) << "not all fields are in the figure";
  }
}

void compare_entry(const Table& table, const EntryRow& row, const ObjectInfo& object,
                   unsigned sub) {
  SCOPED_TRACE(testing::Message() << "line " << row.line << ": sub-index " << std::hex << sub);
  const EntryInfo* entry = find_entry(object, sub);
  ASSERT_NE(entry, nullptr);
  for (const std::string& word : words_of(row.text)) {
    if (!row.is_variable || !is_of_object(word, object)) compare_with_entry(word, *entry);
  }
  if (!row.name.empty()) {
    EXPECT_EQ(name_at(object, *entry, sub), numbered(row.name, sub));
  }
  compare_fields(row, *entry, table.is_complete("figures"));
  for (const Values& values : row.values) {
    SCOPED_TRACE(values.field);
    const auto bits = find_bits(*entry, values.field);
    ASSERT_TRUE(bits);
    for (const Value& value : values.values) compare_value(value, *bits);
  }
}

/// The object at one of the indices of a row.
void compare_object(const Table& table, const ObjectRow& row, const Profile& profile,
                    unsigned index) {
  SCOPED_TRACE(testing::Message() << "line " << row.line << ": " << std::hex << index << "h");
  const ObjectInfo* object = find_object(profile, index);
  ASSERT_NE(object, nullptr);
  for (const std::string& word : words_of(row.text)) {
    const bool is_of_entry = row.text.starts_with("VAR");
    EXPECT_TRUE(is_of_object(word, *object) || is_of_entry) << word;
  }
  if (!row.name.empty()) {
    EXPECT_EQ(object->name, row.name);
  }
  for (const EntryRow& entry : row.entries) {
    for (unsigned sub = entry.first; sub <= entry.last; ++sub) {
      compare_entry(table, entry, *object, sub);
    }
  }
}

/// Checks that an object has no entries but those up to the highest one of the table, without a
/// gap.
void expect_no_other_entries(const ObjectRow& row, const ObjectInfo& object) {
  unsigned last = 0;
  for (const EntryRow& entry : row.entries) last = std::max(last, entry.last);
  unsigned next = 0;
  for (const EntryInfo& entry : object.entries()) {
    EXPECT_EQ(entry.sub_first, next) << object.name;
    next = entry.last_sub() + 1U;
  }
  EXPECT_EQ(next, last + 1) << object.name;
}

struct Clauses : testing::TestWithParam<const char*> {
  const Table table = read_table(GetParam());
  const Profile& profile = *find_profile(std::string_view(GetParam()));
};

TEST_P(Clauses, AreWhatTheDescriptionSays) {
  EXPECT_FALSE(table.objects.empty());
  for (const ObjectRow& row : table.objects) {
    compare_object(table, row, profile, row.first);
    if (row.last != row.first) compare_object(table, row, profile, row.last);
  }
}

TEST_P(Clauses, NothingElseIsDescribed) {
  std::vector<ObjectRow> rows = table.objects;
  std::ranges::sort(rows, {}, &ObjectRow::first);
  std::size_t position = 0;
  for (const ObjectInfo* object : profile.objects) {
    if (!table.is_complete("objects")) break;
    ASSERT_LT(position, rows.size()) << object->name;
    const ObjectRow& row = rows[position++];
    ASSERT_EQ(object->index, row.first) << "line " << row.line;
    EXPECT_EQ(object->count, row.last - row.first + 1) << "line " << row.line;
  }
  for (const ObjectRow& row : table.objects) {
    const ObjectInfo* object = find_object(profile, row.first);
    if (!table.is_complete("entries") || object == nullptr || row.entries.empty()) continue;
    SCOPED_TRACE(testing::Message() << "line " << row.line << ": " << std::hex << row.first);
    expect_no_other_entries(row, *object);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Clauses, testing::Values("407", "417-4", "447-3"), [](const auto& of) {
  std::string name = std::string("Cia") + of.param;
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace canvoy::clauses
