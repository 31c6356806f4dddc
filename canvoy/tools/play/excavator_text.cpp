#include "canvoy/tools/play/excavator_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using excavator::ExcavatorEvent;
using excavator::ExcavatorNetwork;
using excavator::ExcavatorSnapshot;

std::string_view button_text(excavator::Button button) {
  constexpr std::string_view texts[] = {"horn", "light", "beacon", "fast travel", "hydraulics"};
  return texts[static_cast<std::size_t>(button)];
}

constexpr std::string_view lamp_texts[] = {"light", "beacon",   "fast", "locked",
                                           "fault", "low fuel", "hot",  "ready"};
constexpr std::string_view movement_texts[] = {"slew",       "stick",       "boom",   "bucket",
                                               "left_track", "right_track", "rotator"};
constexpr std::string_view shown_texts[] = {"fuel_percent", "oil_celsius", "slew_degrees",
                                            "height_cm",    "rpm",         "reach_cm",
                                            "page",         "detail"};

class ExcavatorNames : public PlanNames<excavator::FaultKind> {
 public:
  explicit ExcavatorNames(const ExcavatorNetwork& network)
      : PlanNames(network.options().faults), network_(network) {}

  std::string device(BusIndex bus, NodeId id) const override {
    if (id == 0) return "all";
    const excavator::DevicePlace& armrest = excavator::armrest_place;
    if (bus != 0 && id == armrest.id) return fmt::format("{} ({})", armrest.name, id);
    for (const excavator::DevicePlace& place : excavator::device_places) {
      if (place.id == id) return fmt::format("{} ({})", place.name, id);
    }
    return text::node_text(id);
  }
  /// Number of an axis with a fault of the plan; 0: none.
  unsigned axis(std::size_t fault) const { return network_.options().faults.faults.at(fault).spot; }

 private:
  const ExcavatorNetwork& network_;
};

std::string lit_text(const excavator::Lamps& lit) {
  std::string text;
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i]) text += fmt::format("{}{}", text.empty() ? "" : ", ", lamp_texts[i]);
  }
  return text.empty() ? "none" : text;
}

Json lit_json(const excavator::Lamps& lit) {
  Json json = Json::array();
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i]) json.push_back(lamp_texts[i]);
  }
  return json;
}

class ExcavatorTeller : public WorldTeller<ExcavatorNames> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const excavator::ActivityChanged& event) const {
    const std::string_view activity = activity_text(event.activity);
    return {fmt::format("operator {}", activity), {{"event", "operator"}, {"operator", activity}}};
  }
  Told operator()(const excavator::BucketDumped& event) const {
    return {fmt::format("{:.2f} m3 of earth come to the heap: {:.1f} m3", event.cubic_metres,
                        event.heap),
            {{"event", "dumped"}, {"m3", event.cubic_metres}, {"heap_m3", event.heap}}};
  }
  Told operator()(const excavator::ButtonPressed& event) const {
    const std::string_view button = button_text(event.button);
    return {fmt::format("press: {}", button), {{"event", "press"}, {"button", button}}};
  }
  Told operator()(const excavator::SwitchChanged& event) const {
    const std::string_view output = button_text(event.button);
    return {fmt::format("{} {}", output, event.is_on ? "on" : "off"),
            {{"event", "switch"}, {"output", output}, {"on", event.is_on}}};
  }
  Told operator()(const excavator::LampsChanged& event) const {
    return {fmt::format("lamps: {}", lit_text(event.lit)),
            {{"event", "lamps"}, {"lit", lit_json(event.lit)}}};
  }
  Told operator()(const excavator::FaultBegan& event) const { return fault(true, event); }
  Told operator()(const excavator::FaultEnded& event) const { return fault(false, event); }

 private:
  template <class Event>
  Told fault(bool begins, const Event& event) const {
    const unsigned axis = names_.axis(event.fault);
    const std::string at = axis != 0 ? fmt::format("at axis {}", axis) : where(event.place);
    return reported_fault(names_, begins, fault_name(event.kind), event.place, at);
  }
};

Json statistics_json(const excavator::ExcavatorStatistics& statistics) {
  return {{"cycles", statistics.cycles},          {"dug_m3", statistics.earth.dug},
          {"heaped_m3", statistics.earth.heaped}, {"spilled_m3", statistics.earth.spilled},
          {"presses", statistics.presses},        {"driven_m", statistics.metres}};
}

Json movements_json(const ExcavatorSnapshot& now) {
  Json json = Json::object();
  for (std::size_t i = 0; i < movements; ++i) {
    json[std::string(movement_texts[i])] = {
        {"place", now.angles[i]}, {"speed", now.speeds[i]}, {"hand", now.hands[i]}};
  }
  return json;
}

Json display_json(const ExcavatorSnapshot& now) {
  Json json = Json::object();
  for (std::size_t i = 0; i < now.display.size(); ++i) {
    const std::int16_t value = now.display[i];
    json[std::string(shown_texts[i])] = value == excavator::no_value ? Json() : Json(value);
  }
  return json;
}

Json pressed_json(const ExcavatorSnapshot& now) {
  Json json = Json::array();
  for (std::size_t i = 0; i < now.pressed.size(); ++i) {
    if (now.pressed[i]) json.push_back(button_text(static_cast<excavator::Button>(i)));
  }
  return json;
}

/// Its joints from the foot of the boom to the tip of the bucket, as `[x, z]` in m.
Json arm_json(const ExcavatorSnapshot& now) {
  Json json = Json::array();
  for (const auto& joint : now.arm) json.push_back(Json::array({joint.x, joint.z}));
  return json;
}

Json excavator_look_json(ExcavatorNetwork& network, std::string_view event) {
  const ExcavatorSnapshot now = network.snapshot();
  const ExcavatorNames names(network);
  Json json = line_json(now.at, event);
  json["operator"] = activity_text(now.activity);
  json["movements"] = movements_json(now);
  json["seat"] = {{"lit", lit_json(now.lit)},
                  {"display", display_json(now)},
                  {"pressed", pressed_json(now)},
                  {"lever_lowered", now.is_lever_lowered}};
  json["plant"] = {{"tip_x_m", now.arm[3].x},
                   {"tip_z_m", now.arm[3].z},
                   {"arm", arm_json(now)},
                   {"bucket_m3", now.statistics.earth.in_bucket},
                   {"horn", bool(now.switched[0])},
                   {"light", bool(now.switched[1])},
                   {"beacon", bool(now.switched[2])},
                   {"hydraulics", bool(now.switched[4])},
                   {"rpm", now.rpm},
                   {"fuel_percent", now.fuel_percent},
                   {"oil_celsius", now.oil_celsius}};
  json["statistics"] = statistics_json(now.statistics);
  const BusSnapshot buses[] = {now.bus, now.embedded};
  json["buses"] = buses_json(names, buses);
  json["nodes"] = nodes_json(names, now.nodes);
  return json;
}

}  // namespace

std::string_view activity_text(excavator::Activity activity) {
  constexpr std::string_view texts[] = {
      "sits down", "reaches out", "lowers the bucket", "digs",        "lifts",   "slews",
      "dumps",     "returns",     "drives on",         "has a break", "gets off"};
  return texts[static_cast<std::size_t>(activity)];
}

ReportedEvent WorldText<excavator::ExcavatorNetwork>::event(const ExcavatorEvent& event,
                                                            const ExcavatorNetwork& network) {
  return reported_at(event.at, std::visit(ExcavatorTeller(network), event.what));
}

Json WorldText<excavator::ExcavatorNetwork>::snapshot(ExcavatorNetwork& network) {
  return excavator_look_json(network, "snapshot");
}

std::string WorldText<excavator::ExcavatorNetwork>::summary_text(ExcavatorNetwork& network) {
  const ExcavatorSnapshot end = network.snapshot();
  const std::vector<excavator::Invariant> all = network.invariants();
  const excavator::ExcavatorStatistics& statistics = end.statistics;
  return fmt::format(
             "{} simulated: {} cycles, {:.0f} m3 of earth dug, {:.0f} m3 on the heap, {:.0f} m3 "
             "spilled; {} presses of buttons, {:.0f} m driven; {} frames, {} error frames\n",
             text::duration_text(end.at - Time{}), statistics.cycles, statistics.earth.dug,
             statistics.earth.heaped, statistics.earth.spilled, statistics.presses,
             statistics.metres, end.bus.frames, end.bus.error_frames) +
         invariants_text(ExcavatorNames(network), std::span<const excavator::Invariant>(all));
}

Json WorldText<excavator::ExcavatorNetwork>::summary(ExcavatorNetwork& network) {
  Json json = excavator_look_json(network, "summary");
  const std::vector<excavator::Invariant> all = network.invariants();
  add_invariants(json, ExcavatorNames(network), std::span<const excavator::Invariant>(all));
  return json;
}

}  // namespace canvoy::tools
