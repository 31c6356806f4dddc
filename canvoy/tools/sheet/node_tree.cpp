#include "canvoy/tools/sheet/node_tree.hpp"

#include <algorithm>
#include <iterator>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"

namespace canvoy::tools {

namespace {

std::string small(std::string_view text) {
  std::string made(text);
  for (char& each : made) each = each >= 'A' && each <= 'Z' ? static_cast<char>(each + 32) : each;
  return made;
}

/// Parameter and mapping of a PDO are written together; other objects separately.
std::uint16_t written_with(std::uint16_t index) {
  constexpr unsigned mapping_bit = 0x0200;  // 1600h beside 1400h, 1A00h beside 1800h
  const bool is_of_pdo =
      index >= object_index::rpdo_parameter && index <= object_index::tpdo_mapping_last;
  return static_cast<std::uint16_t>(is_of_pdo ? index & ~mapping_bit : index);
}

}  // namespace

NodeTree::NodeTree(Session& session, NodeId node, formats::DataSheet sheet)
    : session_(session),
      node_(node),
      sheet_(std::move(sheet)),
      profile_(std::make_unique<decoder::SheetProfile>(sheet_)) {
  network_.set_sheet(node_, profile_->sheet());
  // The sheet was just made from these values.
  const auto put = [this](std::uint16_t index, std::uint8_t sub, const formats::SheetEntry& entry) {
    const auto type = formats::sheet_type(entry.data_type);
    if (entry.value.empty() || !type) return;
    if (auto bytes = formats::sheet_bytes(*type, entry.value, node_))
      learn({index, sub}, {*std::move(bytes), {}, {}, true});
  };
  for (const auto& [index, object] : sheet_.objects) {
    if (object.is_variable()) put(index, 0, object.own);
    for (const auto& [sub, entry] : object.subs) put(index, sub, entry);
  }
}

std::string NodeTree::name_of(const Place& place) const {
  const ObjectInfo* object = find_description(profile_->profile(), place.index);
  const EntryInfo* info = object == nullptr ? nullptr : find_entry(*object, place.sub);
  return text::object_name_text({.index = place.index,
                                 .sub = place.sub,
                                 .profile = &profile_->profile(),
                                 .object = object,
                                 .entry = info});
}

std::vector<NodeTree::Row> NodeTree::rows(const std::string& search) const {
  std::vector<Row> rows;
  const std::string wanted = small(search);
  const auto is_found = [&](const Row& row) {
    return wanted.empty() || small(row.name).find(wanted) != std::string::npos ||
           small(text::object_text(row.place.index, row.place.sub)).find(wanted) !=
               std::string::npos ||
           small(value(row)).find(wanted) != std::string::npos;
  };
  for (const auto& [index, object] : sheet_.objects) {
    if (object.is_variable()) {
      Row row{.place = {index, 0}, .name = name_of({index, 0})};
      if (is_found(row)) rows.push_back(std::move(row));
      continue;
    }
    // A search covers all of them.
    const bool is_open = open_.contains(index) || !wanted.empty();
    const ObjectInfo* described = find_description(profile_->profile(), index);
    const std::string name =
        described == nullptr ? text::object_text(index, 0) : name_of({index, 0});
    Row folder{.place = {index, 0},
               .is_folder = true,
               .is_open = is_open,
               .name = name.substr(0, name.find(", "))};
    // A found object is shown with all of its entries, and an entry with its object.
    const bool is_whole = is_found(folder);
    const std::size_t place = rows.size();
    rows.push_back(std::move(folder));
    if (!is_open) continue;
    for (const auto& [sub, entry] : object.subs) {
      std::string own = name_of({index, sub});
      const std::size_t comma = own.find(", ");
      if (comma != std::string::npos) own.erase(0, comma + 2);
      Row row{.place = {index, sub}, .depth = 1, .name = std::move(own)};
      if (is_whole || is_found(row)) rows.push_back(std::move(row));
    }
    if (!is_whole && rows.size() == place + 1) rows.pop_back();
  }
  return rows;
}

void NodeTree::toggle(const Row& row) {
  if (!open_.erase(row.place.index)) open_.insert(row.place.index);
}

const EntryInfo* NodeTree::described(const Place& place) {
  const ObjectInfo* object = find_description(profile_->profile(), place.index);
  const EntryInfo* plain = object == nullptr ? nullptr : find_entry(*object, place.sub);
  return plain == nullptr
             ? nullptr
             : network_.as_told(node_, profile_->profile(), plain, place.index, place.sub);
}

std::string NodeTree::text_of(const Place& place, std::span<const std::uint8_t> bytes) const {
  const ObjectInfo* object = find_description(profile_->profile(), place.index);
  const EntryInfo* plain = object == nullptr ? nullptr : find_entry(*object, place.sub);
  const EntryInfo* told = plain == nullptr ? nullptr
                                           : network_.as_told(node_, profile_->profile(), plain,
                                                              place.index, place.sub);
  return text::value_text(told, bytes);
}

std::string NodeTree::value(const Row& row) const {
  if (row.is_folder) return row.is_open ? "" : "...";
  const auto found = known_.find(row.place);
  if (found == known_.end() || !found->second.is_read) return "";
  return found->second.fault.empty() ? text_of(row.place, found->second.bytes)
                                     : found->second.fault;
}

std::string NodeTree::json(const Row& row) const {
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("node").number(std::int64_t{node_});
  append_index(json, row.place.index, row.place.sub);
  json.key("name").text(name_of(row.place));
  const auto found = known_.find(row.place);
  if (found != known_.end() && found->second.fault.empty()) {
    const ObjectInfo* object = find_description(profile_->profile(), row.place.index);
    const EntryInfo* plain = object == nullptr ? nullptr : find_entry(*object, row.place.sub);
    const EntryInfo* told = plain == nullptr ? nullptr
                                             : network_.as_told(node_, profile_->profile(), plain,
                                                                row.place.index, row.place.sub);
    json.key("raw").hex(found->second.bytes);
    json.key("value");
    text::append_value_json(line, told, found->second.bytes);
    if (told != nullptr && told->value.unit != Unit::none)
      json.key("unit").text(symbol(told->value.unit));
  }
  json.end_object();
  return line;
}

bool NodeTree::has_changed(const Row& row) const {
  constexpr Duration span = 2s;
  const auto found = known_.find(row.place);
  return found != known_.end() && found->second.changed != Time{} &&
         session_.loop().now() - found->second.changed < span;
}

bool NodeTree::is_writable(const Row& row) const {
  const formats::SheetEntry* said = entry(row);
  return !row.is_folder && said != nullptr && formats::is_writable(*said);
}

void NodeTree::learn(const Place& place, Known known) {
  Known& before = known_[place];
  const bool is_other =
      before.is_read && (before.bytes != known.bytes || before.fault != known.fault);
  known.changed = is_other ? session_.loop().now() : before.changed;
  known.is_read = true;
  if (known.fault.empty()) network_.learn(node_, place.index, place.sub, known.bytes);
  before = std::move(known);
}

bool NodeTree::refresh(const Row& row) {
  const formats::SheetEntry* said = entry(row);
  if (row.is_folder || said == nullptr || said->access == "wo") return false;
  if (said->data_type == static_cast<unsigned>(DataType::domain)) {
    learn(row.place, {{}, "a domain", {}, true});
    return false;
  }
  const auto answer = session_.try_read(node_, row.place.index, row.place.sub);
  if (answer) {
    learn(row.place, {*answer, {}, {}, true});
  } else {
    learn(row.place, {{}, text::abort_text(answer.abort()), {}, true});
  }
  return true;
}

void NodeTree::write(const Row& row, const std::string& text) {
  const EntryInfo* info = described(row.place);
  session_.write(node_, row.place.index, row.place.sub,
                 parse_value(info == nullptr ? EntryInfo{} : *info, text));
  refresh(row);
}

formats::DataSheet NodeTree::sheet() const {
  formats::DataSheet made = sheet_;
  for (auto& [index, object] : made.objects) {
    const auto put = [&, this](std::uint8_t sub, formats::SheetEntry& entry) {
      const auto found = known_.find({index, sub});
      const auto type = formats::sheet_type(entry.data_type);
      if (found == known_.end() || !found->second.fault.empty() || !type) return;
      entry.value = formats::sheet_value_text(*type, found->second.bytes).value_or(entry.value);
    };
    if (object.is_variable()) put(0, object.own);
    for (auto& [sub, entry] : object.subs) put(sub, entry);
  }
  return made;
}

NodeTree::Comparison NodeTree::compare(const std::string& path) {
  const std::vector<ConfigurationEntry> written = read_configuration(path, node_).entries;
  Comparison made;
  std::set<std::uint16_t> changed;
  for (const ConfigurationEntry& wanted : final_entries(written)) {
    const Place place{wanted.index, wanted.sub};
    const auto answer = session_.try_read(node_, wanted.index, wanted.sub);
    if (answer && std::ranges::equal(*answer, wanted.value)) continue;
    changed.insert(written_with(wanted.index));
    made.differences.push_back({place, name_of(place),
                                answer ? text_of(place, *answer) : text::abort_text(answer.abort()),
                                text_of(place, wanted.value)});
  }
  std::ranges::copy_if(written, std::back_inserter(made.steps), [&](const auto& entry) {
    return changed.contains(written_with(entry.index));
  });
  return made;
}

void NodeTree::write(const ConfigurationEntry& step) {
  session_.write(node_, step.index, step.sub, step.value);
  refresh({.place = {step.index, step.sub}, .name = {}});
}

}  // namespace canvoy::tools
