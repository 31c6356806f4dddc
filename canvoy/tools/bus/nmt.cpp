// canvoy nmt BUS COMMAND NODE: starts, stops and resets nodes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>

#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

struct NmtOptions {
  std::string bus;
  std::string command;
  std::string node = "all";
};

struct CommandName {
  std::string_view name;
  NmtCommand command;
};
constexpr auto command_names = std::to_array<CommandName>({
    {"start", NmtCommand::start},
    {"stop", NmtCommand::stop},
    {"preop", NmtCommand::enter_pre_operational},
    {"reset-node", NmtCommand::reset_node},
    {"reset-communication", NmtCommand::reset_communication},
});

int command_nodes(const NmtOptions& options) {
  const auto* found = std::ranges::find(command_names, options.command, &CommandName::name);
  if (found == command_names.end()) {
    throw UsageError(
        fmt::format("'{}' is no NMT command: start, stop, preop, reset-node or reset-communication",
                    options.command));
  }
  const NodeId node = options.node == "all" ? NodeId{0} : parse_node_id(options.node);
  Session session(options.bus);
  session.send(Frame::data_frame(can_id::nmt, {static_cast<std::uint8_t>(found->command), node}));
  return exit_done;
}

}  // namespace

void add_nmt(CLI::App& app, Action& action) {
  const auto options = std::make_shared<NmtOptions>();
  CLI::App* command = app.add_subcommand("nmt", "Start, stop or reset nodes");
  command->add_option("bus", options->bus, "can0, vcan0, udp:239.74.163.2:43113")->required();
  command
      ->add_option("command", options->command,
                   "start, stop, preop, reset-node, reset-communication")
      ->required();
  command->add_option("node", options->node, "node-ID, or all (the default)");
  command->callback([options, &action] { action = [options] { return command_nodes(*options); }; });
}

}  // namespace canvoy::tools
