#include "canvoy/tools/play/taxi_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/device/car/car_words.hpp"
#include "canvoy/tools/play/car_text.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using taxi::money_unit;
using taxi::TaxiEvent;
using taxi::TaxiNetwork;
using taxi::TaxiSnapshot;

std::string_view activity_text(taxi::Activity activity) {
  using taxi::Activity;
  switch (activity) {
    case Activity::off_duty:
      return "off duty";
    case Activity::calibrating:
      return "drives to calibrate the meter";
    case Activity::signing_on:
      return "signs on";
    case Activity::waiting:
      return "waits at the stand";
    case Activity::fetching:
      return "drives to a passenger";
    case Activity::unmet:
      return "waits for who does not come";
    case Activity::boarding:
      return "passengers get in";
    case Activity::hiring:
      return "starts the meter";
    case Activity::carrying:
      return "drives with passengers";
    case Activity::at_lights:
      return "stands at a light";
    case Activity::stopping:
      return "stops the meter";
    case Activity::paying:
      return "passengers pay";
    case Activity::releasing:
      return "clears the meter";
    case Activity::going_to_rest:
      return "goes to rest";
    case Activity::resting:
      return "has a break";
    case Activity::rising:
      return "ends the break";
    case Activity::signing_off:
      return "signs off";
  }
  return "";
}

/// An amount in 0,001 of the currency unit; `-` if there is none.
std::string money_text(std::uint32_t amount) {
  return amount == cia447::TripData::unknown ? "-" : fmt::format("{:.2f}", amount / money_unit);
}
std::string level_text(const std::array<std::uint8_t, 2>& level) {
  std::string text;
  for (const std::uint8_t character : level) {
    if (character >= 0x20 && character < 0x7F) text += static_cast<char>(character);
  }
  return text;
}

/// Trips that a fault may have affected.
Json excused_json(const taxi::Trip& trip) {
  Json all = Json::array();
  if (trip.excused.fare) all.push_back("fare");
  if (trip.excused.distance) all.push_back("distance");
  if (trip.excused.duration) all.push_back("duration");
  return all;
}

Json trip_json(const taxi::Trip& trip) {
  return {{"begin", in_seconds(trip.begin - Time{})},
          {"end", in_seconds(trip.end - Time{})},
          {"distance_m", trip.metres},
          {"metered_distance_m", trip.metered_metres},
          {"duration_s", trip.seconds},
          {"metered_duration_s", trip.metered_seconds},
          {"fare", trip.metered_fare / money_unit},
          {"fare_low", trip.fare_low / money_unit},
          {"fare_high", trip.fare_high / money_unit},
          {"paid", trip.paid / money_unit},
          {"tariff_change", trip.has_tariff_change},
          {"total", trip.total / money_unit},
          {"extras", trip.extras / money_unit},
          {"judged", trip.is_read},
          {"excused", excused_json(trip)}};
}

class TaxiTeller : public WorldTeller<CarNames<TaxiNetwork>> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const taxi::MeterChanged& event) const {
    const std::string state = taximeter_words(event.state);
    return {fmt::format("meter: {}", state), {{"event", "meter"}, {"state", state}}};
  }
  Told operator()(const taxi::TariffChanged& event) const {
    const std::string level = level_text(event.level);
    return {fmt::format("meter: tariff {}", level), {{"event", "tariff"}, {"level", level}}};
  }
  Told operator()(const taxi::TripPaid& event) const {
    Json json{{"event", "paid"}};
    json.update(trip_json(event.trip));
    return {fmt::format("{:.2f} km in {}: {:.2f} paid", event.trip.metres / 1000,
                        text::duration_text(event.trip.end - event.trip.begin),
                        event.trip.paid / money_unit),
            std::move(json)};
  }
  Told operator()(const taxi::MeterRecorded& event) const {
    const std::string text(cia447::audit_text(event.entry).view());
    return {fmt::format("meter records: {}", text), {{"event", "meter-records"}, {"entry", text}}};
  }
  Told operator()(const taxi::PassengersSeen& event) const {
    using enum taxi::PassengersSeen::Doing;
    switch (event.doing) {
      case get_in:
        return {"passengers get in", {{"event", "passengers"}, {"do", "get-in"}}};
      case stay_away:
        return {"nobody is there", {{"event", "passengers"}, {"do", "stay-away"}}};
      case get_out:
        return {"passengers get out", {{"event", "passengers"}, {"do", "get-out"}}};
      case walk_away:
        return {"passengers walk away: the meter does not start",
                {{"event", "passengers"}, {"do", "walk-away"}}};
    }
    return {"", {}};
  }
  Told operator()(const taxi::MeterWaitedFor& event) const {
    const std::string state = taximeter_words(event.state);
    return {fmt::format("the driver waits for the meter: press it, until it is {}", state),
            {{"event", "meter-waited-for"}, {"state", state}}};
  }
  Told operator()(const taxi::AlarmPressed&) const {
    return {"the driver presses the alarm key", {{"event", "alarm"}}};
  }
  Told operator()(const taxi::CallHeard&) const {
    return {"the control room hears the alarm", {{"event", "alarm-heard"}}};
  }
  Told operator()(const taxi::ShiftChanged& event) const {
    return {event.begins ? "the shift begins" : "the shift is over",
            {{"event", event.begins ? "shift-begins" : "shift-ends"}}};
  }
};

/// State of a lamp as seen at this moment: on, dimmed, off; blinking twice in three seconds.
char lamp_seen(cia447::Lamp lamp, Time now) {
  constexpr Duration blink = 1500ms;
  const bool is_bright = (now - Time{}) % blink < blink / 2;
  switch (lamp) {
    case cia447::Lamp::on:
      return '*';
    case cia447::Lamp::dimmed:
      return '+';
    case cia447::Lamp::blinking:
      return is_bright ? '*' : '.';
    default:
      return '.';
  }
}

/// Lines of a text, each padded to `columns`.
std::vector<std::string> lines_of(std::string_view text, std::size_t lines, std::size_t columns) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < lines; ++i) {
    const std::size_t end = text.find('\n');
    all.push_back(fmt::format("{:<{}}", text.substr(0, end), columns));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return all;
}

/// Roof, terminal and paper.
std::string parts_text(const TaxiSnapshot& now) {
  constexpr std::size_t lines = 4;
  constexpr std::size_t columns[] = {20, 16, 32};
  std::string text = "  roof      ";
  for (const cia447::Lamp lamp : now.lamps) text += fmt::format("{} ", lamp_seen(lamp, now.at));
  text += fmt::format("  tariff {}\n\n", level_text(now.trip.level));
  text += fmt::format("  {:<22}  {:<18}  {}\n", "terminal: display 1", "display 2", "paper");
  const auto frame = fmt::format("  +{:-<20}+  +{:-<16}+  :{: <32}:\n", "", "", "");
  std::string paper;
  for (const std::string& line : now.paper) paper += line + "\n";
  const std::vector<std::string> shown[] = {lines_of(now.screens[0].text, lines, columns[0]),
                                            lines_of(now.screens[1].text, lines, columns[1]),
                                            lines_of(paper, lines, columns[2])};
  text += frame;
  for (std::size_t i = 0; i < lines; ++i) {
    text += fmt::format("  |{}|  |{}|  :{}:\n", shown[0][i], shown[1][i], shown[2][i]);
  }
  return text + frame + "\n";
}

Json parts_json(const TaxiSnapshot& now) {
  Json lamps = Json::array();
  for (const cia447::Lamp lamp : now.lamps) lamps.push_back(lamp_words(lamp));
  Json screens = Json::array();
  for (const taxi::Screen& screen : now.screens) {
    screens.push_back({{"holder", screen.holder}, {"text", screen.text}});
  }
  return {{"lamps", lamps}, {"displays", screens}, {"paper", now.paper}};
}

Json meter_json(const TaxiSnapshot& now) {
  const auto amount = [](std::uint32_t value) {
    return value == cia447::TripData::unknown ? Json() : Json(value / money_unit);
  };
  return {{"state", taximeter_words(now.meter)},         {"fare", amount(now.trip.fare)},
          {"supplements", amount(now.trip.supplements)}, {"total", amount(now.trip.total)},
          {"distance_km", amount(now.trip.distance)},    {"level", level_text(now.trip.level)}};
}

Json look_json(TaxiNetwork& network, std::string_view event) {
  const TaxiSnapshot now = network.snapshot();
  const CarNames<TaxiNetwork> names(network);
  Json json = line_json(now.at, event);
  json["meter"] = meter_json(now);
  json["driver"] = activity_text(now.driver);
  json["asleep"] = now.is_asleep;
  json["carried"] = now.carried;
  json["paid"] = now.paid;
  json.update(parts_json(now));
  json["plant"] = {{"distance_m", now.metres}, {"speed_m_per_s", now.speed}};
  json["buses"] = buses_json(names, std::span(&now.bus, 1));
  json["nodes"] = nodes_json(names, now.nodes);
  return json;
}

}  // namespace

ReportedEvent WorldText<taxi::TaxiNetwork>::event(const TaxiEvent& event,
                                                  const TaxiNetwork& network) {
  return reported_at(event.at, std::visit(TaxiTeller(network), event.what));
}

std::string WorldText<taxi::TaxiNetwork>::picture(TaxiNetwork& network, double speed) {
  const TaxiSnapshot now = network.snapshot();
  const CarNames<TaxiNetwork> names(network);
  constexpr double to_kmh = 3.6;
  std::string text = fmt::format(
      "Canvoy: a taxi, CiA 447-3 at {} kbit/s    {}{}\n\n", network.options().bit_rate / 1000,
      text::duration_text(now.at - Time{}), speed > 0 ? fmt::format("  (x{:g})", speed) : "");
  text += fmt::format("  +--------------------------+\n  | {:<12} tariff {:<4} |   driver   {}\n",
                      taximeter_words(now.meter), level_text(now.trip.level),
                      now.is_asleep ? "away: the network sleeps" : activity_text(now.driver));
  text += fmt::format("  | fare        {:>12} |   speed    {:.0f} km/h\n",
                      money_text(now.trip.fare), now.speed * to_kmh);
  text += fmt::format("  | extras      {:>12} |   driven   {:.2f} km\n",
                      money_text(now.trip.supplements), now.metres / 1000);
  text += fmt::format("  | km          {:>12} |   carried  {} times, {:.2f} paid\n",
                      money_text(now.trip.distance), now.carried, now.paid);
  text += "  +--------------------------+\n\n" + parts_text(now);
  for (const NodeSnapshot& node : now.nodes) {
    text += fmt::format("  {:<28}{}\n", names.device(0, node.id), tools::state_text(node));
  }
  text += fmt::format("  {:<28}{:.1f} %, {} frames, {} error frames\n\n", "bus load",
                      now.bus.load * 100, now.bus.frames, now.bus.error_frames);
  return text + last_events(network, 8);
}

Json WorldText<taxi::TaxiNetwork>::snapshot(TaxiNetwork& network) {
  return look_json(network, "snapshot");
}

std::string WorldText<taxi::TaxiNetwork>::summary_text(TaxiNetwork& network) {
  const TaxiSnapshot end = network.snapshot();
  const CarNames<TaxiNetwork> names(network);
  const std::vector<taxi::Invariant> all = network.invariants();
  return fmt::format(
             "{} simulated: {:.1f} km driven, {} trips, {:.2f} paid; {} frames, {} error frames\n",
             text::duration_text(end.at - Time{}), end.metres / 1000, end.carried, end.paid,
             end.bus.frames, end.bus.error_frames) +
         invariants_text(names, std::span<const taxi::Invariant>(all));
}

Json WorldText<taxi::TaxiNetwork>::summary(TaxiNetwork& network) {
  Json json = look_json(network, "summary");
  Json trips = Json::array();
  for (const taxi::Trip& trip : network.trips()) trips.push_back(trip_json(trip));
  json["trips"] = std::move(trips);
  const std::vector<taxi::Invariant> all = network.invariants();
  add_invariants(json, CarNames(network), std::span<const taxi::Invariant>(all));
  return json;
}

}  // namespace canvoy::tools
