#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "canvoy/formats/sheet/sheet_scan.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/profiles/mapping_value.hpp"

namespace canvoy::formats {

namespace {

constexpr unsigned sub_last = 254;

bool is_printable(std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t each) { return each >= ' ' && each < 0x7F; });
}

/// Of numbers the unsigned one of this length; of all else a text, or octets.
DataType least_type(std::span<const std::uint8_t> bytes) {
  switch (bytes.size()) {
    case 1:
      return DataType::unsigned8;
    case 2:
      return DataType::unsigned16;
    case 3:
      return DataType::unsigned24;
    case 4:
      return DataType::unsigned32;
    case 8:
      return is_printable(bytes) ? DataType::visible_string : DataType::unsigned64;
    default:
      return is_printable(bytes) ? DataType::visible_string : DataType::octet_string;
  }
}

/// 0 where it is none.
std::uint32_t number_in_text(const std::string& text) {
  const auto number = sheet_number(text);
  return number ? static_cast<std::uint32_t>(number->number) : 0;
}

/// Index and sub-index of what its PDOs carry.
std::set<std::uint32_t> mapped_entries(const DataSheet& sheet) {
  std::set<std::uint32_t> mapped;
  for (const auto& [index, object] : sheet.objects) {
    if (!is_pdo_mapping(index)) continue;
    for (const auto& [sub, entry] : object.subs) {
      if (sub != 0) mapped.insert(number_in_text(entry.value) >> 8);
    }
  }
  return mapped;
}

}  // namespace

void SheetScan::read_undescribed(DataSheet& sheet, std::uint16_t first, std::uint16_t last) {
  for (unsigned index = first; index <= last; ++index) {
    tell(index - first, std::size_t{last} - first + 1, static_cast<std::uint16_t>(index));
    if (sheet.objects.contains(static_cast<std::uint16_t>(index))) continue;
    read_undescribed_object(sheet, static_cast<std::uint16_t>(index));
  }
  const std::set<std::uint32_t> mapped = mapped_entries(sheet);
  for (auto& [index, object] : sheet.objects) {
    if (mapped.contains(std::uint32_t{index} << 8)) object.own.pdo_mapping = object.is_variable();
    for (auto& [sub, entry] : object.subs) {
      entry.pdo_mapping = entry.pdo_mapping || mapped.contains(std::uint32_t{index} << 8 | sub);
    }
  }
}

SheetEntry SheetScan::undescribed_entry(std::uint16_t index, std::uint8_t sub, const Bytes& bytes) {
  const DataType type = least_type(bytes);
  SheetEntry entry = {.name = fmt::format("{:04X}h:{:02X}h", index, sub),
                      .data_type = static_cast<unsigned>(type),
                      .access = "rw",
                      .value = sheet_value_text(type, bytes).value_or("")};
  entry.default_value = entry.value;
  ++count_;
  return entry;
}

/// One byte in sub-index 00h may be a value, or how many there are: sub-index 01h tells.
void SheetScan::read_undescribed_object(DataSheet& sheet, std::uint16_t index) {
  const Result<Bytes> own = read_(index, 0);
  if (!own && is_absent(own.abort())) return;
  SheetObject object = {.group = group_of(index), .own = {}, .subs = {}};
  if (!own) {
    unread_.push_back({index, 0, fmt::format("{:04X}h", index), own.abort(), ""});
    return;
  }
  object.own = undescribed_entry(index, 0, *own);
  object.own.name = fmt::format("{:04X}h", index);
  const unsigned count = own->size() == 1 ? own->front() : 0;
  for (unsigned sub = 1; sub <= std::min(count, sub_last); ++sub) {
    const Result<Bytes> answer = read_(index, static_cast<std::uint8_t>(sub));
    if (!answer && is_absent(answer.abort())) {
      if (sub == 1) break;
      continue;
    }
    if (!answer) {
      unread_.push_back({index, static_cast<std::uint8_t>(sub), "", answer.abort(), ""});
      continue;
    }
    object.subs.emplace(static_cast<std::uint8_t>(sub),
                        undescribed_entry(index, static_cast<std::uint8_t>(sub), *answer));
  }
  if (!object.subs.empty()) {
    object.subs.emplace(0, object.own);
    object.subs[0].access = "ro";
    object.own = {.name = object.own.name,
                  .object_type = static_cast<unsigned>(ObjectCode::record)};
  }
  sheet.objects.emplace(index, std::move(object));
}

}  // namespace canvoy::formats
