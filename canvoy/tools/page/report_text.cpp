#include "canvoy/tools/page/report_text.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "canvoy/formats/plain_text.hpp"

namespace canvoy::tools {

namespace {

using formats::markup_text;
using Json = nlohmann::ordered_json;

template <class... Values>
void write(std::string& page, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(page), format, std::forward<Values>(values)...);
}

std::string text_at(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double number_in(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number() ? found->get<double>() : 0;
}

/// With as many digits as are useful.
std::string digits_of(double number) {
  constexpr double many = 100;
  const double size = std::abs(number);
  std::string text = fmt::format("{:.{}f}", number, size >= many ? 1 : size >= 1 ? 2 : 3);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string measured(double number, std::string_view unit) {
  return unit.empty() ? digits_of(number) : fmt::format("{} {}", digits_of(number), unit);
}

std::string begun_large(std::string text) {
  if (!text.empty())
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string title_of(const Json& about) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> titles = {{
      {"lift", "Lifts in a building"},
      {"charger", "Charger and battery"},
      {"charging-yard", "A charging yard"},
      {"taxi", "A taxi at work"},
      {"police", "A police car on patrol"},
      {"bus-line", "A bus on its line"},
      {"excavator", "An excavator at work"},
  }};
  std::string kind = text_at(about, "kind");
  for (const auto& [name, title] : titles) {
    if (name == kind) return std::string(title);
  }
  // A bus and a log are known by their names.
  const std::string source = text_at(about, "source");
  if (source.empty()) return kind;
  const std::size_t folder = kind == "log" ? source.rfind('/') : std::string::npos;
  return source.substr(folder == std::string::npos ? 0 : folder + 1);
}

void begin_card(std::string& page, std::string_view title) {
  write(page, "<section class=\"card\">\n<h2>{}</h2>\n", markup_text(title));
}
void end_card(std::string& page) {
  page += "</section>\n";
}

bool has_held(const Json& verdict) {
  return verdict.value("held", true);
}

/// With its exponent: m/s2 as m/s².
std::string unit_text(std::string unit) {
  if (unit.ends_with('2')) unit.replace(unit.size() - 1, 1, "²");
  if (unit.ends_with('3')) unit.replace(unit.size() - 1, 1, "³");
  return unit;
}

/// `for at most`: a number goes on with the sentence.
bool ends_before_number(std::string_view words) {
  return words.ends_with(" by") || words.ends_with(" most") || words.ends_with(" for");
}

std::string verdict_words(const Json& it) {
  std::string words = text_at(it, "words");
  if (words.empty()) words = text_at(it, "invariant");
  std::string what;
  if (number_in(it, "lift") != 0) what += fmt::format("lift {}: ", number_in(it, "lift"));
  if (const std::string fault = text_at(it, "fault"); !fault.empty()) what += fault + ": ";
  what = what.empty() ? begun_large(words) : what + words;
  if (!it.value("decided", true)) return what + ": not decided.";
  const std::string unit = unit_text(text_at(it, "unit"));
  const double worst = number_in(it, "worst");
  const double allowed = number_in(it, "allowed");
  what += (ends_before_number(what) ? " " : ": ") + measured(worst, unit);
  if (worst > 0 && it.contains("worst_at")) {
    what += ", at " + report_time_text(number_in(it, "worst_at"));
  }
  return what +
         (allowed == 0 ? "; none allowed." : fmt::format("; {} allowed.", measured(allowed, unit)));
}

/// Broken ones first, then those closest to their limit.
double verdict_weight(const Json& it) {
  constexpr double broken = 1e9;
  const double allowed = number_in(it, "allowed");
  const double near = allowed > 0 ? number_in(it, "worst") / allowed : 0;
  return (has_held(it) ? 0 : broken) + (it.value("decided", true) ? 1 + near : 0);
}

void put_verdicts(std::string& page, const Json& summary) {
  const auto found = summary.find("invariants");
  if (found == summary.end() || found->empty()) return;
  std::vector<Json> all(found->begin(), found->end());
  std::ranges::stable_sort(all, std::ranges::greater{}, verdict_weight);
  begin_card(page, "Verdicts");
  page += "<table class=\"plain verdicts\"><tbody>\n";
  for (const Json& it : all) {
    const bool held = has_held(it);
    const bool decided = it.value("decided", true);
    write(page, "<tr{}><td><span class=\"state{}\">{}</span></td><td>{}</td></tr>\n",
          held ? "" : " class=\"broken\"",
          !held     ? " bad"
          : decided ? " good"
                    : "",
          !held     ? "FAIL"
          : decided ? "PASS"
                    : "open",
          markup_text(verdict_words(it)));
  }
  page += "</tbody></table>\n";
  end_card(page);
}

/// Excludes what is elsewhere in the report, or of the last moment only.
bool is_statistic(std::string_view key) {
  constexpr std::array<std::string_view, 15> others = {
      "time", "event",    "invariants", "nodes", "buses",    "all_held", "all_decided", "movements",
      "seat", "displays", "lamps",      "paper", "terminal", "arm",      "wish"};
  return std::ranges::find(others, key) == others.end();
}

void put_statistics(std::string& page, const Json& from, const std::string& before) {
  constexpr std::size_t list_max = 8;
  for (const auto& [key, value] : from.items()) {
    if (!is_statistic(key)) continue;
    const auto [name, unit] = statistic_words(before, key);
    if (value.is_object()) {
      put_statistics(page, value, name);
    } else if (value.is_array() && !value.empty() && value.size() <= list_max) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i].is_object()) put_statistics(page, value[i], fmt::format("{} {}", name, i + 1));
      }
    } else if (value.is_number() || (value.is_string() && value != "")) {
      const std::string text =
          value.is_number() ? measured(value.get<double>(), unit) : value.get<std::string>();
      write(page, "<tr><td>{}</td><td class=\"number\">{}</td></tr>\n", markup_text(name),
            markup_text(text));
    }
  }
}

struct FaultSpan {
  double begin;
  double end;
  std::string fault;
};

std::vector<FaultSpan> fault_spans(const Json& events, double until) {
  std::vector<FaultSpan> spans;
  std::map<std::string, double> open;
  for (const Json& event : events) {
    const std::string what = text_at(event, "event");
    const std::string fault = text_at(event, "fault");
    const std::string key = fmt::format("{} {} {} {}", fault, text_at(event, "bus"),
                                        number_in(event, "node"), number_in(event, "lift"));
    if (what == "fault-begins") open[key] = number_in(event, "time");
    if (what != "fault-ends" || !open.contains(key)) continue;
    spans.push_back({open[key], number_in(event, "time"), fault});
    open.erase(key);
  }
  for (const auto& [key, begin] : open)
    spans.push_back({begin, until, key.substr(0, key.find(' '))});
  return spans;
}

/// Times of emergencies; the end of an error is none.
std::vector<double> emergency_times(const Json& events) {
  std::vector<double> times;
  for (const Json& event : events) {
    const bool is_one = text_at(event, "event") == "emergency" && text_at(event, "code") != "0000";
    if (is_one) times.push_back(number_in(event, "time"));
  }
  return times;
}

/// What is drawn into each curve.
struct CurveMarks {
  std::vector<FaultSpan> faults;
  std::vector<double> emergencies;
};

/// A value over time, constant until it changes: steps, with gaps where there is no number.
/// One of the points has a number.
class DrawnCurve {
 public:
  DrawnCurve(const Json& points, double begin, double end)
      : points_(points), begin_(begin), end_(end) {
    low_ = std::numeric_limits<double>::max();
    high_ = std::numeric_limits<double>::lowest();
    for (const Json& point : points) {
      if (point[1].is_null()) continue;
      low_ = std::min(low_, point[1].get<double>());
      high_ = std::max(high_, point[1].get<double>());
    }
  }

  void put_to(std::string& page, const std::string& title, const std::string& last,
              std::string_view unit, const CurveMarks& marks) const {
    write(page,
          "<figure class=\"curve\"><figcaption>{0} <b>{1}</b></figcaption>\n"
          "<svg viewBox=\"0 0 {2} {3}\" role=\"img\" aria-label=\"{0}, {4} to {5}\">\n",
          markup_text(title), markup_text(last), width, height, measured(low_, unit),
          measured(high_, unit));
    for (const FaultSpan& span : marks.faults) {
      const double from = std::max(x(span.begin), left);
      write(page,
            "<rect class=\"fault-band\" x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\">"
            "<title>{}</title></rect>\n",
            from, top, std::max(2.0, x(span.end) - from), height - top - bottom,
            markup_text(span.fault));
    }
    put_emergencies(page, marks.emergencies);
    write(page, "<path class=\"axis\" d=\"M{0} {1}V{2}H{3}\"/>\n<path class=\"line\" d=\"{4}\"/>\n",
          left, top, height - bottom, width - right, path());
    write(page,
          "<text x=\"{0}\" y=\"{1}\" text-anchor=\"end\">{2}</text>"
          "<text x=\"{0}\" y=\"{3}\" text-anchor=\"end\">{4}</text>\n",
          left - 6, top + 9, digits_of(high_), height - bottom, digits_of(low_));
    write(page,
          "<text x=\"{}\" y=\"{}\">{}</text><text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n"
          "</svg></figure>\n",
          left, height - 5, report_time_text(begin_), width - right, height - 5,
          report_time_text(end_));
  }

 private:
  static constexpr double width = 600;
  static constexpr double height = 120;
  static constexpr double left = 56;
  static constexpr double right = 4;
  static constexpr double top = 8;
  static constexpr double bottom = 22;

  /// Those that lie in one another's mark are one.
  void put_emergencies(std::string& page, const std::vector<double>& times) const {
    constexpr double mark_width = 2;
    std::string marks;
    double last = -mark_width;
    for (const double time : times) {
      if (x(time) - last < mark_width) continue;
      last = x(time);
      write(marks, "M{:.1f} {}v8", last, top);
    }
    if (!marks.empty()) write(page, "<path class=\"emergency-mark\" d=\"{}\"/>\n", marks);
  }
  double x(double time) const {
    return left + (time - begin_) / std::max(end_ - begin_, 1e-6) * (width - left - right);
  }
  double y(double value) const {
    return height - bottom -
           (value - low_) / std::max(high_ - low_, 1e-9) * (height - top - bottom);
  }
  std::string path() const {
    std::string made;
    bool has_number = false;
    for (const Json& point : points_) {
      const double at = x(point[0].get<double>());
      if (has_number) write(made, "H{:.1f}", at);
      if (!point[1].is_null()) {
        const double value = y(point[1].get<double>());
        if (has_number) {
          write(made, "V{:.1f}", value);
        } else {
          write(made, "M{:.1f} {:.1f}", at, value);
        }
      }
      has_number = !point[1].is_null();
    }
    if (has_number) write(made, "H{:.1f}", x(end_));
    return made;
  }

  const Json& points_;
  double begin_;
  double end_;
  double low_ = 0;
  double high_ = 0;
};

/// Names of the nodes, by bus and node-ID.
class ReportNames {
 public:
  explicit ReportNames(const Json& nodes) {
    for (const Json& node : nodes) names_[key(node)] = text_at(node, "device");
  }
  std::string of(const Json& place) const {
    if (number_in(place, "node") == 0) return text_at(place, "bus");
    const auto known = names_.find(key(place));
    return known == names_.end() ? fmt::format("node {}", number_in(place, "node")) : known->second;
  }
  std::string of(const std::string& bus, const std::string& node) const {
    if (node == "0") return "of no node";
    const auto known = names_.find(bus + " " + node);
    return known == names_.end() ? "node " + node : known->second;
  }

 private:
  static std::string key(const Json& place) {
    return fmt::format("{} {}", text_at(place, "bus"), number_in(place, "node"));
  }
  std::map<std::string, std::string> names_;
};

void put_curves(std::string& page, const Json& report, const ReportNames& names, double begin,
                double end) {
  const Json& curves = report["curves"];
  if (curves.empty()) return;
  const CurveMarks marks{.faults = fault_spans(report["events"], end),
                         .emergencies = emergency_times(report["events"])};
  begin_card(page, "Over time");
  page += "<div class=\"pair\">\n";
  for (const auto& [key, points] : curves.items()) {
    const auto found = report["values"].find(key);
    if (found == report["values"].end()) continue;
    const Json& told = *found;
    const Json& value = told["values"][0];
    const std::string name =
        value.contains("name") ? text_at(value, "name") : text_at(value, "index");
    DrawnCurve(points, begin, end)
        .put_to(page, fmt::format("{}: {}", names.of(told), name), text_at(told, "text"),
                text_at(value, "unit"), marks);
  }
  page += "</div>\n";
  if (!marks.faults.empty()) page += "<p class=\"hint\">Red: a fault was there.</p>\n";
  if (!marks.emergencies.empty()) page += "<p class=\"hint\">Orange: an emergency.</p>\n";
  end_card(page);
}

void put_events(std::string& page, const Json& report) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> tones = {{
      {"fault-begins", "bad"},
      {"broken", "bad"},
      {"emergency", "warn"},
      {"fault-ends", "good"},
      {"can-state", "warn"},
      {"silent", "bad"},
      {"heard-again", "good"},
      {"bus-lost", "bad"},
      {"bus-back", "good"},
      {"frames-lost", "bad"},
  }};
  begin_card(page, "Events");
  if (report["events"].empty()) page += "<p class=\"hint\">Nothing has happened.</p>\n";
  page += "<ol class=\"events\" tabindex=\"0\">\n";
  for (const Json& event : report["events"]) {
    const std::string what = text_at(event, "event");
    const auto* const tone =
        std::ranges::find(tones, what, [](const auto& each) { return each.first; });
    write(page, "<li{}><b>{}</b> {}\n",
          tone == tones.end() ? "" : fmt::format(" class=\"{}\"", tone->second),
          report_time_text(number_in(event, "time")), markup_text(text_at(event, "words")));
  }
  page += "</ol>\n";
  if (const double left_out = number_in(report, "events_left_out"); left_out != 0) {
    write(page, "<p class=\"hint\">{} more events of little weight are not in this report.</p>\n",
          left_out);
  }
  end_card(page);
}

void put_nodes(std::string& page, const Json& nodes) {
  if (nodes.empty()) return;
  begin_card(page, "Nodes");
  page +=
      "<div class=\"scroll\"><table class=\"plain wide\"><thead><tr><th>Device</th><th>Bus</th>"
      "<th class=\"number\">Node</th><th>State</th><th>CAN controller</th><th>Error register</th>"
      "</tr></thead><tbody>\n";
  for (const Json& node : nodes) {
    write(page,
          "<tr><td>{}</td><td>{}</td><td "
          "class=\"number\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
          markup_text(text_at(node, "device")), markup_text(text_at(node, "bus")),
          number_in(node, "node"), markup_text(text_at(node, "state")),
          markup_text(text_at(node, "can_state")), markup_text(text_at(node, "error_register")));
  }
  page += "</tbody></table></div>\n";
  end_card(page);
}

void put_load_row(std::string& page, const std::string& name, const Json& counts, double length_s) {
  write(page,
        "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td></tr>\n",
        markup_text(name), number_in(counts, "frames"),
        digits_of(number_in(counts, "frames") / length_s),
        digits_of(number_in(counts, "bits") / length_s));
}

void put_load(std::string& page, const Json& counts, const ReportNames& names, double length_s) {
  begin_card(page, "Mean load");
  page +=
      "<div class=\"scroll\"><table class=\"plain\"><thead><tr><td></td><th "
      "class=\"number\">Frames</th>"
      "<th class=\"number\">Frames a second</th><th "
      "class=\"number\">bit/s</th></tr></thead><tbody>\n";
  for (const auto& [bus, all] : counts.items()) {
    put_load_row(page, bus, all, length_s);
    for (const auto& [node, each] : all["nodes"].items()) {
      put_load_row(page, fmt::format("{}, {}", bus, names.of(bus, node)), each, length_s);
    }
    for (const auto& [service, each] : all["services"].items()) {
      put_load_row(page, fmt::format("{}, {}", bus, service), each, length_s);
    }
  }
  page += "</tbody></table></div>\n";
  end_card(page);
}

void put_values(std::string& page, const Json& values, const ReportNames& names) {
  constexpr std::size_t text_max = 160;
  std::string rows;
  std::size_t shown = 0;
  for (const auto& [key, told] : values.items()) {
    const Json& value = told["values"][0];
    const std::string raw = text_at(value, "raw");
    if (raw.find_first_not_of('0') == std::string::npos) continue;
    std::string text = text_at(told, "text");
    if (text.size() > text_max) text = text.substr(0, text.rfind(' ', text_max)) + " …";
    write(rows,
          "<tr><td>{}</td><td>{}:{}</td><td class=\"words\">{}</td>"
          "<td class=\"words\"><b>{}</b></td><td>{}</td></tr>\n",
          markup_text(names.of(told)), text_at(value, "index"), text_at(value, "sub"),
          markup_text(text_at(value, "name")), markup_text(text), raw);
    ++shown;
  }
  if (shown == 0) return;
  write(page,
        "<section class=\"card\"><details><summary>Last values: {}, and {} of which all bits are "
        "0</summary><div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"Last values\"><table class=\"plain wide\"><tbody>\n{}"
        "</tbody></table></div></details></section>\n",
        shown, values.size() - shown, rows);
}

void put_head(std::string& page, const Json& report, double length_s) {
  const Json& about = report["about"];
  const Json& end = report["end"];
  const auto summary = end.value("summary", Json::object());
  const auto invariants = summary.value("invariants", Json::array());
  const auto broken =
      std::ranges::count_if(invariants, [](const Json& it) { return !has_held(it); });
  const bool is_decided =
      std::ranges::all_of(invariants, [](const Json& it) { return it.value("decided", true); });
  write(page, "<h1>Report: {}", markup_text(title_of(about)));
  if (!invariants.empty()) {
    write(page, " <span class=\"state {}\">{}</span>", broken == 0 ? "good" : "bad",
          broken != 0  ? fmt::format("{} broken", broken)
          : is_decided ? "all holds"
                       : "none broken");
  }
  const auto plan = end.value("plan", Json::object());
  write(page, "</h1>\n<p class=\"muted\">{}: <code class=\"mono\">{}</code>, {}</p>\n",
        plan.empty() ? "To see it" : "The same run once more",
        markup_text(plan.empty() ? text_at(about, "command") : text_at(plan, "command")),
        report_time_text(length_s));
}

void put_gaps(std::string& page, const Json& gaps) {
  if (gaps.empty()) return;
  page += "<div class=\"lost\">\n";
  for (const Json& gap : gaps) write(page, "<p>{}</p>\n", markup_text(gap.get<std::string>()));
  page += "</div>\n";
}

}  // namespace

std::string report_time_text(double seconds) {
  constexpr double calendar_from = 4e8;  ///< times of runs begin at 0
  constexpr std::int64_t tenths = 10;
  constexpr std::int64_t minute = 60;
  constexpr std::int64_t hour = 3600;
  const auto all = static_cast<std::int64_t>(std::floor(seconds * tenths + 1e-6));
  const std::int64_t whole = all / tenths;
  if (seconds > calendar_from) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S}.{} UTC", fmt::gmtime(static_cast<std::time_t>(whole)),
                       all % tenths);
  }
  const std::int64_t minutes = whole / minute % minute;
  if (whole < hour) return fmt::format("{}:{:02}.{}", minutes, whole % minute, all % tenths);
  return fmt::format("{}:{:02}:{:02}.{}", whole / hour, minutes, whole % minute, all % tenths);
}

StatisticWords statistic_words(std::string_view before, std::string_view key) {
  struct Ending {
    std::string_view key;
    std::string_view unit;
  };
  constexpr std::array endings = {
      Ending{"_m_per_s", "m/s"}, Ending{"_m_s", "m/s"},   Ending{"_percent", "%"},
      Ending{"_celsius", "°C"},  Ending{"_degrees", "°"}, Ending{"_kwh", "kWh"},
      Ending{"_wh", "Wh"},       Ending{"_ah", "Ah"},     Ending{"_km", "km"},
      Ending{"_kg", "kg"},       Ending{"_mm", "mm"},     Ending{"_cm", "cm"},
      Ending{"_m3", "m³"},       Ending{"_ms", "ms"},     Ending{"_min", "min"},
      Ending{"_s", "s"},         Ending{"_m", "m"},       Ending{"_a", "A"},
      Ending{"_v", "V"},         Ending{"_h", "h"},
  };
  std::string_view unit;
  for (const Ending& each : endings) {
    if (!key.ends_with(each.key)) continue;
    unit = each.unit;
    key.remove_suffix(each.key.size());
    break;
  }
  std::string name(key == "percentile_90" ? "for 90 %" : key);
  std::ranges::replace(name, '_', ' ');
  if (before.empty()) return {begun_large(std::move(name)), unit};
  return {fmt::format("{}, {}", before, name), unit};
}

std::string report_text(const Json& report) {
  const double begin = number_in(report["about"], "begin");
  const double end = number_in(report["end"], "time");
  const double length_s = std::max(end - begin, 1e-6);
  const auto summary = report["end"].value("summary", Json::object());
  const auto nodes = report.value("nodes", Json::array());
  const ReportNames names(nodes);
  std::string page;
  put_head(page, report, length_s);
  put_gaps(page, report.value("gaps", Json::array()));
  page += "<div id=\"picture\"></div>\n";
  if (report["about"].contains("scenery")) {
    page += "<noscript><p class=\"hint\">Pictures of the run need JavaScript.</p></noscript>\n";
  }
  put_verdicts(page, summary);
  std::string statistics;
  put_statistics(statistics, summary, "");
  if (!statistics.empty()) {
    begin_card(page, "Statistics");
    page += "<table class=\"plain\"><tbody>\n" + statistics + "</tbody></table>\n";
    end_card(page);
  }
  put_curves(page, report, names, begin, end);
  put_events(page, report);
  put_nodes(page, nodes);
  put_load(page, report["end"]["counts"], names, length_s);
  put_values(page, report["values"], names);
  page += "<p class=\"muted\">Written by Canvoy. It loads nothing, and can be sent as it is.</p>\n";
  return page;
}

}  // namespace canvoy::tools
