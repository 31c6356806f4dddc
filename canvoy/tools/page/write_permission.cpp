#include "canvoy/tools/page/write_permission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

[[noreturn]] void refuse(std::string_view item) {
  throw UsageError(fmt::format(
      "--allow-write: '{}' is not understood: give all, or a list as nmt,1017,6000-67FF,10:6010",
      item));
}

unsigned parse_number(std::string_view digits, int base, unsigned most, std::string_view item) {
  unsigned number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number, base);
  if (error != std::errc{} || stop != end || number > most) refuse(item);
  return number;
}

}  // namespace

bool WritePermission::allows(NodeId node, std::uint16_t index) const {
  return std::ranges::any_of(ranges_, [&](const Range& range) {
    return (range.node == 0 || range.node == node) && index >= range.first && index <= range.last;
  });
}

WritePermission parse_write_permission(std::string_view text) {
  constexpr unsigned index_max = 0xFFFF;
  WritePermission permission;
  permission.text_ = text;
  while (!text.empty()) {
    const std::string_view item = text.substr(0, text.find(','));
    text.remove_prefix(std::min(item.size() + 1, text.size()));
    if (item == "nmt" || item == "all") permission.nmt_ = true;
    if (item == "all") permission.ranges_.push_back({0, 0, index_max});
    if (item == "nmt" || item == "all") continue;
    const std::size_t colon = item.find(':');
    WritePermission::Range range;
    if (colon != std::string_view::npos) {
      range.node = static_cast<NodeId>(parse_number(item.substr(0, colon), 10, node_id_max, item));
      if (range.node == 0) refuse(item);
    }
    const std::string_view indices = item.substr(colon == std::string_view::npos ? 0 : colon + 1);
    const std::size_t hyphen = std::min(indices.find('-'), indices.size());
    range.first =
        static_cast<std::uint16_t>(parse_number(indices.substr(0, hyphen), 16, index_max, item));
    range.last = range.first;
    if (hyphen < indices.size()) {
      range.last =
          static_cast<std::uint16_t>(parse_number(indices.substr(hyphen + 1), 16, index_max, item));
    }
    if (range.last < range.first) refuse(item);
    permission.ranges_.push_back(range);
  }
  return permission;
}

}  // namespace canvoy::tools
