#include "canvoy/formats/eds/eds_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canvoy::formats {

namespace {

constexpr auto domain = static_cast<unsigned>(ObjectCode::domain);

void add_text(IniSection& section, const char* key, const std::string& text) {
  if (!text.empty()) section.add(key, text);
}

/// All texts of an entry except the kind of its object.
void add_entry(IniSection& section, const SheetEntry& entry, bool configured) {
  if (entry.data_type != 0) section.add("DataType", fmt::format("0x{:04X}", entry.data_type));
  add_text(section, "AccessType", entry.access);
  add_text(section, "DefaultValue", entry.default_value);
  add_text(section, "LowLimit", entry.low_limit);
  add_text(section, "HighLimit", entry.high_limit);
  // node-canopen refuses a domain with this key, with any value.
  if (entry.data_type != 0 && entry.object_type != domain) {
    section.add("PDOMapping", entry.pdo_mapping ? "1" : "0");
  }
  add_text(section, "ObjFlags", entry.obj_flags);
  if (configured) add_text(section, "ParameterValue", entry.value);
  add_text(section, "Denotation", entry.denotation);
  for (const KeyValue& other : entry.others) section.add(other.key, other.value);
}

IniSection entry_section(std::string name, const SheetEntry& entry) {
  IniSection section = {std::move(name), 0, {}};
  section.add("ParameterName", entry.name);
  section.add("ObjectType", fmt::format("0x{:X}", entry.object_type));
  return section;
}

void add_object(Ini& file, std::uint16_t index, const SheetObject& object, bool configured) {
  IniSection section = entry_section(fmt::format("{:04X}", index), object.own);
  if (!object.is_variable()) section.add("SubNumber", fmt::format("{}", object.subs.size()));
  add_entry(section, object.own, configured);
  file.sections.push_back(std::move(section));
  for (const auto& [sub, entry] : object.subs) {
    IniSection part = entry_section(fmt::format("{:04X}sub{:X}", index, sub), entry);
    add_entry(part, entry, configured);
    file.sections.push_back(std::move(part));
  }
}

void add_group(Ini& file, const DataSheet& sheet, const char* name, SheetObject::Group group) {
  IniSection list = {name, 0, {}};
  list.add("SupportedObjects", "0");
  for (const auto& [index, object] : sheet.objects) {
    if (object.group == group) {
      list.add(fmt::format("{}", list.lines.size()), fmt::format("0x{:04X}", index));
    }
  }
  list.lines.front().value = fmt::format("{}", list.lines.size() - 1);
  file.sections.push_back(std::move(list));
  for (const auto& [index, object] : sheet.objects) {
    if (object.group == group) add_object(file, index, object, sheet.configured);
  }
}

/// Sections that precede the objects in files of other tools.
bool stands_first(const IniSection& section) {
  return same_letters(section.name, "FileInfo") || same_letters(section.name, "DeviceInfo") ||
         section.name.empty();
}

}  // namespace

std::string write_eds(const DataSheet& sheet) {
  Ini file;
  std::ranges::copy_if(sheet.sections, std::back_inserter(file.sections), stands_first);
  if (!sheet.dummies.empty()) {
    IniSection dummies = {"DummyUsage", 0, {}};
    for (const auto& [index, used] : sheet.dummies) {
      dummies.add(fmt::format("Dummy{:04X}", index), used ? "1" : "0");
    }
    file.sections.push_back(std::move(dummies));
  }
  if (!sheet.comments.empty()) {
    IniSection comments = {"Comments", 0, {}};
    comments.add("Lines", fmt::format("{}", sheet.comments.size()));
    for (const std::string& comment : sheet.comments) {
      comments.add(fmt::format("Line{}", comments.lines.size()), comment);
    }
    file.sections.push_back(std::move(comments));
  }
  using enum SheetObject::Group;
  add_group(file, sheet, "MandatoryObjects", mandatory);
  add_group(file, sheet, "OptionalObjects", optional);
  add_group(file, sheet, "ManufacturerObjects", manufacturer);
  for (const auto& [index, object] : sheet.objects) {
    if (object.group == not_listed) add_object(file, index, object, sheet.configured);
  }
  std::ranges::copy_if(sheet.sections, std::back_inserter(file.sections),
                       [](const IniSection& section) { return !stands_first(section); });
  return write_ini(file);
}

}  // namespace canvoy::formats
