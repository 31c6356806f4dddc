#include "canvoy/tools/play/bus_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "canvoy/text/first_characters.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/play/bus_words.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using bus_line::BusNetwork;
using bus_line::BusNetworkSnapshot;
using bus_line::NetworkEvent;

constexpr double to_kmh = 3.6;

/// Joins lines into one.
std::string on_one_line(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
    text.replace(at, 1, " | ");
  }
  return text.empty() ? "dark" : text;
}

std::string delay_text(Duration delay) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(delay).count();
  if (seconds == 0) return "on time";
  return fmt::format("{} s {}", std::abs(seconds), seconds > 0 ? "late" : "early");
}

std::string_view how_text(bus_line::StopReached::How how) {
  using How = bus_line::StopReached::How;
  if (how == How::arrives) return "arrives at";
  return how == How::leaves ? "leaves" : "goes past";
}

/// ` of the third car`; empty: of the first one.
std::string of_car(unsigned car) {
  constexpr std::array<std::string_view, bus_line::cars_max + 1> numbers = {"", "", "second",
                                                                            "third", "fourth"};
  return car == 1 ? "" : fmt::format(" of the {} car", numbers.at(car));
}

class BusTeller : public WorldTeller<BusNames> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const bus_line::JourneyBegan& event) const {
    return {fmt::format("journey {} to {}", event.journey, event.destination),
            {{"event", "journey"}, {"journey", event.journey}, {"destination", event.destination}}};
  }
  Told operator()(const bus_line::StopReached& event) const {
    using How = bus_line::StopReached::How;
    const std::string_view how = event.how == How::arrives  ? "arrives"
                                 : event.how == How::leaves ? "leaves"
                                                            : "passes";
    return {fmt::format("bus {} {}, {}, {} aboard", how_text(event.how), event.stop,
                        delay_text(event.delay), event.aboard),
            {{"event", "stop"},
             {"how", how},
             {"stop", event.stop},
             {"delay_s", in_seconds(event.delay)},
             {"aboard", event.aboard}}};
  }
  Told operator()(const bus_line::BlockEnded&) const {
    return {"the block is over", {{"event", "block-over"}}};
  }
  Told operator()(const bus_line::DisplayShows& event) const {
    return {fmt::format("{}: {}", names_.device(0, event.node), on_one_line(event.text)),
            {{"event", "display"}, {"node", event.node}, {"text", event.text}}};
  }
  Told operator()(const bus_line::Announced& event) const {
    return {fmt::format("loudspeakers{}: {}", of_car(event.car), event.stop),
            {{"event", "announcement"},
             {"stop_point", event.stop_point},
             {"stop", event.stop},
             {"car", event.car}}};
  }
  Told operator()(const bus_line::StopSignLit& event) const {
    return {fmt::format("stop sign{} {}", of_car(event.car), event.is_lit ? "on" : "off"),
            {{"event", "stop-sign"}, {"lit", event.is_lit}, {"car", event.car}}};
  }
  Told operator()(const bus_line::TicketIssued& event) const {
    const std::string_view what = event.is_printed ? "printed" : "cancelled";
    return {
        fmt::format("ticket {}: zone {}, segment {}", what, event.fare_zone, event.route_segment),
        {{"event", "ticket"},
         {"ticket", what},
         {"fare_zone", event.fare_zone},
         {"route_segment", event.route_segment}}};
  }
};

/// The present content of a display, with its name above.
std::string display_text(const BusNames& names, const BusNetworkSnapshot::Shown& shown) {
  constexpr std::size_t columns = 60;
  std::string text = fmt::format("  {}\n  +{:-<{}}+\n", names.name(shown.node), "", columns + 2);
  std::string_view rest = shown.text;
  do {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    do {
      text += fmt::format("  | {} |\n", text::first_characters(line, columns));
      line.remove_prefix(std::min(columns, line.size()));
    } while (!line.empty());
    rest.remove_prefix(std::min(end + 1, rest.size()));
  } while (!rest.empty());
  return text +
         fmt::format("  +{:-<{}}+{}\n", "", columns + 2, shown.is_sign_lit ? "  [ STOP ]" : "");
}

/// `o====>---o------o`: its stops, and where the bus is between them.
std::string line_picture(const BusNetworkSnapshot& now) {
  constexpr double columns = 70;
  const bus_line::BusRoute& route = *now.truth.route;
  const double length = std::max(1.0, route.stops.back().metres);
  const auto column = [&](double metres) {
    const double at = std::clamp(metres / length, 0.0, 1.0) * (columns - 1);
    return static_cast<std::size_t>(std::lround(at));
  };
  std::string way(static_cast<std::size_t>(columns), '-');
  for (const bus_line::RouteStop& stop : route.stops) way[column(stop.metres)] = 'o';
  if (now.state != bus_line::BusState::transferring) way[column(now.metres_on_route)] = '>';
  return "  " + way + "\n";
}

std::string_view bus_state_words(const BusNetworkSnapshot& now) {
  switch (now.state) {
    case bus_line::BusState::at_stop:
      return "stands at";
    case bus_line::BusState::driving:
      return "drives to";
    case bus_line::BusState::transferring:
      return "goes over to";
    case bus_line::BusState::over:
      return "has ended at";
  }
  return "";
}

std::string_view door_words(bus_line::DoorState state) {
  switch (state) {
    case bus_line::DoorState::closed:
      return "closed";
    case bus_line::DoorState::opening:
      return "opening";
    case bus_line::DoorState::open:
      return "open";
    case bus_line::DoorState::closing:
      return "closing";
  }
  return "";
}

std::string clock_text(const cia407::CivilTime& time) {
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", time.year, time.month, time.day,
                     time.hour, time.minute, time.second);
}

Json bus_look_json(BusNetwork& network, std::string_view event) {
  const BusNetworkSnapshot now = network.snapshot();
  const BusNames names(network.options());
  Json json = line_json(now.at, event);
  json["local_time"] = clock_text(now.local_time);
  json["plant"] = {{"block", now.truth.block->number},
                   {"journey", now.truth.journey->number},
                   {"destination", now.truth.route->destination_at(now.truth.reached())},
                   {"stop", now.truth.stop->name},
                   {"at_stop", now.truth.is_at_stop},
                   {"stop_requested", now.truth.stop_requested},
                   {"fare_zone", now.truth.fare.zone},
                   {"route_segment", now.truth.fare.segment},
                   {"aboard", now.truth.aboard},
                   {"delay_s", in_seconds(now.delay)},
                   {"latitude", now.position.latitude},
                   {"longitude", now.position.longitude},
                   {"speed_m_per_s", now.speed},
                   {"distance_m", now.odometer}};
  Json doors = Json::array();
  for (const bus_line::DoorState door : now.doors) doors.push_back(door_words(door));
  json["plant"]["doors"] = std::move(doors);
  json["counted_aboard"] = now.counted;
  Json displays = Json::array();
  for (const BusNetworkSnapshot::Shown& shown : now.displays) {
    displays.push_back({{"node", shown.node},
                        {"display", names.name(shown.node)},
                        {"car", names.car(shown.node)},
                        {"text", shown.text},
                        {"stop_sign", shown.is_sign_lit}});
  }
  json["displays"] = std::move(displays);
  json["statistics"] = bus_statistics_json(now.statistics, now.riders);
  json["buses"] = buses_json(names, now.buses);
  json["nodes"] = nodes_json(names, now.nodes);
  return json;
}

}  // namespace

ReportedEvent WorldText<bus_line::BusNetwork>::event(const NetworkEvent& event,
                                                     const BusNetwork& network) {
  return reported_at(event.at, std::visit(BusTeller(network.options()), event.what));
}

std::string WorldText<bus_line::BusNetwork>::picture(BusNetwork& network, double speed) {
  const BusNetworkSnapshot now = network.snapshot();
  const BusNames names(network.options());
  std::string text = fmt::format("Canvoy: a bus, CiA 407 at {} kbit/s    {}    {}{}\n\n",
                                 network.options().bit_rate / 1000, clock_text(now.local_time),
                                 text::duration_text(now.at - Time{}),
                                 speed > 0 ? fmt::format("  (x{:g})", speed) : "");
  for (const BusNetworkSnapshot::Shown& shown : now.displays) text += display_text(names, shown);
  text += "\n" + line_picture(now);
  text += fmt::format("  {} {}, {:.0f} km/h, {}; {} aboard, {} counted\n\n", bus_state_words(now),
                      now.truth.stop->name, now.speed * to_kmh, delay_text(now.delay),
                      now.truth.aboard, now.counted);
  for (const NodeSnapshot& node : now.nodes) {
    text += fmt::format("  {:<28}{}\n", names.device(0, node.id), tools::state_text(node));
  }
  for (std::size_t i = 0; i < now.buses.size(); ++i) {
    const BusSnapshot& bus = now.buses.at(i);
    text += fmt::format("  {:<28}{:.1f} %, {} frames, {} error frames\n",
                        fmt::format("bus load, car {}", i + 1), bus.load * 100, bus.frames,
                        bus.error_frames);
  }
  return text + "\n" + last_events(network, 8);
}

Json WorldText<bus_line::BusNetwork>::snapshot(BusNetwork& network) {
  return bus_look_json(network, "snapshot");
}

std::string WorldText<bus_line::BusNetwork>::summary_text(BusNetwork& network) {
  const BusNetworkSnapshot end = network.snapshot();
  const BusNames names(network.options());
  const std::vector<bus_line::Invariant> all = network.invariants();
  return fmt::format("{} simulated: {}\n", text::duration_text(end.at - Time{}),
                     service_text(end.statistics, end.riders, end.odometer, end.traffic())) +
         invariants_text(names, std::span<const bus_line::Invariant>(all));
}

Json WorldText<bus_line::BusNetwork>::summary(BusNetwork& network) {
  Json json = bus_look_json(network, "summary");
  const std::vector<bus_line::Invariant> all = network.invariants();
  add_invariants(json, BusNames(network.options()), std::span<const bus_line::Invariant>(all));
  return json;
}

}  // namespace canvoy::tools
