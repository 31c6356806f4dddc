// canvoy read BUS NODE OBJECT: one value of a node, in its unit.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/node_profile.hpp"
#include "canvoy/tools/session.hpp"
#include "canvoy/tools/text.hpp"
#include "canvoy/tools/value.hpp"
#include "canvoy/tools/value_file.hpp"

namespace canvoy::tools {

namespace {

struct ReadOptions {
  std::string bus;
  std::string node;
  std::string object;
  unsigned profile = 0;
  unsigned time_out_ms = 1000;
  bool json = false;
  std::string out;
  bool block = false;
  bool segmented = false;
};

int read_object(const ReadOptions& options) {
  const NodeId node = parse_node_id(options.node);
  check_object(options.object, options.profile);
  Session session(options.bus, std::chrono::milliseconds(options.time_out_ms));
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
  if (options.json) {
    nlohmann::ordered_json line = {{"node", node}, {"index", object.index}, {"sub", object.sub}};
    if (object.entry != nullptr) line["name"] = name_of(*object.object, *object.entry);
    line["value"] = value_json(object.entry, bytes);
    if (object.entry != nullptr && object.entry->value.unit != Unit::none) {
      line["unit"] = symbol(object.entry->value.unit);
    }
    fmt::print("{}\n", line.dump());
  } else {
    fmt::print("{}\n", value_text(object.entry, bytes));
  }
  return exit_done;
}

}  // namespace

void add_read(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ReadOptions>();
  CLI::App* command = app.add_subcommand("read", "Read one object of a node by SDO");
  command->add_option("bus", options->bus, "can0, vcan0, udp:239.74.163.2:43113")->required();
  command->add_option("node", options->node, "node-ID: 10 or 0x0A")->required();
  command->add_option("object", options->object, "6010, 1018:4, or a name as battery_voltage")
      ->required();
  command->add_option("--profile", options->profile,
                      "number of the profile, as 419 (default: what the node's 1000h says)");
  command->add_option("--timeout", options->time_out_ms, "for one answer, in ms (default 1000)")
      ->check(CLI::Range(1U, 600'000U));
  CLI::Option* json = command->add_flag("--json", options->json, "one JSON object");
  command
      ->add_option("--out", options->out,
                   "write the bytes to this file; in blocks, where the node knows them")
      ->excludes(json);
  CLI::Option* block = command->add_flag("--block", options->block, "in blocks, or not at all");
  command->add_flag("--segmented", options->segmented, "in segments (default without --out)")
      ->excludes(block);
  command->callback([options, &action] { action = [options] { return read_object(*options); }; });
}

}  // namespace canvoy::tools
