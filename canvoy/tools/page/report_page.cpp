#include "canvoy/tools/page/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/gateway/base64.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/page/json_difference.hpp"
#include "canvoy/tools/page/report_text.hpp"
#include "canvoy/web/page_files.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t curves_max = 12;
/// A value with fewer changes is reported as text, without a curve.
constexpr std::size_t curve_points_min = 4;
constexpr std::size_t curve_points_max = 300;
constexpr std::size_t values_told_max = 1000;
/// Below it are communication parameters (CiA 301, 7.4.1).
constexpr std::string_view first_own_text = "2000";

bool is_grave(std::string_view event_line) {
  constexpr std::array names = {R"("event":"fault-)",     R"("event":"broken")",
                                R"("event":"emergency")", R"("event":"can-state")",
                                R"("event":"nmt-state")", R"("event":"nmt-command")",
                                R"("event":"silent")",    R"("event":"heard-again")",
                                R"("event":"bus-)",       R"("event":"frames-lost")"};
  return std::ranges::any_of(
      names, [&](std::string_view name) { return event_line.find(name) != event_line.npos; });
}

std::uint64_t count_in(const Json& from, const char* key) {
  return from.value(key, std::uint64_t{0});
}

/// A line of the terminal; one that begins with the name of a bus keeps it.
std::string as_sentence(std::string line) {
  if (line.starts_with("no ")) line.front() = 'N';
  return line + '.';
}

/// Sentences of what this report does not have, since it was not read or not heard.
Json gaps_of(const Json& about, const Json& last) {
  const Json snapshot = last.value("snapshot", Json::object());
  const Json play = last.value("play", Json::object());
  Json gaps = Json::array();
  const auto unreadable = count_in(about, "unreadable");
  if (unreadable == 1) {
    gaps.push_back(fmt::format("1 line of this log could not be read, and is missing here: {}.",
                               about.value("unreadable_at", "")));
  } else if (unreadable != 0) {
    gaps.push_back(
        fmt::format("{} lines of this log could not be read, and are missing here. The first: {}.",
                    unreadable, about.value("unreadable_at", "")));
  }
  if (const auto others = count_in(about, "of_other_buses"); others != 0) {
    gaps.push_back(fmt::format("{} frames are of more buses than a report shows.", others));
  }
  if (const auto lost = count_in(snapshot, "frames_lost") + count_in(play, "frames_lost");
      lost != 0) {
    gaps.push_back(fmt::format("{} frames were lost before they reached this program.", lost));
  }
  std::string trouble = snapshot.value("trouble", "");
  if (trouble.empty()) trouble = play.value("trouble", "");
  const std::string state = snapshot.value("bus_state", "");
  if (!trouble.empty()) {
    gaps.push_back(fmt::format("The bus was lost at the end: {}.", trouble));
  } else if (!state.empty() && state != "error-active") {
    gaps.push_back(fmt::format("The bus was {} at the end.", state));
  }
  return gaps;
}

/// An object of a node over time.
struct Curve {
  Json last;
  Json points = Json::array();
};

/// Collects the data of a source while it continues.
class ReportMaker {
 public:
  explicit ReportMaker(LiveSource& source) : source_(source), about_(source.description()) {}

  /// Makes the report of a run or a log, from its start.
  Json make() {
    const double length = about_.value("end", 0.0);  // from the start
    for (std::size_t i = 0; i < report_pictures; ++i) {
      go_to(length * static_cast<double>(i) / (report_pictures - 1));
      take_picture();
      take_values();
    }
    return made();
  }

  /// Makes the report of a bus, from now on.
  Json make(const GoOn& go_on) {
    about_["begin"] = source_.state()["time"];
    bool goes_on = true;
    for (std::size_t i = 0; i < report_pictures && goes_on; ++i) {
      goes_on = go_on(i);
      source_.advance(Time{});
      take_events();
      take_values();
    }
    return made();
  }

 private:
  Json made() {
    Json last = source_.state();
    last["counts"] = source_.counts();
    Json nodes = last["snapshot"].value("nodes", Json::array());
    Json gaps = gaps_of(about_, last);
    for (std::string line : source_.feed().unknown_pdos({})) {
      gaps.push_back(as_sentence(std::move(line)));
    }
    last.erase("snapshot");
    return {{"about", about_},    {"pictures", pictures_}, {"end", last},
            {"nodes", nodes},     {"events", events()},    {"events_left_out", left_out_},
            {"values", values()}, {"curves", curves()},    {"gaps", std::move(gaps)}};
  }

  /// Events are collected on the way, since the source keeps only the latest.
  void go_to(double seconds) {
    source_.act("seek", {{"time", seconds}}, [](const Json&) {});
    do {
      source_.advance(Time{});
      take_events();
    } while (source_.state()["play"]["seeking"].get<bool>());
  }

  void take_events() {
    const EventLines& events = source_.events();
    for (event_ = std::max(event_, events.first()); event_ < events.end(); ++event_) {
      const std::string& line = events.line(event_);
      (is_grave(line) ? grave_ : small_).emplace_back(event_, line);
      trim(small_);
      trim(grave_);
    }
  }
  void trim(auto& lines) {
    if (lines.size() <= report_events_max) return;
    lines.pop_front();
    ++left_out_;
  }

  void take_picture() {
    const Json state = source_.state();
    Json now = {{"time", state["time"]}, {"snapshot", state.value("snapshot", Json())}};
    // No picture shows them, and the last ones are in the text.
    for (const char* const name : {"nodes", "buses"}) now["snapshot"].erase(name);
    pictures_.push_back(pictures_.empty() ? now : json_difference(picture_, now));
    picture_ = std::move(now);
  }

  void take_values() {
    std::string members;
    source_.feed().append_values(members, change_);
    change_ = source_.feed().changes();
    const Json changed = Json::parse(fmt::format("{{{}}}", members));
    for (const auto& [key, told] : changed.items()) {
      Curve& curve = curves_[key];
      const Json value = told["values"][0].value("value", Json());
      const bool is_other = curve.points.empty() || curve.points.back()[1] != value;
      if (value.is_number() && is_other) {
        curve.points.push_back(Json::array({told["time"], value}));
      }
      curve.last = told;
    }
  }

  /// In order; minor ones only if there is room.
  Json events() {
    while (grave_.size() + small_.size() > report_events_max && !small_.empty()) {
      small_.pop_front();
      ++left_out_;
    }
    std::vector<std::pair<std::uint64_t, std::string>> all(grave_.begin(), grave_.end());
    all.insert(all.end(), small_.begin(), small_.end());
    std::ranges::sort(all);
    Json list = Json::array();
    for (const auto& [number, line] : all) list.push_back(Json::parse(line));
    return list;
  }

  Json values() const {
    Json list = Json::object();
    for (const auto& [key, curve] : curves_) {
      if (list.size() == values_told_max) break;
      list[key] = curve.last;
    }
    return list;
  }

  /// The curves with the most changes, those with a unit first.
  Json curves() const {
    std::vector<std::pair<std::string_view, const Curve*>> best;
    for (const auto& [key, curve] : curves_) {
      const bool is_own = curve.last["values"][0].value("index", "") >= first_own_text;
      if (is_own && curve.points.size() >= curve_points_min) best.emplace_back(key, &curve);
    }
    std::ranges::stable_sort(best, std::ranges::greater{}, [](const auto& each) {
      const Curve& curve = *each.second;
      return std::pair(curve.last["values"][0].contains("unit"), curve.points.size());
    });
    Json list = Json::object();
    for (std::size_t i = 0; i < std::min(best.size(), curves_max); ++i) {
      list[std::string(best[i].first)] = points_of(*best[i].second);
    }
    return list;
  }

  /// All that was heard, where the source still has it; else what pictures have caught.
  Json points_of(const Curve& curve) const {
    const Json& value = curve.last["values"][0];
    const auto hex = [&value](const char* key) {
      return std::stoul(value.value(key, "0"), nullptr, 16);
    };
    Json points = source_.feed()
                      .history(curve.last.value("bus", ""), curve.last.value("node", NodeId{0}),
                               static_cast<std::uint16_t>(hex("index")),
                               static_cast<std::uint8_t>(hex("sub")))
                      .points(curve_points_max);
    return points.size() < curve.points.size() ? curve.points : points;
  }

  LiveSource& source_;
  Json about_;
  Json pictures_ = Json::array();
  Json picture_;
  std::deque<std::pair<std::uint64_t, std::string>> grave_;
  std::deque<std::pair<std::uint64_t, std::string>> small_;
  std::uint64_t event_ = 0;
  std::uint64_t left_out_ = 0;
  std::map<std::string, Curve> curves_;
  std::uint64_t change_ = 0;
};

void put(std::string& page, std::string_view mark, std::string_view text) {
  page.replace(page.find(mark), mark.size(), text);
}

/// A bus and a log have no picture of a world.
bool has_pictures(const Json& report) {
  return report["about"].contains("scenery");
}

/// By gzip and base64, in a script that does nothing.
std::string packed(std::string_view id, std::string_view text) {
  const std::string bytes = web::compressed(text);
  return fmt::format(
      "<script type=\"text/plain\" id=\"{}\">{}</script>\n", id,
      gateway::to_base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
}

/// Unpacks the script that draws the pictures, and runs it.
constexpr std::string_view begin_script =
    "<script>(async()=>{const b=Uint8Array.from(atob(document.getElementById('script').textContent"
    "),c=>c.charCodeAt(0)),s=document.createElement('script');s.textContent=await new Response(new "
    "Blob([b]).stream().pipeThrough(new DecompressionStream('gzip'))).text();document.body.append("
    "s)})()</script>";

/// The pictures, and the script that draws them.
std::string packed_pictures(const Json& report, std::string_view script) {
  const Json& about = report["about"];
  const Json data = {{"about", {{"kind", about["kind"]}, {"scenery", about["scenery"]}}},
                     {"pictures", report["pictures"]}};
  return packed("data", data.dump(-1, ' ', false, Json::error_handler_t::replace)) +
         packed("script", script) + std::string(begin_script);
}

}  // namespace

Json report_json(LiveSource& source) {
  return ReportMaker(source).make();
}

std::string report_page(const Json& report) {
  const web::ReportFiles files = web::report_files();
  std::string page(files.page);
  put(page, "/*style*/", files.style);
  put(page, "<!--report-->", report_text(report));
  put(page, "<!--pictures-->", has_pictures(report) ? packed_pictures(report, files.script) : "");
  return page;
}

namespace {

void write_page(const Json& report, const std::string& path) {
  const std::string page = report_page(report);
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(page.data()), page.size()});
}

}  // namespace

int write_report(LiveSource& source, const std::string& path) {
  write_page(report_json(source), path);
  return source.finish();
}

int write_report(LiveSource& source, const GoOn& go_on, const std::string& path) {
  write_page(ReportMaker(source).make(go_on), path);
  return source.finish();
}

}  // namespace canvoy::tools
