#include "canvoy/formats/sheet/sheet_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/sheet/sheet_agreement.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy::formats {

namespace {

std::string default_text(const Default& initial, DataType type, std::uint8_t highest_sub) {
  switch (initial.kind) {
    case Default::Kind::none:
      return bit_length(type) == 0 || !is_integer(type) ? "" : sheet_number_text(0, type);
    case Default::Kind::text:
      return std::string(initial.text);
    case Default::Kind::plus_node_id:
      return fmt::format("$NODEID+0x{:X}", initial.number);
    case Default::Kind::highest_sub:
      return sheet_number_text(highest_sub, type);
    case Default::Kind::number:
      break;
  }
  return sheet_number_text(initial.number, type);
}

/// The limits, extended by values with a meaning of their own: a data sheet has only one range.
NumberRange allowed_range(const EntryInfo& entry) {
  NumberRange allowed = {entry.value.limits.low, entry.value.limits.high};
  for (const NamedValue& named : entry.value.names) {
    if (named.meaning >= Meaning::reserved) continue;
    const NumberRange range = range_of(named, bits_of(entry));
    allowed.low = std::min(allowed.low, range.low);
    allowed.high = std::max(allowed.high, range.high);
  }
  return allowed;
}

/// Value of an entry in a node with this node-ID.
std::string value_at(const SheetEntry& entry, std::uint8_t node_id) {
  const auto number = sheet_number(entry.default_value);
  if (!number || !number->plus_node_id) return entry.default_value;
  return fmt::format("0x{:X}", number->at(node_id));
}

IniSection& section_of(DataSheet& sheet, std::string_view name) {
  const IniSection* found = sheet.section(name);
  if (found != nullptr)
    return sheet.sections[static_cast<std::size_t>(found - sheet.sections.data())];
  return sheet.sections.emplace_back(IniSection{std::string(name), 0, {}});
}

void set(IniSection& section, std::string_view key, std::string value) {
  const auto found = std::ranges::find_if(
      section.lines, [key](const IniLine& line) { return same_letters(line.key, key); });
  if (found != section.lines.end()) {
    found->value = std::move(value);
  } else {
    section.add(std::string(key), std::move(value));
  }
}

/// EDS files are ASCII (CiA 306), but profiles have dashes.
std::string ascii_text(std::string text) {
  constexpr std::string_view dash = "\u2013";
  for (std::size_t at = 0; (at = text.find(dash, at)) != std::string::npos; ++at) {
    text.replace(at, dash.size(), "-");
  }
  return text;
}

SheetEntry made_entry(std::string name, DataType type, std::string access, std::string initial) {
  SheetEntry entry;
  entry.name = std::move(name);
  entry.data_type = static_cast<unsigned>(type);
  entry.access = std::move(access);
  entry.default_value = std::move(initial);
  return entry;
}

}  // namespace

void commission(DataSheet& sheet, const SheetIdentity& identity) {
  sheet.configured = true;
  IniSection& file = section_of(sheet, "FileInfo");
  set(file, "FileName", identity.file_name);
  set(file, "ModificationTime", identity.time);
  set(file, "ModificationDate", identity.date);
  set(file, "ModifiedBy", "Canvoy");
  set(file, "LastEDS", identity.last_eds);
  IniSection& node = section_of(sheet, "DeviceComissioning");
  set(node, "NodeID", fmt::format("{}", identity.node_id));
  set(node, "NodeName", identity.node_name.empty() ? identity.product_name : identity.node_name);
  set(node, "Baudrate", fmt::format("{}", identity.kilobits_per_second));
  if (node.find("NetNumber") == nullptr) set(node, "NetNumber", "1");
  if (node.find("NetworkName") == nullptr) set(node, "NetworkName", "");
  if (node.find("CANopenManager") == nullptr) set(node, "CANopenManager", "0");
  set(node, "LSS_SerialNumber", fmt::format("{}", identity.serial_number));
}

SheetMaker::SheetMaker(const Profile& profile, SheetIdentity identity)
    : profile_(profile), identity_(std::move(identity)) {}

SheetEntry SheetMaker::entry_of(const Part& part, const EntryInfo& entry, unsigned index,
                                unsigned sub) const {
  const ObjectInfo& object = part.object();
  const Access access = canvoy::detail::access_of(part, entry);
  SheetEntry made;
  made.name =
      entry.name.empty() ? object_name(profile_, object, index) : entry_name(object, entry, sub);
  made.data_type = static_cast<unsigned>(entry.type);
  made.access = access_name(access);
  made.default_value =
      default_text(canvoy::detail::initial_of(part, entry), entry.type, part.highest_sub());
  made.pdo_mapping = allows(access, Access::tpdo) || allows(access, Access::rpdo);
  if (entry.value.limits.kind == Limits::Kind::absolute) {
    const NumberRange allowed = allowed_range(entry);
    made.low_limit = sheet_number_text(allowed.low, entry.type);
    made.high_limit = sheet_number_text(allowed.high, entry.type);
  }
  if (entry.type == DataType::domain) made.object_type = 2;
  return made;
}

void SheetMaker::add(const Part& part) {
  const ObjectInfo& object = part.object();
  for (unsigned i = 0; i < part.count(); ++i) {
    const auto index = static_cast<std::uint16_t>(part.index() + i);
    if (object.subs.empty()) {
      add_variable(index, entry_of(part, object.entry, index, 0));
      continue;
    }
    SheetObject& made =
        add_record(index, object_name(profile_, object, index), object.code == ObjectCode::array);
    for (const EntryInfo& entry : object.entries()) {
      if (!part.has(entry)) continue;
      for (unsigned sub = entry.sub_first; sub <= part.last_sub(entry); ++sub) {
        made.subs[static_cast<std::uint8_t>(sub)] = entry_of(part, entry, index, sub);
      }
    }
  }
}

SheetObject& SheetMaker::add_record(std::uint16_t index, std::string name, bool is_array) {
  SheetObject& object = sheet_.objects[index];
  object.group = group_of(index);
  object.own.name = std::move(name);
  object.own.object_type = static_cast<unsigned>(is_array ? ObjectCode::array : ObjectCode::record);
  return object;
}

void SheetMaker::add_variable(std::uint16_t index, SheetEntry entry) {
  SheetObject& object = sheet_.objects[index];
  object.group = group_of(index);
  object.own = std::move(entry);
}

bool SheetMaker::has_dummy(std::uint32_t mapped) {
  const MappingValue value(mapped);
  return value.is_dummy() || value.bits == 8 || value.bits == 16 || value.bits == 32;
}

std::uint32_t SheetMaker::received(std::uint32_t mapped) const {
  const MappingValue value(mapped);
  if (value.is_dummy() || has(value.index) || !has_dummy(mapped)) return mapped;
  const DataType dummy = value.bits == 8    ? DataType::unsigned8
                         : value.bits == 16 ? DataType::unsigned16
                                            : DataType::unsigned32;
  return MappingValue(static_cast<unsigned>(dummy), 0, value.bits).raw();
}

void SheetMaker::add(const PdoInfo& pdo) {
  using enum DataType;
  const bool is_tpdo = pdo.direction == PdoInfo::Direction::transmit;
  const auto parameter = static_cast<std::uint16_t>(
      (is_tpdo ? object_index::tpdo_parameter : object_index::rpdo_parameter) + pdo.number - 1);
  const char* kind = is_tpdo ? "TPDO" : "RPDO";
  SheetObject& parameters = add_record(parameter, fmt::format("{} communication parameter", kind));
  const std::string cob_id = pdo.plus_node_id ? fmt::format("$NODEID+0x{:X}", pdo.cob_id)
                                              : sheet_number_text(pdo.cob_id, unsigned32);
  parameters.subs = {
      {0, made_entry("Highest sub-index supported", unsigned8, "const", "0x05")},
      {1, made_entry("COB-ID", unsigned32, "rw", cob_id)},
      {2, made_entry("Transmission type", unsigned8, "rw",
                     sheet_number_text(pdo.transmission_type, unsigned8))},
      {3, made_entry("Inhibit time", unsigned16, "rw",
                     sheet_number_text(pdo.inhibit_time, unsigned16))},
      {5,
       made_entry("Event timer", unsigned16, "rw", sheet_number_text(pdo.event_timer, unsigned16))},
  };
  SheetObject& mapping = add_record(static_cast<std::uint16_t>(parameter + 0x200),
                                    fmt::format("{} mapping parameter", kind));
  constexpr unsigned source_mode = 0xFE;
  const std::size_t count =
      pdo.multiplexed == MpdoKind::no
          ? pdo.mapping.size()
          : source_mode + (pdo.multiplexed == MpdoKind::destination ? 1U : 0U);
  mapping.subs[0] = made_entry("Number of mapped objects", unsigned8, "rw",
                               sheet_number_text(static_cast<std::int64_t>(count), unsigned8));
  for (std::size_t i = 0; i < pdo.mapping.size(); ++i) {
    const std::uint32_t mapped = is_tpdo ? pdo.mapping[i] : received(pdo.mapping[i]);
    mapping.subs[static_cast<std::uint8_t>(i + 1)] =
        made_entry(fmt::format("Mapped object {}", i + 1), unsigned32, "rw",
                   sheet_number_text(mapped, unsigned32));
  }
}

void SheetMaker::add_basics(std::uint32_t device_type) {
  using enum DataType;
  const auto add_missing = [this](std::uint16_t index, const SheetEntry& entry) {
    if (!has(index)) add_variable(index, entry);
  };
  const std::string type_text = sheet_number_text(device_type, unsigned32);
  add_missing(object_index::device_type, made_entry("Device type", unsigned32, "ro", type_text));
  // A profile that describes 1000h itself leaves its value to the device.
  SheetEntry& type_entry = sheet_.objects[object_index::device_type].own;
  const auto type_number = sheet_number(type_entry.default_value);
  if (type_number && type_number->number == 0) type_entry.default_value = type_text;
  SheetEntry error_register = made_entry("Error register", unsigned8, "ro", "0x00");
  error_register.pdo_mapping = true;
  add_missing(object_index::error_register, error_register);
  add_missing(object_index::heartbeat_producer,
              made_entry("Producer heartbeat time", unsigned16, "rw", "0x0000"));
  if (has(object_index::identity)) return;
  const auto hex = [](std::uint32_t number) { return sheet_number_text(number, unsigned32); };
  add_record(object_index::identity, "Identity object").subs = {
      {0, made_entry("Highest sub-index supported", unsigned8, "const", "0x04")},
      {1, made_entry("Vendor-ID", unsigned32, "ro", hex(identity_.vendor_id))},
      {2, made_entry("Product code", unsigned32, "ro", hex(identity_.product_code))},
      {3, made_entry("Revision number", unsigned32, "ro", hex(identity_.revision))},
      {4, made_entry("Serial number", unsigned32, "ro", hex(0))},
  };
}

void SheetMaker::add_sections() {
  IniSection file = {"FileInfo", 0, {}};
  file.add("FileName", identity_.file_name);
  file.add("FileVersion", "1");
  file.add("FileRevision", "0");
  file.add("EDSVersion", "4.0");
  file.add("Description", fmt::format("{}: {}", profile_.name, profile_.title));
  file.add("CreationTime", identity_.time);
  file.add("CreationDate", identity_.date);
  file.add("CreatedBy", "Canvoy");
  file.add("ModificationTime", identity_.time);
  file.add("ModificationDate", identity_.date);
  file.add("ModifiedBy", "Canvoy");

  const auto hex = [](std::uint32_t number) { return fmt::format("0x{:08X}", number); };
  IniSection device = {"DeviceInfo", 0, {}};
  device.add("VendorName", identity_.vendor_name);
  device.add("VendorNumber", hex(identity_.vendor_id));
  device.add("ProductName", identity_.product_name);
  device.add("ProductNumber", hex(identity_.product_code));
  device.add("RevisionNumber", hex(identity_.revision));
  device.add("OrderCode", "");
  for (const unsigned rate : {10U, 20U, 50U, 125U, 250U, 500U, 800U, 1000U}) {
    device.add(fmt::format("BaudRate_{}", rate), "1");
  }
  device.add("SimpleBootUpMaster", "0");
  device.add("SimpleBootUpSlave", "1");
  device.add("Granularity", "1");
  device.add("DynamicChannelsSupported", "0");
  device.add("GroupMessaging", "0");
  device.add("NrOfRXPDO", "0");
  device.add("NrOfTXPDO", "0");
  device.add("LSS_Supported", identity_.answers_lss ? "1" : "0");
  sheet_.sections = {std::move(file), std::move(device)};
}

DataSheet SheetMaker::take() {
  add_sections();
  make_agree(sheet_);
  for (auto& [index, object] : sheet_.objects) {
    object.own.name = ascii_text(object.own.name);
    for (auto& [sub, entry] : object.subs) entry.name = ascii_text(entry.name);
  }
  constexpr std::uint16_t last_dummy = 7;
  for (std::uint16_t index = 1; index <= last_dummy; ++index) sheet_.dummies[index] = true;
  if (identity_.node_id == 0) return std::move(sheet_);
  commission(sheet_, identity_);
  for (auto& [index, object] : sheet_.objects) {
    if (object.is_variable()) object.own.value = value_at(object.own, identity_.node_id);
    for (auto& [sub, entry] : object.subs) entry.value = value_at(entry, identity_.node_id);
  }
  return std::move(sheet_);
}

}  // namespace canvoy::formats
