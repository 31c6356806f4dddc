// canvoy replay LOG BUS: the frames of a log on a bus again, at their times.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/watch/decode_log.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"

namespace canvoy::tools {

namespace {

struct ReplayOptions {
  std::string log;
  std::string bus;
  std::vector<std::string> nodes;
  double speed = 1;
  unsigned loops = 1;
  bool json = false;
};

/// Buses, and which bus of the log each one gets.
struct Routes {
  std::string buses;                  ///< with commas between them
  std::vector<std::string> channels;  ///< of each; empty: that of its name, or the next
};

/// `can0,can1`, or as canplayer has it `can0=vcan0`: to can0 goes what the log has of vcan0. The
/// sign in `udp:?ttl=1` is part of the bus.
Routes parse_routes(std::string_view text) {
  Routes routes;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view part = text.substr(0, comma);
    const std::size_t sign = part.find('=', std::min(part.find('?') + 1, part.size()));
    const bool is_option = part.find('?') != std::string_view::npos;
    const std::size_t end =
        is_option && sign != std::string_view::npos ? part.find('=', sign + 1) : sign;
    if (!routes.buses.empty()) routes.buses += ',';
    routes.buses += part.substr(0, end);
    routes.channels.emplace_back(end == std::string_view::npos ? "" : part.substr(end + 1));
    if (comma == std::string_view::npos) return routes;
    text.remove_prefix(comma + 1);
  }
}

class Replay {
 public:
  explicit Replay(const ReplayOptions& options) : Replay(options, parse_routes(options.bus)) {}

  int run() {
    for (unsigned round = 0; !is_over_ && (options_.loops == 0 || round < options_.loops); ++round)
      play();
    // Waiting frames are sent before the bus is closed.
    if (!is_over_) session_.loop().run_until(session_.loop().now() + Duration(20ms));
    tell();
    if (!session_.loss().empty()) throw Failure(session_.loss());
    return is_over_ ? exit_failed : exit_done;
  }

 private:
  Replay(const ReplayOptions& options, const Routes& routes)
      : options_(options), session_(routes.buses), buses_(session_.buses()) {
    for (const std::string& node : options.nodes) nodes_.insert(parse_node_id(node));
    for (std::size_t i = 0; i < routes.channels.size(); ++i) {
      if (!routes.channels[i].empty()) chosen_.emplace(routes.channels[i], buses_.at(i));
    }
  }

  void play() {
    LogReader trace(value_or_throw(formats::TraceReader::open(options_.log)));
    std::map<std::string, text::FrameDecoder, std::less<>> decoders;
    formats::TraceFrame heard;
    std::optional<Time> first;
    const Time begin = session_.loop().now();
    for (formats::TraceRead read; (read = trace.next(heard)) != formats::TraceRead::end;) {
      if (read == formats::TraceRead::bad) show_bad(options_.log, trace);
      if (read != formats::TraceRead::frame) continue;
      if (!first) first = heard.time;
      auto decoder = decoders.find(heard.channel);
      if (decoder == decoders.end()) {
        decoder = decoders.try_emplace(std::string(heard.channel)).first;
      }
      // Decodes all frames, so that mappings are those of the log.
      const NodeId node = decoder->second.decode(heard.frame).node;
      if (heard.frame.is_error() || (!nodes_.empty() && !nodes_.contains(node))) {
        ++left_out_;
        continue;
      }
      if (!wait_for(begin, heard.time - *first)) return;
      send(heard);
      if (is_over_) return;
    }
    refuse_log_without_frames(options_.log, trace);
  }

  /// False: the user has ended it.
  bool wait_for(Time begin, Duration offset) {
    const bool is_timed = options_.speed > 0 && offset >= Duration::zero();
    const Time now = session_.loop().now();
    const Time due = is_timed ? begin + Duration(static_cast<std::int64_t>(
                                            static_cast<double>(offset.count()) / options_.speed))
                              : now;
    latest_ = std::max(latest_, now - due);
    // If it is late, or at full speed, it checks signals and sockets at intervals.
    constexpr std::uint64_t frames_between = 64;
    if (now < due || sent_ % frames_between == 0) {
      is_over_ = session_.loop().run_until(due) == host::EventLoop::End::stopped;
    }
    return !is_over_;
  }

  void send(const formats::TraceFrame& heard) {
    host::HostBus& bus = bus_of(heard.channel);
    constexpr int tries_max = 10'000;
    for (int tries = 0; !bus.send(heard.frame); ++tries) {
      is_over_ = !session_.loss().empty();
      if (is_over_) return;
      if (tries == tries_max) {
        throw Failure(fmt::format(
            "{} takes no frames: is another node there to acknowledge, at the same bit rate?",
            bus.name()));
      }
      const Time until = session_.loop().now() + Duration(1ms);
      if (session_.loop().run_until(until) == host::EventLoop::End::stopped) {
        is_over_ = true;
        return;
      }
    }
    ++sent_;
  }

  /// The bus with its name, else the next of the given ones.
  host::HostBus& bus_of(std::string_view channel) {
    const auto known = chosen_.find(channel);
    if (known != chosen_.end()) return *known->second;
    const auto named = std::ranges::find(buses_, channel, &host::HostBus::name);
    host::HostBus* const bus =
        named != buses_.end() ? *named : buses_.at(chosen_.size() % buses_.size());
    chosen_.emplace(channel, bus);
    return *bus;
  }

  void tell() const {
    const double late_ms = static_cast<double>(latest_.count()) / 1000;
    if (options_.json) {
      JsonEvent event("replayed");
      event->key("file").text(options_.log);
      event->key("sent").number(sent_);
      event->key("left_out").number(left_out_);
      event->key("latest_ms").number(late_ms);
      event.print();
      return;
    }
    fmt::print("{} frames sent, {} left out; the latest {:.1f} ms behind its time\n", sent_,
               left_out_, late_ms);
    for (const auto& [channel, bus] : chosen_) {
      if (channel != bus->name()) fmt::print("{} of the log went to {}\n", channel, bus->name());
    }
  }

  const ReplayOptions& options_;
  Session session_;
  std::vector<host::HostBus*> buses_;
  std::map<std::string, host::HostBus*, std::less<>> chosen_;
  std::set<NodeId> nodes_;
  std::uint64_t sent_ = 0;
  std::uint64_t left_out_ = 0;
  Duration latest_{};
  bool is_over_ = false;
};

}  // namespace

void add_replay(Verb& app) {
  const auto options = std::make_shared<ReplayOptions>();
  Verb& command = app.add_verb("replay", "Send the frames of a log on a bus again, at their times");
  command.add({
      {"log", options->log, log_argument_text(), required},
      {"bus", options->bus,
       "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0; several as can0,can1: a bus of the log "
       "goes to that of its name, or to the next; can0=vcan7: to can0 goes vcan7 of the log",
       required},
      {"--speed", options->speed, "2: twice as fast; 0: as fast as the bus takes it (default 1)",
       between(0.0, 1'000'000.0)},
      {"--loop", options->loops, "how often; 0 or nothing: until ^C (default 1)", may_be_bare},
      {"--node", options->nodes,
       "only what this node sends, or is sent to it; several: --node 5 7"},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy replay night.log can0 --speed 100\n"
      "  canvoy replay night.log can0 --speed 100 --node 10\n"
      "  canvoy replay night.log can0 --speed 0 --loop 2 --json");
  command.runs([options] { return Replay(*options).run(); });
}

}  // namespace canvoy::tools
