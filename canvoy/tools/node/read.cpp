// canvoy read BUS NODE OBJECT...: values of a node, in their units; repeatedly if requested.
#include <fmt/format.h>

#include <deque>
#include <memory>
#include <optional>

#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/remote_object.hpp"

namespace canvoy::tools {

namespace {

struct ReadObjectsOptions : AskOptions {
  std::vector<std::string> objects = {};
  std::string type = {};
  std::string out = {};
  std::optional<std::string> watch = {};  ///< the interval
  std::string duration = {};
  std::uint64_t count = 0;
  bool block = false;
  bool segmented = false;
};

constexpr Duration watch_usual = 1s;

/// What can be known of a line of a script before the first one is run.
void check_reading(const ReadObjectsOptions& options) {
  options.node_id();
  for (const std::string& object : options.objects) check_object(object, options.profile);
  if (!options.type.empty()) parse_type_argument(options.type);
  if (!options.out.empty() && options.objects.size() > 1) {
    throw UsageError("--out: the bytes of one object only");
  }
  if (!options.watch && !(options.duration.empty() && options.count == 0)) {
    throw UsageError("--for and --count are for --watch");
  }
}

/// One object, and the last printed value.
struct WatchedObject {
  RemoteObject object;
  std::vector<std::uint8_t> last = {};
};

class ObjectReading {
 public:
  ObjectReading(const ReadObjectsOptions& options, Session& session)
      : options_(options), session_(session), node_(options.node_id()) {
    for (const std::string& text : options.objects) add(text);
  }

  void read_once() {
    for (WatchedObject& each : objects_) {
      each.last = each.object.read(session_);
      print(each);
    }
  }

  /// Prints changes only.
  void watch(Duration interval, Duration length) {
    const Time begin = session_.loop().now();
    const Time end = length == Duration::max() ? never : begin + length;
    for (Time due = begin; due < end;) {
      for (WatchedObject& each : objects_) {
        std::vector<std::uint8_t> bytes = each.object.read(session_);
        if (is_told_ && bytes == each.last) continue;
        each.last = std::move(bytes);
        print(each);
        if (++printed_ == options_.count) return;
      }
      is_told_ = true;
      // Reads that a pause of the machine has delayed do not follow in a burst.
      due = std::max(due, session_.loop().now() - interval) + interval;
      session_.loop().run_until(std::min(end, due));
      if (session_.loop().signal() != 0) return;
    }
  }

 private:
  void add(const std::string& text) {
    RemoteObject object(session_, node_, text, options_.profile, options_.type);
    const ObjectAddress& address = object.address();
    const bool has_entries =
        address.object != nullptr && !address.object->subs.empty() && address.sub == 0;
    const bool is_whole = has_entries && text.find_first_of(": ") == std::string::npos;
    if (is_whole && options_.type.empty() && add_entries(address.index)) return;
    width_ = std::max(width_, object.name().size());
    objects_.push_back({std::move(object)});
  }

  /// Entries of a record or array of the node, after sub-index 00h; false if there is no number of
  /// entries.
  bool add_entries(std::uint16_t index) {
    const auto count = session_.try_read(node_, index, 0);
    const unsigned highest = count && count->size() == 1 ? count->front() : 0U;
    bool is_any = false;
    for (unsigned sub = 1; sub <= highest; ++sub) {
      const auto answer = session_.try_read(node_, index, static_cast<std::uint8_t>(sub));
      if (!answer && (is_absent(answer.abort()) || answer.abort() == AbortCode::no_data)) continue;
      RemoteObject entry(session_, node_, fmt::format("{:04X}:{:02X}", index, sub),
                         options_.profile);
      width_ = std::max(width_, entry.name().size());
      objects_.push_back({std::move(entry)});
      is_any = true;
    }
    return is_any;
  }

  void print(const WatchedObject& each) const {
    if (options_.json) return print_json(each);
    const std::string text = each.object.text(each.last);
    const std::string name = each.object.name();
    if (options_.watch) fmt::print("{:10.3f}s  ", in_seconds(session_.loop().now() - Time{}));
    if (objects_.size() > 1 || options_.watch) fmt::print("{:<{}}  ", name, width_);
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }

  void print_json(const WatchedObject& each) const {
    std::string line;
    text::JsonLine json(line);
    json.begin_object();
    if (options_.watch) json.key("time").number(in_seconds(session_.loop().now() - Time{}));
    each.object.append_place(json);
    each.object.append_value(json, line, each.last);
    json.end_object();
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }

  const ReadObjectsOptions& options_;
  Session& session_;
  NodeId node_;
  std::deque<WatchedObject> objects_;
  std::size_t width_ = 0;
  std::uint64_t printed_ = 0;
  bool is_told_ = false;
};

void write_out(const ReadObjectsOptions& options, Session& session) {
  const NodeId node = options.node_id();
  const ObjectAddress object =
      find_object_of(session, node, options.objects.front(), options.profile);
  session.show_progress();
  write_value_file(options.out, session.read(node, object.index, object.sub));
}

int read_objects(const ReadObjectsOptions& options, Sessions& sessions) {
  const Duration interval = parse_duration_argument(options.watch.value_or(""), watch_usual);
  const Duration length = parse_duration_argument(options.duration, Duration::max());
  Session& session = options.open(sessions);
  if (!options.out.empty()) session.choose(SdoTransfer::automatic);
  if (options.segmented) session.choose(SdoTransfer::segmented);
  if (options.block) session.choose(SdoTransfer::block);
  if (!options.out.empty()) {
    write_out(options, session);
    return exit_done;
  }
  session.show_progress();
  ObjectReading reading(options, session);
  if (options.watch) {
    reading.watch(interval, length);
  } else {
    reading.read_once();
  }
  return exit_done;
}

}  // namespace

void add_read(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<ReadObjectsOptions>();
  Verb& command = app.add_verb("read", "Read objects of a node by SDO");
  options->add_bus(command);
  options->add_any_node(command);
  command.add({
      {"object", options->objects,
       "6010, 1018:4, a name as battery_voltage, or a part of it; 1018: all of its entries; or "
       "several",
       required},
      {"--type", options->type, "what the value is, whatever the profile says: u16, vs, ..."},
  });
  options->add_profile(command);
  options->add_time_out(command);
  command.add({
      {"--json", options->json, "one JSON object a line"},
      {"--watch", options->watch,
       "again and again, and show what has changed: every 200ms (default 1s)", may_be_bare},
      {"--for", options->duration, "with --watch: end after this time"},
      {"--count", options->count, "with --watch: end after as many lines", above_zero},
      {"--out", options->out, "write the bytes to this file; in blocks, where the node knows them",
       excludes("--json", "--type", "--watch")},
      {"--block", options->block, "in blocks, or not at all"},
      {"--segmented", options->segmented, "in segments (default without --out)",
       excludes("--block")},
  });
  command.add_examples(
      "  canvoy read can0 10 temperature\n"
      "  canvoy read can0 10 6010 1018:4 battery_parameters:ah_capacity --json\n"
      "  canvoy read can0 0Ah temperature battery_voltage --watch 200ms --for 1s\n"
      "  canvoy read can0 10 1017 --type u16 --timeout 500ms\n"
      "  canvoy read udp:239.74.163.2:43113 10 1008 --out name.txt");
  command.when_parsed([options] { check_reading(*options); });
  command.runs([options, &sessions] { return read_objects(*options, sessions); });
}

}  // namespace canvoy::tools
