#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/eds/eds_parts.hpp"

namespace canvoy::formats {

namespace {

constexpr unsigned compact_pdos_max = 512;
constexpr unsigned mapped_objects_max = 64;
constexpr unsigned predefined_max = 4;  ///< PDOs with a CAN-ID from the node-ID (CiA 301, 7.3.3)
constexpr auto record = static_cast<unsigned>(ObjectCode::record);

/// A sub-index of a communication parameter (CiA 301, 7.5.2.35 and 7.5.2.37).
struct ParameterSub {
  const char* name;
  DataType type;
};
constexpr auto parameter_subs = std::to_array<ParameterSub>({
    {"COB-ID", DataType::unsigned32},
    {"Transmission type", DataType::unsigned8},
    {"Inhibit time", DataType::unsigned16},
    {"Reserved", DataType::unsigned8},
    {"Event timer", DataType::unsigned16},
    {"SYNC start value", DataType::unsigned8},
});

struct PdoKind {
  const char* name;
  const char* count_key;
  unsigned parameter;
  unsigned mapping;
  unsigned first_can_id;  ///< of PDO 1 of node 0
};
constexpr auto kinds = std::to_array<PdoKind>({
    {"RPDO", "NrOfRXPDO", object_index::rpdo_parameter, 0x1600, 0x200},
    {"TPDO", "NrOfTXPDO", object_index::tpdo_parameter, 0x1A00, 0x180},
});

SheetEntry entry_of(std::string name, DataType type, const char* access, std::string value,
                    std::size_t line) {
  SheetEntry entry = {.name = std::move(name),
                      .data_type = static_cast<unsigned>(type),
                      .access = access,
                      .default_value = std::move(value)};
  entry.line = line;
  return entry;
}

SheetObject parameter_of(const PdoKind& kind, unsigned number, unsigned mask, std::size_t line) {
  SheetObject made = {.group = SheetObject::Group::optional, .own = {}, .subs = {}};
  made.own = {.name = fmt::format("{} {} communication parameter", kind.name, number),
              .object_type = record};
  made.own.line = line;
  unsigned highest = 0;
  for (unsigned bit = 0; bit < parameter_subs.size(); ++bit) {
    if ((mask >> bit & 1U) == 0) continue;
    highest = bit + 1;
    std::string value;
    if (bit == 0) {
      constexpr unsigned step = 0x100;
      value = number <= predefined_max
                  ? fmt::format("$NODEID+0x{:X}", kind.first_can_id + (number - 1) * step)
                  : "0x80000000";
    }
    made.subs.emplace(static_cast<std::uint8_t>(highest),
                      entry_of(parameter_subs.at(bit).name, parameter_subs.at(bit).type, "rw",
                               std::move(value), line));
  }
  made.subs.emplace(std::uint8_t{0}, entry_of("Highest sub-index supported", DataType::unsigned8,
                                              "const", fmt::format("{}", highest), line));
  return made;
}

SheetObject mapping_of(const PdoKind& kind, unsigned number, std::size_t line) {
  SheetObject made = {.group = SheetObject::Group::optional, .own = {}, .subs = {}};
  made.own = {.name = fmt::format("{} {} mapping parameter", kind.name, number),
              .object_type = record};
  made.own.line = line;
  made.subs.emplace(std::uint8_t{0},
                    entry_of("Number of mapped objects", DataType::unsigned8, "rw", "0", line));
  for (unsigned sub = 1; sub <= mapped_objects_max; ++sub) {
    made.subs.emplace(static_cast<std::uint8_t>(sub),
                      entry_of(fmt::format("Mapped object {}", sub), DataType::unsigned32, "rw",
                               "0x00000000", line));
  }
  return made;
}

bool has(const DataSheet& sheet, unsigned index) {
  return sheet.objects.contains(static_cast<std::uint16_t>(index));
}

bool is_described(const DataSheet& sheet, const PdoKind& kind, unsigned at) {
  return has(sheet, kind.parameter + at) || has(sheet, kind.mapping + at);
}

void add_pdos(DataSheet& sheet, const PdoKind& kind, unsigned count, unsigned mask,
              std::size_t line) {
  unsigned described = 0;
  for (unsigned at = 0; at < compact_pdos_max; ++at)
    described += is_described(sheet, kind, at) ? 1U : 0U;
  unsigned to_make = count > described ? count - described : 0;
  for (unsigned at = 0; at < compact_pdos_max; ++at) {
    if (!is_described(sheet, kind, at)) {
      if (to_make == 0) continue;
      --to_make;
    }
    const auto parameter = static_cast<std::uint16_t>(kind.parameter + at);
    const auto mapping = static_cast<std::uint16_t>(kind.mapping + at);
    if (!has(sheet, parameter)) {
      sheet.objects.emplace(parameter, parameter_of(kind, at + 1, mask, line));
    }
    if (!has(sheet, mapping)) sheet.objects.emplace(mapping, mapping_of(kind, at + 1, line));
  }
}

}  // namespace

void add_compact_pdos(DataSheet& sheet, Findings& findings) {
  const IniSection* device = sheet.section("DeviceInfo");
  const IniLine* compact = device == nullptr ? nullptr : device->find("CompactPDO");
  const auto mask = compact == nullptr ? std::nullopt : sheet_number(compact->value);
  if (!mask || mask->number == 0) return;
  constexpr std::int64_t mask_max = 0x3F;
  if (mask->number < 0 || mask->number > mask_max || mask->plus_node_id) {
    findings.push_back({compact->number, device->name,
                        fmt::format("CompactPDO is {}", compact->value),
                        "bits of sub-indices 01h to 06h, 0x01 to 0x3F", Finding::Weight::error});
    return;
  }
  for (const PdoKind& kind : kinds) {
    const IniLine* line = device->find(kind.count_key);
    const auto count = line == nullptr ? std::nullopt : sheet_number(line->value);
    const std::int64_t wanted = count && !count->plus_node_id ? count->number : 0;
    if (wanted < 0 || wanted > std::int64_t{compact_pdos_max}) {
      findings.push_back({line->number, device->name,
                          fmt::format("{} is {}", line->key, line->value),
                          fmt::format("0 to {}", compact_pdos_max), Finding::Weight::error});
      continue;
    }
    add_pdos(sheet, kind, static_cast<unsigned>(wanted), static_cast<unsigned>(mask->number),
             compact->number);
  }
}

}  // namespace canvoy::formats
