#include "canvoy/tools/sheet/described_nodes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/eds_export.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/sheet/world_nodes.hpp"

namespace canvoy::tools {

namespace {

bool is_file(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_regular_file(path, none);
}

DescribedNode of_file(const std::string& path, NodeId id) {
  formats::Findings findings;
  DescribedNode node = {.id = id, .sheet = read_sheet_file(path, findings)};
  if (node.id == 0) node.id = std::max<NodeId>(1, node.sheet.node_id());
  node.name = formats::plain_text(node.sheet.text("DeviceComissioning", "NodeName"));
  if (node.name.empty())
    node.name = formats::plain_text(node.sheet.text("DeviceInfo", "ProductName"));
  if (node.name.empty()) node.name = std::filesystem::path(path).stem().string();
  return node;
}

/// Node-ID of its first virtual device; 1 if it has none.
NodeId usual_node_id(const std::string& name) {
  if (const DeviceKind* kind = find_any_device_kind(name)) return kind->info.node_id;
  const SharedNode shared = parse_shared_node(name);
  if (!shared.car.empty()) return shared.car.front()->info.node_id;
  return shared.bus.empty() ? NodeId{1} : shared.bus.front()->info.node_id;
}

DescribedNode of_word(const std::string& word, NodeId id) {
  if (is_file(word)) return of_file(word, id);
  if (is_device_name(word)) return describe_device(word, id);
  throw UsageError(
      fmt::format("'{}' is neither a file nor a device (canvoy device --list): name a data sheet, "
                  "a device or a "
                  "network file{}",
                  word, did_you_mean(word, all_device_names())));
}

/// A table of a network file that is a node: with a sheet, or a device of the catalogue.
std::optional<DescribedNode> of_table(const toml::table& table, const std::string& device,
                                      const std::filesystem::path& folder,
                                      const std::string& path) {
  const auto id = table["id"].value<std::int64_t>();
  const auto sheet = table["sheet"].value<std::string>();
  const std::string kind = table["device"].value_or(device);
  if (!id || (!sheet && find_any_device_kind(kind) == nullptr)) return std::nullopt;
  if (*id < 1 || *id > node_id_max) {
    throw Failure(fmt::format("{} line {}: id: {} is no node-ID: 1 to 127", path,
                              table.source().begin.line, *id));
  }
  const auto node_id = static_cast<NodeId>(*id);
  DescribedNode node =
      sheet ? of_file((folder / *sheet).string(), node_id) : describe_device(kind, node_id);
  node.bus = table["bus"].value_or(std::string());
  node.name = table["name"].value_or(node.name);
  return node;
}

std::vector<DescribedNode> of_network(const std::string& path) {
  const toml::table file = parse_toml_file(path);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::vector<DescribedNode> nodes;
  const auto add = [&](const toml::table& table, const std::string& name) {
    if (auto node = of_table(table, name, folder, path)) nodes.push_back(*std::move(node));
  };
  for (const auto& [key, value] : file) {
    const std::string name(key.str());
    if (const toml::table* table = value.as_table()) add(*table, name);
    const toml::array* array = name == "node" ? value.as_array() : nullptr;
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
      if (const toml::table* table = array->get_as<toml::table>(i)) add(*table, {});
    }
  }
  if (nodes.empty()) nodes = describe_world(path);
  if (!nodes.empty()) return nodes;
  throw Failure(fmt::format(
      "{}: no node stands in it with its id, and a device of the catalogue or a sheet = \"FILE\"",
      path));
}

}  // namespace

bool is_device_name(const std::string& name) {
  return find_any_device_kind(name) != nullptr || !parse_shared_node(name).empty();
}

DescribedNode describe_device(const std::string& name, NodeId id) {
  if (id == 0) id = usual_node_id(name);
  ExportOptions options;
  options.what = name;
  options.node_id = id;
  return {.name = name, .id = id, .sheet = export_sheet(options)};
}

std::vector<DescribedNode> describe_nodes(const std::string& text) {
  if (text.ends_with(".toml")) return of_network(text);
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || is_file(text)) return {of_word(text, 0)};
  return {of_word(text.substr(sign + 1), parse_node_id(text.substr(0, sign)))};
}

void tell_apart(std::vector<DescribedNode>& nodes) {
  std::set<std::pair<std::string, NodeId>> ids;
  for (const DescribedNode& node : nodes) {
    if (ids.insert({node.bus, node.id}).second) continue;
    throw UsageError(
        fmt::format("two nodes have node-ID {}: say which is which, 5=charger", node.id));
  }
  std::multiset<std::string> names;
  for (const DescribedNode& node : nodes) names.insert(node.name);
  for (DescribedNode& node : nodes) {
    if (names.count(node.name) > 1) node.name += fmt::format(" {}", node.id);
  }
}

}  // namespace canvoy::tools
