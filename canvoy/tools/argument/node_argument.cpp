#include "canvoy/tools/argument/node_argument.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/toml_file.hpp"

namespace canvoy::tools {

namespace {

std::optional<NodeId> node_number(std::string_view digits, int base) {
  unsigned id = 0;
  const char* last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, id, base);
  if (error != std::errc{} || end != last || !is_node_id(id)) return std::nullopt;
  return static_cast<NodeId>(id);
}

/// `10`, `0x0A`, `0Ah`
std::optional<NodeId> plain_node_id(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) return node_number(text.substr(2), 16);
  if (text.ends_with('h') || text.ends_with('H')) {
    text.remove_suffix(1);
    return node_number(text, 16);
  }
  return node_number(text, 10);
}

/// The names of the network, and their source.
struct NodeNameFile {
  std::string path = [] {
    const char* given = std::getenv("CANVOY_NETWORK");
    return std::string(given == nullptr ? "" : given);
  }();
  std::optional<std::vector<NamedNode>> nodes = std::nullopt;
};
NodeNameFile& node_name_file() {
  static NodeNameFile file;
  return file;
}

std::optional<NodeId> id_in(const toml::table& table) {
  for (const char* key : {"node", "id", "node-id"}) {
    const auto id = table[key].value<std::int64_t>();
    if (id && *id > 0 && is_node_id(static_cast<unsigned>(*id))) return static_cast<NodeId>(*id);
  }
  return std::nullopt;
}

std::string name_in(const toml::table& table, std::string_view key) {
  for (const char* named : {"name", "device"}) {
    if (const auto name = table[named].value<std::string>()) return *name;
  }
  return std::string(key);
}

void collect_nodes(const toml::table& table, std::vector<NamedNode>& nodes) {
  for (const auto& [key, node] : table) {
    const auto add = [&nodes, name = std::string_view(key.str())](const toml::table& part) {
      if (const auto id = id_in(part)) nodes.push_back({name_in(part, name), *id});
      collect_nodes(part, nodes);
    };
    if (const toml::table* part = node.as_table()) add(*part);
    if (const toml::array* parts = node.as_array()) {
      for (const toml::node& part : *parts) {
        if (part.is_table()) add(*part.as_table());
      }
    }
  }
}

[[noreturn]] void refuse_node(std::string_view text, const std::vector<NamedNode>& nodes) {
  std::vector<std::string> names;
  names.reserve(nodes.size());
  for (const NamedNode& node : nodes) names.push_back(node.name);
  const std::string advice = nodes.empty() ? ", or --network FILE with its name"
                                           : fmt::format(", or a name: {}", choices_text(nodes));
  throw UsageError(fmt::format("'{}' is no node-ID: give 1 to 127, as 10 or 0Ah{}{}", text, advice,
                               did_you_mean(text, names)));
}

template <class Is>
std::vector<NamedNode> nodes_where(const Is& is) {
  std::vector<NamedNode> found;
  for (const NamedNode& node : named_nodes()) {
    const auto is_same = [&node](const NamedNode& other) { return other.id == node.id; };
    if (is(node.name) && std::ranges::none_of(found, is_same)) found.push_back(node);
  }
  return found;
}

}  // namespace

std::optional<NodeId> find_node_id(std::string_view text) {
  constexpr std::string_view word = "node ";
  if (text.starts_with(word)) text.remove_prefix(word.size());
  const std::size_t bracket = text.find(" (");
  if (bracket == std::string_view::npos || !text.ends_with(')')) return plain_node_id(text);
  const auto id = plain_node_id(text.substr(0, bracket));
  const std::string_view again = text.substr(bracket + 2, text.size() - bracket - 3);
  return id == plain_node_id(again) ? id : std::nullopt;
}

std::vector<NamedNode> nodes_called(std::string_view text) {
  auto found = nodes_where([text](std::string_view name) { return same_name(name, text); });
  const std::string part = plain_name(text);
  if (!found.empty() || part.empty()) return found;
  return nodes_where([&part](std::string_view name) { return has_name(plain_name(name), part); });
}

bool names_node(std::string_view text) {
  return find_node_id(text).has_value() || !nodes_called(text).empty();
}

std::string choices_text(const std::vector<NamedNode>& nodes) {
  constexpr std::size_t shown_max = 8;
  std::vector<std::string> choices;
  for (const NamedNode& node : nodes) {
    if (choices.size() == shown_max) break;
    choices.push_back(fmt::format("{}: {}", node.name, text::node_text(node.id)));
  }
  const std::size_t hidden = nodes.size() - choices.size();
  return fmt::format("{}{}", fmt::join(choices, ", "),
                     hidden == 0 ? "" : fmt::format(" and {} more", hidden));
}

std::vector<NamedNode> read_named_nodes(const std::string& path) {
  std::vector<NamedNode> nodes;
  collect_nodes(parse_toml_file(path), nodes);
  return nodes;
}

void use_network_file(const std::string& path) {
  node_name_file() = {path, std::nullopt};
}

const std::vector<NamedNode>& named_nodes() {
  NodeNameFile& file = node_name_file();
  if (!file.nodes) {
    file.nodes = file.path.empty() ? std::vector<NamedNode>{} : read_named_nodes(file.path);
  }
  return *file.nodes;
}

NodeId parse_node_id(std::string_view text) {
  if (const auto id = find_node_id(text)) return *id;
  const std::vector<NamedNode> found = nodes_called(text);
  if (found.empty()) refuse_node(text, named_nodes());
  if (found.size() == 1) return found.front().id;
  throw UsageError(fmt::format("'{}' is several: {}; give the number", text, choices_text(found)));
}

}  // namespace canvoy::tools
