#include "canvoy/formats/sheet/sheet_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/sheet/sheet_agreement.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats {

namespace {

constexpr unsigned last_index = 0xFFFF;

bool is_domain(const SheetEntry& entry) {
  return entry.data_type == static_cast<unsigned>(DataType::domain);
}

bool is_readable(const SheetEntry& entry) {
  return !same_letters(entry.access, "wo") && !is_domain(entry) && entry.data_type != 0;
}

/// The identity of a device is constant: its value is its default.
bool is_fixed(std::uint16_t index) {
  constexpr std::uint16_t fixed[] = {object_index::device_type, object_index::device_name,
                                     object_index::hardware_version, object_index::software_version,
                                     object_index::identity};
  return std::ranges::find(fixed, index) != std::end(fixed);
}

/// The description of the object, at an index in any block of the profile.
Part part_at(const Profile& profile, const ObjectInfo& object, unsigned index) {
  const unsigned offset = index - object.index;
  const unsigned number = offset < object.count ? offset : offset % profile.block_pitch;
  return Part(object).only(number).moved(offset - number);
}

std::size_t count_described(const Profile& profile) {
  std::size_t count = 0;
  for (unsigned index = object_index::device_type; index <= last_index; ++index) {
    count += find_description(profile, index) != nullptr;
  }
  return count;
}

std::string value_text(const SheetEntry& entry, std::span<const std::uint8_t> bytes) {
  const std::optional<DataType> type = sheet_type(entry.data_type);
  if (!type) return {};
  return sheet_value_text(*type, bytes).value_or("");
}

constexpr unsigned sub_last = 254;

bool is_printable(std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t each) { return each >= ' ' && each < 0x7F; });
}

/// The unsigned type of this length for a number; else a text, or octets.
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

/// 0 if there is none.
std::uint32_t number_in_text(const std::string& text) {
  const auto number = sheet_number(text);
  return number ? static_cast<std::uint32_t>(number->number) : 0;
}

/// Index and sub-index of the entries in its PDOs.
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

void SheetScan::tell(std::size_t done, std::size_t all, std::uint16_t index) const {
  if (tell_) tell_({done, all, index});
}

void SheetScan::read_values(DataSheet& sheet) {
  std::size_t done = 0;
  for (auto& [index, object] : sheet.objects) {
    tell(done++, sheet.objects.size(), index);
    object.own.value.clear();
    if (object.is_variable()) read_entry(index, 0, object.own);
    for (auto& [sub, entry] : object.subs) read_entry(index, sub, entry);
  }
}

void SheetScan::read_entry(std::uint16_t index, std::uint8_t sub, SheetEntry& entry) {
  entry.value.clear();
  if (index < object_index::device_type || !is_readable(entry)) return;
  const Result<Bytes> answer = read_(index, sub);
  note(index, sub, entry, answer);
  const auto type = sheet_type(entry.data_type);
  if (answer && type) entry.value = sheet_value_text(*type, *answer).value_or("");
}

void SheetScan::read_domains(DataSheet& sheet, const Keep& keep) {
  for (auto& [index, object] : sheet.objects) {
    if (object.is_variable()) read_domain(index, 0, object.own, keep);
    for (auto& [sub, entry] : object.subs) read_domain(index, sub, entry, keep);
  }
}

void SheetScan::read_domain(std::uint16_t index, std::uint8_t sub, SheetEntry& entry,
                            const Keep& keep) {
  if (index < object_index::device_type || !is_domain(entry) || same_letters(entry.access, "wo"))
    return;
  const Result<Bytes> answer = read_(index, sub);
  if (!answer) {
    unread_.push_back({index, sub, entry.name, answer.abort(), ""});
    return;
  }
  constexpr std::string_view key = "UploadFile";
  std::erase_if(entry.others, [key](const KeyValue& each) { return same_letters(each.key, key); });
  entry.others.push_back({std::string(key), keep(index, sub, *answer)});
  ++count_;
}

/// Counts a read value, and keeps an unread entry.
void SheetScan::note(std::uint16_t index, std::uint8_t sub, const SheetEntry& entry,
                     const Result<Bytes>& answer) {
  if (!answer) {
    // Entries of the history without an error do not exist yet.
    const bool is_empty = index == object_index::error_history && sub != 0;
    if (!is_empty) unread_.push_back({index, sub, entry.name, answer.abort(), ""});
    return;
  }
  const auto type = sheet_type(entry.data_type);
  if (!type) {
    unread_.push_back({index, sub, entry.name, AbortCode::none,
                       fmt::format("values of DataType 0x{:04X} are not known", entry.data_type)});
  } else if (!sheet_value_text(*type, *answer)) {
    const bool is_text = is_string(*type);
    unread_.push_back({index, sub, entry.name, AbortCode::none,
                       is_text ? "the text does not fit into a line of a file"
                               : fmt::format("the node has {} bytes there, and the type {}",
                                             answer->size(), byte_length(*type))});
  } else {
    ++count_;
  }
}

DataSheet SheetScan::read_profile(const Profile& profile, SheetIdentity identity) {
  const SheetIdentity known = identity;
  identity.node_id = 0;
  SheetMaker maker(profile, std::move(identity));
  std::map<std::uint16_t, Answers> found;
  const std::size_t all = count_described(profile);
  std::size_t done = 0;
  for (unsigned index = object_index::device_type; index <= last_index; ++index) {
    const ObjectInfo* object = find_description(profile, index);
    if (object == nullptr) continue;
    tell(done++, all, static_cast<std::uint16_t>(index));
    Answers answers = ask_object(static_cast<std::uint16_t>(index), *object);
    if (answers.empty()) continue;
    maker.add(part_at(profile, *object, index));
    found.emplace(static_cast<std::uint16_t>(index), std::move(answers));
  }
  DataSheet sheet = maker.take();
  for (const auto& [index, answers] : found) fill(index, sheet.objects[index], answers);
  make_agree(sheet);
  commission(sheet, known);
  return sheet;
}

/// The answers of the node for each existing entry; empty if the object does not exist.
SheetScan::Answers SheetScan::ask_object(std::uint16_t index, const ObjectInfo& object) {
  Answers answers;
  for (const EntryInfo& entry : object.entries()) {
    if (entry.type == DataType::domain) continue;
    ask_entries(index, entry, answers);
    if (answers.empty()) return answers;  // the first entry does not exist
  }
  return answers;
}

void SheetScan::ask_entries(std::uint16_t index, const EntryInfo& entry, Answers& answers) {
  for (unsigned sub = entry.sub_first; sub <= entry.last_sub(); ++sub) {
    const auto first = answers.find(0);
    const bool has_highest = first != answers.end() && first->second && first->second->size() == 1;
    const unsigned highest = has_highest ? first->second->front() : 0;
    Result<Bytes> answer = read_(index, static_cast<std::uint8_t>(sub));
    const AbortCode abort = answer.abort();
    if (!is_absent(abort)) answers.emplace(static_cast<std::uint8_t>(sub), std::move(answer));
    const bool is_end = is_absent(abort) || abort == AbortCode::no_data;
    if (is_end && sub >= highest) return;
  }
}

/// Puts answers into the fully described object of a sheet.
void SheetScan::fill(std::uint16_t index, SheetObject& object, const Answers& answers) {
  const auto put = [&](std::uint8_t sub, SheetEntry& entry) {
    const Result<Bytes>& answer = answers.at(sub);
    if (answer.abort() != AbortCode::write_only) note(index, sub, entry, answer);
    if (answer) entry.value = value_text(entry, *answer);
  };
  if (object.is_variable()) {
    put(0, object.own);
    if (is_fixed(index)) object.own.default_value = object.own.value;
    return;
  }
  const Result<Bytes>& count = answers.begin()->second;
  const unsigned highest = count && count->size() == 1 ? count->front() : 0U;
  // Domains are not read: they exist if sub-index 00h counts them.
  const auto is_there = [&](std::uint8_t sub, const SheetEntry& entry) {
    return answers.contains(sub) || (is_domain(entry) && sub <= highest);
  };
  std::erase_if(object.subs, [&](const auto& each) { return !is_there(each.first, each.second); });
  for (auto& [sub, entry] : object.subs) {
    if (!answers.contains(sub)) continue;
    put(sub, entry);
    if (is_fixed(index)) entry.default_value = entry.value;
  }
  const auto first = object.subs.find(0);
  if (first == object.subs.end() || is_writable(first->second)) return;
  first->second.default_value = sheet_number_text(object.subs.rbegin()->first, DataType::unsigned8);
}

// Undescribed objects

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

/// One byte in sub-index 00h may be a value, or the number of entries: sub-index 01h decides.
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
