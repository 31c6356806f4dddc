// canvoy plot LOG OBJECT...: values over time, in their units.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "canvoy/decoder/active_field.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/cli/png_file.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/terminal/screen.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"
#include "canvoy/tools/watch/decode_log.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/plot_series.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"

namespace canvoy::tools {

namespace {

constexpr std::size_t series_max = 64;

struct PlotOptions {
  std::string log;
  std::vector<std::string> objects;
  std::string out;
  FramePrinterOptions printer;
};

/// Letters and digits only, in lower case.
std::string bare(std::string_view text) {
  std::string made;
  for (const char each : text) {
    if (each >= 'A' && each <= 'Z') made += static_cast<char>(each - 'A' + 'a');
    if ((each >= 'a' && each <= 'z') || (each >= '0' && each <= '9')) made += each;
  }
  return made;
}

/// `0x6020/2` as `602002`, `0x6020` as `6020`; empty: no index.
std::string digits_of(const std::string& text) {
  constexpr std::size_t digits = 4;
  const std::size_t begin = text.starts_with("0x") || text.starts_with("0X") ? 2 : 0;
  const std::size_t end =
      std::min(text.find_first_not_of("0123456789abcdefABCDEF", begin), text.size());
  const auto address = find_address(base_profile(), text);
  if (end != begin + digits || !address) return {};
  const bool is_whole = end == text.size() || (text[end] == 'h' && end + 1 == text.size());
  return fmt::format("{:04x}", address->index) +
         (is_whole ? "" : fmt::format("{:02x}", address->sub));
}

/// `6010`, `6010h:01h`, or a part of a name.
class WantedObject {
 public:
  explicit WantedObject(const std::string& text) : text_(text), bare_(bare(text)) {
    if (bare_.empty())
      throw UsageError(fmt::format("'{}' is no object: an index, or a part of a name", text));
    std::string digits = bare_;
    std::erase(digits, 'h');
    const bool is_index = (digits.size() == 4 || digits.size() == 6) &&
                          digits.find_first_not_of("0123456789abcdef") == std::string::npos;
    number_ = is_index ? digits : digits_of(text);
  }

  bool matches(const decoder::DecodedValue& value, std::string_view bare_name) {
    const std::string place = fmt::format("{:04x}{:02x}", value.index, value.sub);
    // Communication parameters have names of their content: they are given by index.
    constexpr std::uint16_t manufacturer_first = 0x2000;
    const bool is_named =
        value.index >= manufacturer_first && bare_name.find(bare_) != std::string_view::npos;
    const bool does = is_named || (!number_.empty() && place.starts_with(number_));
    is_found_ = is_found_ || does;
    return does;
  }
  bool is_found() const { return is_found_; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::string bare_;
  std::string number_;
  bool is_found_ = false;
};

class Plot {
 public:
  explicit Plot(const PlotOptions& options) : options_(options), printer_(options.printer) {
    for (const std::string& text : options.objects) wanted_.emplace_back(text);
  }

  void read() {
    LogReader trace(value_or_throw(formats::TraceReader::open(options_.log)));
    formats::TraceFrame heard;
    for (auto read = trace.next(heard); read != formats::TraceRead::end; read = trace.next(heard)) {
      if (read != formats::TraceRead::frame) continue;
      const Duration time = heard.time.time_since_epoch();
      const text::FrameWords* words = printer_.look(time, heard.channel, heard.frame);
      if (words == nullptr) continue;
      if (!first_bus_) first_bus_ = heard.channel;
      has_buses_ = has_buses_ || heard.channel != *first_bus_;
      for (const decoder::DecodedValue& value : words->values)
        take(time, heard.channel, words->node, value);
    }
    refuse_log_without_frames(options_.log, trace);
    print_unknown_pdos(options_.log, printer_, {.fate = "left out"});
    for (const WantedObject& wanted : wanted_) {
      if (!wanted.is_found())
        throw Failure(fmt::format(
            "{}: no value in it is called '{}'; canvoy monitor {} --table shows those that are{}",
            options_.log, wanted.text(), options_.log, did_you_mean(wanted.text(), names())));
    }
    if (!options_.printer.json && curves_.empty())
      throw Failure(fmt::format("{}: what was asked for has no number in it", options_.log));
  }

  std::vector<PlotSeries> series() const {
    std::vector<PlotSeries> made;
    for (const Curve& curve : curves_) {
      made.push_back(curve.series);
      made.back().rename(label(curve));
    }
    return made;
  }

 private:
  /// State of an entry of a node: whether it is selected, and the series of its numbers.
  struct Known {
    const EntryInfo* entry = nullptr;
    bool is_wanted = false;
    std::string name;
    std::map<const FieldInfo*, PlotSeries*> series;
  };
  using Key = std::tuple<std::string, NodeId, std::uint16_t, std::uint8_t>;
  struct Curve {
    PlotSeries series;
    std::string bus;
    NodeId node = 0;  ///< 0: unknown node
  };

  /// `temperature (10)`; with the bus if the log has several, which is only known at its end.
  std::string label(const Curve& curve) const {
    std::vector<std::string> places;
    if (curve.node != 0) places.push_back(fmt::format("{}", curve.node));
    if (has_buses_) places.push_back(fmt::format("on {}", formats::plain_text(curve.bus)));
    if (places.empty()) return curve.series.name();
    return fmt::format("{} ({})", curve.series.name(), fmt::join(places, " "));
  }

  /// Names of all values that were seen.
  std::vector<std::string> names() const {
    std::set<std::string> found;
    for (const auto& [key, known] : known_) found.insert(known.name);
    return {found.begin(), found.end()};
  }

  void take(Duration time, std::string_view bus, NodeId node, const decoder::DecodedValue& value) {
    Known& known = known_[{std::string(bus), node, value.index, value.sub}];
    if (known.entry != value.entry || known.name.empty()) {
      known.entry = value.entry;
      known.name = text::object_name_text(value);
      known.is_wanted = false;
      for (WantedObject& wanted : wanted_)
        known.is_wanted = wanted.matches(value, bare(known.name)) || known.is_wanted;
    }
    if (!known.is_wanted || value.entry == nullptr) return;
    const EntryInfo& entry = *value.entry;
    if (entry.fields.empty())
      return add(known, time, bus, node, value, nullptr, read_value(entry, value.bytes()));
    for (const FieldInfo& field : entry.fields) {
      if (!decoder::is_active(entry, field, value.bytes())) continue;
      add(known, time, bus, node, value, &field, read_field(entry, field, value.bytes()));
    }
  }

  void add(Known& known, Duration time, std::string_view bus, NodeId node,
           const decoder::DecodedValue& value, const FieldInfo* field, const Reading& reading) {
    if (reading.kind != Reading::Kind::number) return;
    const double at = static_cast<double>(time.count()) / 1e6;
    const std::string_view unit = symbol(reading.value->unit);
    if (options_.printer.json) return print(at, bus, node, value, known.name, field, reading);
    PlotSeries*& series = known.series[field];
    if (series == nullptr) {
      if (curves_.size() == series_max)
        throw Failure(fmt::format("{}: there are more than {} values of this: say which",
                                  options_.log, series_max));
      const bool is_only = field == nullptr || field == only_field(*value.entry);
      const std::string name =
          is_only ? known.name : known.name + ", " + formats::field_name(*field);
      series =
          &curves_.emplace_back(PlotSeries(name, std::string(unit)), std::string(bus), node).series;
    }
    series->add(at, reading.number);
  }

  static void print(double at, std::string_view bus, NodeId node,
                    const decoder::DecodedValue& value, const std::string& name,
                    const FieldInfo* field, const Reading& reading) {
    std::string line;
    text::JsonLine json(line);
    json.begin_object();
    json.key("time").number(at);
    json.key("bus").text(formats::plain_text(bus));
    if (node != 0) json.key("node").number(std::int64_t{node});
    append_index(json, value.index, value.sub);
    json.key("name").text(name);
    if (field != nullptr) json.key("field").text(formats::field_name(*field));
    json.key("value").number(reading.number);
    if (reading.value->unit != Unit::none) json.key("unit").text(symbol(reading.value->unit));
    json.end_object();
    fmt::print("{}\n", line);
  }

  const PlotOptions& options_;
  FramePrinter printer_;
  std::deque<WantedObject> wanted_;
  std::map<Key, Known> known_;
  std::deque<Curve> curves_;
  std::optional<std::string> first_bus_;
  bool has_buses_ = false;
};

int plot(const PlotOptions& options) {
  const bool is_svg = options.out.ends_with(".svg");
  const bool is_png = options.out.ends_with(".png");
  if (!options.out.empty() && !is_svg && !is_png)
    throw UsageError(fmt::format("'{}' ends like no picture: .svg or .png", options.out));
  if (!options.out.empty() && options.printer.json)
    throw UsageError("--json prints lines, and --out writes a picture");
  Plot plot(options);
  plot.read();
  if (options.printer.json) return exit_done;
  const std::vector<PlotSeries> series = plot.series();
  if (is_svg) {
    const std::string text = plot_svg(series, options.log);
    write_value_file(options.out,
                     {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return exit_done;
  }
  if (is_png) {
    write_png(options.out, plot_dots(series, options.log));
    return exit_done;
  }
  const Screen::Size size = Screen::size();
  fmt::print("{}", plot_text(series, size.columns, size.rows - 2, wants_colour(STDOUT_FILENO)));
  return exit_done;
}

}  // namespace

void add_plot(Verb& app) {
  const auto options = std::make_shared<PlotOptions>();
  Verb& command = app.add_verb("plot", "Show values of a log over time");
  command.add({
      {"log", options->log, log_argument_text(), required},
      {"objects", options->objects, "6010, 6020:02, or a part of a name: temperature", required},
      {"--out", options->out,
       "write a picture into this file: .svg or .png (default: on the terminal)"},
  });
  options->printer.add_nodes_to(command);
  options->printer.add_filter_to(command);
  command.add({
      {"--json", options->printer.json, "one JSON object for each value"},
  });
  command.add_examples(
      "  canvoy plot night.log temperature\n"
      "  canvoy plot night.log temperature voltage --out night.svg\n"
      "  canvoy plot night.log temperature --out night.png\n"
      "  canvoy plot night.log 6010 --node 10=418 --filter 'time<1h'\n"
      "  canvoy plot night.log state_of_charge --json");
  command.runs([options] { return plot(*options); });
}

}  // namespace canvoy::tools
