#include "canvoy/tools/sheet/profile_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/sheet/provisions_text.hpp"

namespace canvoy::tools {

namespace {

using formats::access_name;
using formats::category_name;
using formats::condition_text;
using formats::data_type_name;
using formats::entry_name;
using formats::field_name;
using formats::mapping_name;
using formats::object_code_name;
using formats::object_name;

/// Collects lines.
class Lines {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    std::string line = fmt::format(format, std::forward<Values>(values)...);
    line.erase(line.find_last_not_of(' ') + 1);
    text_ += line + '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// `6100h to 611Fh`
std::string index_text(const ObjectInfo& object) {
  if (object.count == 1) return fmt::format("{:04X}h", object.index);
  return fmt::format("{:04X}h to {:04X}h", object.index, object.index + object.count - 1);
}

/// The most common description of the entries of an object.
const EntryInfo& typical_entry(const ObjectInfo& object) {
  return object.entries().back();
}

std::string type_text(const ObjectInfo& object) {
  const std::string_view type = data_type_name(typical_entry(object).type);
  if (object.subs.empty()) return std::string(type);
  return fmt::format("{} {}", object_code_name(object.code), type);
}

std::string access_text(const EntryInfo& entry) {
  if (entry.consumer_access == Access::none) return std::string(access_name(entry));
  return fmt::format("{}, consumer {}", access_name(entry), access_name(entry.consumer_access));
}

std::string pattern_text(std::int64_t number, const BitRange& bits) {
  return formats::pattern_text(number, bits.bits) + 'h';
}

std::string default_text(const Default& initial, const EntryInfo& entry) {
  switch (initial.kind) {
    case Default::Kind::none:
      return "";
    case Default::Kind::text:
      return fmt::format("\"{}\"", initial.text);
    case Default::Kind::plus_node_id:
      return fmt::format("{:X}h + node-ID", initial.number);
    case Default::Kind::highest_sub:
      return initial.number == 0 ? "" : fmt::format("{}", initial.number);
    case Default::Kind::number:
      break;
  }
  if (is_real(entry.type)) {
    return fmt::format("{:.10g}", formats::real_value(initial.number, entry.type));
  }
  const BitRange bits = bits_of(entry);
  const ValueInfo& value = entry.value;
  const bool is_plain = value.notation == Notation::number && value.names.empty() &&
                        entry.fields.empty() && entry.type != DataType::boolean;
  if (!is_plain) return pattern_text(initial.number, bits);
  const auto pattern = static_cast<std::uint64_t>(initial.number);
  return fmt::format("{}", number_of(pattern, bits.bits, bits.is_signed));
}

std::string defaults_text(const EntryInfo& entry) {
  const std::string own = default_text(entry.initial, entry);
  const std::string consumer = default_text(entry.consumer_initial, entry);
  std::string text = own.empty() ? "" : ", default " + own;
  if (!consumer.empty()) text += ", default of a consumer " + consumer;
  return text;
}

/// `raw x 0.125 - 40 °C`
std::string scale_text(const Scale& scale, Unit unit) {
  const auto denominator = static_cast<double>(scale.denominator);
  const double factor = static_cast<double>(scale.numerator) / denominator;
  const double offset = static_cast<double>(scale.offset) / denominator;
  std::string text = factor == 1 ? "raw" : fmt::format("raw x {:.10g}", factor);
  if (offset != 0) text += fmt::format(" {} {:.10g}", offset < 0 ? '-' : '+', std::abs(offset));
  return unit == Unit::none ? text : fmt::format("{} {}", text, symbol(unit));
}

/// `raw 0 to 3599, that is 0 to 359.9 °`; if both are equal, `raw 0 to 253 px`.
std::string limits_text(const ValueInfo& value, const BitRange& bits) {
  const bool is_minimum = value.limits.kind == Limits::Kind::minimum;
  std::string text = fmt::format("raw {}", value.limits.low);
  if (value.limits.low != value.limits.high) text += fmt::format(" to {}", value.limits.high);
  const std::string_view unit = symbol(value.unit);
  const bool is_scaled = value.scale != Scale{} || !value.pieces.empty();
  if (is_minimum) text += " at least";
  if (!is_scaled) return unit.empty() ? text : fmt::format("{} {}", text, unit);
  double low = to_physical(static_cast<double>(value.limits.low), value.scale);
  double high = to_physical(static_cast<double>(value.limits.high), value.scale);
  if (!value.pieces.empty()) std::tie(low, high) = NumberRules(value, bits).physical_range();
  return fmt::format("{}, that is {:.12g} to {:.12g} {}", text, low, high, unit);
}

/// `in the unit that 6480h:02h says, kg by default`
std::string unit_entry_text(const ValueInfo& value) {
  const UnitEntry& place = value.unit_entry;
  std::string text =
      place.sub == 0
          ? fmt::format("in the unit that the same sub-index of {:04X}h says", place.index)
          : fmt::format("in the unit that {} says", text::object_text(place.index, place.sub));
  if (value.unit == Unit::none) return text;
  return fmt::format("{}, {} by default", text, symbol(value.unit));
}

void add_scale(Lines& lines, const std::string& margin, const ValueInfo& value,
               const BitRange& bits) {
  for (const Piece& piece : value.pieces) {
    lines.add("{}{} to {}: {} {}", margin, piece.first, piece.last,
              scale_text(piece.scale, value.unit), piece.name);
  }
  const bool has_limits = value.limits.kind != Limits::Kind::none;
  if (value.pieces.empty() && value.scale != Scale{}) {
    lines.add("{}{}", margin, scale_text(value.scale, value.unit));
  } else if (value.unit_entry.index != 0) {
    lines.add("{}{}", margin, unit_entry_text(value));
  } else if (value.pieces.empty() && value.unit != Unit::none && !has_limits) {
    lines.add("{}in {}", margin, symbol(value.unit));
  }
  if (has_limits) lines.add("{}{}", margin, limits_text(value, bits));
}

/// In order of code, whatever the order of the descriptions.
std::vector<NamedValue> in_order(const Items<NamedValue>& names) {
  std::vector<NamedValue> sorted(names.begin(), names.end());
  std::ranges::sort(sorted, {}, &NamedValue::first);
  return sorted;
}

void add_value(Lines& lines, const std::string& margin, const ValueInfo& value,
               const BitRange& bits) {
  add_scale(lines, margin, value, bits);
  if (value.step.index != 0) {
    lines.add("{}a count is as many steps as {:04X}h:{:02X}h says", margin, value.step.index,
              value.step.sub);
  }
  for (const NamedValue& named : in_order(value.names)) {
    const std::string first = pattern_text(named.first, bits);
    const std::string range = named.first == named.last
                                  ? first
                                  : fmt::format("{} to {}", first, pattern_text(named.last, bits));
    const bool is_plain = named.meaning == Meaning::state || named.meaning >= Meaning::reserved;
    const std::string_view meaning = is_plain ? "" : formats::meaning_name(named.meaning);
    const bool is_said = named.name.find(meaning) != std::string_view::npos;
    lines.add("{}{:<12} {}{}", margin, range, named.name,
              is_said ? "" : fmt::format(" ({})", meaning));
  }
}

std::string sub_text(const EntryInfo& entry) {
  if (entry.sub_first == entry.last_sub()) return fmt::format("{:02X}h", entry.sub_first);
  return fmt::format("{:02X}h to {:02X}h", entry.sub_first, entry.last_sub());
}

std::string bits_text(const FieldInfo& field) {
  if (field.bits == 1) return fmt::format("bit {}", field.first_bit);
  return fmt::format("bits {} to {}", field.first_bit, field.first_bit + field.bits - 1);
}

/// An earlier entry of the object with the same fields, or null.
const EntryInfo* like(const ObjectInfo& object, const EntryInfo& entry) {
  for (const EntryInfo& earlier : object.entries()) {
    if (&earlier == &entry || entry.fields.empty()) return nullptr;
    if (earlier.fields.begin() == entry.fields.begin()) return &earlier;
  }
  return nullptr;
}

void add_fields(Lines& lines, const EntryInfo& entry) {
  for (const FieldInfo& field : entry.fields) {
    const std::string condition = condition_text(field);
    lines.add("      {:<14} {}{}", bits_text(field), field_name(field),
              condition.empty() ? "" : fmt::format(", if {}", condition));
    if (!field.description.empty()) lines.add("          {}", field.description);
    add_value(lines, "          ", field.value, bits_of(field));
  }
}

std::string category_text(Category category, std::string_view condition) {
  if (condition.empty()) return std::string(category_name(category));
  return fmt::format("{} ({})", category_name(category), condition);
}

void add_entry(Lines& lines, const ObjectInfo& object, const EntryInfo& entry) {
  const std::string attributes =
      fmt::format("{}, {}, PDO mapping {}{}", data_type_name(entry.type), access_text(entry),
                  mapping_name(entry.mapping), defaults_text(entry));
  if (object.subs.empty()) {
    lines.add("  {} {}", object_code_name(object.code), attributes);
  } else {
    lines.add("  {:<10} {}", sub_text(entry), entry_name(object, entry));
    lines.add("      {}, {}", attributes, category_text(entry.category, entry.condition));
  }
  if (entry.capacity != 0) lines.add("      at most {} bytes", entry.capacity);
  if (!entry.description.empty()) lines.add("      {}", entry.description);
  if (bit_length(entry.type) != 0) add_value(lines, "      ", entry.value, bits_of(entry));
}

void add_devices(Lines& lines, const Profile& profile, const ObjectInfo& object) {
  for (const VirtualDeviceInfo& device : profile.virtual_devices) {
    for (const DeviceObject& has : device.objects) {
      const unsigned last = has.last == 0 ? has.index : has.last;
      if (last < object.index || has.index > object.index + object.count - 1) continue;
      lines.add("  in {}: {}{}{}", device_text(device), category_text(has.category, has.condition),
                has.access == Access::none ? "" : fmt::format(", {}", access_name(has.access)),
                has.consumed ? ", consumed" : "");
    }
  }
}

/// The entry in a mapping: `battery_status`, or `6001h:02h` without a name. `before`: the object
/// named before it, which is not repeated; set to this one.
std::string mapped_text(const Profile& profile, std::uint32_t mapped, const ObjectInfo*& before) {
  const MappingValue value(mapped);
  const ObjectInfo* object = find_description(profile, value.index);
  const EntryInfo* entry = object == nullptr ? nullptr : find_entry(*object, value.sub);
  const bool is_named = std::exchange(before, object) == object;
  if (entry == nullptr) return fmt::format("{:04X}h:{:02X}h", value.index, value.sub);
  if (object->subs.empty()) return object_name(profile, *object, value.index);
  std::string name = entry_name(*object, *entry, value.sub);
  if (is_named) return name;
  return fmt::format("{}: {}", object_name(profile, *object, value.index), name);
}

std::string cob_id_text(const PdoInfo& pdo) {
  constexpr std::uint32_t invalid = 0x8000'0000;
  constexpr std::uint32_t can_id = 0x1FFF'FFFF;
  std::string text = fmt::format("{:03X}h{}", pdo.cob_id & can_id, pdo.plus_node_id ? "+ID" : "");
  if ((pdo.cob_id & invalid) != 0) text += ", invalid";
  return text;
}

void add_pdos(Lines& lines, const Profile& profile) {
  bool first = true;
  for_each_pdo(profile, [&](const PdoInfo& pdo) {
    if (std::exchange(first, false)) lines.add("\nPDOs");
    std::vector<std::string> mapped;
    const ObjectInfo* before = nullptr;
    for (const std::uint32_t entry : pdo.mapping) {
      mapped.push_back(mapped_text(profile, entry, before));
    }
    const unsigned last = pdo.last_number == 0 ? pdo.number : pdo.last_number;
    lines.add(
        "  {} {:<9} {:<14} {}", pdo.direction == PdoInfo::Direction::transmit ? "TPDO" : "RPDO",
        last == pdo.number ? fmt::format("{}", last) : fmt::format("{} to {}", pdo.number, last),
        cob_id_text(pdo),
        pdo.multiplexed != MpdoKind::no ? "multiplexed"
                                        : fmt::format("{}", fmt::join(mapped, ", ")));
  });
}

std::string folded(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c != ' ' && c != '_' && c != '-') {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

bool is_in(const std::string& word, std::string_view name) {
  return folded(name).find(word) != std::string::npos;
}

bool names_word(const ValueInfo& value, const std::string& word) {
  return std::ranges::any_of(value.names,
                             [&](const NamedValue& named) { return is_in(word, named.name); });
}

/// True if an entry, a field or a value in it has such a name.
bool names_word(const EntryInfo& entry, const std::string& word) {
  if (is_in(word, entry.name) || names_word(entry.value, word)) return true;
  return std::ranges::any_of(entry.fields, [&](const FieldInfo& field) {
    return is_in(word, field.name) || names_word(field.value, word);
  });
}

}  // namespace

std::string profile_list_text() {
  Lines lines;
  lines.add("{:<8} {:>7} {:>7}  {}", "profile", "objects", "devices", "title");
  for (const Profile* profile : all_profiles()) {
    const std::size_t devices = profile->virtual_devices.size();
    lines.add("{:<8} {:>7} {:>7}  {}", short_name(*profile), profile->objects.size(),
              devices == 0 ? "" : std::to_string(devices), profile->title);
  }
  return lines.take();
}

std::string object_line(const ObjectInfo& object) {
  const EntryInfo& entry = typical_entry(object);
  return fmt::format("{:<14} {:<44} {:<22} {:<6} {:<9} {:<12} {}", index_text(object),
                     object_name(object), type_text(object), access_name(entry),
                     mapping_name(entry.mapping), category_name(object.category), object.clause);
}

std::string profile_text(const Profile& profile) {
  Lines lines;
  lines.add("{}: {}", profile.name, profile.title);
  if (profile.base != nullptr) lines.add("built on {}", profile.base->name);
  if (profile.block_count > 1) {
    lines.add("up to {} times in one node, {:X}h apart from 6000h on", profile.block_count,
              profile.block_pitch);
  }
  lines.add("\n{:<14} {:<44} {:<22} {:<6} {:<9} {:<12} {}", "index", "object", "type", "access",
            "PDO", "category", "clause");
  for (const ObjectInfo* object : profile.objects) lines.add("{}", object_line(*object));
  if (!profile.virtual_devices.empty()) lines.add("\nvirtual devices");
  for (const VirtualDeviceInfo& device : profile.virtual_devices) {
    const auto mandatory =
        std::ranges::count(device.objects, Category::mandatory, &DeviceObject::category);
    lines.add("  {}: {} objects, {} of them mandatory", device_text(device), device.objects.size(),
              mandatory);
  }
  add_pdos(lines, profile);
  if (!profile.error_codes.empty()) lines.add("\nemergency error codes");
  for (const ErrorCodeInfo& error : profile.error_codes) {
    lines.add("  {:04X}h {}", error.code, error.text);
  }
  for (const ReadingInfo& reading : profile.readings) {
    lines.add("\nreading {}: {} (errata {})", reading.name, reading.description, reading.errata);
  }
  return lines.take() + provisions_text(profile);
}

namespace {

/// The profile that describes an object: the profile itself, its base, CiA 301 or 302.
const Profile& describer_of(const Profile& profile, const ObjectInfo& object) {
  for (const Profile* candidate : {&profile, profile.base, &base_profile(), &cia302::profile}) {
    if (candidate != nullptr && find_object(*candidate, object.index) == &object) return *candidate;
  }
  return profile;
}

}  // namespace

std::string object_details_text(const Profile& profile, const ObjectInfo& object,
                                const EntryInfo* only) {
  Lines lines;
  lines.add("{} {}", index_text(object), object_name(object));
  const std::string clause = object.clause.empty() ? "" : fmt::format(", {}", object.clause);
  lines.add("  {}{}{}, {}", describer_of(profile, object).name, clause,
            object.errata.empty() ? "" : fmt::format(" (errata {})", object.errata),
            category_text(object.category, object.condition));
  if (!object.description.empty()) lines.add("  {}", object.description);
  if (!object.subs.empty()) lines.add("  {}", object_code_name(object.code));
  for (const EntryInfo& entry : object.entries()) {
    if (only != nullptr && only != &entry) continue;
    add_entry(lines, object, entry);
    const EntryInfo* earlier = only == nullptr ? like(object, entry) : nullptr;
    if (earlier == nullptr) {
      add_fields(lines, entry);
    } else {
      lines.add("      fields as in {}", sub_text(*earlier));
    }
  }
  add_devices(lines, profile, object);
  return lines.take() + provisions_text(profile, object);
}

std::vector<const ObjectInfo*> find_objects(const Profile& profile, std::string_view word) {
  const std::string letters = folded(word);
  std::vector<const ObjectInfo*> found;
  if (letters.empty()) return found;
  for (const ObjectInfo* object : profile.objects) {
    if (is_in(letters, object->name)) found.push_back(object);
  }
  if (!found.empty()) return found;
  for (const ObjectInfo* object : profile.objects) {
    const bool inside = std::ranges::any_of(
        object->entries(), [&](const EntryInfo& entry) { return names_word(entry, letters); });
    if (inside) found.push_back(object);
  }
  return found;
}

}  // namespace canvoy::tools
