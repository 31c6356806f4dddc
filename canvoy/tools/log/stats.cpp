// canvoy stats LOG: how often each CAN-ID comes, with which cycle and jitter, and what it takes of
// the bus.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/log/decode_log.hpp"
#include "canvoy/tools/log/trace_complaints.hpp"
#include "canvoy/tools/log/trace_progress.hpp"
#include "canvoy/words/frame_decoder.hpp"
#include "canvoy/words/json_line.hpp"

namespace canvoy::tools {

namespace {

struct StatsOptions {
  std::string log;
  unsigned bit_rate = 0;  ///< in kbit/s; 0: not known
  bool json = false;
};

/// Of the frames with one CAN-ID on one bus.
struct IdStatistics {
  std::string service = {};
  NodeId node = 0;
  std::uint64_t count = 0;
  std::uint64_t bits = 0;
  Time latest{};
  // Of the times between them, in seconds (Welford's way, which keeps its digits).
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

  void read() {
    formats::TraceReader trace = value_or_throw(formats::TraceReader::open(options_.log));
    TraceProgress progress(trace);
    formats::TraceFrame heard;
    for (formats::TraceRead read; (read = trace.next(heard)) != formats::TraceRead::end;) {
      if (read == formats::TraceRead::bad) show_bad(options_.log, trace);
      progress.show(trace);
      if (read == formats::TraceRead::frame) take(heard);
    }
    refuse_log_without_frames(options_.log, trace);
  }

  void print() const {
    if (options_.json) return print_json();
    fmt::print("{:<8} {:<12} {:>9} {:>10} {:>9} {:>9} {:>9} {:>6}\n", "CAN-ID", "service", "frames",
               "per s", "cycle ms", "jitter", "longest", load_head());
    std::string bus;
    for (const auto& [id, each] : ids_) {
      if (has_several_buses() && id.bus != bus) fmt::print("{}\n", id.bus);
      bus = id.bus;
      fmt::print("{:<8} {:<12} {:>9} {:>10.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>6.2f}\n", id_text(id),
                 service_text(each), each.count, rate(each), each.mean * 1e3, each.jitter() * 1e3,
                 each.most * 1e3, load(each));
    }
    fmt::print("{} frames in {:.3f} s, {:.1f} a second{}\n", frames_, seconds(),
               static_cast<double>(frames_) / seconds(), load_text());
  }

 private:
  void take(const formats::TraceFrame& heard) {
    if (frames_++ == 0) first_ = heard.time;
    last_ = std::max(last_, heard.time);
    const unsigned bits = frame_bits(heard.frame) + intermission_bits;
    bits_ += bits;
    IdOfBus key{std::string(heard.channel), heard.frame.id, heard.frame.is_extended()};
    if (heard.frame.is_error()) key.id = ~0U;
    IdStatistics& each = ids_[key];
    if (each.count == 0) {
      words::FrameDecoder decoder;
      const words::FrameWords& words = decoder.decode(heard.frame);
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
  /// Of the bus, or of all bits where its rate is not known.
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
      words::JsonLine json(line);
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

  const StatsOptions& options_;
  std::map<IdOfBus, IdStatistics> ids_;
  std::uint64_t frames_ = 0;
  std::uint64_t bits_ = 0;
  Time first_{};
  Time last_{};
};

}  // namespace

void add_stats(Verb& app) {
  const auto options = std::make_shared<StatsOptions>();
  Verb& command =
      app.add_verb("stats", "Show rates, cycle times with jitter and load of each CAN-ID of a log");
  command.add({
      {"log", options->log, log_argument_text(), required},
      {"--bit-rate", options->bit_rate, "in kbit/s, for the load", between(1U, 1000U)},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy stats night.log\n"
      "  canvoy stats night.log --bit-rate 125 --json");
  command.runs([options] {
    Statistics statistics(*options);
    statistics.read();
    statistics.print();
    return exit_done;
  });
}

}  // namespace canvoy::tools
