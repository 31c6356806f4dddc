// canvoy write BUS NODE OBJECT VALUE: writes one value of a node, given in its unit, and prints the
// previous and the new value.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/remote_object.hpp"

namespace canvoy::tools {

namespace {

using OldBytes = std::optional<std::vector<std::uint8_t>>;

struct WriteOptions : AskOptions {
  std::string object = {};
  std::optional<std::string> value = {};
  std::string type = {};
  std::string file = {};
  bool block = false;
  bool segmented = false;
  bool blind = false;
};

/// A program takes minutes at a low bit rate: values from a file are sent in blocks.
SdoTransfer transfer_of(const WriteOptions& options) {
  if (options.block) return SdoTransfer::block;
  if (options.segmented || options.file.empty()) return SdoTransfer::segmented;
  return SdoTransfer::automatic;
}

/// Present value of the node; nothing if it is not readable.
OldBytes held_by(Session& session, const RemoteObject& object) {
  const ObjectAddress& place = object.address();
  const Result<std::vector<std::uint8_t>> held =
      session.try_read(object.node(), place.index, place.sub);
  return held ? OldBytes(*held) : std::nullopt;
}

std::vector<std::uint8_t> value_bytes(const WriteOptions& options, const RemoteObject& object,
                                      const OldBytes& old) {
  const std::string value = options.value.value_or("");
  if (object.entry() == nullptr && !value.starts_with("hex:")) {
    throw UsageError(fmt::format("the type of {} is not known here: add --type u16 or the like",
                                 text::object_text(object.address().index, object.address().sub)));
  }
  const bool is_number = old && old->size() <= sizeof(std::uint64_t);
  return parse_value(object.entry() == nullptr ? EntryInfo{} : *object.entry(), value,
                     is_number ? load_unsigned(*old) : 0);
}

void append_old(text::JsonLine& json, std::string& line, const RemoteObject& object,
                const OldBytes& old) {
  json.key("old");
  if (!old) return json.null();
  text::append_value_json(line, object.entry(), *old);
}

/// Prints the previous and the new value: a node may accept a value and hold another.
void tell(const WriteOptions& options, const RemoteObject& object, const OldBytes& old,
          const OldBytes& held, std::span<const std::uint8_t> written) {
  const std::span<const std::uint8_t> now = held ? std::span<const std::uint8_t>(*held) : written;
  if (options.json) {
    std::string line;
    text::JsonLine json(line);
    json.begin_object();
    object.append_place(json);
    append_old(json, line, object, old);
    object.append_value(json, line, now);
    json.end_object();
    fmt::print("{}\n", line);
    return;
  }
  const std::string was = old ? text::value_text(object.entry(), *old) : "?";
  fmt::print("{}: {} -> {}\n", object.name(), was, text::value_text(object.entry(), now));
}

void report_file(const WriteOptions& options, NodeId node, const ObjectAddress& object,
                 std::size_t bytes) {
  if (!options.json) {
    fmt::print("{}: {} bytes written\n", printed_name(object), bytes);
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("node").number(node);
  append_index(json, object.index, object.sub);
  json.key("bytes").number(static_cast<std::int64_t>(bytes));
  json.end_object();
  fmt::print("{}\n", line);
}

int write_file(const WriteOptions& options, Sessions& sessions) {
  const NodeId node = options.node_id();
  const std::vector<std::uint8_t> bytes = read_value_file(options.file);
  Session& session = options.open(sessions);
  const ObjectAddress object = find_object_of(session, node, options.object, options.profile);
  session.choose(transfer_of(options));
  session.show_progress();
  session.write(node, object.index, object.sub, bytes);
  report_file(options, node, object, bytes.size());
  return exit_done;
}

/// What can be known of a line of a script before the first one is run.
void check_writing(const WriteOptions& options) {
  options.node_id();
  check_object(options.object, options.profile);
  if (options.value.has_value() != options.file.empty()) {
    throw UsageError("give a value, or --file with the bytes");
  }
  if (options.type.empty()) return;
  const EntryInfo typed{.type = parse_type_argument(options.type)};
  if (options.file.empty()) parse_value(typed, options.value.value_or(""));
}

int write_object(const WriteOptions& options, Sessions& sessions) {
  if (!options.file.empty()) return write_file(options, sessions);
  const NodeId node = options.node_id();
  Session& session = options.open(sessions);
  const RemoteObject object(session, node, options.object, options.profile, options.type);
  // Invalid values are refused before the node is accessed.
  std::vector<std::uint8_t> bytes = value_bytes(options, object, std::nullopt);
  const auto held = [&] { return options.blind ? std::nullopt : held_by(session, object); };
  const OldBytes old = held();
  if (old) bytes = value_bytes(options, object, old);
  session.choose(transfer_of(options));
  session.write(node, object.address().index, object.address().sub, bytes);
  tell(options, object, old, held(), bytes);
  return exit_done;
}

}  // namespace

void add_write(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<WriteOptions>();
  Verb& command =
      app.add_verb("write", "Write one object of a node by SDO; tells the old and new value");
  options->add_bus(command);
  options->add_any_node(command);
  command.add({
      {"object", options->object, "6010, 1018:4, a name as battery_voltage, or a part of it",
       required},
      {"value", options->value,
       "in the object's unit or one that measures the same: 21.5, '48 V', 1min30s, ready; the "
       "stored number, 0x1A3; 'FIELD: VALUE, ...'; a text; or hex:01 02"},
      {"--file", options->file,
       "write the bytes of this file; in blocks, where the node knows them", excludes("value")},
      {"--block", options->block, "in blocks, or not at all"},
      {"--segmented", options->segmented, "in segments (default without --file)",
       excludes("--block")},
      {"--blind", options->blind, "read neither the old nor the new value"},
      {"--type", options->type, "of an object that no profile knows: u16, vs, ..."},
  });
  options->add_profile(command);
  options->add_time_out(command);
  options->add_json(command);
  command.add_examples(
      "  canvoy write can0 10 producer_heartbeat_time 500ms\n"
      "  canvoy write can0 10 1017 1s --json\n"
      "  canvoy write can0 5 battery_temperature '21.5 degC'\n"
      "  canvoy write can0 10 1017 0x1F4 --type u16 --blind");
  command.when_parsed([options] { check_writing(*options); });
  command.runs([options, &sessions] { return write_object(*options, sessions); });
}

}  // namespace canvoy::tools
