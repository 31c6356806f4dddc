#include "canvoy/text/communication_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

std::string id_text(CobId cob_id) {
  return (cob_id.raw & CobId::extended) == 0 ? fmt::format("{:X}h", cob_id.can_id())
                                             : fmt::format("{:08X}h, of 29 bits", cob_id.can_id());
}

bool has(CobId cob_id, std::uint32_t bit) {
  return (cob_id.raw & bit) != 0;
}

std::string sync_text(CobId cob_id) {
  return id_text(cob_id) + (has(cob_id, CobId::bit30) ? ", sends SYNC" : ", sends no SYNC");
}

std::string time_text(CobId cob_id) {
  const std::string_view sends = has(cob_id, CobId::bit30) ? "sends TIME" : "sends no TIME";
  const std::string_view takes = has(cob_id, CobId::bit31) ? "takes it" : "does not take it";
  return fmt::format("{}, {}, {}", id_text(cob_id), sends, takes);
}

std::string used_text(CobId cob_id) {
  return id_text(cob_id) + (cob_id.valid() ? ", in use" : ", not in use");
}

std::string tpdo_text(CobId cob_id) {
  const bool is_on_request = !has(cob_id, CobId::bit30);
  return used_text(cob_id) + (is_on_request ? ", also on request" : "");
}

std::string heartbeat_text(std::uint32_t raw) {
  const std::uint32_t node = raw >> 16 & 0xFF;
  const std::uint32_t time_ms = raw & 0xFFFF;
  if (time_ms == 0 || !is_node_id(node)) return "none";
  return fmt::format("{}, within {} ms", node_text(static_cast<NodeId>(node)), time_ms);
}

std::string mapping_text(std::uint32_t raw) {
  const MappingValue mapped(raw);
  if (raw == 0) return "nothing";
  if (mapped.is_dummy()) return fmt::format("{} bits that nobody wants", mapped.bits);
  return fmt::format("{}, {} bit{}", object_text(mapped.index, mapped.sub), mapped.bits,
                     mapped.bits == 1 ? "" : "s");
}

/// A range of indices with one meaning, for sub-indices `first` to `last`.
struct Range {
  std::uint16_t from;
  std::uint16_t to;
  std::uint8_t first;
  std::uint8_t last;
  std::string (*text)(std::uint32_t raw);
};

template <std::string (*text)(CobId)>
std::string of_cob_id(std::uint32_t raw) {
  return text(CobId{raw});
}

constexpr std::array ranges = {
    Range{0x1005, 0x1005, 0, 0, of_cob_id<sync_text>},
    Range{0x1012, 0x1012, 0, 0, of_cob_id<time_text>},
    Range{0x1014, 0x1014, 0, 0, of_cob_id<used_text>},
    Range{0x1016, 0x1016, 1, 127, heartbeat_text},
    Range{0x1028, 0x1028, 1, 127, of_cob_id<used_text>},
    Range{0x1200, 0x12FF, 1, 2, of_cob_id<used_text>},
    Range{0x1400, 0x15FF, 1, 1, of_cob_id<used_text>},
    Range{0x1600, 0x17FF, 1, 64, mapping_text},
    Range{0x1800, 0x19FF, 1, 1, of_cob_id<tpdo_text>},
    Range{0x1A00, 0x1BFF, 1, 64, mapping_text},
};

}  // namespace

std::string communication_text(std::uint16_t index, std::uint8_t sub,
                               std::span<const std::uint8_t> bytes) {
  if (bytes.size() != sizeof(std::uint32_t)) return {};
  const auto* const found = std::ranges::find_if(ranges, [&](const Range& range) {
    return index >= range.from && index <= range.to && sub >= range.first && sub <= range.last;
  });
  if (found == ranges.end()) return {};
  return found->text(static_cast<std::uint32_t>(load_unsigned(bytes)));
}

}  // namespace canvoy::text
