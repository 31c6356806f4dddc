#include "canvoy/tools/session/unknown_nodes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

/// TPDOs of the nodes in the pre-defined connection set (CiA 301, 7.3.3).
constexpr bool is_predefined_tpdo(std::uint32_t can_id) {
  constexpr std::uint32_t transmit_bit = 0x80;
  return can_id > can_id::tpdo1 && can_id < can_id::sdo_response && (can_id & transmit_bit) != 0 &&
         (can_id & node_id_max) != 0;
}

class PdoQuestions {
 public:
  PdoQuestions(Session& session, NodeId node) : session_(session), node_(node) {}

  /// Reads PDO parameters from `parameter` on, until several consecutive ones are missing.
  void ask(std::uint16_t parameter, std::uint16_t mapping) {
    constexpr unsigned missing_max = 4;
    constexpr unsigned pdos_max = 512;
    unsigned missing = 0;
    for (std::uint16_t i = 0; i < pdos_max && missing < missing_max; ++i) {
      const auto cob_id = number(static_cast<std::uint16_t>(parameter + i), 1);
      missing = cob_id ? 0 : missing + 1;
      if (cob_id && CobId{*cob_id}.valid()) ask_mapping(static_cast<std::uint16_t>(mapping + i));
    }
  }
  std::optional<std::uint32_t> number(std::uint16_t index, std::uint8_t sub) {
    const auto answer = session_.try_read(node_, index, sub);
    if (!answer) return std::nullopt;
    return static_cast<std::uint32_t>(load_unsigned(*answer));
  }

 private:
  void ask_mapping(std::uint16_t index) {
    const auto count = number(index, 0);
    if (!count || *count > pdo_bits_max) return;
    for (std::uint8_t sub = 1; sub <= *count; ++sub) number(index, sub);
  }

  Session& session_;
  NodeId node_;
};

}  // namespace

NodeId sender_of(const Frame& frame) {
  if (frame.is_remote() || frame.is_error() || frame.is_extended()) return 0;
  const std::uint32_t id = frame.id;
  const bool is_of_node = (id > can_id::emergency && id < can_id::time) || is_predefined_tpdo(id) ||
                          (id > can_id::sdo_response && id < can_id::sdo_request) ||
                          (id > can_id::error_control && id <= can_id::error_control + node_id_max);
  return is_of_node ? static_cast<NodeId>(id & node_id_max) : NodeId{0};
}

void UnknownNodes::hear(std::string_view bus, const Frame& frame, const text::FrameWords& words) {
  const NodeId node = sender_of(frame);
  if (!is_node_id(node)) return;
  auto found = buses_.find(bus);
  if (found == buses_.end()) {
    if (buses_.size() == buses_max) return;
    found = buses_.emplace(bus, Bus{}).first;
  }
  found->second.heard[node] = true;
  if (!is_predefined_tpdo(frame.id) || frame.length == 0) return;
  if (!words.values.empty()) {
    found->second.unknown[node] = false;
  } else if (words.service.find("PDO") != std::string_view::npos) {
    found->second.unknown[node] = true;
  }
}

std::vector<NodeOnBus> UnknownNodes::unknown() const {
  std::vector<NodeOnBus> nodes;
  for (const auto& [name, bus] : buses_) {
    for (NodeId id = 1; id <= node_id_max; ++id) {
      if (bus.unknown[id]) nodes.push_back({name, id});
    }
  }
  return nodes;
}

std::optional<NodeOnBus> UnknownNodes::next_unasked() {
  for (auto& [name, bus] : buses_) {
    for (NodeId id = 1; id <= node_id_max; ++id) {
      if (!bus.heard[id] || bus.asked[id]) continue;
      bus.asked[id] = true;
      return NodeOnBus{name, id};
    }
  }
  return std::nullopt;
}

bool UnknownNodes::is_on_several(NodeId id) const {
  return std::ranges::count_if(buses_, [id](const auto& bus) { return bus.second.heard[id]; }) > 1;
}

/// In the form of --node and --eds: `10`, or `can1:10`.
std::string UnknownNodes::option(const NodeOnBus& node) const {
  const std::string id = fmt::format("{}", node.id);
  return is_on_several(node.id) ? formats::plain_text(node.bus) + ':' + id : id;
}

std::string UnknownNodes::next_untold() {
  for (auto& [name, bus] : buses_) {
    const Nodes untold = bus.unknown & ~bus.told;
    for (NodeId id = 1; untold.any() && id <= node_id_max; ++id) {
      if (!untold[id]) continue;
      bus.told[id] = true;
      return how_to_know({name, id});
    }
  }
  return {};
}

std::string UnknownNodes::how_to_know(const NodeOnBus& node) const {
  const std::string own = option(node);
  const std::string on =
      is_on_several(node.id) ? " on " + formats::plain_text(node.bus) : std::string();
  return fmt::format(
      "{}{} sends PDOs, and it is not known what they carry: say its profile, --node {}=418, or "
      "a data sheet, --eds {}=FILE, or have it asked, --ask",
      text::node_text(node.id), on, own, own);
}

std::string UnknownNodes::text() const {
  const std::vector<NodeOnBus> nodes = unknown();
  if (nodes.empty()) return {};
  std::vector<std::string> names;
  names.reserve(nodes.size());
  for (const NodeOnBus& node : nodes) names.push_back(option(node));
  return fmt::format(
      "not known: node{} {}. Say a profile, --node {}=418, or have them asked, --ask",
      names.size() == 1 ? "" : "s", fmt::join(names, ", "), names.front());
}

bool ask_node(Session& session, NodeId node) {
  PdoQuestions questions(session, node);
  try {
    questions.number(object_index::device_type, 0);
    for (std::uint8_t sub = 1; sub <= 4; ++sub) questions.number(object_index::identity, sub);
    questions.ask(object_index::tpdo_parameter, object_index::tpdo_mapping);
    questions.ask(object_index::rpdo_parameter, object_index::rpdo_mapping);
  } catch (const Failure&) {
    return false;
  }
  return true;
}

}  // namespace canvoy::tools
