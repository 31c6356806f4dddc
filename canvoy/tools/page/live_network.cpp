#include "canvoy/tools/page/live_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/text/communication_text.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/page/object_list.hpp"
#include "canvoy/tools/page/refusal.hpp"

namespace canvoy::tools {

namespace {

using Json = LiveSource::Json;

NodeId node_in(const Json& arguments) {
  return arguments.at("node").get<NodeId>();
}

NmtCommand nmt_command_of(std::string_view name) {
  struct Named {
    std::string_view name;
    NmtCommand command;
  };
  constexpr std::array commands = {
      Named{"start", NmtCommand::start}, Named{"stop", NmtCommand::stop},
      Named{"enter pre-operational", NmtCommand::enter_pre_operational},
      Named{"reset node", NmtCommand::reset_node},
      Named{"reset communication", NmtCommand::reset_communication}};
  const auto found = std::ranges::find(commands, name, &Named::name);
  check_invariant(found != commands.end());  // the table of routes has the same ones
  return found->command;
}

ObjectAddress address_in(const Profile& profile, NodeId node, std::string_view text) {
  const std::optional<ObjectAddress> address = find_address(profile, text);
  if (!address) {
    throw NotThere(
        fmt::format("'{}' is no object that is known of node {}: give an index, as "
                    "6010 or 1018:4, or a name",
                    text, node));
  }
  return *address;
}

/// Keys of canvoy read --json.
Json value_json(NodeId node, const ObjectAddress& object, std::span<const std::uint8_t> bytes) {
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("node").number(node);
  append_index(json, object.index, object.sub);
  if (object.entry != nullptr) json.key("name").text(name_of(*object.object, *object.entry));
  json.key("raw").hex(bytes);
  json.key("value");
  text::append_value_json(line, object.entry, bytes);
  if (object.entry != nullptr && object.entry->value.unit != Unit::none) {
    json.key("unit").text(symbol(object.entry->value.unit));
  }
  const std::string words = text::communication_text(object.index, object.sub, bytes);
  json.key("text").text(words.empty() ? text::value_text(object.entry, bytes) : words);
  json.end_object();
  return Json::parse(line, nullptr, false);
}

/// A missing answer has no abort code.
Json failure_json(NodeId node, const ObjectAddress& object, const SdoEnd& end) {
  Json made = {
      {"error", fmt::format("{}, {}: {}", text::node_text(node),
                            text::object_text(object.index, object.sub), text::end_text(end))}};
  if (!end.is_silence()) {
    made["abort"] = fmt::format("{:08X}", static_cast<std::uint32_t>(end.abort()));
  }
  return made;
}

}  // namespace

std::string LiveSource::bus_in(const Json& arguments) const {
  std::string bus = text_of(arguments, "bus");
  if (std::ranges::find(feed_.buses(), bus) == feed_.buses().end()) {
    throw NotThere(fmt::format("there is no bus '{}'", bus));
  }
  return bus;
}

LiveSource::Json LiveSource::objects(const Json& arguments) {
  const std::string bus = bus_in(arguments);
  const Profile& profile = feed_.profile(bus, node_in(arguments));
  return {{"profile", profile.name},
          {"objects", object_list_json(profile, arguments.value("search", ""))}};
}

LiveSource::Json LiveSource::history(const Json& arguments) {
  const std::string bus = bus_in(arguments);
  const NodeId node = node_in(arguments);
  const ObjectAddress object =
      address_in(feed_.profile(bus, node), node, text_of(arguments, "object"));
  return feed_.history(bus, node, object.index, object.sub).json();
}

std::unique_ptr<FrameStream> LiveSource::watch(const std::string& filter, bool is_anew) {
  std::unique_ptr<FrameWalk> own = walk(filter, is_anew);
  if (!filter.empty()) return own;
  std::shared_ptr<SharedFrames> shared = shared_.lock();
  if (!shared) {
    shared = SharedFrames::create([this] { return walk("", true); });
    shared_ = shared;
  }
  return shared->join(std::move(own));
}

std::unique_ptr<FrameWalk> LiveSource::walk(const std::string& filter, bool is_anew) const {
  const std::uint64_t end = feed_.end();
  const std::uint64_t since = is_anew ? 0 : end - std::min(end, reported_before);
  return std::make_unique<FrameReader>(feed_, filter, since);
}

std::string text_of(const Json& arguments, const char* name) {
  return arguments.at(name).get<std::string>();
}

void LiveNetwork::act(std::string_view what, const Json& arguments, const Done& done) {
  if (what == "read") return read(arguments, done);
  if (what == "write") return write(arguments, done);
  if (what == "nmt") return command(arguments, done);
  if (what == "objects") return done(objects(arguments));
  if (what == "history") return done(history(arguments));
  if (what == "record") {
    if (arguments.value("on", true)) {
      recorder_.begin(epoch());
    } else {
      recorder_.end();
    }
    return done({{"done", true}});
  }
  throw NotNow(fmt::format("'{}' cannot be done here", what));
}

ObjectAddress LiveNetwork::address_of(std::string_view bus, NodeId node, std::string_view text) {
  return address_in(feed_.profile(bus, node), node, text);
}

void LiveNetwork::read(const Json& arguments, const Done& done) {
  const std::string bus = text_of(arguments, "bus");
  const NodeId node = node_in(arguments);
  const ObjectAddress object = address_of(bus, node, text_of(arguments, "object"));
  request({.kind = BusRequest::Kind::read,
           .bus = bus,
           .node = node,
           .index = object.index,
           .sub = object.sub},
          [node, object, done](const SdoRequests::Answer& answer) {
            done(answer.end ? value_json(node, object, answer.bytes)
                            : failure_json(node, object, answer.end));
          });
}

void LiveNetwork::write(const Json& arguments, const Done& done) {
  const std::string bus = text_of(arguments, "bus");
  const NodeId node = node_in(arguments);
  const ObjectAddress object = address_of(bus, node, text_of(arguments, "object"));
  if (!permission_.allows(node, object.index)) {
    throw NotAllowed(
        fmt::format("{} of node {} may not be written: start the command with "
                    "--allow-write {}:{:04X}",
                    text::object_text(object.index, object.sub), node, node, object.index));
  }
  const std::string text = text_of(arguments, "value");
  if (object.entry == nullptr && !text.starts_with("hex:")) {
    throw UsageError(fmt::format("the type of {} is not known: give bytes, as hex:01 02",
                                 text::object_text(object.index, object.sub)));
  }
  const EntryInfo entry = object.entry == nullptr ? EntryInfo{} : *object.entry;
  request({.kind = BusRequest::Kind::write,
           .bus = bus,
           .node = node,
           .index = object.index,
           .sub = object.sub,
           .bytes = parse_value(entry, text)},
          [node, object, done](const SdoRequests::Answer& written) {
            done(written.end ? Json{{"written", true}} : failure_json(node, object, written.end));
          });
}

void LiveNetwork::command(const Json& arguments, const Done& done) {
  if (!permission_.allows_nmt()) {
    throw NotAllowed("NMT commands are not allowed: start the command with --allow-write nmt");
  }
  const auto command = static_cast<std::uint8_t>(nmt_command_of(text_of(arguments, "command")));
  request({.kind = BusRequest::Kind::nmt,
           .bus = text_of(arguments, "bus"),
           .node = node_in(arguments),
           .bytes = {command}},
          {});
  done({{"sent", true}});
}

}  // namespace canvoy::tools
