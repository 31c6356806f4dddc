// canvoy scan BUS: finds the nodes on a bus by listening, by SDO and by LSS.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/session/node_sweep.hpp"
#include "canvoy/tools/sheet/network_text.hpp"
#include "canvoy/tools/sheet/node_reader.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"

namespace canvoy::tools {

namespace {

struct ScanOptions {
  std::string bus;
  std::string listen = "1100ms";
  std::string out;
  std::string time_out = "100ms";
  bool no_lss = false;
  bool json = false;
};

/// Identity of a node, from 1018h and 1008h.
struct Identified {
  std::array<std::optional<std::uint32_t>, 4> identity{};
  std::string name{};
};

struct ScannedNode {
  NodeSweep::Found found;
  Identified is;
  std::string profile;
  std::string virtual_devices;
};

/// Meaning of the bits of a device type beside the profile number.
std::string device_type_words(std::uint32_t device_type) {
  const Profile* profile = find_profile(device_type);
  if (profile == nullptr || profile->device_type.size() < 2) return {};  // the number alone
  const EntryInfo entry = {.type = DataType::unsigned32,
                           .value = {.notation = Notation::hexadecimal},
                           .fields = profile->device_type};
  std::array<std::uint8_t, 4> bytes{};
  store(bytes.data(), device_type);
  return text::value_text(&entry, bytes);
}

class BusScan {
 public:
  explicit BusScan(const ScanOptions& options)
      : options_(options), session_(options.bus), sweep_(session_) {}

  /// Sends all requests while listening, which takes longer.
  std::vector<ScannedNode> run() {
    const Duration time_out = parse_duration_argument(options_.time_out);
    const Time end = session_.loop().now() + parse_duration_argument(options_.listen);
    ask(time_out, end);
    std::vector<ScannedNode> nodes;
    for (const NodeSweep::Found& found : sweep_.found()) nodes.push_back(examine(found));
    return nodes;
  }
  bool has_unconfigured() const { return sweep_.has_unconfigured(); }

  formats::DataSheet sheet_of(NodeId node, const std::string& path) {
    return NodeReader(session_, node, {.bus = options_.bus, .out = path}).read();
  }

 private:
  void ask(Duration time_out, Time end) {
    try {
      if (!options_.no_lss) sweep_.ask_unconfigured();
      sweep_.ask_all();
      sweep_.listen_until(session_.loop().now() + time_out);
      for (const NodeSweep::Found& found : sweep_.found()) {
        if (found.answers) identified(found.id);
      }
      sweep_.listen_until(end);
      // For nodes that have come up meanwhile, or were busy.
      if (sweep_.ask_silent()) sweep_.listen_until(session_.loop().now() + time_out);
    } catch (const Failure&) {
      if (session_.loop().signal() != 0) throw;
      // Nodes that cannot be read may still be heard.
      sweep_.listen_until(end);
      if (sweep_.found().empty()) throw;
    }
  }

  /// Identity of a node, read once.
  const Identified& identified(NodeId id) {
    const auto [place, is_new] = identified_.try_emplace(id);
    Identified& node = place->second;
    if (!is_new) return node;
    try {
      std::uint8_t sub = 0;
      for (std::optional<std::uint32_t>& part : node.identity) {
        const auto answer = session_.try_read(id, object_index::identity, ++sub);
        if (answer) part = static_cast<std::uint32_t>(load_unsigned(*answer));
      }
      const auto name = session_.try_read(id, object_index::device_name, 0);
      if (name)
        node.name = formats::plain_text(
            formats::sheet_value_text(DataType::visible_string, *name).value_or(""));
    } catch (const Failure&) {
      // The node has fallen silent: what is known of it is reported.
      if (session_.loop().signal() != 0) throw;
    }
    return node;
  }

  ScannedNode examine(const NodeSweep::Found& found) {
    ScannedNode node = {.found = found, .is = {}, .profile = {}, .virtual_devices = {}};
    if (!found.answers) return node;
    node.is = identified(found.id);
    if (!found.device_type) return node;
    const Profile* profile = find_profile(*found.device_type);
    const unsigned number = *found.device_type & 0xFFFFU;
    node.profile = profile != nullptr ? std::string(short_name(*profile))
                   : number == 0      ? ""
                                      : fmt::format("{}", number);
    node.virtual_devices = device_type_words(*found.device_type);
    return node;
  }

  const ScanOptions& options_;
  Session session_;
  NodeSweep sweep_;
  std::map<NodeId, Identified> identified_;
};

std::string hex_or_blank(const std::optional<std::uint32_t>& number) {
  return number ? fmt::format("{:08X}", *number) : "-";
}

std::string state_words(const NodeSweep::Found& found) {
  if (found.state) return std::string(text::nmt_state_text(*found.state));
  return found.is_heard ? "is heard" : "answers";
}

/// A row of the table; a name that has no room in the terminal stands in the next line.
void print_scanned(const std::array<std::string, 8>& cells, const std::string& name,
                   bool is_below) {
  std::string row;
  constexpr std::array<std::size_t, 8> widths = {5, 17, 10, 9, 10, 10, 10, 10};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row += fmt::format("{:<{}}", cells.at(i), widths.at(i));
  }
  if (!is_below) row += name;
  row.resize(row.find_last_not_of(' ') + 1);
  fmt::print("{}\n", row);
  if (is_below && !name.empty()) fmt::print("     {}\n", name);
}

void print_nodes(const std::vector<ScannedNode>& nodes) {
  constexpr std::size_t name_at = 81;
  const std::size_t width = terminal_width(STDOUT_FILENO);
  const bool is_below = width != 0 && std::ranges::any_of(nodes, [width](const ScannedNode& node) {
                          return name_at + node.is.name.size() > width;
                        });
  print_scanned({"node", "state", "1000h", "profile", "vendor", "product", "revision", "serial"},
                is_below ? "" : "name", is_below);
  for (const ScannedNode& node : nodes) {
    print_scanned({fmt::format("{}", node.found.id), state_words(node.found),
                   hex_or_blank(node.found.device_type), node.profile.empty() ? "-" : node.profile,
                   hex_or_blank(node.is.identity[0]), hex_or_blank(node.is.identity[1]),
                   hex_or_blank(node.is.identity[2]), hex_or_blank(node.is.identity[3])},
                  node.is.name, is_below);
    if (!node.virtual_devices.empty()) fmt::print("     {}\n", node.virtual_devices);
    if (!node.found.answers) fmt::print("     does not answer to SDO\n");
  }
}

void print_json(const std::vector<ScannedNode>& nodes, bool has_unconfigured) {
  constexpr std::array<std::string_view, 4> parts = {"vendor_id", "product_code", "revision",
                                                     "serial_number"};
  for (const ScannedNode& node : nodes) {
    std::string line;
    text::JsonLine json(line);
    json.begin_object();
    json.key("node").number(std::int64_t{node.found.id});
    if (node.found.state) json.key("state").text(text::nmt_state_text(*node.found.state));
    line += fmt::format(R"(,"heard":{},"answers":{})", node.found.is_heard, node.found.answers);
    if (node.found.device_type) json.key("device_type").text(hex_or_blank(node.found.device_type));
    if (!node.profile.empty()) json.key("profile").text(node.profile);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (node.is.identity.at(i)) json.key(parts.at(i)).text(hex_or_blank(node.is.identity.at(i)));
    }
    if (!node.is.name.empty()) json.key("name").text(node.is.name);
    if (!node.virtual_devices.empty()) json.key("text").text(node.virtual_devices);
    json.end_object();
    fmt::print("{}\n", line);
  }
  fmt::print("{{\"nodes\":{},\"unconfigured\":{}}}\n", nodes.size(), has_unconfigured);
}

/// The network, and a DCF of each node beside it.
void write_network(BusScan& scan, const ScanOptions& options,
                   const std::vector<ScannedNode>& nodes) {
  const std::filesystem::path folder = std::filesystem::path(options.out).parent_path();
  std::string text = fmt::format("# What was on {} at {:%Y-%m-%d %H:%M:%S} UTC.\n", options.bus,
                                 fmt::gmtime(std::chrono::system_clock::now()));
  for (const ScannedNode& node : nodes) {
    text += fmt::format("\n[[node]]\nbus = {}\nid = {}\n", text_value(options.bus), node.found.id);
    if (!node.is.name.empty()) text += fmt::format("name = {}\n", text_value(node.is.name));
    if (node.found.device_type)
      text += fmt::format("device_type = 0x{:08X}\n", *node.found.device_type);
    if (!node.found.answers) continue;
    const std::string file = fmt::format("node{}.dcf", node.found.id);
    const std::string path = (folder / file).string();
    const std::string sheet = sheet_text(scan.sheet_of(node.found.id, path), path);
    write_value_file(path, {reinterpret_cast<const std::uint8_t*>(sheet.data()), sheet.size()});
    text += fmt::format("sheet = {}\n", text_value(file));
  }
  write_value_file(options.out, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

int scan_bus(const ScanOptions& options) {
  parse_duration_argument(options.listen);
  BusScan scan(options);
  const std::vector<ScannedNode> nodes = scan.run();
  if (!options.out.empty()) write_network(scan, options, nodes);
  const bool has_unconfigured = scan.has_unconfigured();
  if (options.json) {
    print_json(nodes, has_unconfigured);
  } else {
    if (!nodes.empty()) print_nodes(nodes);
    fmt::print("{} node{}\n", nodes.size(), nodes.size() == 1 ? "" : "s");
    if (has_unconfigured) {
      fmt::print("there are devices without a node-ID: canvoy lss {} scan\n", options.bus);
    }
    if (!options.out.empty())
      fmt::print("written to {}, and a DCF for each that answers\n", options.out);
  }
  return nodes.empty() && !has_unconfigured ? exit_failed : exit_done;
}

}  // namespace

void add_scan(Verb& app) {
  const auto options = std::make_shared<ScanOptions>();
  Verb& command = app.add_verb("scan", "Say who is on a bus, and write it down");
  command.add({
      {"bus", options->bus, bus_text, required},
      {"--listen", options->listen, "for so long in all, while nodes are asked (default 1100ms)"},
      {"--timeout", options->time_out, "for the last answers, at least: 500ms, 2s (default 100ms)"},
      {"--no-lss", options->no_lss, "do not ask for devices without a node-ID"},
      {"--out",
       options->out,
       "write the network into this file (.toml), and a DCF for each node beside it",
       {.allowed =
            [](const std::string& path) {
              return path.ends_with(".toml") ? std::string() : path + ": name it .toml";
            }}},
      {"--json", options->json, "one JSON object for each node, and one at the end"},
  });
  command.set_footer(
      "Nobody is changed by it: it listens, reads 1000h, 1008h and 1018h, and asks by LSS whether\n"
      "anybody has no node-ID. The exit status is 1 where nobody is there.\n"
      "Examples:\n"
      "  canvoy scan can0\n"
      "  canvoy scan can0 --out network.toml\n"
      "  canvoy scan udp:239.74.163.2:43113 --listen 5s --json");
  command.runs([options] { return scan_bus(*options); });
}

}  // namespace canvoy::tools
