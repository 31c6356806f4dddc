#include "canvoy/text/object_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "canvoy/formats/terms.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

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

}  // namespace canvoy::text
