// canvoy read BUS NODE OBJECT: one value of a node, in its unit.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "canvoy/tools/bus/node_profile.hpp"
#include "canvoy/tools/bus/remote_argument.hpp"
#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/value_argument.hpp"
#include "canvoy/tools/value_file.hpp"
#include "canvoy/words/json_line.hpp"
#include "canvoy/words/text.hpp"
#include "canvoy/words/value_text.hpp"

namespace canvoy::tools {

namespace {

struct ReadOptions {
  std::string bus;
  std::string node;
  std::string object;
  std::string type;
  unsigned profile = 0;
  unsigned time_out_ms = 1000;
  bool json = false;
  std::string out;
  bool block = false;
  bool segmented = false;
  RemoteOptions remote = {};
};

/// What the user says of the entry goes before what a profile says.
EntryInfo entry_of_type(const std::string& type, std::span<const std::uint8_t> bytes) {
  const EntryInfo entry{.type = parse_type_argument(type)};
  const unsigned length = byte_length(entry.type);
  if (length != 0 && length != bytes.size()) {
    throw Failure(fmt::format("the node has {} bytes there, and {} has {}: hex {:02X}",
                              bytes.size(), type, length, fmt::join(bytes, " ")));
  }
  return entry;
}

void print_json(const BusArgument& bus, NodeId node, const ObjectAddress& object,
                const EntryInfo* entry, std::span<const std::uint8_t> bytes) {
  std::string line;
  words::JsonLine json(line);
  json.begin_object();
  if (bus.is_remote()) json.key("network").number(bus.network);
  json.key("node").number(node);
  json.key("index").text(fmt::format("{:04X}", object.index));
  json.key("sub").text(fmt::format("{:02X}", object.sub));
  if (object.entry != nullptr) json.key("name").text(name_of(*object.object, *object.entry));
  json.key("raw").hex(bytes);
  json.key("value");
  words::append_value_json(line, entry, bytes);
  if (entry != nullptr && entry->value.unit != Unit::none) {
    json.key("unit").text(symbol(entry->value.unit));
  }
  json.end_object();
  fmt::print("{}\n", line);
}

/// `can0/2:7 OBJECT`: the bus says the node, too.
BusArgument take_bus(ReadOptions& options) {
  BusArgument bus = parse_bus_argument(options.bus);
  if (bus.is_remote() && options.object.empty()) {
    options.object = std::exchange(options.node, fmt::format("{}", bus.device));
  } else if (bus.is_remote()) {
    throw UsageError(fmt::format("{} says the node: give the object alone", options.bus));
  }
  if (options.object.empty()) throw UsageError("object is required");
  return bus;
}

int read_object(ReadOptions options) {
  const BusArgument bus = take_bus(options);
  const NodeId node = parse_node_id(options.node);
  check_object(options.object, options.profile);
  if (!options.type.empty()) parse_type_argument(options.type);
  Session session(bus.bus, std::chrono::milliseconds(options.time_out_ms));
  reach(session, bus, options.remote);
  const ObjectAddress object = find_object_of(session, node, options.object, options.profile);
  if (!options.out.empty()) session.choose(SdoTransfer::automatic);
  if (options.segmented) session.choose(SdoTransfer::segmented);
  if (options.block) session.choose(SdoTransfer::block);
  session.show_progress();
  const std::vector<std::uint8_t> bytes = session.read(node, object.index, object.sub);
  if (!options.out.empty()) {
    write_value_file(options.out, bytes);
    return exit_done;
  }
  std::optional<EntryInfo> typed;
  std::optional<NodeEntry> known;
  const EntryInfo* entry = nullptr;
  if (!options.type.empty()) {
    entry = &typed.emplace(entry_of_type(options.type, bytes));
  } else {
    entry = known.emplace(session, node, object).get();
  }
  if (options.json) {
    print_json(bus, node, object, entry, bytes);
  } else {
    fmt::print("{}\n", words::value_text(entry, bytes));
  }
  return exit_done;
}

}  // namespace

void add_read(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ReadOptions>();
  CLI::App* command = app.add_subcommand("read", "Read one object of a node by SDO");
  command
      ->add_option(
          "bus", options->bus,
          "can0, vcan0, udp:239.74.163.2:43113; can0/2:7 for node 7 of network 2 behind a node")
      ->required();
  command->add_option("node", options->node, "node-ID: 10 or 0x0A; not where the bus says it")
      ->required();
  command->add_option("object", options->object, "6010, 1018:4, or a name as battery_voltage");
  CLI::Option* type = command->add_option(
      "--type", options->type, "what the value is, whatever the profile says: u16, vs, ...");
  command->add_option("--profile", options->profile,
                      "number of the profile, as 419 (default: what the node's 1000h says)");
  command->add_option("--timeout", options->time_out_ms, "for one answer, in ms (default 1000)")
      ->check(CLI::Range(1U, 600'000U));
  CLI::Option* json = command->add_flag("--json", options->json, "one JSON object");
  command
      ->add_option("--out", options->out,
                   "write the bytes to this file; in blocks, where the node knows them")
      ->excludes(json)
      ->excludes(type);
  CLI::Option* block = command->add_flag("--block", options->block, "in blocks, or not at all");
  command->add_flag("--segmented", options->segmented, "in segments (default without --out)")
      ->excludes(block);
  add_remote_options(*command, options->remote);
  command->callback([options, &action] { action = [options] { return read_object(*options); }; });
}

}  // namespace canvoy::tools
