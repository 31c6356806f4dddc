// canvoy write BUS NODE OBJECT VALUE: one value of a node, given in its unit.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "canvoy/tools/bus/node_profile.hpp"
#include "canvoy/tools/bus/remote_argument.hpp"
#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/value_argument.hpp"
#include "canvoy/tools/value_file.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

struct WriteOptions {
  std::string bus;
  std::string node;
  std::string object;
  std::optional<std::string> value;
  std::string type;
  unsigned profile = 0;
  unsigned time_out_ms = 1000;
  std::string file;
  bool block = false;
  bool segmented = false;
  RemoteOptions remote = {};
};

/// A program for a node takes minutes at a low bit rate: what comes from a file is worth blocks.
SdoTransfer transfer_of(const WriteOptions& options) {
  if (options.block) return SdoTransfer::block;
  if (options.segmented || options.file.empty()) return SdoTransfer::segmented;
  return SdoTransfer::automatic;
}

std::vector<std::uint8_t> value_bytes(const WriteOptions& options, Session& session, NodeId node,
                                      const ObjectAddress& object) {
  const std::string value = options.value.value_or("");
  if (!options.type.empty()) {
    return parse_value(EntryInfo{.type = parse_type_argument(options.type)}, value);
  }
  if (object.entry == nullptr && !value.starts_with("hex:")) {
    throw UsageError(fmt::format("the type of {} is not known here: add --type u16 or the like",
                                 words::object_text(object.index, object.sub)));
  }
  const NodeEntry known(session, node, object);
  return parse_value(known.get() == nullptr ? EntryInfo{} : *known.get(), value);
}

/// `can0/2:7 OBJECT`: the bus says the node, too.
BusArgument take_bus(WriteOptions& options) {
  BusArgument bus = parse_bus_argument(options.bus);
  if (bus.is_remote() && options.value) {
    throw UsageError(fmt::format("{} says the node: give object and value alone", options.bus));
  }
  if (bus.is_remote()) {
    if (!options.object.empty()) options.value = options.object;
    options.object = std::exchange(options.node, fmt::format("{}", bus.device));
  }
  if (options.object.empty()) throw UsageError("object is required");
  return bus;
}

int write_object(WriteOptions options) {
  const BusArgument bus = take_bus(options);
  const NodeId node = parse_node_id(options.node);
  check_object(options.object, options.profile);
  if (options.value.has_value() != options.file.empty()) {
    throw UsageError("give a value, or --file with the bytes");
  }
  std::vector<std::uint8_t> bytes;
  if (!options.file.empty()) bytes = read_value_file(options.file);
  Session session(bus.bus, std::chrono::milliseconds(options.time_out_ms));
  reach(session, bus, options.remote);
  const ObjectAddress object = find_object_of(session, node, options.object, options.profile);
  if (options.file.empty()) bytes = value_bytes(options, session, node, object);
  session.choose(transfer_of(options));
  session.show_progress();
  session.write(node, object.index, object.sub, bytes);
  return exit_done;
}

}  // namespace

void add_write(CLI::App& app, Action& action) {
  const auto options = std::make_shared<WriteOptions>();
  CLI::App* command = app.add_subcommand("write", "Write one object of a node by SDO");
  command
      ->add_option(
          "bus", options->bus,
          "can0, vcan0, udp:239.74.163.2:43113; can0/2:7 for node 7 of network 2 behind a node")
      ->required();
  command->add_option("node", options->node, "node-ID: 10 or 0x0A; not where the bus says it")
      ->required();
  command->add_option("object", options->object, "1017, 1018:4, or a name as battery_voltage");
  CLI::Option* value =
      command->add_option("value", options->value,
                          "in the object's unit: 21.5, '48 V', ready, 0x1A3, a text, or hex:01 02");
  command
      ->add_option("--file", options->file,
                   "write the bytes of this file; in blocks, where the node knows them")
      ->excludes(value);
  CLI::Option* block = command->add_flag("--block", options->block, "in blocks, or not at all");
  command->add_flag("--segmented", options->segmented, "in segments (default without --file)")
      ->excludes(block);
  command->add_option("--type", options->type, "of an object that no profile knows: u16, vs, ...");
  command->add_option("--profile", options->profile,
                      "number of the profile, as 419 (default: what the node's 1000h says)");
  command->add_option("--timeout", options->time_out_ms, "for one answer, in ms (default 1000)")
      ->check(CLI::Range(1U, 600'000U));
  add_remote_options(*command, options->remote);
  command->callback([options, &action] { action = [options] { return write_object(*options); }; });
}

}  // namespace canvoy::tools
