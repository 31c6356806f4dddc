#include "canvoy/tools/live/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/live/json_difference.hpp"
#include "canvoy/tools/value_file.hpp"
#include "canvoy/web/page_files.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t curves_max = 12;
/// What has changed less often is told as a value, and needs no curve.
constexpr std::size_t curve_points_min = 4;
constexpr std::size_t values_told_max = 1000;
/// Below it are parameters of communication (CiA 301, 7.4.1).
constexpr std::string_view first_own_index = "2000";

bool is_grave(std::string_view event_line) {
  constexpr std::array names = {R"("event":"fault-)",     R"("event":"broken")",
                                R"("event":"emergency")", R"("event":"can-state")",
                                R"("event":"nmt-state")", R"("event":"nmt-command")"};
  return std::ranges::any_of(
      names, [&](std::string_view name) { return event_line.find(name) != event_line.npos; });
}

/// Of an object of a node, over time.
struct Curve {
  Json last;
  Json points = Json::array();
};

class ReportMaker {
 public:
  explicit ReportMaker(LiveSource& source) : source_(source), about_(source.description()) {}

  Json make() {
    const double length = about_.value("end", 0.0);  // counts from the begin
    for (std::size_t i = 0; i < report_pictures; ++i) {
      go_to(length * static_cast<double>(i) / (report_pictures - 1));
      take_picture();
      take_values();
    }
    Json last = source_.state();
    last.erase("snapshot");
    return {{"about", about_},    {"pictures", pictures_},        {"end", last},
            {"events", events()}, {"events_left_out", left_out_}, {"values", values()},
            {"curves", curves()}};
  }

 private:
  /// Events are taken on the way: the source keeps the latest alone.
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
    const Json now = {{"time", state["time"]}, {"snapshot", state.value("snapshot", Json())}};
    pictures_.push_back(pictures_.empty() ? now : json_difference(picture_, now));
    picture_ = now;
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

  /// In their order; small ones only as far as there is room.
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

  /// Those that have changed most, with a unit before those without.
  Json curves() const {
    std::vector<std::pair<std::string_view, const Curve*>> best;
    for (const auto& [key, curve] : curves_) {
      const bool is_own = curve.last["values"][0].value("index", "") >= first_own_index;
      if (is_own && curve.points.size() >= curve_points_min) best.emplace_back(key, &curve);
    }
    std::ranges::stable_sort(best, std::ranges::greater{}, [](const auto& each) {
      const Curve& curve = *each.second;
      return std::pair(curve.last["values"][0].contains("unit"), curve.points.size());
    });
    Json list = Json::object();
    for (std::size_t i = 0; i < std::min(best.size(), curves_max); ++i) {
      list[std::string(best[i].first)] = best[i].second->points;
    }
    return list;
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

}  // namespace

Json report_json(LiveSource& source) {
  return ReportMaker(source).make();
}

std::string report_page(const Json& report) {
  std::string data = report.dump(-1, ' ', false, Json::error_handler_t::replace);
  // Nothing that a log says ends the element that it stands in.
  for (std::size_t at = 0; (at = data.find('<', at)) != std::string::npos;) {
    data.replace(at, 1, "\\u003c");
  }
  const web::ReportFiles files = web::report_files();
  std::string page(files.page);
  put(page, "/*style*/", files.style);
  put(page, "/*script*/", files.script);
  put(page, "/*report*/", data);
  return page;
}

int write_report(LiveSource& source, const std::string& path) {
  const std::string page = report_page(report_json(source));
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(page.data()), page.size()});
  return source.finish();
}

}  // namespace canvoy::tools
