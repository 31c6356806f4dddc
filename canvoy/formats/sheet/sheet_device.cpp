#include "canvoy/formats/sheet/sheet_device.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t text_bytes_min = 64;  ///< data sheets give no maximum length of a string
constexpr std::size_t text_bytes_max = 4096;
constexpr std::size_t domain_bytes_max = 65536;

/// The functions of these objects are beyond a dictionary and its services: they belong to SDO
/// clients, NMT masters, managers, program loaders and debuggers.
constexpr canvoy::detail::IndexRange of_an_application[] = {
    {0x1023, 0x1026}, {0x102A, 0x102A}, {0x1280, 0x12FF}, {0x1F00, 0x1F9F}};

bool is_storage(std::uint16_t index) {
  return index == object_index::store_parameters || index == object_index::restore_parameters;
}

Access access_of(const SheetEntry& entry, bool is_sent) {
  const auto said = said_access(entry);
  if (!said) return Access::rw;
  if (!entry.pdo_mapping) return said->by_sdo;
  return said->by_sdo | said->in_pdos | (is_sent ? Access::tpdo : Access::none);
}

}  // namespace

SheetTables::SheetTables(const DataSheet& sheet, Findings& left_out)
    : sheet_(sheet), left_out_(left_out) {
  for (const auto& [index, object] : sheet.objects) add_object(index, object);
}

void SheetTables::add_object(std::uint16_t index, const SheetObject& object) {
  if (index < object_index::device_type) return;
  std::vector<EntryRow> rows;
  if (object.is_variable()) {
    add_entry(rows, index, 0, object.own);
  } else {
    for (const auto& [sub, entry] : object.subs) add_entry(rows, index, sub, entry);
  }
  if (!rows.empty()) canvoy::add_object(tables_, {.index = index}, rows);
}

void SheetTables::add_entry(std::vector<EntryRow>& rows, std::uint16_t index, std::uint8_t sub,
                            const SheetEntry& entry) {
  const auto leave_out = [&](std::string what) {
    left_out_.push_back(
        {entry.line, place_text(index, sub), std::move(what), "", Finding::Weight::warning});
  };
  // Each entry has up to three limits, or a wide default, and the tables store positions in 16
  // bits.
  constexpr std::size_t entries_max = 0xFFFF / 4;
  if (tables_.entries.size() + rows.size() == entries_max) {
    return leave_out("there are too many entries");
  }
  const auto type = sheet_type(entry.data_type);
  if (!type) return leave_out(fmt::format("DataType is 0x{:04X}", entry.data_type));
  const bool is_sent = sheet_.sends_unreadable(index, sub);
  EntryRow row = {
      .sub_first = sub, .sub_last = sub, .type = *type, .access = access_of(entry, is_sent)};
  if (!set_default(row, entry)) return leave_out("the default is no value of the type");
  // A sheet does not distinguish process data from parameters that a PDO may carry.
  if (entry.pdo_mapping) row.traits = row.traits | EntryTraits::not_stored;
  // A device with a sub-index for a group stores it on command, unless the sheet says otherwise.
  const bool is_said = !entry.default_value.empty() || !entry.value.empty();
  if (is_storage(index) && sub != 0 && !is_said) row.initial = 1;
  if (is_integer(*type)) set_limits(row, entry);
  rows.push_back(row);
}

/// The value of a configured device takes precedence over the default.
bool SheetTables::set_default(EntryRow& row, const SheetEntry& entry) {
  const std::string& text = entry.value.empty() ? entry.default_value : entry.value;
  if (is_string(row.type)) {
    const auto bytes = sheet_bytes(row.type, text, 0);
    if (!bytes || bytes->size() > text_bytes_max) return false;
    row.capacity = static_cast<std::uint16_t>(std::max(bytes->size(), text_bytes_min));
    row.initial_text = texts_.emplace_back(bytes->begin(), bytes->end());
    return true;
  }
  if (row.type == DataType::domain) return true;
  const auto number = sheet_number(text);
  if (is_integer(row.type) && number && number->plus_node_id) {
    constexpr NodeId node_id_max = 127;
    if (!sheet_bytes(row.type, text, 0) || !sheet_bytes(row.type, text, node_id_max)) return false;
    row.traits = row.traits | EntryTraits::plus_node_id;
    row.initial = number->number;
    return true;
  }
  const auto bytes = sheet_bytes(row.type, text, 0);
  if (!bytes) return false;
  const auto pattern = load_unsigned(*bytes);
  row.initial = is_signed(row.type) ? sign_extend(pattern, bit_length(row.type))
                                    : static_cast<std::int64_t>(pattern);
  return true;
}

void SheetTables::set_limits(EntryRow& row, const SheetEntry& entry) {
  const auto low = sheet_number(entry.low_limit);
  const auto high = sheet_number(entry.high_limit);
  // Limits that depend on the node-ID, of one side, or beyond the type, are not checked.
  if (!low || !high || low->plus_node_id || high->plus_node_id) return;
  if (!sheet_bytes(row.type, entry.low_limit, 0) || !sheet_bytes(row.type, entry.high_limit, 0)) {
    return;
  }
  const auto number = [&row](std::int64_t pattern) {
    return number_of(static_cast<std::uint64_t>(pattern), bit_length(row.type),
                     is_signed(row.type));
  };
  row.low = number(low->number);
  row.high = number(high->number);
  if (row.low <= row.high) row.traits = row.traits | EntryTraits::limited;
}

DomainContents::DomainContents(Dictionary& dictionary) {
  domain_.open_read = decltype(domain_.open_read)::to<&DomainContents::open_read>(*this);
  domain_.read = decltype(domain_.read)::to<&DomainContents::read>(*this);
  domain_.open_write = decltype(domain_.open_write)::to<&DomainContents::open_write>(*this);
  domain_.write = decltype(domain_.write)::to<&DomainContents::write>(*this);
  domain_.close_write = decltype(domain_.close_write)::to<&DomainContents::close_write>(*this);
  const DictionaryTables& tables = dictionary.tables();
  for (const ObjectRow& row : tables.objects) {
    const auto entries = tables.entries_of(row);
    if (std::ranges::find(entries, DataType::domain, &EntryShape::type) == entries.end()) continue;
    Hook& hook = hooks_.emplace_back();
    hook.first = hook.last = row.index;
    hook.domain = &domain_;
    dictionary.attach(hook);
  }
}

Result<std::uint32_t> DomainContents::open_read(const Entry& entry) {
  Content& here = content(entry);
  here.is_new = false;
  return static_cast<std::uint32_t>(here.bytes.size());
}

Result<std::size_t> DomainContents::read(const Entry& entry, std::uint32_t offset,
                                         std::span<std::uint8_t> bytes) {
  const Content& here = content(entry);
  if (here.is_new) return AbortCode::device_state;
  const Bytes& all = here.bytes;
  const std::size_t first = std::min<std::size_t>(offset, all.size());
  const std::size_t count = std::min(bytes.size(), all.size() - first);
  std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), count, bytes.begin());
  return count;
}

AbortCode DomainContents::open_write(const Entry& entry, std::uint32_t size) {
  Content& here = content(entry);
  if (here.arriving) return AbortCode::device_state;
  if (size > domain_bytes_max) return AbortCode::out_of_memory;
  here.arriving.emplace();
  return AbortCode::none;
}

AbortCode DomainContents::write(const Entry& entry, std::span<const std::uint8_t> bytes) {
  Content& here = content(entry);
  if (!here.arriving) return AbortCode::device_state;
  Bytes& written = *here.arriving;
  if (written.size() + bytes.size() > domain_bytes_max) return AbortCode::out_of_memory;
  written.insert(written.end(), bytes.begin(), bytes.end());
  return AbortCode::none;
}

AbortCode DomainContents::close_write(const Entry& entry, bool complete) {
  Content& here = content(entry);
  if (complete && here.arriving) {
    here.bytes = std::move(*here.arriving);
    here.is_new = true;
  }
  here.arriving.reset();
  return AbortCode::none;
}

SheetDevice::SheetDevice(const DataSheet& sheet, const Port& port, NodeId node_id,
                         const Options& options)
    : sheet_(sheet, left_out_), device_(sheet_.tables(), port, node_id, options.further_routes) {
  add_own_sheet(sheet);
  add_storage(options);
}

void SheetDevice::add_storage(const Options& options) {
  const bool is_wanted =
      canvoy::detail::count_objects(device_.tables(), object_index::store_parameters,
                                    object_index::restore_parameters) != 0;
  if (is_wanted && options.stores_in_memory) storage_.emplace(node());
}

/// 1021h holds the data sheet of the device, as text if 1022h is 0.
void SheetDevice::add_own_sheet(const DataSheet& sheet) {
  const auto found = node().dictionary().find(object_index::store_eds, 0);
  if (!found || found->row->type != DataType::domain) return;
  const auto format = node().dictionary().find(object_index::store_eds_format, 0);
  if (format && node().dictionary().default_number(*format) != 0) return;
  DataSheet eds = sheet;
  eds.configured = false;
  const std::string text = write_eds(eds);
  domains_.fill(object_index::store_eds, 0, DomainContents::Bytes(text.begin(), text.end()));
}

std::vector<SheetDevice::IndexRange> SheetDevice::without_behaviour() const {
  std::vector<IndexRange> ranges;
  for (const ObjectRow& row : device_.tables().objects) {
    const bool is_one = std::ranges::any_of(
        of_an_application, [&row](const IndexRange& range) { return range.contains(row.index); });
    if (!is_one) continue;
    if (!ranges.empty() && ranges.back().last + 1 == row.index) {
      ranges.back().last = row.index;
    } else {
      ranges.push_back({row.index, row.index});
    }
  }
  return ranges;
}

}  // namespace canvoy::formats
