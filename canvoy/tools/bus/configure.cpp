// canvoy configure BUS NODE FILE: writes the configuration of a node, entry by entry.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

struct ConfigureOptions {
  std::string bus;
  std::string node;
  std::string file;
  unsigned time_out_ms = 1000;
  bool check = false;
};

std::string entries_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "entry" : "entries");
}

std::string size_text(const ConfigurationEntry& entry) {
  return fmt::format("{} {}", entry.value.size(), entry.value.size() == 1 ? "byte" : "bytes");
}

int check_only(const std::vector<ConfigurationEntry>& entries) {
  for (const ConfigurationEntry& entry : entries) {
    fmt::print("{}  {}\n", words::object_text(entry.index, entry.sub), size_text(entry));
  }
  fmt::print("{}, nothing written\n", entries_text(entries.size()));
  return exit_done;
}

void write_all(Session& session, NodeId node, const std::vector<ConfigurationEntry>& entries) {
  std::size_t written = 0;
  for (const ConfigurationEntry& entry : entries) {
    try {
      session.write(node, entry.index, entry.sub, entry.value);
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{}; {} of {} written before", failure.what(), written,
                                entries_text(entries.size())));
    }
    ++written;
    fmt::print("{:>{}}/{}  {}  {}\n", written, fmt::formatted_size("{}", entries.size()),
               entries.size(), words::object_text(entry.index, entry.sub), size_text(entry));
    std::fflush(stdout);
  }
}

/// What of a DCF is not written as it stands there.
void say_what_differs(const Configuration& configuration, NodeId node) {
  if (configuration.moved != 0) {
    fmt::print("the file is of {}: {} with the node-ID in them are those of {}\n",
               words::node_text(configuration.sheet_node), entries_text(configuration.moved),
               words::node_text(node));
  }
  if (configuration.process_data != 0) {
    fmt::print("{} of process data left as they are\n", entries_text(configuration.process_data));
  }
}

/// The file is read whole before the bus is touched.
int configure(const ConfigureOptions& options) {
  const NodeId node = parse_node_id(options.node);
  const Configuration configuration = read_configuration(options.file, node);
  const std::vector<ConfigurationEntry>& entries = configuration.entries;
  say_what_differs(configuration, node);
  if (options.check) return check_only(entries);
  Session session(options.bus, std::chrono::milliseconds(options.time_out_ms));
  write_all(session, node, entries);
  fmt::print("{} configured: {} written\n", words::node_text(node), entries_text(entries.size()));
  return exit_done;
}

}  // namespace

void add_configure(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ConfigureOptions>();
  CLI::App* command = app.add_subcommand("configure", "Write a file of entries into a node by SDO");
  command->add_option("bus", options->bus, "can0, vcan0, udp:239.74.163.2:43113")->required();
  command->add_option("node", options->node, "node-ID: 10 or 0x0A")->required();
  command
      ->add_option(
          "file", options->file,
          "a DCF or XDC, a concise DCF (CiA 302-3), or text: 'index sub type value' a line, as "
          "'1017 0 u16 500'; # begins a comment")
      ->required();
  command->add_flag("--check", options->check, "only read the file and list its entries");
  command->add_option("--timeout", options->time_out_ms, "for one answer, in ms (default 1000)")
      ->check(CLI::Range(1U, 600'000U));
  command->callback([options, &action] { action = [options] { return configure(*options); }; });
}

}  // namespace canvoy::tools
