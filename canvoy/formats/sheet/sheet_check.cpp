#include "canvoy/formats/sheet/sheet_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/sheet/sheet_agreement.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats {

namespace {

constexpr auto domain_code = static_cast<unsigned>(ObjectCode::domain);
constexpr std::string_view accesses[] = {"ro", "wo", "rw", "rwr", "rww", "const"};

/// Keys of a section (CiA 306, 4.4 and 4.5).
struct Keys {
  std::string_view section;
  std::span<const std::string_view> keys;
};
constexpr std::string_view file_keys[] = {"FileName",     "FileVersion", "FileRevision",
                                          "EDSVersion",   "Description", "CreationTime",
                                          "CreationDate", "CreatedBy"};
constexpr std::string_view device_keys[] = {
    "VendorName",     "VendorNumber",       "ProductName",       "ProductNumber",
    "RevisionNumber", "SimpleBootUpMaster", "SimpleBootUpSlave", "Granularity",
    "NrOfRXPDO",      "NrOfTXPDO",          "LSS_Supported"};
constexpr Keys required_keys[] = {{"FileInfo", file_keys}, {"DeviceInfo", device_keys}};

/// Keys without a counterpart in XDD and XDC (CiA 311).
constexpr std::string_view keys_of_eds_alone[] = {"FileRevision", "EDSVersion",   "Description",
                                                  "CreationTime", "CreationDate", "RevisionNumber"};

/// Keys with a number as value.
constexpr std::string_view file_numbers[] = {"FileVersion", "FileRevision"};
constexpr std::string_view device_numbers[] = {"VendorNumber", "ProductNumber", "RevisionNumber",
                                               "Granularity",  "NrOfRXPDO",     "NrOfTXPDO"};
constexpr Keys number_keys[] = {{"FileInfo", file_numbers}, {"DeviceInfo", device_numbers}};

/// True for `1600sub0` and similar entries.
bool is_number_of_mapped(std::string_view place) {
  const auto index = parse_hex(place.substr(0, 4), 4);
  return index && place.substr(4) == "sub0" && is_pdo_mapping(*index);
}

class Checker {
 public:
  Checker(const DataSheet& sheet, const Profile* profile, Findings& findings)
      : sheet_(sheet), profile_(profile), findings_(findings) {}

  void check() {
    check_sections();
    check_groups();
    for (const auto& [index, object] : sheet_.objects) check_object(index, object);
    for (const auto& [index, object] : sheet_.objects) check_mapping(index, object);
    if (profile_ != nullptr) check_mandatory();
  }

 private:
  void complain(std::size_t line, std::string section, std::string text, std::string expected = "",
                Finding::Weight weight = Finding::Weight::error) {
    findings_.push_back({line, std::move(section), std::move(text), std::move(expected), weight});
  }
  void warn(std::size_t line, std::string section, std::string text, std::string expected = "") {
    complain(line, std::move(section), std::move(text), std::move(expected),
             Finding::Weight::warning);
  }

  void check_sections() {
    for (const Keys& required : required_keys) {
      const IniSection* found = sheet_.section(required.section);
      if (found == nullptr) {
        complain(0, std::string(required.section), "the section is missing");
        continue;
      }
      for (const std::string_view key : required.keys) {
        if (found->find(key) == nullptr && has_place_for(key)) {
          warn(found->number, found->name, fmt::format("{} is missing", key));
        }
      }
    }
    for (const Keys& numbers : number_keys) check_numbers(numbers);
    check_pdo_counts();
    check_pdo_pairs();
  }

  bool has_place_for(std::string_view key) const {
    return sheet_.xml.empty() ||
           std::ranges::find(keys_of_eds_alone, key) == std::end(keys_of_eds_alone);
  }

  void check_numbers(const Keys& numbers) {
    const IniSection* found = sheet_.section(numbers.section);
    if (found == nullptr) return;
    for (const std::string_view key : numbers.keys) {
      const IniLine* line = found->find(key);
      if (line != nullptr && !sheet_number(line->value)) {
        warn(line->number, found->name, fmt::format("{} is '{}'", key, line->value), "a number");
      }
    }
  }

  void check_pdo_counts() {
    const IniSection* device = sheet_.section("DeviceInfo");
    if (device == nullptr) return;
    const auto check = [&](std::string_view key, unsigned first, unsigned last) {
      const std::size_t count = sheet_.count_objects(first, last);
      const IniLine* line = device->find(key);
      const auto number = line == nullptr ? std::nullopt : sheet_number(line->value);
      if (number && number->number != static_cast<std::int64_t>(count)) {
        warn(line->number, device->name, fmt::format("{} is {}", key, line->value),
             fmt::format("{}, as there are parameters", count));
      }
    };
    check("NrOfRXPDO", object_index::rpdo_parameter, object_index::rpdo_parameter_last);
    check("NrOfTXPDO", object_index::tpdo_parameter, object_index::tpdo_parameter_last);
  }

  /// Each PDO needs both of its parameters (CiA 301, 7.5.2.35 to 7.5.2.38).
  void check_pdo_pairs() {
    const auto check = [&](unsigned first, unsigned last, unsigned other, const char* what) {
      for (unsigned index = first; index <= last; ++index) {
        const auto found = sheet_.objects.find(static_cast<std::uint16_t>(index));
        const unsigned partner = index - first + other;
        if (found == sheet_.objects.end() ||
            sheet_.objects.contains(static_cast<std::uint16_t>(partner))) {
          continue;
        }
        warn(found->second.own.line, place_text(index),
             fmt::format("{}h is missing", place_text(partner)),
             fmt::format("[{}], its {} parameter; or CompactPDO in DeviceInfo", place_text(partner),
                         what));
      }
    };
    using namespace object_index;
    check(rpdo_parameter, rpdo_parameter_last, rpdo_mapping, "mapping");
    check(rpdo_mapping, rpdo_mapping_last, rpdo_parameter, "communication");
    check(tpdo_parameter, tpdo_parameter_last, tpdo_mapping, "mapping");
    check(tpdo_mapping, tpdo_mapping_last, tpdo_parameter, "communication");
  }

  /// Step of the size of mapped entries, in bits: `Granularity` (CiA 306).
  unsigned granularity() const {
    const auto number = sheet_number(sheet_.text("DeviceInfo", "Granularity"));
    constexpr std::int64_t bits_max = 64;
    return number && number->number > 0 && number->number <= bits_max
               ? static_cast<unsigned>(number->number)
               : 0;
  }

  void check_groups() {
    for (const unsigned index : {0x1000U, 0x1001U, 0x1018U}) {
      const auto found = sheet_.objects.find(static_cast<std::uint16_t>(index));
      if (found == sheet_.objects.end()) {
        complain(0, place_text(index), "the object is missing", "all devices have it (CiA 301)");
      } else if (found->second.group != SheetObject::Group::mandatory) {
        warn(found->second.own.line, place_text(index), "MandatoryObjects does not name it");
      }
    }
    for (const auto& [index, object] : sheet_.objects) {
      using enum SheetObject::Group;
      if (object.group == not_listed) continue;
      const bool own = group_of(index) == manufacturer;
      if (own != (object.group == manufacturer)) {
        warn(object.own.line, place_text(index), "it is in the wrong list of objects",
             own ? "ManufacturerObjects" : "MandatoryObjects or OptionalObjects");
      }
    }
  }

  void check_object(std::uint16_t index, const SheetObject& object) {
    constexpr unsigned known_types[] = {2, 5, 6, 7, 8, 9};
    if (std::ranges::find(known_types, object.own.object_type) == std::end(known_types)) {
      complain(object.own.line, place_text(index),
               fmt::format("ObjectType is 0x{:X}", object.own.object_type),
               "0x2, 0x5, 0x6, 0x7, 0x8 or 0x9");
    }
    if (object.is_variable()) {
      check_variable(index, object);
    } else {
      check_compound(index, object);
    }
    check_description(index, object);
  }

  void check_variable(std::uint16_t index, const SheetObject& object) {
    if (object.own.object_type == 8 || object.own.object_type == 9) {
      complain(object.own.line, place_text(index), "an array or record without entries",
               fmt::format("[{}]", place_text(index, 0)));
      return;
    }
    check_entry(place_text(index), object.own);
  }

  void check_compound(std::uint16_t index, const SheetObject& object) {
    const SheetEntry& own = object.own;
    if (own.object_type == 7 || own.object_type == 2) {
      complain(own.line, place_text(index), "a variable with entries", "ObjectType 0x8 or 0x9");
    }
    for (const auto& [sub, entry] : object.subs) check_entry(place_text(index, sub), entry);
    if (own.object_type == 8) check_array(index, object);
    const auto first = object.subs.find(0);
    if (first == object.subs.end()) {
      complain(own.line, place_text(index), "sub-index 00h is missing");
      return;
    }
    const auto count = sheet_number(first->second.default_value);
    const unsigned highest = object.subs.rbegin()->first;
    const bool varies =
        is_pdo_mapping(index) || index == object_index::error_history || is_writable(first->second);
    if (count && !varies && count->number != static_cast<std::int64_t>(highest)) {
      warn(first->second.line, place_text(index, 0),
           fmt::format("the highest sub-index is given as {}", count->number),
           fmt::format("{}", highest));
    }
  }

  void check_array(std::uint16_t index, const SheetObject& object) {
    unsigned type = 0;
    for (const auto& [sub, entry] : object.subs) {
      if (sub == 0) continue;
      if (type == 0) type = entry.data_type;
      if (entry.data_type == type) continue;
      warn(entry.line, place_text(index, sub), "an entry of an array has another type",
           "one type, or ObjectType 0x9");
      return;
    }
  }

  void check_entry(const std::string& place, const SheetEntry& entry) {
    if (entry.name.empty()) warn(entry.line, place, "ParameterName is empty");
    const auto type = sheet_type(entry.data_type);
    if (!type) {
      const bool own_type = entry.data_type >= 0x20 && entry.data_type <= 0x25F;
      if (!own_type) {
        complain(entry.line, place, fmt::format("DataType is 0x{:04X}", entry.data_type),
                 "the index of a data type");
      }
      return;
    }
    check_access(place, entry);
    check_values(place, entry, *type);
    if (entry.pdo_mapping && (bit_length(*type) == 0 || bit_length(*type) > 64)) {
      complain(entry.line, place, "PDOMapping is 1", "0: the value does not fit into a PDO");
    }
  }

  void check_access(const std::string& place, const SheetEntry& entry) {
    if (std::ranges::find(accesses, entry.access) != std::end(accesses)) return;
    const bool is_case = std::ranges::any_of(
        accesses, [&entry](std::string_view each) { return same_letters(each, entry.access); });
    complain(entry.line, place, fmt::format("AccessType is '{}'", entry.access),
             fmt::format("one of {}", fmt::join(accesses, ", ")),
             is_case ? Finding::Weight::warning : Finding::Weight::error);
  }

  void check_values(const std::string& place, const SheetEntry& entry, DataType type) {
    constexpr std::uint8_t any_node_id = 1;
    struct Value {
      const char* key;
      const std::string& text;
    };
    const Value values[] = {{"DefaultValue", entry.default_value},
                            {"LowLimit", entry.low_limit},
                            {"HighLimit", entry.high_limit},
                            {"ParameterValue", entry.value}};
    for (const Value& value : values) {
      if (value.text.empty() || sheet_bytes(type, value.text, any_node_id)) continue;
      complain(entry.line, place, fmt::format("{} is '{}'", value.key, value.text),
               type == DataType::domain
                   ? "no value: the content of a DOMAIN is in a file, UploadFile=NAME where it is "
                     "read, DownloadFile=NAME where it is written"
                   : fmt::format("a value of {}", data_type_name(type)));
    }
    if (is_integer(type)) check_limits(place, entry, type);
  }

  void check_limits(const std::string& place, const SheetEntry& entry, DataType type) {
    const auto number = [type](const std::string& text) -> std::optional<std::int64_t> {
      const auto parsed = sheet_number(text);
      if (text.empty() || !parsed) return std::nullopt;
      return number_of(static_cast<std::uint64_t>(parsed->at(1)), bit_length(type),
                       is_signed(type));
    };
    const auto low = number(entry.low_limit);
    const auto high = number(entry.high_limit);
    if (low && high && *low > *high) {
      complain(entry.line, place, "LowLimit is above HighLimit");
      return;
    }
    const auto check = [&](const char* key, const std::string& text) {
      const auto value = number(text);
      if (!value) return;
      if ((low && *value < *low) || (high && *value > *high)) {
        complain(entry.line, place, fmt::format("{} is {}", key, text),
                 fmt::format("{} to {}", entry.low_limit, entry.high_limit));
      }
    };
    check("DefaultValue", entry.default_value);
    check("ParameterValue", entry.value);
  }

  /// Entries that a PDO maps by default must exist.
  void check_mapping(std::uint16_t index, const SheetObject& object) {
    if (!is_pdo_mapping(index)) return;
    const SheetEntry* count = sheet_.find(index, 0);
    const auto number = count == nullptr ? std::nullopt : sheet_number(count->default_value);
    if (!number || number->number > pdo_bits_max) return;
    unsigned bits = 0;
    for (const auto& numbered : object.subs) {
      const unsigned sub = numbered.first;
      const SheetEntry& entry = numbered.second;
      const auto mapped = sheet_number(entry.default_value);
      if (sub == 0 || sub > number->number || !mapped || mapped->number == 0) continue;
      bits += check_mapped(place_text(index, sub), entry,
                           MappingValue(static_cast<std::uint32_t>(mapped->number)));
    }
    if (bits > pdo_bits_max) {
      complain(object.own.line, place_text(index), fmt::format("{} bits are mapped", bits),
               "64 at most");
    }
  }

  unsigned check_mapped(const std::string& place, const SheetEntry& entry,
                        const MappingValue& mapped) {
    if (mapped.is_dummy()) return mapped.bits;
    const SheetEntry* found = sheet_.find(mapped.index, mapped.sub);
    if (found == nullptr) {
      complain(entry.line, place,
               fmt::format("{:04X}h:{:02X}h is mapped and not there", mapped.index, mapped.sub));
      return mapped.bits;
    }
    if (!found->pdo_mapping) {
      complain(entry.line, place,
               fmt::format("{:04X}h:{:02X}h is mapped", mapped.index, mapped.sub),
               "PDOMapping=1 there");
    }
    const auto type = sheet_type(found->data_type);
    const unsigned step = granularity();
    if (step > 1 && mapped.bits % step != 0) {
      warn(entry.line, place, fmt::format("{} bits are mapped", mapped.bits),
           fmt::format("a multiple of {}, as Granularity says", step));
    }
    if (type && bit_length(*type) != mapped.bits) {
      complain(entry.line, place, fmt::format("{} bits are mapped", mapped.bits),
               fmt::format("{}", bit_length(*type)));
    }
    return mapped.bits;
  }

  /// Compares with the profile, or with CiA 301.
  void check_description(std::uint16_t index, const SheetObject& object) {
    const Profile& known = profile_ == nullptr ? base_profile() : *profile_;
    const ObjectInfo* described = find_description(known, index);
    if (described == nullptr) {
      constexpr unsigned profile_first = 0x6000;
      constexpr unsigned profile_last = 0x9FFF;
      if (profile_ != nullptr && index >= profile_first && index <= profile_last) {
        warn(object.own.line, place_text(index),
             fmt::format("{} has no such object", profile_->name));
      }
      return;
    }
    check_code(index, object, *described);
    if (object.is_variable()) {
      check_described(place_text(index), object.own, described->entry, *described);
      return;
    }
    for (const auto& [sub, entry] : object.subs) {
      const EntryInfo* info = find_entry(*described, sub);
      if (info != nullptr) {
        check_described(place_text(index, sub), entry, *info, *described);
      } else if (!is_pdo_mapping(index) && !is_of_old(index, sub)) {
        warn(entry.line, place_text(index, sub),
             fmt::format("{} has no such entry", described->name));
      }
    }
  }

  /// Before version 4.2, CiA 301 gave the parameters of all PDOs sub-indices up to 05h, some
  /// without meaning: 1800h:04h was a placeholder.
  static bool is_of_old(std::uint16_t index, unsigned sub) {
    const bool is_parameter =
        (index >= object_index::rpdo_parameter && index <= object_index::rpdo_parameter_last) ||
        (index >= object_index::tpdo_parameter && index <= object_index::tpdo_parameter_last);
    constexpr unsigned sub_max = 5;
    return is_parameter && sub <= sub_max;
  }

  void check_code(std::uint16_t index, const SheetObject& object, const ObjectInfo& described) {
    const auto code = static_cast<unsigned>(described.code);
    const bool compound = !described.subs.empty();
    // Some specifications call a domain by type a variable.
    const bool is_domain = !compound && described.entry.type == DataType::domain;
    if (object.own.object_type == code || (is_domain && object.own.object_type == domain_code))
      return;
    const std::string wrong = fmt::format("ObjectType is 0x{:X}", object.own.object_type);
    const std::string right =
        fmt::format("0x{:X}: {} is {}", code, described.name, object_code_name(described.code));
    const bool is_mild = compound && (object.own.object_type == 8 || object.own.object_type == 9);
    complain(object.own.line, place_text(index), wrong, right,
             is_mild ? Finding::Weight::warning : Finding::Weight::error);
  }

  void check_described(const std::string& place, const SheetEntry& entry, const EntryInfo& info,
                       const ObjectInfo& described) {
    if (described.subs.empty() != (place.find("sub") == std::string::npos)) return;
    if (entry.data_type != static_cast<unsigned>(info.type)) {
      complain(
          entry.line, place, fmt::format("DataType is 0x{:04X}", entry.data_type),
          fmt::format("0x{:04X} {}", static_cast<unsigned>(info.type), data_type_name(info.type)));
    }
    if (profile_ == nullptr) return;
    check_described_access(place, entry, info);
    check_described_value(place, "DefaultValue", entry.default_value, entry, info);
    check_described_value(place, "ParameterValue", entry.value, entry, info);
    if (info.mapping == Mapping::by_default && !entry.pdo_mapping) {
      warn(entry.line, place, "PDOMapping is 0", "1");
    } else if (info.mapping == Mapping::no && entry.pdo_mapping) {
      complain(entry.line, place, "PDOMapping is 1", "0");
    }
  }

  /// Reports reserved values, and values outside the range without a meaning of their own.
  void check_described_value(const std::string& place, const char* key, const std::string& text,
                             const SheetEntry& entry, const EntryInfo& info) {
    const auto parsed = sheet_number(text);
    if (text.empty() || !parsed || parsed->plus_node_id || !is_integer(info.type)) return;
    const unsigned bits = bit_length(info.type);
    const std::int64_t value =
        number_of(static_cast<std::uint64_t>(parsed->number), bits, is_signed(info.type));
    const NamedValue* named = find_name(info.value, value, bits, is_signed(info.type));
    const Limits& limits = info.value.limits;
    if (named != nullptr && named->meaning == Meaning::reserved) {
      warn(entry.line, place, fmt::format("{} is {}, which is reserved", key, text));
    } else if (named == nullptr && limits.kind == Limits::Kind::absolute &&
               (value < limits.low || value > limits.high)) {
      warn(entry.line, place, fmt::format("{} is {}", key, text),
           fmt::format("{} to {}", limits.low, limits.high));
    }
  }

  void check_described_access(const std::string& place, const SheetEntry& entry,
                              const EntryInfo& info) {
    if (info.access_by_device) return;
    const auto agrees = [&entry](Access access) {
      const std::string_view name = access_name(access);
      return same_letters(entry.access, name) ||
             (name == "rw" &&
              (same_letters(entry.access, "rwr") || same_letters(entry.access, "rww"))) ||
             (name == "ro" && same_letters(entry.access, "const"));
    };
    if (agrees(info.access) || agrees(info.consumer_access)) return;
    if (info.or_const && agrees(Access::const_)) return;
    // A device with a fixed mapping has a fixed number of entries (CiA 301, 7.5.2.36).
    if (is_number_of_mapped(place) && agrees(Access::ro)) return;
    const std::string_view consumer = access_name(info.consumer_access);
    warn(entry.line, place, fmt::format("AccessType is {}", entry.access),
         consumer.empty()
             ? std::string(access_name(info.access))
             : fmt::format("{}, or {} of a consumer", access_name(info.access), consumer));
  }

  void check_mandatory() {
    // If there are virtual devices, they determine the mandatory application objects.
    constexpr unsigned application_first = 0x6000;
    for (const ObjectInfo* object : profile_->objects) {
      if (!profile_->virtual_devices.empty() && object->index >= application_first) return;
      if (object->category == Category::mandatory && !sheet_.objects.contains(object->index)) {
        complain(0, place_text(object->index), fmt::format("{} is missing", object_name(*object)),
                 fmt::format("{} has it in all devices", profile_->name));
      }
    }
  }

  const DataSheet& sheet_;
  const Profile* profile_;
  Findings& findings_;
};

}  // namespace

void check_sheet(const DataSheet& sheet, const Profile* profile, Findings& findings) {
  Checker(sheet, profile, findings).check();
  check_agreement(sheet, findings);
  std::ranges::stable_sort(findings, {}, &Finding::line);
}

}  // namespace canvoy::formats
