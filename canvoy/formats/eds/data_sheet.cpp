#include "canvoy/formats/eds/data_sheet.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace canvoy::formats {

namespace {

constexpr std::string_view node_id_word = "$NODEID";

std::string without_blanks(std::string_view text) {
  std::string kept(text);
  std::erase_if(kept, [](char c) { return c == ' ' || c == '\t'; });
  return kept;
}

/// An unsigned number in the notation that its prefix names.
std::optional<std::uint64_t> parse_magnitude(std::string_view text) {
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    base = 16;
  } else if (text.size() > 1 && text.starts_with('0') &&
             text.find_first_not_of("01234567") == std::string_view::npos) {
    base = 8;
  }
  std::uint64_t number = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number, base);
  if (text.empty() || error != std::errc{} || end != last) return std::nullopt;
  return number;
}

std::optional<SheetNumber> parse_signed(std::string_view text) {
  constexpr std::uint64_t greatest = std::numeric_limits<std::int64_t>::max();
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const auto magnitude = parse_magnitude(text);
  if (!magnitude || (negative && *magnitude > greatest + 1)) return std::nullopt;
  const auto number = static_cast<std::int64_t>(negative ? 0 - *magnitude : *magnitude);
  return SheetNumber{.number = number, .is_pattern = !negative && *magnitude > greatest};
}

std::optional<SheetNumber> plus_node_id(const std::optional<SheetNumber>& number) {
  constexpr std::int64_t node_id_max = 127;
  constexpr std::int64_t number_max = std::numeric_limits<std::int64_t>::max() - node_id_max;
  if (!number || number->is_pattern || number->number > number_max) return std::nullopt;
  return SheetNumber{.number = number->number, .plus_node_id = true};
}

bool is_same_section(std::string_view one, std::string_view other) {
  return same_letters(one, other) || (is_commissioning(one) && is_commissioning(other));
}

}  // namespace

bool is_commissioning(std::string_view section_name) {
  return same_letters(section_name, "DeviceComissioning") ||
         same_letters(section_name, "DeviceCommissioning");
}

std::optional<SheetNumber> sheet_number(std::string_view text) {
  const std::string kept = without_blanks(text);
  std::string_view rest = kept;
  const auto is_word = [](std::string_view part) { return same_letters(part, node_id_word); };
  if (is_word(rest.substr(0, node_id_word.size()))) {
    rest.remove_prefix(node_id_word.size());
    if (rest.empty()) return SheetNumber{.plus_node_id = true};
    return rest.starts_with('+') ? plus_node_id(parse_signed(rest.substr(1))) : std::nullopt;
  }
  const std::size_t plus = rest.find('+', 1);
  const bool at_end = plus != std::string_view::npos && is_word(rest.substr(plus + 1));
  return at_end ? plus_node_id(parse_signed(rest.substr(0, plus))) : parse_signed(rest);
}

const SheetEntry* DataSheet::find(unsigned index, unsigned sub) const {
  const auto object = objects.find(static_cast<std::uint16_t>(index));
  if (index > 0xFFFF || sub > 0xFF || object == objects.end()) return nullptr;
  if (object->second.is_variable()) return sub == 0 ? &object->second.own : nullptr;
  const auto entry = object->second.subs.find(static_cast<std::uint8_t>(sub));
  return entry == object->second.subs.end() ? nullptr : &entry->second;
}

const IniSection* DataSheet::section(std::string_view name) const {
  const auto found = std::ranges::find_if(
      sections, [name](const IniSection& each) { return is_same_section(each.name, name); });
  return found == sections.end() ? nullptr : &*found;
}

std::size_t DataSheet::count_objects(unsigned first, unsigned last) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      objects, [=](const auto& object) { return object.first >= first && object.first <= last; }));
}

std::string_view DataSheet::text(std::string_view section_name, std::string_view key) const {
  for (const IniSection& each : sections) {
    // A sheet may have both spellings, with the key in one of them.
    const auto value = is_same_section(each.name, section_name) ? each.value(key) : std::nullopt;
    if (value) return *value;
  }
  return {};
}

NodeId DataSheet::node_id() const {
  const auto number = sheet_number(text("DeviceComissioning", "NodeID"));
  const bool is_said = number && number->number >= node_id_min && number->number <= node_id_max;
  return is_said ? static_cast<NodeId>(number->number) : NodeId{0};
}

bool DataSheet::sends_unreadable(unsigned index, unsigned sub) const {
  const SheetEntry* const wanted = find(index, sub);
  const auto said = wanted == nullptr ? std::nullopt : said_access(*wanted);
  if (!said || !wanted->pdo_mapping || allows(said->by_sdo, Access::sdo_read)) return false;
  const auto end = objects.upper_bound(object_index::tpdo_mapping_last);
  for (auto object = objects.lower_bound(object_index::tpdo_mapping); object != end; ++object) {
    for (const auto& [position, entry] : object->second.subs) {
      const auto mapped = sheet_number(entry.value.empty() ? entry.default_value : entry.value);
      const bool is_it = mapped && (mapped->number >> 8) == (std::int64_t{index} << 8 | sub);
      if (position != 0 && is_it) return true;
    }
  }
  return false;
}

std::optional<SaidAccess> said_access(const SheetEntry& entry) {
  struct Named {
    std::string_view name;
    SaidAccess access;
  };
  constexpr Named names[] = {
      {"ro", {Access::ro, Access::tpdo}},
      {"wo", {Access::wo, Access::rpdo}},
      {"rw", {Access::rw, Access::tpdo | Access::rpdo}},
      {"rwr", {Access::rw, Access::tpdo}},
      {"rww", {Access::rw, Access::rpdo}},
      {"const", {Access::const_, Access::tpdo}},
  };
  const auto* found = std::ranges::find_if(
      names, [&entry](const Named& named) { return same_letters(named.name, entry.access); });
  return found == std::end(names) ? std::nullopt : std::optional(found->access);
}

bool is_writable(const SheetEntry& entry) {
  const auto said = said_access(entry);
  return said && allows(said->by_sdo, Access::sdo_write);
}

SheetObject::Group group_of(unsigned index) {
  constexpr unsigned manufacturer_first = 0x2000;
  constexpr unsigned manufacturer_last = 0x5FFF;
  if (index == object_index::device_type || index == object_index::error_register ||
      index == object_index::identity)
    return SheetObject::Group::mandatory;
  const bool own = index >= manufacturer_first && index <= manufacturer_last;
  return own ? SheetObject::Group::manufacturer : SheetObject::Group::optional;
}

std::string place_text(unsigned index) {
  return fmt::format("{:04X}", index);
}
std::string place_text(unsigned index, unsigned sub) {
  return fmt::format("{:04X}sub{:X}", index, sub);
}

std::optional<unsigned> parse_hex(std::string_view text, std::size_t digits_max) {
  unsigned number = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number, 16);
  if (text.empty() || text.size() > digits_max || error != std::errc{} || end != last) {
    return std::nullopt;
  }
  return number;
}

}  // namespace canvoy::formats
