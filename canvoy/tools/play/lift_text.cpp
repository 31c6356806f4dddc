#include "canvoy/tools/play/lift_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "canvoy/profiles/cia417.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/play/lift_picture.hpp"
#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/tools/terminal/screen.hpp"

namespace canvoy::tools {

namespace {

using lift::CallEnd;
using lift::CallKey;
using lift::Direction;
using lift::Invariant;
using lift::LiftNetworkDescription;
using lift::LiftSummary;

std::string_view direction_text(Direction direction) {
  switch (direction) {
    case Direction::up:
      return "up";
    case Direction::down:
      return "down";
    case Direction::none:
      break;
  }
  return "none";
}

bool is_group_bus(const LiftNetworkDescription& network, std::size_t bus) {
  return std::ranges::any_of(network.nodes, [bus](const lift::NodeDescription& each) {
    return each.bus == bus && each.kind == lift::DeviceKind::group_controller;
  });
}

/// Lift controllers have a second node on the bus of a group.
/// `lift2: lift-drive (2)`
std::string name_of(const LiftNetworkDescription& network, std::size_t bus, NodeId id) {
  const auto node = std::ranges::find_if(network.nodes, [&](const lift::NodeDescription& each) {
    return each.bus == bus && each.id == id;
  });
  const std::string where = bus < network.buses.size() ? network.buses[bus].name : "?";
  if (node == network.nodes.end() && is_group_bus(network, bus) &&
      id <= network.building.lift_count()) {
    return fmt::format("{}: controller of lift {}", where, id);
  }
  if (node == network.nodes.end()) return fmt::format("{}: {}", where, text::node_text(id));
  return fmt::format("{}: {} ({})", where, lift::device_kind_name(node->kind), id);
}

std::string floor_name(const LiftNetworkDescription& network, lift::FloorNumber floor) {
  if (floor == lift::no_floor || floor > network.building.floor_count()) return "no floor";
  return "floor " + network.building.floor(floor).name;
}

std::string place_name(const LiftNetworkDescription& network, lift::FloorNumber floor) {
  return floor == lift::no_floor ? "between floors" : "at " + floor_name(network, floor);
}

std::string call_text(const LiftNetworkDescription& network, const CallKey& call) {
  if (call.to != lift::no_floor) {
    return fmt::format("call from {} to {}", floor_name(network, call.floor),
                       floor_name(network, call.to));
  }
  if (call.lift != 0) {
    return fmt::format("call to {} in lift {}", floor_name(network, call.floor), call.lift);
  }
  return fmt::format("call {} at {}", direction_text(call.direction),
                     floor_name(network, call.floor));
}

std::string_view end_text(CallEnd end) {
  switch (end) {
    case CallEnd::served:
      return "is served";
    case CallEnd::fire_service:
      return "is taken back: fire service";
    case CallEnd::out_of_order:
      return "is taken back: out of order";
    case CallEnd::cancelled:
      return "is taken back";
    case CallEnd::unexplained:
      return "is lost";
  }
  return "ends";
}

std::string_view trip_text(lift::SafetyChain::Trip trip) {
  using enum lift::SafetyChain::Trip;
  switch (trip) {
    case none:
      break;
    case overspeed:
      return "overspeed governor";
    case unintended_movement:
      return "unintended movement";
    case final_limit:
      return "final limit switch";
    case gear:
      return "safety gear";
    case brake:
      return "brake slipped at its self-test";
  }
  return "";
}

/// In JSON, and in words; actions at a floor end with its name.
struct TechnicianStepWords {
  std::string_view name;
  std::string_view text;
};
TechnicianStepWords step_words(lift::TechnicianStep step) {
  using enum lift::TechnicianStep;
  switch (step) {
    case called_for_trip:
      return {"called", "is called: only a hand closes the safety chain"};
    case called_for_people:
      return {"called", "is called: people are shut in"};
    case arrives:
      return {"arrives", "arrives, and presses the stop switch"};
    case moves_car:
      return {"moves-car", "moves the car by hand to "};
    case lets_out:
      return {"lets-out", "lets everybody out at "};
    case inspects:
      return {"inspects", "inspects roof of the car and pit"};
    case resets:
      return {"resets", "resets it by hand"};
    case leaves:
      return {"leaves", "leaves"};
    case called_for_fault:
      return {"called", "is called: the lift stays out of order"};
    case called_for_complaint:
      return {"called", "is called: people complain"};
    case rides:
      return {"rides", "rides on the roof of the car by inspection control"};
    case restarts:
      return {"restarts", "switches controller and drive off and on"};
    case gives_up:
      return {"gives-up", "leaves it out of service"};
  }
  return {};
}

std::string_view emergency_meaning(std::uint16_t code) {
  const auto known = std::ranges::find(cia417::profile.error_codes, code, &ErrorCodeInfo::code);
  return known != cia417::profile.error_codes.end() ? known->text : text::emergency_text(code);
}

class LiftNames : public PlanNames<lift::FaultKind> {
 public:
  explicit LiftNames(const LiftNetworkDescription& network)
      : PlanNames(network.faults), network_(network) {}

  std::string bus(BusIndex bus) const override {
    return bus < network_.buses.size() ? network_.buses[bus].name : "";
  }
  std::string device(BusIndex bus, NodeId id) const override { return name_of(network_, bus, id); }
  std::string_view part() const override { return "lift"; }
  std::string_view emergency(std::uint16_t code) const override { return emergency_meaning(code); }
  const LiftNetworkDescription& network() const { return network_; }

 private:
  const LiftNetworkDescription& network_;
};

class LiftTeller : public WorldTeller<LiftNames> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const lift::LampChanged& event) const {
    const std::string call = call_text(names_.network(), event.call);
    const std::string text =
        event.lit ? call + " is acknowledged" : fmt::format("{} {}", call, end_text(event.end));
    return {text,
            {{"event", "lamp"},
             {"lit", event.lit},
             {"lift", event.call.lift},
             {"floor", event.call.floor},
             {"direction", direction_text(event.call.direction)},
             {"to", event.call.to},
             {"text", text}}};
  }
  Told operator()(const lift::CarStarted& event) const {
    return car(
        "start", event.lift, event.floor,
        fmt::format("starts {} with {}", place_name(names_.network(), event.floor),
                    event.persons == 1 ? "1 person" : fmt::format("{} persons", event.persons)));
  }
  Told operator()(const lift::CarStopped& event) const {
    return car("stop", event.lift, event.floor,
               "stops " + place_name(names_.network(), event.floor));
  }
  Told operator()(const lift::DoorsOpened& event) const {
    return car("doors", event.lift, event.floor,
               "is open " + place_name(names_.network(), event.floor));
  }
  Told operator()(const lift::ChainTripped& event) const {
    const bool is_reset = event.trip == lift::SafetyChain::Trip::none;
    const std::string text =
        is_reset
            ? fmt::format("safety chain of lift {} is reset by hand", event.lift)
            : fmt::format("safety chain of lift {} is open: {}", event.lift, trip_text(event.trip));
    return {text,
            {{"event", "safety_chain"},
             {"lift", event.lift},
             {"trip", is_reset ? std::string_view() : trip_text(event.trip)},
             {"text", text}}};
  }
  Told operator()(const lift::TechnicianDid& event) const {
    const TechnicianStepWords words = step_words(event.step);
    std::string text(words.text);
    if (event.floor != lift::no_floor) text += floor_name(names_.network(), event.floor);
    return {fmt::format("technician of lift {} {}", event.lift, text),
            {{"event", "technician"},
             {"lift", event.lift},
             {"do", words.name},
             {"floor", event.floor},
             {"text", text}}};
  }
  Told operator()(const HandActed& event) const {
    Told hand = told(names_, event);
    hand.json()["bus"] = names_.bus(event.bus);
    return hand;
  }
  Told operator()(const lift::FaultBegan& event) const { return fault(true, event); }
  Told operator()(const lift::FaultEnded& event) const { return fault(false, event); }

 private:
  static Told car(std::string_view event, lift::LiftNumber lift, lift::FloorNumber floor,
                  const std::string& what) {
    return {fmt::format("lift {} {}", lift, what),
            {{"event", event}, {"lift", lift}, {"floor", floor}, {"text", what}}};
  }
  template <class Event>
  Told fault(bool begins, const Event& event) const {
    return reported_fault(names_, begins, fault_name(event.kind), event.place, place_text(event));
  }
  /// `at lift2: lift-landing-panel (24), floor 4`
  template <class Event>
  std::string place_text(const Event& event) const {
    const FaultPlace& place = event.place;
    if (place.node == 0) {
      return place.part == 0 ? "of all lifts" : fmt::format("of lift {}", place.part);
    }
    const bool is_cut = event.kind == lift::FaultKind::cable_cut;
    std::string text = fmt::format("{} {}", is_cut ? "behind" : "at",
                                   name_of(names_.network(), place.bus, place.node));
    const bool is_in_plan = event.fault < names_.network().faults.faults.size();
    const auto floor =
        is_in_plan ? names_.network().faults.faults[event.fault].spot : lift::no_floor;
    if (floor != lift::no_floor) text += ", " + floor_name(names_.network(), floor);
    return text;
  }
};

std::string times_text(std::string_view title, const LiftSummary::Times& times) {
  return fmt::format("  {:<22}{:6.1f} s mean, {:6.1f} s for 90 %, {:6.1f} s longest\n", title,
                     in_seconds(times.mean), in_seconds(times.percentile_90),
                     in_seconds(times.longest));
}

Json times_json(const LiftSummary::Times& times) {
  return {{"mean_s", in_seconds(times.mean)},
          {"percentile_90_s", in_seconds(times.percentile_90)},
          {"longest_s", in_seconds(times.longest)}};
}

}  // namespace

namespace {

std::string_view mode_name(lift::LiftMode mode) {
  switch (mode) {
    case lift::LiftMode::starting:
      return "starting";
    case lift::LiftMode::normal:
      return "normal";
    case lift::LiftMode::fire_recall:
      return "fire recall";
    case lift::LiftMode::fire_brigade:
      return "fire brigade";
    case lift::LiftMode::special:
      return "special service";
    case lift::LiftMode::out_of_order:
      return "out of order";
    case lift::LiftMode::fault:
      return "fault";
  }
  return "unknown";
}

Json landings_json(const lift::LiftNetworkSnapshot& now) {
  Json all = Json::array();
  for (const lift::LandingSnapshot& landing : now.landings) {
    all.push_back({{"waiting_up", landing.waiting_up},
                   {"waiting_down", landing.waiting_down},
                   {"lamp_up", landing.lamp_up},
                   {"lamp_down", landing.lamp_down}});
  }
  return all;
}

}  // namespace

Json building_json(const LiftNetworkDescription& network) {
  Json floors = Json::array();
  for (const lift::Floor& floor : network.building.floors) {
    floors.push_back({{"floor", floor.name}, {"height_m", floor.height_m}});
  }
  Json lifts = Json::array();
  for (const lift::LiftDesign& each : network.building.lifts) {
    Json served = Json::array();
    for (unsigned floor = 1; floor <= floors.size(); ++floor) {
      const auto number = static_cast<lift::LiftNumber>(lifts.size() + 1);
      if (network.building.serves(number, static_cast<lift::FloorNumber>(floor))) {
        served.push_back(floor);
      }
    }
    lifts.push_back({{"rated_persons", each.car.rated_persons},
                     {"rated_load_kg", each.car.rated_load_kg},
                     {"speed_m_s", each.speed_m_s},
                     {"floors", served}});
  }
  return {{"floors", floors},
          {"lifts", lifts},
          {"destination_control", network.people.destination_control}};
}

ReportedEvent reported_event(const lift::LiftEvent& event, const LiftNetworkDescription& network) {
  return reported_at(event.at, std::visit(LiftTeller(network), event.what));
}

Json lift_snapshot_json(const LiftNetworkDescription& network,
                        const lift::LiftNetworkSnapshot& now) {
  Json lifts = Json::array();
  for (const lift::LiftSnapshot& car : now.lifts) {
    double open = 0;
    for (const lift::LiftSnapshot::Door& door : car.doors) open = std::max(open, door.open_share);
    lifts.push_back({{"position_m", car.position_m},
                     {"speed_m_s", car.speed_m_s},
                     {"floor", car.nearest_floor},
                     {"direction", direction_text(car.direction)},
                     {"open", open},
                     {"mode", mode_name(car.mode)},
                     {"car_calls", car.car_calls},
                     {"overload", car.overload},
                     {"persons", car.persons},
                     {"load_kg", car.load_kg},
                     {"starts", car.starts},
                     {"energy_wh", car.energy_wh}});
  }
  const LiftNames names(network);
  Json json = line_json(now.at, "snapshot");
  json["waiting"] = now.waiting;
  json["riding"] = now.riding;
  json["served"] = now.served;
  json["lifts"] = lifts;
  json["landings"] = landings_json(now);
  json["buses"] = buses_json(names, now.buses);
  json["nodes"] = nodes_json(names, now.nodes);
  return json;
}

std::string lift_invariant_text(const Invariant& invariant, const LiftNetworkDescription& network) {
  return invariant_text(LiftNames(network), judged(invariant));
}

namespace {

/// A car that went up with a small load has fed energy back: not written as -0.00.
double kilowatt_hours(double watt_hours) {
  return std::round(watt_hours / 10) / 100 + 0.0;
}

/// Persons in five minutes from the interval, as in the classical calculation.
double capacity_of(const LiftSummary& summary) {
  constexpr double five_minutes_s = 300;
  return summary.interval_s > 0 ? five_minutes_s * summary.persons_of_car / summary.interval_s : 0;
}

std::string interval_text(const LiftSummary& summary) {
  std::string text;
  if (summary.interval_s > 0) {
    text += fmt::format("  {:<22}{:6.1f} s, {:.1f} persons a car", "interval", summary.interval_s,
                        summary.persons_of_car);
    if (summary.formula_interval_s > 0) {
      text += fmt::format("; by the formula {:.1f} s", summary.formula_interval_s);
    }
    text += fmt::format("\n  {:<22}{:6.0f} persons in 5 minutes by the interval\n",
                        "handling capacity", capacity_of(summary));
  }
  if (summary.is_saturated) {
    text += "  saturated: for 5 minutes more people waited than fill each car twice\n";
  }
  return text;
}

/// Of a lift that does not come back from a fault.
std::string standstill_text(const LiftSummary::Lift& lift) {
  constexpr Duration told_from = 1min;
  if (!lift.is_hindered || lift.stands < told_from) return "";
  return fmt::format("; has stood for {}", text::duration_text(lift.stands));
}

}  // namespace

std::string lift_summary_text(const LiftSummary& summary, std::span<const Invariant> invariants,
                              const LiftNetworkDescription& network) {
  std::string text = fmt::format("{} simulated: {} came, {} were carried, {} gave up\n",
                                 text::duration_text(summary.run), summary.arrived, summary.served,
                                 summary.gave_up);
  text += times_text("waiting time", summary.waiting);
  if (summary.gave_up != 0) {
    text += fmt::format("  {:<22}{:>6} who gave up count until they left\n", "", summary.gave_up);
  }
  text += times_text("time to destination", summary.to_destination);
  text +=
      fmt::format("  {:<22}{:6} persons carried\n", "most in 5 minutes", summary.most_in_5_minutes);
  text += interval_text(summary);
  for (std::size_t i = 0; i < summary.lifts.size(); ++i) {
    const LiftSummary::Lift& each = summary.lifts[i];
    text += fmt::format("  {:<22}{:6} starts, {:.0f} an hour, {:.0f} m, {:.2f} kWh{}\n",
                        fmt::format("lift {}", i + 1), each.starts, each.starts_an_hour,
                        each.distance_m, kilowatt_hours(each.energy_wh), standstill_text(each));
  }
  const LiftNames names(network);
  for (std::size_t bus = 0; bus < summary.buses.size(); ++bus) {
    text += fmt::format("  {:<22}{:6.1f} % load\n", fmt::format("bus {}", names.bus(bus)),
                        summary.buses[bus].load * 100);
  }
  text += invariants_text(names, invariants);
  return text;
}

Json lift_summary_json(const LiftSummary& summary, std::span<const Invariant> invariants,
                       const LiftNetworkDescription& network) {
  Json lifts = Json::array();
  for (const LiftSummary::Lift& each : summary.lifts) {
    lifts.push_back({{"starts", each.starts},
                     {"starts_an_hour", each.starts_an_hour},
                     {"distance_m", each.distance_m},
                     {"energy_wh", each.energy_wh},
                     {"stands_s", in_seconds(each.stands)},
                     {"hindered", each.is_hindered}});
  }
  const LiftNames names(network);
  Json json = line_json(Time{} + summary.run, "summary");
  json.update({{"arrived", summary.arrived},
               {"served", summary.served},
               {"gave_up", summary.gave_up},
               {"waiting", times_json(summary.waiting)},
               {"to_destination", times_json(summary.to_destination)},
               {"most_in_5_minutes", summary.most_in_5_minutes},
               {"interval_s", summary.interval_s},
               {"handling_capacity_in_5_minutes", capacity_of(summary)},
               {"formula_interval_s", summary.formula_interval_s},
               {"saturated", summary.is_saturated},
               {"persons_of_car", summary.persons_of_car},
               {"lifts", lifts},
               {"buses", buses_json(names, summary.buses)}});
  add_invariants(json, names, invariants);
  return json;
}

using LiftText = WorldText<lift::LiftNetwork>;

ReportedEvent LiftText::event(const lift::LiftEvent& event, const lift::LiftNetwork& network) {
  return reported_event(event, network.description());
}

/// As many rows of floors as a terminal has room for, beside the surroundings and some events.
std::string LiftText::picture(lift::LiftNetwork& network, double speed) {
  constexpr unsigned rows_around = 10;
  constexpr unsigned rows_of_events = 4;
  constexpr unsigned rows_least = 8;
  const Screen::Size size = Screen::size();
  const unsigned rows =
      std::max(size.rows, rows_around + rows_of_events + rows_least) - rows_around - rows_of_events;
  return lift_picture(network.description(), network.snapshot(), speed, rows, size.columns);
}

Json LiftText::snapshot(lift::LiftNetwork& network) {
  return lift_snapshot_json(network.description(), network.snapshot());
}

std::string LiftText::summary_text(lift::LiftNetwork& network) {
  return lift_summary_text(network.summary(), network.invariants(), network.description());
}

Json LiftText::summary(lift::LiftNetwork& network) {
  return lift_summary_json(network.summary(), network.invariants(), network.description());
}

}  // namespace canvoy::tools
