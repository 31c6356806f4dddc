// canvoy configure BUS NODE FILE: writes the configuration of a node, entry by entry.
#include <fmt/format.h>

#include <memory>

#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/remote_object.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"

namespace canvoy::tools {

namespace {

struct ConfigureOptions : AskOptions {
  std::string file = {};
  bool check = false;
  bool diff = false;
};

std::string entries_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "entry" : "entries");
}

std::string size_text(const ConfigurationEntry& entry) {
  return fmt::format("{} {}", entry.value.size(), entry.value.size() == 1 ? "byte" : "bytes");
}

int check_only(const std::vector<ConfigurationEntry>& entries) {
  for (const ConfigurationEntry& entry : entries) {
    fmt::print("{}  {}\n", text::object_text(entry.index, entry.sub), size_text(entry));
  }
  fmt::print("{}, nothing written\n", entries_text(entries.size()));
  return exit_done;
}

void report_written(NodeId node, const ConfigurationEntry& entry) {
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("event").text("written");
  json.key("node").number(node);
  append_index(json, entry.index, entry.sub);
  json.key("raw").hex(entry.value);
  json.end_object();
  fmt::print("{}\n", line);
}

void write_all(const ConfigureOptions& options, Session& session, NodeId node,
               const std::vector<ConfigurationEntry>& entries) {
  std::size_t written = 0;
  for (const ConfigurationEntry& entry : entries) {
    try {
      session.write(node, entry.index, entry.sub, entry.value);
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{}; {} of {} written before", failure.what(), written,
                                entries_text(entries.size())));
    }
    ++written;
    if (options.json) {
      report_written(node, entry);
      continue;
    }
    fmt::print("{:>{}}/{}  {}  {}\n", written, fmt::formatted_size("{}", entries.size()),
               entries.size(), text::object_text(entry.index, entry.sub), size_text(entry));
    std::fflush(stdout);
  }
}

/// Reports parts of a DCF that are changed or not written.
void say_what_differs(const Configuration& configuration, NodeId node) {
  if (configuration.moved != 0) {
    fmt::print("the file is of {}: {} with the node-ID in them are those of {}\n",
               text::node_text(configuration.sheet_node), entries_text(configuration.moved),
               text::node_text(node));
  }
  if (configuration.process_data != 0) {
    fmt::print("{} of process data left as they are\n", entries_text(configuration.process_data));
  }
}

/// `1017h:00h`, as written by data sheets and by this program.
std::string address_text(const ConfigurationEntry& entry) {
  return fmt::format("{:04X}:{:02X}", entry.index, entry.sub);
}

/// Reports an entry of the file beside the value of the node.
void report_difference(const ConfigureOptions& options, const RemoteObject& object,
                       const std::optional<std::vector<std::uint8_t>>& held,
                       std::span<const std::uint8_t> wanted) {
  if (!options.json) {
    const ObjectAddress& place = object.address();
    const std::string was = held ? text::value_text(object.entry(), *held) : "not there";
    const std::string name = place.entry == nullptr ? "" : "  " + object.name();
    fmt::print("{}{}: {} -> {}\n", text::object_text(place.index, place.sub), name, was,
               text::value_text(object.entry(), wanted));
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("event").text("difference");
  object.append_place(json);
  json.key("old");
  held ? text::append_value_json(line, object.entry(), *held) : json.null();
  object.append_value(json, line, wanted);
  json.end_object();
  fmt::print("{}\n", line);
}

/// Lists the changes of the file; like diff, status 1 if there are any.
int compare_all(const ConfigureOptions& options, Session& session, NodeId node,
                const std::vector<ConfigurationEntry>& written) {
  const std::vector<ConfigurationEntry> entries = final_entries(written);
  const unsigned profile = profile_of_node(session, node);
  std::size_t differences = 0;
  for (const ConfigurationEntry& entry : entries) {
    const Result<std::vector<std::uint8_t>> held = session.try_read(node, entry.index, entry.sub);
    if (held && *held == entry.value) continue;
    const RemoteObject object(session, node, address_text(entry), profile);
    report_difference(options, object, held ? std::optional(*held) : std::nullopt, entry.value);
    ++differences;
  }
  if (!options.json) {
    fmt::print("{}: {} of {} {}\n", text::node_text(node), differences,
               entries_text(entries.size()), entries.size() == 1 ? "differs" : "differ");
  }
  return differences == 0 ? exit_done : exit_failed;
}

/// The whole file is read before the bus is used.
int configure(const ConfigureOptions& options, Sessions& sessions) {
  const NodeId node = options.node_id();
  const Configuration configuration = read_configuration(options.file, node);
  const std::vector<ConfigurationEntry>& entries = configuration.entries;
  if (!options.json) say_what_differs(configuration, node);
  if (options.check) return check_only(entries);
  Session& session = options.open(sessions);
  if (options.diff) return compare_all(options, session, node, entries);
  write_all(options, session, node, entries);
  if (!options.json) {
    fmt::print("{} configured: {} written\n", text::node_text(node), entries_text(entries.size()));
  }
  return exit_done;
}

}  // namespace

void add_configure(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<ConfigureOptions>();
  Verb& command = app.add_verb(
      "configure", "Write a file of entries into a node by SDO, or see what would change");
  options->add_bus(command);
  options->add_any_node(command);
  command.add({
      {"file", options->file,
       "a DCF or XDC, a concise DCF (CiA 302-3), or text: 'index sub type value' a line, as "
       "'1017 0 u16 500'; # begins a comment",
       required},
      {"--check", options->check, "only read the file and list its entries"},
      {"--diff", options->diff,
       "only show what the node has otherwise; status 1 where there is something",
       excludes("--check")},
  });
  options->add_time_out(command);
  command.add({
      {"--json", options->json, "one JSON object a line", excludes("--check")},
  });
  command.add_examples(
      "  canvoy configure can0 10 battery.dcf --check\n"
      "  canvoy configure can0 10 battery.dcf --diff\n"
      "  canvoy configure can0 10 battery.dcf --json");
  command.runs([options, &sessions] { return configure(*options, sessions); });
}

}  // namespace canvoy::tools
