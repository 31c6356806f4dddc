#include "canvoy/tools/page/live_source.hpp"

#include <nlohmann/json.hpp>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/json_line.hpp"

namespace canvoy::tools {

void EventLines::add(ReportedEvent event) {
  std::string& line = lines_.emplace_back(std::move(event.json));
  line.pop_back();
  text::JsonLine(line).key("words").text(event.text);
  line += '}';
  if (lines_.size() <= lines_max) return;
  lines_.pop_front();
  ++first_;
}

namespace {

LiveSource::Json counts_json(const FrameFeed::Counts& counts) {
  return {{"frames", counts.frames}, {"bits", counts.bits}, {"last", in_seconds(counts.last)}};
}

}  // namespace

LiveSource::Json LiveSource::counts() const {
  Json all = Json::object();
  for (std::size_t i = 0; i < feed_.buses().size(); ++i) {
    const FrameFeed::BusCounts& of_bus = feed_.counts(i);
    Json bus = counts_json(of_bus.all);
    bus["nodes"] = Json::object();
    for (const auto& [node, counts] : of_bus.nodes) {
      bus["nodes"][std::to_string(node)] = counts_json(counts);
    }
    bus["services"] = Json::object();
    for (const auto& [service, counts] : of_bus.services) {
      bus["services"][service] = counts_json(counts);
    }
    all[feed_.buses()[i]] = std::move(bus);
  }
  return all;
}

}  // namespace canvoy::tools
