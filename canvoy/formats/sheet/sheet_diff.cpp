#include "canvoy/formats/sheet/sheet_diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "canvoy/formats/sheet/sheet_value.hpp"

namespace canvoy::formats {

namespace {

class Comparer {
 public:
  Comparer(const DataSheet& first, const DataSheet& second) : first_(first), second_(second) {}

  std::vector<Difference> compare() {
    compare_sections();
    std::set<std::uint16_t> indices;
    for (const auto& [index, object] : first_.objects) indices.insert(index);
    for (const auto& [index, object] : second_.objects) indices.insert(index);
    for (const std::uint16_t index : indices) compare_object(index);
    return std::move(found_);
  }

 private:
  void add(std::string place, std::string key, std::string first, std::string second) {
    found_.push_back({std::move(place), std::move(key), std::move(first), std::move(second)});
  }

  void compare_sections() {
    for (const IniSection& one : first_.sections) {
      // The lines before the first section are comments.
      if (one.name.empty() || same_letters(one.name, "FileInfo")) continue;
      const IniSection* other = second_.section(one.name);
      if (other == nullptr) {
        add(one.name, "", "there", "");
      } else {
        compare_keys(one, *other);
      }
    }
    for (const IniSection& other : second_.sections) {
      const bool is_new = first_.section(other.name) == nullptr;
      if (is_new && !other.name.empty() && !same_letters(other.name, "FileInfo"))
        add(other.name, "", "", "there");
    }
  }

  void compare_keys(const IniSection& one, const IniSection& other) {
    for (const IniLine& line : one.lines) {
      if (line.key.empty()) continue;
      const auto value = other.value(line.key).value_or("");
      if (!same(line.value, value)) add(one.name, line.key, line.value, std::string(value));
    }
    for (const IniLine& line : other.lines) {
      if (!line.key.empty() && one.find(line.key) == nullptr && !line.value.empty()) {
        add(one.name, line.key, "", line.value);
      }
    }
  }

  static bool same(std::string_view a, std::string_view b) {
    if (a == b) return true;
    const auto number_a = sheet_number(a);
    return number_a && number_a == sheet_number(b);
  }

  void compare_object(std::uint16_t index) {
    const auto one = first_.objects.find(index);
    const auto other = second_.objects.find(index);
    const std::string place = place_text(index);
    if (one == first_.objects.end()) return add(place, "", "", other->second.own.name);
    if (other == second_.objects.end()) return add(place, "", one->second.own.name, "");
    compare_entry(place, one->second.own, other->second.own);
    std::set<std::uint8_t> subs;
    for (const auto& [sub, entry] : one->second.subs) subs.insert(sub);
    for (const auto& [sub, entry] : other->second.subs) subs.insert(sub);
    for (const std::uint8_t sub : subs) compare_sub(index, sub);
  }

  void compare_sub(std::uint16_t index, std::uint8_t sub) {
    const SheetEntry* one = first_.find(index, sub);
    const SheetEntry* other = second_.find(index, sub);
    const std::string place = place_text(index, sub);
    if (one == nullptr || other == nullptr) {
      add(place, "", one == nullptr ? "" : one->name, other == nullptr ? "" : other->name);
    } else {
      compare_entry(place, *one, *other);
    }
  }

  /// The value of a key that CiA 306 does not define; comments are ignored.
  static std::string other_key(const SheetEntry& entry, const std::string& key) {
    const auto found = std::ranges::find_if(
        entry.others, [&key](const KeyValue& each) { return same_letters(each.key, key); });
    return found == entry.others.end() ? std::string() : found->value;
  }

  void compare_others(const std::string& place, const SheetEntry& one, const SheetEntry& other) {
    for (const KeyValue& own : one.others) {
      const std::string value = other_key(other, own.key);
      if (!own.key.empty() && own.value != value) add(place, own.key, own.value, value);
    }
    for (const KeyValue& own : other.others) {
      const bool is_new = !own.key.empty() && other_key(one, own.key).empty();
      if (is_new && !own.value.empty()) add(place, own.key, "", own.value);
    }
  }

  void compare_entry(const std::string& place, const SheetEntry& one, const SheetEntry& other) {
    const auto compare = [&](const char* key, const std::string& a, const std::string& b) {
      if (a != b) add(place, key, a, b);
    };
    const auto compare_value = [&](const char* key, const std::string& a, const std::string& b) {
      if (a.empty() != b.empty() || !same_value(one.data_type, a, b)) compare(key, a, b);
    };
    const auto hex = [](unsigned number) { return fmt::format("0x{:X}", number); };
    compare("ParameterName", one.name, other.name);
    compare("ObjectType", hex(one.object_type), hex(other.object_type));
    compare("DataType", hex(one.data_type), hex(other.data_type));
    if (!same_letters(one.access, other.access)) add(place, "AccessType", one.access, other.access);
    compare_value("DefaultValue", one.default_value, other.default_value);
    compare_value("LowLimit", one.low_limit, other.low_limit);
    compare_value("HighLimit", one.high_limit, other.high_limit);
    compare("PDOMapping", one.pdo_mapping ? "1" : "0", other.pdo_mapping ? "1" : "0");
    if (!same(one.obj_flags, other.obj_flags))
      add(place, "ObjFlags", one.obj_flags, other.obj_flags);
    compare_value("ParameterValue", one.value, other.value);
    compare("Denotation", one.denotation, other.denotation);
    compare_others(place, one, other);
  }

  const DataSheet& first_;
  const DataSheet& second_;
  std::vector<Difference> found_;
};

}  // namespace

std::vector<Difference> compare_sheets(const DataSheet& first, const DataSheet& second) {
  return Comparer(first, second).compare();
}

}  // namespace canvoy::formats
