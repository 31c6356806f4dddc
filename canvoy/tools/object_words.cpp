#include "canvoy/tools/object_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

#include "canvoy/formats/terms.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/value.hpp"

namespace canvoy::tools {

namespace {

using decoder::DecodedValue;
using decoder::Mark;
using decoder::Marks;

std::vector<std::string_view> names_of(Marks marks) {
  std::vector<std::string_view> names;
  for (const Mark mark : decoder::all_marks) {
    if (marks.has(mark)) names.push_back(decoder::mark_name(mark));
  }
  return names;
}

std::string raw_text(const DecodedValue& value) {
  return fmt::format("{:02X}", fmt::join(value.bytes(), ""));
}

}  // namespace

std::string object_name_text(const DecodedValue& value) {
  if (value.object == nullptr) return object_text(value.index, value.sub);
  std::string object = formats::object_name(*value.profile, *value.object, value.index);
  if (value.entry == nullptr) return fmt::format("{}:{:02X}h", object, value.sub);
  if (value.entry->name.empty()) return object;
  return object + ", " + formats::entry_name(*value.object, *value.entry, value.sub);
}

std::string marks_text(Marks marks) {
  return fmt::format("{}", fmt::join(names_of(marks), ", "));
}

nlohmann::ordered_json values_json(std::span<const DecodedValue> values) {
  auto list = nlohmann::ordered_json::array();
  for (const DecodedValue& value : values) {
    nlohmann::ordered_json item = {{"object", fmt::format("{:04X}", value.index)},
                                   {"sub", fmt::format("{:02X}", value.sub)}};
    if (value.object != nullptr) item["name"] = object_name_text(value);
    item["raw"] = raw_text(value);
    item["value"] = value_json(value.entry, value.bytes());
    const bool has_unit = value.entry != nullptr && value.entry->value.unit != Unit::none;
    if (has_unit) item["unit"] = symbol(value.entry->value.unit);
    if (!value.marks.empty()) item["marks"] = marks_json(value.marks);
    list.push_back(std::move(item));
  }
  return list;
}

nlohmann::ordered_json marks_json(Marks marks) {
  return names_of(marks);
}

}  // namespace canvoy::tools
