#include "canvoy/formats/eds/eds_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "canvoy/formats/eds/eds_parts.hpp"
#include "canvoy/formats/encoding.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t index_digits = 4;

/// A number of up to 32 bits that does not depend on the node-ID.
std::optional<unsigned> parse_unsigned(std::string_view text) {
  const auto parsed = sheet_number(text);
  if (!parsed) return std::nullopt;
  const SheetNumber number = *parsed;
  const bool fits = !number.plus_node_id && number.number >= 0 && number.number <= 0xFFFF'FFFF;
  return fits ? std::optional(static_cast<unsigned>(number.number)) : std::nullopt;
}

/// Meaning of the name of a section: `1018`, `1018sub1`, `1018Value`.
struct SectionPlace {
  unsigned index = 0;
  std::string_view suffix;  ///< after the index
};
std::optional<SectionPlace> place_of(std::string_view name) {
  if (name.size() < index_digits) return std::nullopt;
  const auto index = parse_hex(name.substr(0, index_digits), index_digits);
  if (!index) return std::nullopt;
  return SectionPlace{*index, name.substr(index_digits)};
}

/// The sub-index in a suffix: `sub1F`.
std::optional<unsigned> sub_of(std::string_view suffix) {
  constexpr std::string_view word = "sub";
  if (!same_letters(suffix.substr(0, word.size()), word)) return std::nullopt;
  return parse_hex(suffix.substr(word.size()), 2);
}

/// Texts of an entry by key.
struct TextKey {
  std::string_view key;
  std::string SheetEntry::*member;
};
constexpr auto text_keys = std::to_array<TextKey>({
    {"ParameterName", &SheetEntry::name},
    {"AccessType", &SheetEntry::access},
    {"DefaultValue", &SheetEntry::default_value},
    {"LowLimit", &SheetEntry::low_limit},
    {"HighLimit", &SheetEntry::high_limit},
    {"ObjFlags", &SheetEntry::obj_flags},
    {"ParameterValue", &SheetEntry::value},
    {"Denotation", &SheetEntry::denotation},
});

class Reader {
 public:
  Reader(const Ini& file, Findings& findings) : file_(file), findings_(findings) {}

  DataSheet read() {
    for (const IniSection& section : file_.sections) {
      check_lines(section);
      if (!seen_.insert(folded(section.name)).second) {
        complain(section.number, section.name, "the section stands here for the second time",
                 "one section of each name");
        if (place_of(section.name)) continue;
      }
      read_section(section);
    }
    read_lists();
    for (const Compact& compact : compacts_) expand(compact);
    for (const IniSection* section : compact_details_) read_compact_detail(*section);
    check_counts();
    return std::move(sheet_);
  }

 private:
  /// An object with entries that are not written out.
  struct Compact {
    std::uint16_t index = 0;
    unsigned count = 0;
    std::size_t line = 0;
  };

  static std::string folded(std::string_view name) {
    std::string letters(name);
    std::ranges::transform(letters, letters.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return letters;
  }

  void complain(std::size_t line, std::string_view section, std::string text,
                std::string expected = "", Finding::Weight weight = Finding::Weight::error) {
    // Many warnings must not hide an error.
    std::size_t& told = weight == Finding::Weight::error ? errors_ : warnings_;
    if (told > findings_max) return;
    if (told++ == findings_max) {
      text = fmt::format("there are more faults like these than the {} told", findings_max);
      line = 0;
      section = {};
      expected.clear();
    }
    findings_.push_back({line, std::string(section), std::move(text), std::move(expected), weight});
  }
  void warn(std::size_t line, std::string_view section, std::string text,
            std::string expected = "") {
    complain(line, section, std::move(text), std::move(expected), Finding::Weight::warning);
  }

  void check_lines(const IniSection& section) {
    std::set<std::string> keys;
    for (const IniLine& line : section.lines) {
      if (is_comment(line)) continue;
      if (line.key.empty()) {
        complain(line.number, section.name, fmt::format("'{}' sets no key", line.value),
                 "key=value");
      } else if (!keys.insert(folded(line.key)).second) {
        complain(line.number, section.name, fmt::format("{} is set again", line.key),
                 "each key once");
      }
    }
  }

  void read_section(const IniSection& section) {
    const auto place = place_of(section.name);
    if (!place) return read_named(section);
    if (place->suffix.empty()) {
      read_object(section, static_cast<std::uint16_t>(place->index));
    } else if (const auto sub = sub_of(place->suffix)) {
      read_sub(section, *place, static_cast<std::uint8_t>(*sub));
    } else if (is_compact_detail(place->suffix)) {
      compact_details_.push_back(&section);
    } else {
      sheet_.sections.push_back(section);
    }
  }

  static bool is_compact_detail(std::string_view suffix) {
    return same_letters(suffix, "Value") || same_letters(suffix, "Name") ||
           same_letters(suffix, "Denotation");
  }

  void read_named(const IniSection& section) {
    if (same_letters(section.name, "DummyUsage")) {
      read_dummies(section);
    } else if (same_letters(section.name, "Comments")) {
      read_comments(section);
    } else if (!is_list(section.name)) {
      sheet_.configured = sheet_.configured || is_commissioning(section.name);
      sheet_.sections.push_back(section);
    }
  }

  static bool is_list(std::string_view name) {
    return std::ranges::any_of(lists,
                               [name](const List& list) { return same_letters(list.name, name); });
  }

  void read_dummies(const IniSection& section) {
    for (const IniLine& line : section.lines) {
      constexpr std::string_view word = "Dummy";
      if (is_comment(line) || line.key.size() <= word.size()) continue;
      const auto index = parse_hex(std::string_view(line.key).substr(word.size()), index_digits);
      if (index) sheet_.dummies[static_cast<std::uint16_t>(*index)] = line.value == "1";
    }
  }

  void read_comments(const IniSection& section) {
    for (const IniLine& line : section.lines) {
      if (!line.key.empty() && !same_letters(line.key, "Lines")) {
        sheet_.comments.push_back(line.value);
      }
    }
  }

  SheetEntry read_entry(const IniSection& section) {
    SheetEntry entry;
    entry.line = section.number;
    bool has_name = false;
    for (const IniLine& line : section.lines) {
      if (is_comment(line)) entry.others.push_back({"", line.value});
      if (line.key.empty()) continue;
      has_name = has_name || same_letters(line.key, "ParameterName");
      read_key(section, line, entry);
    }
    if (!has_name) warn(section.number, section.name, "ParameterName is missing");
    return entry;
  }

  void read_key(const IniSection& section, const IniLine& line, SheetEntry& entry) {
    const auto* found = std::ranges::find_if(
        text_keys, [&line](const TextKey& each) { return same_letters(each.key, line.key); });
    if (found != text_keys.end()) {
      entry.*found->member = line.value;
      const bool is_value = found->member == &SheetEntry::value;
      sheet_.configured = sheet_.configured || (is_value && !line.value.empty());
    } else if (same_letters(line.key, "ObjectType")) {
      entry.object_type = read_number(section, line, 7);
    } else if (same_letters(line.key, "DataType")) {
      entry.data_type = read_number(section, line, 0);
    } else if (same_letters(line.key, "PDOMapping")) {
      entry.pdo_mapping = read_number(section, line, 0) != 0;
    } else if (!same_letters(line.key, "SubNumber") && !same_letters(line.key, "CompactSubObj")) {
      entry.others.push_back({line.key, line.value});
    }
  }

  /// An empty value is read as `otherwise`, like most tools do.
  unsigned read_number(const IniSection& section, const IniLine& line, unsigned otherwise) {
    if (line.value.empty()) {
      warn(line.number, section.name,
           fmt::format("{} is empty: 0x{:X} is assumed", line.key, otherwise), "a number");
      return otherwise;
    }
    if (const auto number = parse_unsigned(line.value)) return *number;
    complain(line.number, section.name, fmt::format("{} is '{}'", line.key, line.value),
             "a number");
    return otherwise;
  }

  void read_object(const IniSection& section, std::uint16_t index) {
    SheetObject& object = sheet_.objects[index];
    object.own = read_entry(section);
    if (section.value("ObjectType").value_or("").empty() && section.find("SubNumber")) {
      object.own.object_type = 9;
      warn(section.number, section.name, "ObjectType is missing", "0x9, since there is SubNumber");
    }
    if (const IniLine* line = section.find("SubNumber")) {
      counts_.push_back({line->number, index, read_number(section, *line, 0)});
    }
    if (const IniLine* line = section.find("CompactSubObj")) {
      const unsigned count = read_number(section, *line, 0);
      if (count > 254) {
        complain(line->number, section.name, fmt::format("CompactSubObj is {}", count), "0 to 254");
      } else if (count > 0) {
        compacts_.push_back({index, count, line->number});
      }
    }
  }

  void read_sub(const IniSection& section, const SectionPlace& place, std::uint8_t sub) {
    const auto found = sheet_.objects.find(static_cast<std::uint16_t>(place.index));
    if (found == sheet_.objects.end()) {
      complain(section.number, section.name, "there is no object for this entry",
               fmt::format("[{:04X}] before it", place.index));
      sheet_.objects[static_cast<std::uint16_t>(place.index)].own.object_type = 9;
    }
    sheet_.objects[static_cast<std::uint16_t>(place.index)].subs[sub] = read_entry(section);
  }

  struct List {
    std::string_view name;
    SheetObject::Group group;
  };
  static constexpr auto lists = std::to_array<List>({
      {"MandatoryObjects", SheetObject::Group::mandatory},
      {"OptionalObjects", SheetObject::Group::optional},
      {"ManufacturerObjects", SheetObject::Group::manufacturer},
  });

  void read_lists() {
    for (const List& list : lists) {
      const IniSection* section = file_.find(list.name);
      if (section == nullptr) {
        warn(0, list.name, "the section is missing");
        continue;
      }
      read_list(*section, list);
    }
    for (const auto& [index, object] : sheet_.objects) {
      if (object.group == SheetObject::Group::not_listed) {
        warn(object.own.line, fmt::format("{:04X}", index), "no list of objects names it",
             "an entry in MandatoryObjects, OptionalObjects or ManufacturerObjects");
      }
    }
  }

  void read_list(const IniSection& section, const List& list) {
    unsigned listed = 0;
    for (const IniLine& line : section.lines) {
      if (is_comment(line) || line.key.empty() || same_letters(line.key, "SupportedObjects")) {
        continue;
      }
      ++listed;
      const auto index = parse_unsigned(line.value);
      const auto found = index && *index <= 0xFFFF
                             ? sheet_.objects.find(static_cast<std::uint16_t>(*index))
                             : sheet_.objects.end();
      if (found == sheet_.objects.end()) {
        complain(line.number, section.name, fmt::format("'{}' has no section", line.value),
                 "the index of an object that is described");
      } else {
        found->second.group = list.group;
      }
    }
    const IniLine* count = section.find("SupportedObjects");
    if (count == nullptr) return warn(section.number, section.name, "SupportedObjects is missing");
    if (read_number(section, *count, 0) != listed) {
      warn(count->number, section.name, fmt::format("SupportedObjects is {}", count->value),
           fmt::format("{}", listed));
    }
  }

  /// Size of one entry with all texts of its object.
  static std::size_t bytes_of(const SheetEntry& entry) {
    std::size_t bytes = sizeof entry;
    for (const TextKey& text : text_keys) bytes += (entry.*text.member).size();
    return bytes;
  }

  void expand(const Compact& compact) {
    SheetObject& object = sheet_.objects[compact.index];
    compact_bytes_ += compact.count * bytes_of(object.own);
    if (compact_bytes_ > compact_bytes_max) {
      return complain(compact.line, place_text(compact.index),
                      fmt::format("CompactSubObj is {}", compact.count),
                      fmt::format("{} MiB of such entries in all", compact_bytes_max >> 20));
    }
    SheetEntry number = {.name = "NrOfObjects",
                         .data_type = 5,
                         .access = "ro",
                         .default_value = std::to_string(compact.count)};
    number.line = object.own.line;
    object.subs.try_emplace(0, std::move(number));
    for (unsigned sub = 1; sub <= compact.count; ++sub) {
      SheetEntry entry = object.own;
      entry.object_type = 7;
      entry.name += std::to_string(sub);
      entry.others.clear();
      object.subs.try_emplace(static_cast<std::uint8_t>(sub), std::move(entry));
    }
    SheetEntry& own = object.own;
    own.access.clear();
    own.default_value.clear();
    own.low_limit.clear();
    own.high_limit.clear();
    own.data_type = 0;
    own.pdo_mapping = false;
  }

  /// `1003Value`: values, names or denotations of single entries of a compact object.
  void read_compact_detail(const IniSection& section) {
    const SectionPlace place = *place_of(section.name);
    std::string SheetEntry::*member = same_letters(place.suffix, "Value") ? &SheetEntry::value
                                      : same_letters(place.suffix, "Name")
                                          ? &SheetEntry::name
                                          : &SheetEntry::denotation;
    const auto object = sheet_.objects.find(static_cast<std::uint16_t>(place.index));
    for (const IniLine& line : section.lines) {
      if (is_comment(line) || line.key.empty() || same_letters(line.key, "NrOfEntries")) continue;
      SheetEntry* entry = nullptr;
      if (object != sheet_.objects.end()) entry = find_sub(object->second, line.key);
      if (entry == nullptr) {
        complain(line.number, section.name, fmt::format("there is no entry {}", line.key));
        continue;
      }
      entry->*member = line.value;
      sheet_.configured = sheet_.configured || member == &SheetEntry::value;
    }
  }

  /// The entry with this text as sub-index, or null.
  static SheetEntry* find_sub(SheetObject& object, std::string_view text) {
    const auto sub = parse_unsigned(text);
    if (!sub || *sub > 0xFF) return nullptr;
    const auto found = object.subs.find(static_cast<std::uint8_t>(*sub));
    return found == object.subs.end() ? nullptr : &found->second;
  }

  struct Count {
    std::size_t line = 0;
    std::uint16_t index = 0;
    unsigned subs = 0;
  };
  void check_counts() {
    for (const Count& count : counts_) {
      const std::size_t subs = sheet_.objects[count.index].subs.size();
      if (subs != count.subs) {
        warn(count.line, fmt::format("{:04X}", count.index),
             fmt::format("SubNumber is {}", count.subs), fmt::format("{}", subs));
      }
    }
  }

  const Ini& file_;
  Findings& findings_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  std::size_t compact_bytes_ = 0;  ///< size of expanded objects
  DataSheet sheet_;
  std::set<std::string> seen_;
  std::vector<Compact> compacts_;
  std::vector<const IniSection*> compact_details_;
  std::vector<Count> counts_;
};

}  // namespace

DataSheet read_eds(std::string_view text, Findings& findings) {
  const DecodedText decoded = decode_text(text);
  if (!decoded.remark().empty()) {
    findings.push_back({0, "", std::string(decoded.remark()), "", Finding::Weight::warning});
  }
  const Ini file = parse_ini(decoded.text);
  DataSheet sheet = Reader(file, findings).read();
  add_modules(sheet, findings);
  add_compact_pdos(sheet, findings);
  return sheet;
}

}  // namespace canvoy::formats
