// canvoy monitor SOURCE: every frame on a bus, or in a log, with its service in words.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <memory>
#include <optional>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/bus_news.hpp"
#include "canvoy/tools/session/log_source.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"
#include "canvoy/tools/watch/decode_log.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"
#include "canvoy/tools/watch/line_output.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/log_writer.hpp"
#include "canvoy/tools/watch/monitor_table.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"

namespace canvoy::tools {

namespace {

struct MonitorOptions {
  std::string source;
  std::string log;
  std::string duration;
  std::string by = "object";
  std::uint64_t count = 0;
  unsigned bit_rate = 0;  ///< in kbit/s; 0: that of the interface
  bool table = false;
  bool ask = false;
  bool no_sheets = false;
  FramePrinterOptions printer;

  Duration limit() const {
    return duration.empty() ? Duration::max() : parse_duration_argument(duration);
  }
};

LiveTable::By parse_table_rows(const std::string& by) {
  if (by == "frame") return LiveTable::By::frame;
  return by == "node" ? LiveTable::By::node : LiveTable::By::object;
}

/// Nodes that are not known are told as they are heard, or below the table.
void show_unknown_pdos(const MonitorOptions& options, FramePrinter& printer) {
  const bool shows_bytes = !options.table && !options.printer.csv;
  const char* const fate = shows_bytes ? "shown as bytes" : "not decoded";
  print_unknown_pdos(options.source, printer, {.fate = fate, .only_with_guess = true});
}

class BusMonitor {
 public:
  explicit BusMonitor(const MonitorOptions& options)
      : options_(options),
        limit_(options.limit()),
        session_(options.source),
        printer_(options.printer),
        table_(parse_table_rows(options.by)),
        traffic_(options.table ? bit_rate_of(options.source, options.bit_rate) : 0) {
    if (!options.log.empty()) {
      log_.emplace(value_or_throw(LogWriter::create(options.log, session_.loop().epoch())));
    }
    const bool has_screen = options.table && !options.printer.json && Screen::is_there();
    if (has_screen) screen_.emplace(options.source, table_);
    use_sheets();
    for (host::HostBus* bus : session_.buses()) listen(*bus);
  }

  int run() {
    const Time end = limit_ == Duration::max() ? never : session_.loop().now() + limit_;
    while (!is_over_ && session_.loop().now() < end) step(end);
    if (log_) check(log_->finish());
    screen_.reset();
    if (options_.table) show_table();
    const std::string without_match = printer_.without_match();
    if (!without_match.empty())
      print_message(fmt::format("{}: {}", options_.source, without_match));
    show_unknown_pdos(options_, printer_);
    if (failure_) throw Failure(*failure_);
    return exit_done;
  }

 private:
  /// The sheets of the folder, if none were given.
  void use_sheets() {
    if (!options_.printer.sheets.empty() || options_.no_sheets) return;
    const std::vector<std::string> names = printer_.use_sheets_of(".");
    if (names.empty()) return;
    print_message(fmt::format("data sheets of this folder are used: {}; --no-sheets uses none",
                              fmt::join(names, ", ")));
  }

  void listen(host::HostBus& bus) {
    bus.on_frame([this, &bus](const host::BusFrame& heard) { show(bus.name(), heard); });
    news_.follow(bus);
  }

  /// Interval for the keyboard, for nodes to read, and for the log.
  static constexpr Duration period = 100ms;
  /// Interval for silent nodes and lost frames.
  static constexpr Duration news_period = 1s;
  /// The picture is drawn in every second step.
  static constexpr unsigned steps_per_picture = 2;

  void step(Time end) {
    const bool is_calm = !screen_ && !options_.ask && !log_;
    const Time until = std::min(end, session_.loop().now() + (is_calm ? news_period : period));
    if (session_.loop().run_until(until) == host::EventLoop::End::stopped) is_over_ = true;
    look_for_news();
    if (log_) check(log_->flush_each_second(session_.loop().now()));
    if (options_.ask && !is_over_) ask_next();
    if (!screen_) return;
    if (!screen_->take_keys()) is_over_ = true;
    if (++steps_ % steps_per_picture == 0) draw();
  }

  void look_for_news() {
    if (session_.loop().now() < next_news_ && !is_over_) return;
    news_.look(session_.loop().now());
    next_news_ = session_.loop().now() + news_period;
  }

  /// The answers are heard like all other frames.
  void ask_next() {
    if (const auto node = nodes_.next_unasked()) {
      for (const host::HostBus* bus : session_.buses()) {
        if (bus->name() == node->bus) session_.speak_on(*bus);
      }
      ask_node(session_, node->id);
    }
    is_over_ = is_over_ || session_.loop().signal() != 0;
  }

  void draw() {
    if (!screen_) return;
    const Duration now = session_.loop().epoch() + session_.loop().now().time_since_epoch();
    screen_->draw(now, traffic_.text(now), news_.text(session_.loop().now()),
                  table_.is_full() ? "there is no room for more rows" : nodes_.text());
  }

  /// Printed once if there is no terminal.
  void show_table() {
    const Duration now = session_.loop().epoch() + session_.loop().now().time_since_epoch();
    if (options_.printer.json) {
      fmt::print("{}", table_.json(now));
      return;
    }
    LiveTable::View view = {
        .now = now, .columns = terminal_width(STDOUT_FILENO), .rows = LiveTable::View::all};
    for (const std::string& line : table_.lines(view)) fmt::print("{}\n", line);
    fmt::print("{}\n", traffic_.text(now));
    if (!nodes_.text().empty()) fmt::print("{}\n", nodes_.text());
  }

  void show(std::string_view bus, const host::BusFrame& heard) {
    if (shown_ == options_.count && options_.count != 0) return;
    const Duration time = session_.loop().epoch() + heard.time.time_since_epoch();
    const text::FrameWords* words = printer_.look(time, bus, heard.frame);
    if (words != nullptr) nodes_.hear(bus, heard.frame, *words);
    if (options_.table) {
      traffic_.add(time, heard.frame);
      if (words != nullptr) table_.take(time, bus, heard.frame, *words);
    } else {
      if (words != nullptr) printer_.append_words(lines_.lines(), time, bus, heard.frame, *words);
      lines_.flush();
      report_unknown();
    }
    if (log_) check(log_->write(heard.time, bus, heard.frame));
    if (words != nullptr && ++shown_ == options_.count) session_.loop().stop();
  }

  /// Reports each node once, beside the output.
  void report_unknown() {
    if (options_.ask || options_.printer.json) return;
    const std::string text = nodes_.next_untold();
    if (!text.empty()) print_message(text);
  }

  /// A log that cannot be written ends the monitor.
  void check(const host::Result<void>& written) {
    if (written) return;
    failure_ = written.error().line();
    session_.loop().stop();
  }

  MonitorOptions options_;
  Duration limit_;
  Session session_;
  FramePrinter printer_;
  LineOutput lines_{options_.printer.json};
  LiveTable table_;
  BusTraffic traffic_;
  UnknownNodes nodes_;
  std::optional<TableScreen> screen_;
  std::optional<LogWriter> log_;
  std::optional<std::string> failure_;
  BusNews news_{[this](const std::string& line) {
    if (!screen_) print_message(line);
  }};
  Time next_news_{};
  std::uint64_t shown_ = 0;
  unsigned steps_ = 0;
  bool is_over_ = false;
};

/// The last values in a log, as a table.
int show_log_table(const MonitorOptions& options) {
  LogReader trace(value_or_throw(formats::TraceReader::open(options.source)));
  FramePrinter printer(options.printer);
  LiveTable table(parse_table_rows(options.by));
  UnknownNodes nodes;
  formats::TraceFrame heard;
  Duration last{};
  for (auto read = trace.next(heard); read != formats::TraceRead::end; read = trace.next(heard)) {
    if (read == formats::TraceRead::bad) show_bad(options.source, trace);
    if (read != formats::TraceRead::frame) continue;
    last = std::max(last, heard.time.time_since_epoch());
    const text::FrameWords* words =
        printer.look(heard.time.time_since_epoch(), heard.channel, heard.frame);
    if (words == nullptr) continue;
    nodes.hear(heard.channel, heard.frame, *words);
    table.take(heard.time.time_since_epoch(), heard.channel, heard.frame, *words);
  }
  refuse_log_without_frames(options.source, trace);
  show_unknown_pdos(options, printer);
  if (options.printer.json) {
    fmt::print("{}", table.json(last));
    return exit_done;
  }
  const LiveTable::View view = {
      .now = last, .columns = terminal_width(STDOUT_FILENO), .rows = LiveTable::View::all};
  for (const std::string& line : table.lines(view)) fmt::print("{}\n", line);
  if (!nodes.text().empty()) fmt::print("{}\n", nodes.text());
  return exit_done;
}

int show_log(const MonitorOptions& options) {
  if (!options.log.empty()) throw UsageError("--log is for a bus: this is a log already");
  if (options.ask) throw UsageError("--ask is for a bus: nobody answers in a log");
  if (options.table) return show_log_table(options);
  LogOptions log = {.log = options.source, .count = options.count, .printer = options.printer};
  if (!options.duration.empty()) log.limit = options.limit();
  return decode_log(log);
}

}  // namespace

void add_monitor(Verb& app) {
  const auto options = std::make_shared<MonitorOptions>();
  Verb& command = app.add_verb("monitor", "Show every frame on a bus or in a log in words");
  command.add({
      {"source", options->source,
       "can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0 of a socketcand; several as "
       "can0,can1; or a log of any format that canvoy decode reads: night.log, ./night",
       required},
      {"--log", options->log, log_option_text("write a log as well")},
      {"--for", options->duration, "end after this time: 30s, 10min, 8h"},
      {"--count", options->count, "end after as many frames", above_zero},
      {"--table", options->table,
       "one row for each object, with its value, age and rate, drawn anew; where no terminal shows "
       "it, once at the end"},
      {"--by",
       options->by,
       "rows of the table: object (default), frame or node",
       {.allowed = OneOf{"object", "frame", "node"}, .needs = "--table"}},
      {"--bit-rate",
       options->bit_rate,
       "in kbit/s, for the bus load (default: that of the interface)",
       {.allowed = Within<unsigned>{1, 1000}, .needs = "--table"}},
      {"--ask", options->ask,
       "ask each node that is heard for its device type, identity and PDOs, by SDO"},
      {"--no-sheets", options->no_sheets,
       "of a bus: do not use the data sheets of this folder (EDS, DCF, XDD, XDC)"},
  });
  options->printer.add_to(command);
  command.add({
      {"--csv", options->printer.csv, csv_text, excludes("--json", "--table")},
  });
  command.add_examples(
      "  canvoy monitor can0\n"
      "  canvoy monitor can0 --csv --for 500ms\n"
      "  canvoy monitor can0,can1 --for 500ms\n"
      "  canvoy monitor can0 --table\n"
      "  canvoy monitor can0 --table --by node --ask\n"
      "  canvoy monitor can0 --log night.log --for 8h\n"
      "  canvoy monitor can0 --filter 'id=180..4FF and not node=5'\n"
      "  canvoy monitor night.log --filter 'boot-up or service=SDO' --count 3\n"
      "  canvoy monitor night.log --node 10=418 --filter 'battery_status=ready'\n"
      "  canvoy monitor ./night.log --filter 'object=6000..6FFF' --json");
  command.runs([options] {
    return is_log_source(options->source) ? show_log(*options) : BusMonitor(*options).run();
  });
}

}  // namespace canvoy::tools
