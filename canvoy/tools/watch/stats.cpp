// canvoy stats LOG|BUS: how often each CAN-ID comes, with which cycle and jitter, and what it takes
// of the bus.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/log_source.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/watch/decode_log.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"
#include "canvoy/tools/watch/trace_progress.hpp"
#include "canvoy/tools/watch/value_table.hpp"

namespace canvoy::tools {

namespace {

struct StatsOptions {
  std::string source;
  std::string duration;   ///< of a bus
  unsigned bit_rate = 0;  ///< in kbit/s; 0: not known
  bool json = false;
  bool csv = false;
};

/// Statistics of the frames with one CAN-ID on one bus.
struct IdStatistics {
  std::string service = {};
  NodeId node = 0;
  std::uint64_t count = 0;
  std::uint64_t bits = 0;
  Time latest{};
  // Statistics of the intervals, in seconds (Welford's method, which keeps the precision).
  double mean = 0;
  double squares = 0;
  double least = 0;
  double most = 0;

  void add(Time time, unsigned frame_bits_taken) {
    bits += frame_bits_taken;
    if (++count > 1) add_period(static_cast<double>((time - latest).count()) / 1e6);
    latest = time;
  }
  double jitter() const {
    return count > 2 ? std::sqrt(squares / static_cast<double>(count - 2)) : 0;
  }

 private:
  void add_period(double period) {
    const auto periods = static_cast<double>(count - 1);
    const double before = period - mean;
    mean += before / periods;
    squares += before * (period - mean);
    least = count == 2 ? period : std::min(least, period);
    most = std::max(most, period);
  }
};

struct IdOfBus {
  std::string bus;
  std::uint32_t id = 0;
  bool is_extended = false;
  friend auto operator<=>(const IdOfBus&, const IdOfBus&) = default;
};

class Statistics {
 public:
  explicit Statistics(const StatsOptions& options) : options_(options) {}

  /// Of a bus, for some time or until the user ends it.
  void listen() {
    Session session(options_.source);
    for (host::HostBus* bus : session.buses()) {
      bus->on_frame([this, bus](const host::BusFrame& heard) {
        take({.time = heard.time, .frame = heard.frame, .channel = bus->name()});
      });
    }
    const Duration time =
        options_.duration.empty() ? listen_time : parse_duration_argument(options_.duration);
    session.loop().run_until(session.loop().now() + time);
    if (frames_ == 0 && !session.loss().empty()) throw Failure(session.loss());
    was_lost_ = session.was_lost();
    if (frames_ == 0) {
      throw Failure(options_.source + ": no frame was heard; --for 1min listens longer");
    }
  }

  void read() {
    if (!options_.duration.empty()) throw UsageError("--for is for a bus: of a log all is read");
    LogReader trace(value_or_throw(formats::TraceReader::open(options_.source)));
    TraceProgress progress(trace);
    formats::TraceFrame heard;
    for (formats::TraceRead read; (read = trace.next(heard)) != formats::TraceRead::end;) {
      if (read == formats::TraceRead::bad) show_bad(options_.source, trace);
      progress.show(trace);
      if (read == formats::TraceRead::frame) take(heard);
    }
    refuse_log_without_frames(options_.source, trace);
  }

  /// Prints the table, and returns the exit status.
  int report() const {
    print();
    if (!was_lost_) return exit_done;
    print_message(
        fmt::format("canvoy: {}: the bus was lost meanwhile; what is told is of what was heard",
                    options_.source));
    return exit_failed;
  }

 private:
  void print() const {
    if (options_.json) return print_json();
    if (options_.csv) return print_csv();
    fmt::print("{:<8} {:<19} {:>8} {:>8} {:>8} {:>8} {:>8} {:>6}\n", "CAN-ID", "service", "frames",
               "per s", "cycle ms", "jitter", "longest", load_head());
    std::string bus;
    for (const auto& [id, each] : ids_) {
      if (has_several_buses() && id.bus != bus) fmt::print("{}\n", id.bus);
      bus = id.bus;
      fmt::print("{:<8} {:<19} {:>8} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>6.2f}\n", id_text(id),
                 service_text(each), each.count, rate(each), each.mean * 1e3, each.jitter() * 1e3,
                 each.most * 1e3, load(each));
    }
    fmt::print("{} frames in {:.3f} s, {:.1f} a second{}\n", frames_, seconds(),
               static_cast<double>(frames_) / seconds(), load_text());
  }

  void take(const formats::TraceFrame& heard) {
    if (frames_++ == 0) first_ = heard.time;
    last_ = std::max(last_, heard.time);
    const unsigned bits = frame_bits(heard.frame) + intermission_bits;
    bits_ += bits;
    IdOfBus key{std::string(heard.channel), heard.frame.id, heard.frame.is_extended()};
    if (heard.frame.is_error()) key.id = ~0U;
    IdStatistics& each = ids_[key];
    if (each.count == 0) {
      text::FrameDecoder decoder;
      const text::FrameWords& words = decoder.decode(heard.frame);
      each.service = words.service;
      each.node = words.node;
    }
    each.add(heard.time, bits);
  }

  bool has_several_buses() const {
    return !ids_.empty() && ids_.begin()->first.bus != ids_.rbegin()->first.bus;
  }
  /// At least one, so that a single frame has a rate.
  double seconds() const {
    return std::max(static_cast<double>((last_ - first_).count()) / 1e6, 1e-6);
  }
  static std::string id_text(const IdOfBus& id) {
    if (id.id == ~0U) return "error";
    return fmt::format("{:0{}X}", id.id, id.is_extended ? 8 : 3);
  }
  static std::string service_text(const IdStatistics& each) {
    return each.node == 0 ? each.service : fmt::format("{} {}", each.service, each.node);
  }
  double rate(const IdStatistics& each) const {
    return static_cast<double>(each.count) / seconds();
  }
  const char* load_head() const { return options_.bit_rate == 0 ? "% bits" : "load %"; }
  /// Share of the bus, or of all bits if the bit rate is unknown.
  double load(const IdStatistics& each) const {
    const double all =
        options_.bit_rate == 0 ? static_cast<double>(bits_) : options_.bit_rate * 1e3 * seconds();
    return static_cast<double>(each.bits) / all * 100;
  }
  std::string load_text() const {
    if (options_.bit_rate == 0) return "; --bit-rate 125 tells the load";
    return fmt::format("; {:.1f} % of {} kbit/s",
                       static_cast<double>(bits_) / (options_.bit_rate * 1e3 * seconds()) * 100,
                       options_.bit_rate);
  }

  void print_json() const {
    for (const auto& [id, each] : ids_) {
      std::string line;
      text::JsonLine json(line);
      json.begin_object();
      json.key("bus").text(id.bus);
      json.key("id").text(id_text(id));
      json.key("service").text(each.service);
      if (each.node != 0) json.key("node").number(each.node);
      json.key("frames").number(each.count);
      json.key("per_second").number(rate(each));
      json.key("cycle_s").number(each.mean);
      json.key("jitter_s").number(each.jitter());
      json.key("shortest_s").number(each.least);
      json.key("longest_s").number(each.most);
      json.key(options_.bit_rate == 0 ? "bits_percent" : "load_percent").number(load(each));
      json.end_object();
      fmt::print("{}\n", line);
    }
  }

  void print_csv() const {
    fmt::print("bus,id,service,node,frames,per_second,cycle_s,jitter_s,shortest_s,longest_s,{}\n",
               options_.bit_rate == 0 ? "bits_percent" : "load_percent");
    for (const auto& [id, each] : ids_) {
      std::string line;
      append_csv_cell(line, id.bus);
      line += ',' + id_text(id) + ',';
      append_csv_cell(line, each.service);
      fmt::print("{},{},{},{},{},{},{},{},{}\n", line,
                 each.node == 0 ? "" : std::to_string(each.node), each.count, rate(each), each.mean,
                 each.jitter(), each.least, each.most, load(each));
    }
  }

  static constexpr Duration listen_time = 10s;

  const StatsOptions& options_;
  std::map<IdOfBus, IdStatistics> ids_;
  std::uint64_t frames_ = 0;
  std::uint64_t bits_ = 0;
  Time first_{};
  Time last_{};
  bool was_lost_ = false;
};

}  // namespace

void add_stats(Verb& app) {
  const auto options = std::make_shared<StatsOptions>();
  Verb& command = app.add_verb(
      "stats", "Show rates, cycle times with jitter and load of each CAN-ID of a log or bus");
  command.add({
      {"source", options->source,
       "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0; several as can0,can1; or " +
           log_argument_text(),
       required},
      {"--for", options->duration, "of a bus: listen for so long: 30s, 10min (default 10s)"},
      {"--bit-rate", options->bit_rate, "in kbit/s, for the load", between(1U, 1000U)},
      {"--json", options->json, "one JSON object a line"},
      {"--csv", options->csv, "a row for each CAN-ID", excludes("--json")},
  });
  command.add_examples(
      "  canvoy stats night.log\n"
      "  canvoy stats can0 --for 1s\n"
      "  canvoy stats night.log --csv\n"
      "  canvoy stats night.log --bit-rate 125 --json");
  command.runs([options] {
    Statistics statistics(*options);
    if (is_log_source(options->source)) {
      statistics.read();
    } else {
      statistics.listen();
    }
    return statistics.report();
  });
}

}  // namespace canvoy::tools
