// canvoy load SOURCE: load of a bus, and the worst-case delay of each of its messages.
#include "canvoy/tools/load/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/host/can_link.hpp"
#include "canvoy/can/simulated/arbitration.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/timing/arrivals.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/load/load_result.hpp"
#include "canvoy/tools/load/loaded_bus.hpp"
#include "canvoy/tools/load/message_list.hpp"
#include "canvoy/tools/play/world.hpp"
#include "canvoy/tools/session/log_source.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"
#include "canvoy/tools/watch/trace_progress.hpp"

namespace canvoy::tools {

namespace {

// Traffic of the buses during listening, by identifier.
//
//     HeardLoad load;
//     load.add(time, "can0", frame);
//     std::vector<LoadedBus> buses = load.buses(Duration{});

/// What is heard in no time at all, since all its frames have the same time.
inline constexpr Duration one_moment{1};

class HeardLoad {
 public:
  static constexpr std::size_t buses_max = 64;

  /// Adds a frame. Times of one bus must not decrease. Throws Failure if there are more than
  /// buses_max buses, or more than messages_max identifiers on one.
  void add(Duration time, std::string_view bus, const Frame& frame);
  /// The buses in order of their names. `listened`: zero means the time from the first frame to the
  /// last.
  std::vector<LoadedBus> buses(Duration listened) const;

 private:
  struct Heard {
    LoadedMessage message{};
    timing::Arrivals arrivals{};
    std::uint64_t bits = 0;
  };
  struct Bus {
    std::map<std::uint32_t, Heard> by_key{};  // in order of priority
    std::uint64_t error_frames = 0;
  };
  static LoadedMessage described(const Heard& heard, Duration listened);

  std::map<std::string, Bus, std::less<>> buses_;
  Duration first_{};
  Duration last_{};
  bool is_empty_ = true;
};

void HeardLoad::add(Duration time, std::string_view bus, const Frame& frame) {
  if (is_empty_) first_ = last_ = time;
  is_empty_ = false;
  first_ = std::min(first_, time);
  last_ = std::max(last_, time);
  auto known = buses_.find(bus);
  if (known == buses_.end()) known = buses_.try_emplace(std::string(bus)).first;
  if (buses_.size() > buses_max)
    throw Failure(fmt::format("there are more than {} buses", buses_max));
  if (frame.is_error()) {
    ++known->second.error_frames;
    return;
  }
  auto& by_key = known->second.by_key;
  Heard& heard = by_key[arbitration_key(frame)];
  if (by_key.size() > messages_max) {
    throw Failure(fmt::format("{} has more than {} identifiers, which is no network",
                              formats::plain_text(bus), messages_max));
  }
  LoadedMessage& message = heard.message;
  message.timing.id = frame.id;
  message.timing.is_extended = frame.is_extended();
  message.timing.is_remote = frame.is_remote();
  message.bytes = std::max<unsigned>(message.bytes, frame.length);
  ++message.frames;
  heard.bits += frame_bits(frame) + intermission_bits;
  heard.arrivals.add(Time(time));
}

LoadedMessage HeardLoad::described(const Heard& heard, Duration listened) {
  LoadedMessage message = heard.message;
  heard.arrivals.describe(message.timing, listened);
  message.bits_per_second =
      static_cast<double>(heard.bits) * 1e6 / static_cast<double>(listened.count());
  complete(message);
  return message;
}

std::vector<LoadedBus> HeardLoad::buses(Duration listened) const {
  if (listened == Duration{}) listened = std::max(last_ - first_, one_moment);
  std::vector<LoadedBus> made;
  for (const auto& [name, bus] : buses_) {
    LoadedBus& each = made.emplace_back();
    each.name = formats::plain_text(name);
    each.heard = listened;
    each.error_frames = bus.error_frames;
    for (const auto& [key, heard] : bus.by_key) each.messages.push_back(described(heard, listened));
  }
  return made;
}

// Load of the buses of a network of `canvoy run`, which is played and listened to for a time.
//
//     const std::vector<LoadedBus> buses = played_load(table, "lift.toml", 10s, 1min);

/// Listens for `length`, starting `after` its start. Throws Failure with file and line.
std::vector<LoadedBus> played_load(TomlTable& table, const std::string& path, Duration after,
                                   Duration length) {
  std::string name;
  table.take("network", name);
  const auto world = std::ranges::find(worlds(), name, &WorldEntry::name);
  if (world == worlds().end()) {
    table.refuse("network", fmt::format("'{}' is not known; there are {}", name, world_names()));
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const HeardWorld made = world->make(table, folder);
  PlayedNetwork& network = *made.network;
  const std::vector<std::string> names = network.bus_names();
  network.run_until(Time(after));
  struct Ear {
    HeardLoad* load;
    std::string name;
  };
  HeardLoad load;
  std::vector<Ear> ears;
  ears.reserve(names.size());
  for (const std::string& name : names) ears.push_back({&load, name});
  for (BusIndex bus = 0; bus < names.size(); ++bus) {
    network.world().bus(bus).observe(
        {.context = &ears[bus],
         .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
           const Ear& ear = *static_cast<Ear*>(context);
           ear.load->add(now.time_since_epoch(), ear.name, frame);
         }});
  }
  network.run_until(Time(after + length));
  std::vector<LoadedBus> buses = load.buses(length);
  for (LoadedBus& bus : buses) {
    const auto index = static_cast<BusIndex>(std::ranges::find(names, bus.name) - names.begin());
    bus.bit_rate = made.bit_rates.at(index);
  }
  return buses;
}

constexpr Duration listening = 10s;
constexpr Duration usual_playing = 1min;

struct LoadOptions {
  std::string source;
  std::string after;
  std::string duration;
  std::string bus;
  std::vector<std::string> added;
  std::string deadlines;
  std::string error_each;
  std::string svg;
  unsigned bit_rate = 0;  ///< kbit/s; 0: from the source
  unsigned errors = 0;
  bool json = false;
};

std::uint32_t said_bit_rate(const LoadOptions& options) {
  constexpr std::uint32_t kilo = 1000;
  return options.bit_rate * kilo;
}

std::vector<LoadedBus> load_of_log(const LoadOptions& options) {
  LogReader trace(value_or_throw(formats::TraceReader::open(options.source)));
  TraceProgress progress(trace);
  HeardLoad load;
  const Duration limit = parse_duration_argument(options.duration, Duration::max());
  const Duration after = parse_duration_argument(options.after, Duration{});
  std::optional<Time> first;
  formats::TraceFrame heard;
  for (formats::TraceRead read; (read = trace.next(heard)) != formats::TraceRead::end;) {
    if (read == formats::TraceRead::bad) show_bad(options.source, trace);
    progress.show(trace);
    if (read != formats::TraceRead::frame) continue;
    if (!first) first = heard.time + after;
    if (heard.time < *first) continue;
    if (heard.time - *first > limit) break;
    load.add(heard.time.time_since_epoch(), heard.channel, heard.frame);
  }
  refuse_log_without_frames(options.source, trace);
  return load.buses(Duration{});
}

std::vector<LoadedBus> load_of_bus(const LoadOptions& options) {
  const Duration length = parse_duration_argument(options.duration, listening);
  Session session(options.source);
  if (!options.after.empty()) session.run_for(parse_duration_argument(options.after));
  HeardLoad load;
  for (host::HostBus* bus : session.buses()) {
    bus->on_frame([&load, bus](const host::BusFrame& heard) {
      load.add(heard.time.time_since_epoch(), bus->name(), heard.frame);
    });
  }
  session.run_for(length);
  if (session.was_lost()) {
    throw Failure(fmt::format("{}: the bus was lost while it was listened to: no load is told",
                              options.source));
  }
  std::vector<LoadedBus> buses = load.buses(length);
  for (LoadedBus& bus : buses) {
    const auto link = host::read_can_link(bus.name);
    if (link) bus.bit_rate = link->bit_rate;
  }
  return buses;
}

std::vector<LoadedBus> load_of_sheets(const LoadOptions& options) {
  std::map<std::string, std::vector<DescribedNode>> by_bus;
  for (DescribedNode& node : describe_nodes(options.source)) {
    const std::string name = node.bus.empty() ? options.source : node.bus;
    by_bus[name].push_back(std::move(node));
  }
  std::vector<LoadedBus> buses;
  for (const auto& [name, nodes] : by_bus) {
    LoadedBus& bus = buses.emplace_back();
    bus.name = name;
    bus.bit_rate = said_bit_rate(options);
    add_sheet_messages(bus, nodes);
  }
  return buses;
}

std::vector<LoadedBus> load_of_file(const LoadOptions& options) {
  TomlFile file(options.source);
  const auto refuse_duration = [&] {
    if (!options.duration.empty() || !options.after.empty())
      throw UsageError(fmt::format("--for and --after are for what is listened to: {} is a plan",
                                   options.source));
  };
  if (file.table().has("network"))
    return played_load(file.table(), options.source,
                       parse_duration_argument(options.after, Duration{}),
                       parse_duration_argument(options.duration, usual_playing));
  refuse_duration();
  if (!is_message_list(file.table())) return load_of_sheets(options);
  return {read_message_list(file.table(), options.source)};
}

std::vector<LoadedBus> load_of_source(const LoadOptions& options) {
  if (options.source.ends_with(".toml")) return load_of_file(options);
  return is_log_source(options.source) ? load_of_log(options) : load_of_bus(options);
}

void keep_bus(std::vector<LoadedBus>& buses, const LoadOptions& options) {
  if (options.bus.empty()) return;
  std::string names;
  for (const LoadedBus& each : buses) names += (names.empty() ? "" : ", ") + each.name;
  std::erase_if(buses, [&](const LoadedBus& each) { return each.name != options.bus; });
  if (!buses.empty()) return;
  throw UsageError(
      fmt::format("{}: there is no bus {}; there are {}", options.source, options.bus, names));
}

/// Adds planned messages.
void add_more(std::vector<LoadedBus>& buses, const LoadOptions& options) {
  if (options.added.empty()) return;
  if (buses.size() != 1) throw UsageError("to which bus is it added? say --bus NAME");
  for (const std::string& each : options.added) {
    if (each.ends_with(".toml")) {
      TomlFile file(each);
      if (is_message_list(file.table())) {
        add_messages(buses.front(), read_message_list(file.table(), each).messages);
        continue;
      }
    }
    static_cast<void>(model_of(buses.front()));  // the bit rate must be known
    add_sheet_messages(buses.front(), describe_nodes(each));
  }
}

/// Neither silence nor error frames alone are a load of 0 %, and one moment has none.
void refuse_nothing(const std::vector<LoadedBus>& buses, const LoadOptions& options) {
  const std::string& source = options.source;
  if (buses.empty()) {
    throw Failure(options.after.empty()
                      ? fmt::format("{}: nothing was heard", source)
                      : fmt::format("{}: nothing was heard after {}", source, options.after));
  }
  const bool has_frames = std::ranges::any_of(buses, [](const LoadedBus& each) {
    return !each.messages.empty() || !each.left_out.empty();
  });
  if (!has_frames && buses.front().error_frames != 0) {
    throw Failure(fmt::format("{}: error frames alone; canvoy doctor says what is wrong", source));
  }
  if (buses.front().heard == one_moment) {
    throw Failure(fmt::format("{}: its frames have one time: a load needs some seconds", source));
  }
}

int show_load(const LoadOptions& options) {
  if (!options.svg.empty() && !options.svg.ends_with(".svg"))
    throw UsageError(fmt::format("'{}' ends like no picture: .svg", options.svg));
  const Duration each =
      options.error_each.empty() ? Duration{} : parse_duration_argument(options.error_each);
  std::vector<LoadedBus> buses = load_of_source(options);
  refuse_nothing(buses, options);
  keep_bus(buses, options);
  for (LoadedBus& bus : buses) {
    if (options.bit_rate != 0) bus.bit_rate = said_bit_rate(options);
    if (options.errors != 0) bus.errors.at_once = options.errors;
    if (each != Duration{}) bus.errors.each = each;
  }
  add_more(buses, options);
  if (!options.deadlines.empty()) {
    TomlFile file(options.deadlines);
    read_deadlines(file.table(), buses);
  }
  std::vector<LoadResult> results;
  bool is_late = false;
  for (const LoadedBus& bus : buses) {
    results.push_back(result_of(bus));
    is_late = is_late || results.back().late != 0;
  }
  for (std::size_t i = 0; i < buses.size(); ++i) {
    if (i > 0 && !options.json) fmt::print("\n");
    fmt::print("{}",
               options.json ? json_text(buses[i], results[i]) : table_text(buses[i], results[i]));
  }
  if (!options.svg.empty()) {
    const std::string text = picture_text(buses, results);
    write_value_file(options.svg,
                     {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  return is_late ? exit_failed : exit_done;
}

}  // namespace

void add_load(Verb& app) {
  const auto options = std::make_shared<LoadOptions>();
  Verb& command = app.add_verb("load", "Show what a bus carries, and how late each message can be");
  command.add({
      {"source", options->source,
       "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0; a log of any format that canvoy decode "
       "reads; a network that canvoy run plays, nodes with their data sheets, or a list of "
       "messages: "
       "FILE.toml",
       required},
      {"--for", options->duration,
       "listen for so long: 30s, 10min (default: 10s to a bus, 1min to a network that is played, "
       "all of a log)"},
      {"--after", options->after,
       "listen from then on: what networks send while they boot is left out"},
      {"--bus", options->bus, "of several buses, this one alone"},
      {"--bit-rate", options->bit_rate,
       "in kbit/s: what if it were this one (default: that of the bus)", between(1U, 1000U)},
      {"--add", options->added,
       "what if this were there as well: a list of messages, a data sheet, or a device as "
       "20=charger",
       one_each},
      {"--deadlines", options->deadlines, "other deadlines than the periods: FILE.toml"},
      {"--errors", options->errors, "errors on the bus, as many at once", between(1U, 1000U)},
      {"--error-each", options->error_each, "one more error in each such time: 100ms"},
      {"--svg", options->svg, "draw responses and deadlines into this file"},
      {"--json", options->json, "one JSON object a line"},
  });
  command.set_footer(
      "Responses are the longest that can be, by the analysis of Davis, Burns, Bril and Lukkien\n"
      "(2007). The exit status is 1 where a deadline can be missed.\n"
      "Examples:\n"
      "  canvoy load can0 --bit-rate 125 --for 3s\n"
      "  canvoy load night.log --bit-rate 125 --after 10s\n"
      "  canvoy load charging.toml --after 10s --svg load.svg\n"
      "  canvoy load charging.toml --bit-rate 250 --errors 2 --json");
  command.runs([options] { return show_load(*options); });
}

}  // namespace canvoy::tools
