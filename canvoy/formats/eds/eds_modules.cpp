#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "canvoy/formats/eds/eds_parts.hpp"

namespace canvoy::formats {

namespace {

constexpr unsigned module_sub_last = 254;
constexpr unsigned modules_max = 1024;
constexpr std::size_t digits_of_index = 4;

/// Name of a section of a module after its number: `M12SubExt6000` is 12 and `SubExt6000`.
struct ModulePart {
  unsigned module = 0;
  std::string_view name;
};
std::optional<ModulePart> module_part(std::string_view section) {
  if (section.size() < 2 || (section[0] != 'M' && section[0] != 'm')) return std::nullopt;
  std::size_t end = 1;
  unsigned number = 0;
  for (; end < section.size() && section[end] >= '0' && section[end] <= '9' && end < 5; ++end) {
    number = number * 10 + static_cast<unsigned>(section[end] - '0');
  }
  if (end == 1 || number == 0) return std::nullopt;
  return ModulePart{number, section.substr(end)};
}

/// Index and optional sub-index after a word: `Fixed2000sub1`.
struct Place {
  std::uint16_t index = 0;
  std::optional<std::uint8_t> sub;
};
std::optional<Place> place_behind(std::string_view name, std::string_view word) {
  if (!same_letters(name.substr(0, word.size()), word)) return std::nullopt;
  name.remove_prefix(word.size());
  const auto index = parse_hex(name.substr(0, digits_of_index), digits_of_index);
  if (!index || name.size() < digits_of_index) return std::nullopt;
  Place place{static_cast<std::uint16_t>(*index), std::nullopt};
  name.remove_prefix(digits_of_index);
  if (name.empty()) return place;
  constexpr std::string_view sub_word = "sub";
  if (!same_letters(name.substr(0, sub_word.size()), sub_word)) return std::nullopt;
  const auto sub = parse_hex(name.substr(sub_word.size()), 2);
  if (!sub) return std::nullopt;
  place.sub = static_cast<std::uint8_t>(*sub);
  return place;
}

class Modules {
 public:
  Modules(DataSheet& sheet, Findings& findings) : sheet_(sheet), findings_(findings) {
    for (const auto& [index, object] : sheet.objects) {
      described_.insert(index);
      for (const auto& [sub, entry] : object.subs) {
        if (const auto name = name_without(sub, entry.name)) made_.emplace(index, *name);
      }
    }
  }

  void add() {
    const IniSection* connected = sheet_.section("ConnectedModules");
    if (connected == nullptr) return report_offered();
    for (const IniSection& section : sheet_.sections) {
      if (const auto part = module_part(section.name)) parts_[part->module].push_back(&section);
    }
    unsigned count = 0;
    for (const IniLine& line : connected->lines) {
      if (is_comment(line) || line.key.empty() || same_letters(line.key, "NrOfEntries")) continue;
      const auto number = sheet_number(line.value);
      if (!number || number->number < 1 || number->number > 0xFFFF || number->plus_node_id) {
        complain(line.number, connected->name, fmt::format("{} is '{}'", line.key, line.value),
                 "the number of a module of SupportedModules");
        continue;
      }
      if (++count > modules_max) {
        return complain(line.number, connected->name, "there are more modules than can be plugged",
                        fmt::format("{} at most", modules_max));
      }
      plug(static_cast<unsigned>(number->number), line);
    }
    update_counts();
  }

 private:
  void complain(std::size_t line, const std::string& section, std::string text,
                std::string expected, Finding::Weight weight = Finding::Weight::error) {
    if (told_++ >= findings_max) return;
    findings_.push_back({line, section, std::move(text), std::move(expected), weight});
  }

  /// The modules of a device are unknown.
  void report_offered() {
    const IniSection* offered = sheet_.section("SupportedModules");
    if (offered == nullptr) return;
    complain(offered->number, offered->name, "no module is plugged in: their objects are not there",
             "[ConnectedModules] with NrOfEntries=1 and 1=1 for module 1 (DCF)",
             Finding::Weight::warning);
  }

  void plug(unsigned module, const IniLine& line) {
    const auto parts = parts_.find(module);
    if (parts == parts_.end()) {
      return complain(line.number, "ConnectedModules",
                      fmt::format("module {} is not described", module),
                      fmt::format("[M{}ModuleInfo] and what it adds", module));
    }
    for (const IniSection* section : parts->second) {
      const std::string_view name = module_part(section->name)->name;
      if (const auto fixed = place_behind(name, "Fixed")) add_fixed(*section, *fixed);
      const auto extended = place_behind(name, "SubExt");
      if (extended && !extended->sub) extend(*section, extended->index);
    }
  }

  /// `Input 4` of sub-index 04h is `Input`; nothing if the number is not there.
  static std::optional<std::string> name_without(unsigned sub, std::string_view name) {
    const std::string number = std::to_string(sub);
    if (sub == 0 || !name.ends_with(number)) return std::nullopt;
    name.remove_suffix(number.size());
    if (name.empty()) return std::string();
    if (!name.ends_with(' ')) return std::nullopt;
    name.remove_suffix(1);
    return std::string(name);
  }
  static std::string name_with(unsigned sub, const std::string& name) {
    return name.empty() ? std::to_string(sub) : fmt::format("{} {}", name, sub);
  }

  static SheetEntry entry_of(const IniSection& section) {
    SheetEntry entry;
    entry.line = section.number;
    const auto text = [&section](std::string_view key) {
      return std::string(section.value(key).value_or(""));
    };
    const auto number = [&section](std::string_view key, unsigned otherwise) {
      const auto read = sheet_number(section.value(key).value_or(""));
      return read && read->number >= 0 && read->number <= 0xFFFF
                 ? static_cast<unsigned>(read->number)
                 : otherwise;
    };
    entry.name = text("ParameterName");
    entry.object_type = number("ObjectType", 7);
    entry.data_type = number("DataType", 0);
    entry.access = text("AccessType");
    entry.default_value = text("DefaultValue");
    entry.low_limit = text("LowLimit");
    entry.high_limit = text("HighLimit");
    entry.obj_flags = text("ObjFlags");
    entry.pdo_mapping = number("PDOMapping", 0) != 0;
    return entry;
  }

  void add_fixed(const IniSection& section, const Place& place) {
    if (described_.contains(place.index)) return;
    SheetObject& object = object_at(place.index);
    if (place.sub) {
      object.subs.insert_or_assign(*place.sub, entry_of(section));
    } else {
      object.own = entry_of(section);
    }
  }

  SheetObject& object_at(std::uint16_t index) {
    const auto [found, is_new] = sheet_.objects.try_emplace(index);
    if (is_new) found->second.group = group_of(index);
    return found->second;
  }

  /// Adds `Count` entries after the existing ones.
  void extend(const IniSection& section, std::uint16_t index) {
    const std::string_view text = section.value("Count").value_or("1");
    const auto count = sheet_number(text);
    if (!count || count->number < 1 || count->number > std::int64_t{module_sub_last}) {
      return complain(section.number, section.name, fmt::format("Count is '{}'", text),
                      "a number of entries, 1 to 254: others are not made");
    }
    const SheetEntry added = entry_of(section);
    // A DCF that was written with its modules has them already.
    if (made_.contains({index, added.name})) return;
    SheetObject& object = object_at(index);
    if (object.own.name.empty()) {
      object.own = {.name = added.name, .object_type = static_cast<unsigned>(ObjectCode::array)};
      object.own.line = section.number;
    }
    if (!object.subs.contains(0)) {
      SheetEntry first = {.name = "Highest sub-index supported", .data_type = 5, .access = "ro"};
      first.line = section.number;
      object.subs.emplace(std::uint8_t{0}, std::move(first));
    }
    bytes_ += static_cast<std::size_t>(count->number) *
              (sizeof added + added.name.size() + added.default_value.size() +
               added.low_limit.size() + added.high_limit.size() + added.obj_flags.size());
    if (bytes_ > compact_bytes_max) {
      return complain(section.number, section.name, "modules make too many entries",
                      fmt::format("{} MiB of them in all", compact_bytes_max >> 20));
    }
    unsigned last = object.subs.rbegin()->first;
    for (std::int64_t made = 0; made < count->number; ++made) {
      if (++last > module_sub_last) {
        return complain(section.number, section.name,
                        fmt::format("{:04X}h has no room for more entries", index), "254 at most");
      }
      SheetEntry entry = added;
      entry.object_type = 7;
      entry.name = name_with(last, added.name);
      object.subs.emplace(static_cast<std::uint8_t>(last), std::move(entry));
    }
    extended_.insert(index);
  }

  void update_counts() {
    for (const std::uint16_t index : extended_) {
      auto& subs = sheet_.objects[index].subs;
      subs[0].default_value = fmt::format("{}", subs.rbegin()->first);
    }
  }

  DataSheet& sheet_;
  Findings& findings_;
  std::map<unsigned, std::vector<const IniSection*>> parts_;  ///< of each module
  std::size_t told_ = 0;
  std::size_t bytes_ = 0;  ///< size of the entries of modules
  std::set<std::uint16_t> extended_;
  std::set<std::uint16_t> described_;                     ///< in the file
  std::set<std::pair<std::uint16_t, std::string>> made_;  ///< entries of the file, without numbers
};

}  // namespace

void add_modules(DataSheet& sheet, Findings& findings) {
  Modules(sheet, findings).add();
}

}  // namespace canvoy::formats
