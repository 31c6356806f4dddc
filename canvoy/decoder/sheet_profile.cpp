#include "canvoy/decoder/sheet_profile.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

/// Value of the entry in a device of this sheet, if it is a number.
std::optional<formats::SheetNumber> said_number(const formats::SheetEntry& entry) {
  return formats::sheet_number(entry.value.empty() ? entry.default_value : entry.value);
}

const Profile& base_of(const formats::DataSheet& sheet, const Network* network) {
  const formats::SheetEntry* device_type = sheet.find(object_index::device_type, 0);
  const auto number = device_type == nullptr ? std::nullopt : said_number(*device_type);
  const Profile* known =
      number ? find_profile(static_cast<std::uint32_t>(number->number)) : nullptr;
  if (known == nullptr) return base_profile();
  return network == nullptr ? *known : network->reading_of(*known);
}

/// rwr and rww are rw, in PDOs for reading or for writing only (CiA 306).
Access access_of(const formats::SheetEntry& entry) {
  const auto said = formats::said_access(entry);
  if (!said) return Access::rw;
  const bool is_one_way =
      said->by_sdo == Access::rw && said->in_pdos != (Access::tpdo | Access::rpdo);
  return is_one_way ? said->by_sdo | said->in_pdos : said->by_sdo;
}

/// None if the sheet gives none, or none that is valid for any node.
Limits limits_of(const formats::SheetEntry& entry, DataType type) {
  const auto low = formats::sheet_number(entry.low_limit);
  const auto high = formats::sheet_number(entry.high_limit);
  const unsigned bits = bit_length(type);
  const bool can_be_told = is_integer(type) && bits < 64 && (low || high) &&
                           !(low && low->plus_node_id) && !(high && high->plus_node_id);
  if (!can_be_told) return {};
  const auto number = [&](std::int64_t written) {
    return number_of(static_cast<std::uint64_t>(written), bits, is_signed(type));
  };
  const NumberRange all = range_of_type(bits, is_signed(type));
  return within(low ? number(low->number) : all.low, high ? number(high->number) : all.high);
}

/// The sheet of the device takes precedence over the profile.
void refine(EntryInfo& entry, const formats::SheetEntry& said, bool is_sent) {
  const Limits limits = limits_of(said, entry.type);
  if (limits.kind != Limits::Kind::none) entry.value.limits = limits;
  if (said.access.empty()) return;
  entry.access = access_of(said);
  // The profile leaves it to the device: 6001h of CiA 407 is sent, and SDO does not read it.
  if (is_sent && entry.access_by_device) entry.access = entry.access | Access::rpdo | Access::tpdo;
  entry.consumer_access = Access::none;
  entry.access_by_device = false;
  entry.mapping = said.pdo_mapping ? Mapping::optional : Mapping::no;
}

/// 0 if nothing is given.
std::int64_t or_zero(const std::optional<formats::SheetNumber>& number) {
  return number ? number->number : 0;
}

Identity identity_of(const formats::DataSheet& sheet) {
  Identity identity;
  for (std::size_t part = 0; part < Identity::count; ++part) {
    const formats::SheetEntry* entry =
        sheet.find(object_index::identity, static_cast<unsigned>(part + 1));
    std::int64_t number = entry == nullptr ? 0 : or_zero(said_number(*entry));
    // Many sheets give it only in the section of the device.
    if (part == LssAddress::vendor && number == 0) {
      number = or_zero(formats::sheet_number(sheet.text("DeviceInfo", "VendorNumber")));
    }
    if (part == LssAddress::product && number == 0) {
      number = or_zero(formats::sheet_number(sheet.text("DeviceInfo", "ProductNumber")));
    }
    if (number != 0) identity.set(part, static_cast<std::uint32_t>(number));
  }
  return identity;
}

}  // namespace

SheetProfile::SheetProfile(const formats::DataSheet& sheet, const Network* network)
    : source_(&sheet), profile_(base_of(sheet, network)) {
  const Profile& base = base_of(sheet, network);
  profile_.base = &base;
  for (const auto& [index, object] : sheet.objects) {
    if (index >= object_index::rpdo_parameter && index <= object_index::tpdo_mapping_last) {
      add_parameters(index, object);
    } else if (const ObjectInfo* described = find_description(base, index)) {
      add_described(index, object, *described);
      add_parameters(index, object);
    } else {
      add_object(index, object);
    }
  }
  for (const ObjectInfo& object : objects_) sorted_.push_back(&object);
  profile_.objects = Items<const ObjectInfo*>(sorted_.data(), sorted_.size());
  profile_.block_count = 1;
  const bool has_pdos = !sheet_.parameters.empty() &&
                        sheet_.parameters.front().index <= object_index::tpdo_mapping_last;
  if (has_pdos) profile_.pdos = {};
  sheet_.identity = identity_of(sheet);
  sheet_.profile = &profile_;
}

void SheetProfile::add_object(std::uint16_t index, const formats::SheetObject& object) {
  std::vector<EntryInfo>& entries = entries_.emplace_back();
  ObjectInfo made = {.index = index,
                     .name = keep(formats::plain_text(object.own.name)),
                     .first_number = formats::no_number};
  if (object.is_variable()) {
    add_entry(entries, index, 0, object.own);
    if (!entries.empty()) made.entry = entries.front();
    made.entry.name = {};
  }
  for (const auto& [sub, entry] : object.subs) add_entry(entries, index, sub, entry);
  if (entries.empty()) return;
  if (!object.is_variable()) {
    made.code = ObjectCode::record;
    made.subs = Items<EntryInfo>(entries.data(), entries.size());
  }
  objects_.push_back(made);
}

void SheetProfile::add_entry(std::vector<EntryInfo>& entries, std::uint16_t index, std::uint8_t sub,
                             const formats::SheetEntry& entry) {
  // A type of the manufacturer, or of a record: the bytes are shown as they are.
  const DataType type = formats::sheet_type(entry.data_type).value_or(DataType::octet_string);
  entries.push_back({.sub_first = sub,
                     .sub_last = sub,
                     .name = keep(formats::plain_text(entry.name)),
                     .first_number = formats::no_number,
                     .type = type});
  refine(entries.back(), entry, source_->sends_unreadable(index, sub));
}

/// The description of the profile, with a separate entry for each sub-index, since the sheet may
/// distinguish them.
void SheetProfile::add_described(std::uint16_t index, const formats::SheetObject& object,
                                 const ObjectInfo& described) {
  ObjectInfo made = described;
  made.index = index;
  made.count = 1;
  made.first_number = static_cast<std::uint16_t>((index - described.index) % profile_.block_pitch +
                                                 described.first_number);
  if (described.subs.empty()) {
    refine(made.entry, object.own, source_->sends_unreadable(index, 0));
    objects_.push_back(made);
    return;
  }
  std::vector<EntryInfo>& entries = entries_.emplace_back();
  for (const auto& [sub, said] : object.subs) {
    const EntryInfo* known = find_entry(described, sub);
    if (known == nullptr) continue;
    EntryInfo& entry = entries.emplace_back(*known);
    entry.first_number = static_cast<std::uint16_t>(known->first_number + sub - known->sub_first);
    entry.sub_first = entry.sub_last = sub;
    refine(entry, said, source_->sends_unreadable(index, sub));
  }
  // The first entry with the sub-index is used.
  entries.insert(entries.end(), described.subs.begin(), described.subs.end());
  made.subs = Items<EntryInfo>(entries.data(), entries.size());
  objects_.push_back(made);
}

void SheetProfile::add_parameters(std::uint16_t index, const formats::SheetObject& object) {
  const bool is_of_pdo = index <= object_index::tpdo_mapping_last;
  for (const auto& [sub, entry] : object.subs) {
    if (!is_of_pdo && !is_unit_source(index, sub)) continue;
    const auto number = said_number(entry);
    if (!number) continue;
    sheet_.parameters.push_back(
        {index, sub, static_cast<std::uint32_t>(number->number), number->plus_node_id});
  }
}

}  // namespace canvoy::decoder
