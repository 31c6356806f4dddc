#include "canvoy/tools/filter/filter_tree.hpp"

#include <algorithm>

namespace canvoy::tools {

namespace {

bool has_node(const FilterFrame& frame, const FilterRanges& nodes) {
  return nodes.contains(frame.words.node) || nodes.contains(frame.words.client);
}

bool has_can_id(const Frame& frame, const FilterRanges& ids) {
  if (frame.is_error()) return false;
  return ids.contains(frame.is_extended() ? frame.id + filter_extended_id : frame.id);
}

bool has_one(std::string_view text, const std::vector<std::string>& names) {
  const std::string plain = plain_name(text);
  return std::ranges::any_of(names, [&](const std::string& name) { return has_name(plain, name); });
}

bool has_mark(decoder::Marks marks, const std::vector<decoder::Mark>& wanted) {
  if (wanted.empty()) return !marks.empty();
  return std::ranges::any_of(wanted, [marks](decoder::Mark mark) { return marks.has(mark); });
}

}  // namespace

bool FilterCondition::holds(const FilterFrame& frame) {
  switch (by) {
    case By::bus:
      return std::ranges::find(names, frame.bus) != names.end();
    case By::node:
      return has_node(frame, ranges);
    case By::can_id:
      return has_can_id(frame.frame, ranges);
    case By::service:
      return has_one(frame.words.service, names);
    case By::value:
      return value.holds(frame.words.values) ||
             (frame.words.about != nullptr && value.names(*frame.words.about));
    case By::text:
      return has_one(frame.words.text, names);
    case By::marks:
      return has_mark(frame.words.marks, marks);
    case By::time:
      return ranges.contains(frame.time.count());
    case By::since_first:
      return ranges.contains(frame.since_first.count());
  }
  return false;
}

}  // namespace canvoy::tools
