// canvoy export dbc|csv|html WHAT: dictionaries and messages of nodes, for tools without CANopen
// support.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <set>

#include "canvoy/formats/signals/dbc_writer.hpp"
#include "canvoy/formats/signals/signal_csv.hpp"
#include "canvoy/formats/signals/signal_html.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/signal_table_maker.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/bus_argument.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/session/node_sweep.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/sheet/described_nodes.hpp"
#include "canvoy/tools/sheet/node_reader.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

struct TableOptions {
  std::string format;
  std::vector<std::string> what;
  std::string bus;
  std::string out;
  std::string time_out = {};
  bool sdo = false;
};

/// `can0 10`, `can0 0Ah`, and with --network `can0 pump`.
bool is_node_on_bus(const std::vector<std::string>& what) {
  if (what.size() != 2 || is_device_name(what[0])) return false;
  // In `5=charger` a node-ID precedes the sign; in `udp:...?ttl=1` none does.
  const std::size_t sign = what[0].find('=');
  const bool is_of_node =
      sign != std::string::npos && names_node(std::string_view(what[0]).substr(0, sign));
  return !is_of_node && names_node(what[1]);
}

std::vector<DescribedNode> node_on_bus(const TableOptions& options) {
  const NodeId node = parse_node_id(options.what[1]);
  Session session(options.what[0], parse_answer_time(options.time_out));
  NodeReader reader(session, node, {.bus = options.what[0]});
  DescribedNode read = {.id = node, .sheet = reader.read()};
  read.name = read.sheet.text("DeviceInfo", "ProductName");
  if (read.name.empty()) read.name = fmt::format("node {}", node);
  return {read};
}

/// All nodes that answer, in sequence.
std::vector<DescribedNode> nodes_on_bus(const TableOptions& options) {
  const std::string& bus = options.what.front();
  const AnswerTime time_out = parse_answer_time(options.time_out);
  Session session(bus, time_out);
  NodeSweep sweep(session);
  sweep.ask_all();
  sweep.listen_until(session.loop().now() + time_out.usual);
  std::vector<DescribedNode> nodes;
  for (const auto& [id, is_heard, answers, state, device_type] : sweep.found()) {
    if (!answers) continue;
    if (::isatty(STDERR_FILENO) == 1) print_message(fmt::format("reads node {} ({:02X}h)", id, id));
    NodeReader reader(session, id, {.bus = bus});
    DescribedNode& node = nodes.emplace_back(DescribedNode{.id = id, .sheet = reader.read()});
    node.name = node.sheet.text("DeviceInfo", "ProductName");
    if (node.name.empty()) node.name = fmt::format("node {}", id);
  }
  if (nodes.empty()) {
    throw Failure(
        fmt::format("{}: no node answers within {}", bus, text::duration_text(time_out.usual)));
  }
  return nodes;
}

std::vector<DescribedNode> wanted_nodes(const TableOptions& options) {
  if (options.what.size() == 1 && names_bus(options.what.front())) return nodes_on_bus(options);
  if (is_node_on_bus(options.what)) return node_on_bus(options);
  std::vector<DescribedNode> nodes;
  for (const std::string& text : options.what) {
    for (DescribedNode& node : describe_nodes(text)) nodes.push_back(std::move(node));
  }
  return nodes;
}

/// A DBC describes one bus.
void choose_bus(std::vector<DescribedNode>& nodes, const std::string& bus) {
  std::set<std::string> buses;
  for (const DescribedNode& node : nodes) buses.insert(node.bus);
  if (bus.empty() && buses.size() > 1) {
    throw UsageError(fmt::format("there are several buses, and a table is of one: --bus {}",
                                 fmt::join(buses, ", ")));
  }
  if (bus.empty()) return;
  if (!buses.contains(bus))
    throw UsageError(fmt::format("--bus: there is no '{}': {}", bus, fmt::join(buses, ", ")));
  std::erase_if(nodes, [&bus](const DescribedNode& node) { return node.bus != bus; });
}

formats::SignalTable wanted_table(const TableOptions& options) {
  text::SignalTableMaker maker(options.sdo);
  if (options.what.size() == 1) {
    if (const Profile* profile = find_profile(options.what.front())) {
      if (options.sdo)
        throw UsageError("--sdo: a profile alone has no node that answers: name a device");
      maker.add_profile(*profile);
      formats::SignalTable table = maker.take();
      if (!table.messages.empty()) return table;
      throw UsageError(fmt::format(
          "{} gives no message a CAN-ID of its own: name a device of it, or a data sheet",
          profile->name));
    }
  }
  std::vector<DescribedNode> nodes = wanted_nodes(options);
  choose_bus(nodes, options.bus);
  tell_apart(nodes);
  for (const DescribedNode& node : nodes) maker.add_device(node.name, node.id, node.sheet);
  return maker.take();
}

int export_table(const TableOptions& options) {
  const formats::SignalTable table = wanted_table(options);
  const std::string text =
      options.format == "dbc" ? formats::write_dbc(table)
      : options.format == "csv"
          ? formats::write_signal_csv(table)
          : formats::write_signal_html(table, fmt::format("{}", fmt::join(options.what, " ")));
  if (options.out.empty()) {
    fmt::print("{}", text);
    return exit_done;
  }
  write_value_file(options.out, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  return exit_done;
}

}  // namespace

void add_export_table(Verb& app) {
  const auto options = std::make_shared<TableOptions>();
  Verb& command = app.add_verb("export", "Write what nodes have and say as DBC, CSV or HTML");
  command.add({
      {"format",
       options->format,
       "dbc, csv or html",
       {.is_required = true, .allowed = OneOf{"dbc", "csv", "html"}}},
      {"what", options->what,
       "a device of canvoy device --list, a data sheet, several of them with their "
       "node-IDs (5=charger 10=pump.eds), a network file, a bus (can0: all nodes that answer), a "
       "bus "
       "and a node (can0 10), or a profile of which the messages have CAN-IDs (417-4)",
       required},
      {"--bus", options->bus, "of a network file with several buses"},
      {"--sdo", options->sdo,
       "with expedited SDO transfers, as signals that are multiplexed by command, index "
       "and sub-index"},
      {"--out", options->out, "into this file (default: printed)"},
      {"--timeout", options->time_out, answer_time_text, answer_time_rules},
  });
  command.add_examples(
      "  canvoy export dbc charger --out charger.dbc\n"
      "  canvoy export dbc 5=charger 10=battery --sdo\n"
      "  canvoy export csv battery.eds\n"
      "  canvoy export html house.toml --bus lift1 --out house.html\n"
      "  canvoy export dbc 417-4\n"
      "  canvoy export dbc can0 10 --out node10.dbc\n"
      "  canvoy export dbc can0 --out can0.dbc");
  command.runs([options] { return export_table(*options); });
}

}  // namespace canvoy::tools
