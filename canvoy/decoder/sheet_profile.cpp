#include "canvoy/decoder/sheet_profile.hpp"

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/formats/sheet_value.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

constexpr std::uint16_t device_type_index = 0x1000;
constexpr unsigned pdo_first = 0x1400;
constexpr unsigned pdo_last = 0x1BFF;

/// What the entry holds in a device of this sheet, where that is a number.
std::optional<formats::SheetNumber> number_of(const formats::SheetEntry& entry) {
  return formats::sheet_number(entry.value.empty() ? entry.default_value : entry.value);
}

const Profile& base_of(const formats::DataSheet& sheet) {
  const formats::SheetEntry* device_type = sheet.find(device_type_index, 0);
  const auto number = device_type == nullptr ? std::nullopt : number_of(*device_type);
  const Profile* known =
      number ? find_profile(static_cast<std::uint32_t>(number->number)) : nullptr;
  return known == nullptr ? base_profile() : *known;
}

Access access_of(const std::string& text) {
  if (text == "ro") return Access::ro;
  if (text == "wo") return Access::wo;
  return text == "const" ? Access::const_ : Access::rw;
}

}  // namespace

SheetProfile::SheetProfile(const formats::DataSheet& sheet) : profile_(base_of(sheet)) {
  const Profile& base = base_of(sheet);
  profile_.base = &base;
  for (const auto& [index, object] : sheet.objects) {
    if (index >= pdo_first && index <= pdo_last) {
      add_parameters(index, object);
    } else if (find_description(base, index) == nullptr) {
      add_object(index, object);
    }
  }
  for (const ObjectInfo& object : objects_) sorted_.push_back(&object);
  profile_.objects = Items<const ObjectInfo*>(sorted_.data(), sorted_.size());
  profile_.block_count = 1;
  if (!parameters_.empty()) profile_.pdos = {};
}

void SheetProfile::add_object(std::uint16_t index, const formats::SheetObject& object) {
  std::vector<EntryInfo>& entries = entries_.emplace_back();
  ObjectInfo made = {.index = index, .name = keep(object.own.name)};
  if (object.is_variable()) {
    add_entry(entries, 0, object.own);
    if (!entries.empty()) made.entry = entries.front();
    made.entry.name = {};
  }
  for (const auto& [sub, entry] : object.subs) add_entry(entries, sub, entry);
  if (entries.empty()) return;
  if (!object.is_variable()) {
    made.code = ObjectCode::record;
    made.subs = Items<EntryInfo>(entries.data(), entries.size());
  }
  objects_.push_back(made);
}

void SheetProfile::add_entry(std::vector<EntryInfo>& entries, std::uint8_t sub,
                             const formats::SheetEntry& entry) {
  const std::optional<DataType> type = formats::sheet_type(entry.data_type);
  if (!type) return;
  entries.push_back({.sub_first = sub,
                     .sub_last = sub,
                     .name = keep(entry.name),
                     .type = *type,
                     .access = access_of(entry.access),
                     .mapping = entry.pdo_mapping ? Mapping::optional : Mapping::no});
}

void SheetProfile::add_parameters(std::uint16_t index, const formats::SheetObject& object) {
  for (const auto& [sub, entry] : object.subs) {
    if (const auto number = number_of(entry)) parameters_.push_back({index, sub, *number});
  }
}

void SheetProfile::apply(Network& network, NodeId node) const {
  network.set_profile(node, profile_);
  for (const Parameter& parameter : parameters_) {
    std::array<std::uint8_t, sizeof(std::uint32_t)> bytes{};
    store(bytes.data(), static_cast<std::uint32_t>(parameter.value.at(node)));
    network.learn(node, parameter.index, parameter.sub, bytes);
  }
}

}  // namespace canvoy::decoder
