#include "canvoy/tools/play/police_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/play/car_text.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using police::PoliceEvent;
using police::PoliceNetwork;
using police::PoliceSnapshot;

std::string_view crew_text(police::Activity activity) {
  using police::Activity;
  switch (activity) {
    case Activity::off_duty:
      return "off duty";
    case Activity::setting_out:
      return "sets out";
    case Activity::patrolling:
      return "on patrol";
    case Activity::conversing:
      return "talks hands-free";
    case Activity::listening:
      return "listens to a call";
    case Activity::acknowledging:
      return "answers the call";
    case Activity::responding:
      return "drives to the call";
    case Activity::at_scene:
      return "at the scene";
    case Activity::reporting:
      return "reports by radio";
    case Activity::bringing:
      return "brings somebody to the station";
    case Activity::resting:
      return "has a break";
    case Activity::clearing:
      return "is free again";
    case Activity::parking:
      return "parks the car";
  }
  return "";
}

std::string_view client_text(const std::optional<police::Client>& client) {
  if (!client) return "car";
  switch (*client) {
    case police::Client::radio:
      return "radio";
    case police::Client::signals:
      return "signals";
    case police::Client::navigation:
      return "navigation";
  }
  return "";
}

std::string_view sound_text(cia447::AdditionalSound sound) {
  using cia447::AdditionalSound;
  switch (sound) {
    case AdditionalSound::none:
      return "none";
    case AdditionalSound::country_specific:
      return "of the country";
    case AdditionalSound::us_hi_lo:
      return "hi-lo";
    case AdditionalSound::us_yelp:
      return "yelp";
    case AdditionalSound::wail:
      return "wail";
    default:
      return "another one";
  }
}

class PoliceTeller : public WorldTeller<CarNames<PoliceNetwork>> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const police::CallMade& event) const {
    return {fmt::format("call {}: help is wanted {:.1f} km away", event.destination,
                        event.metres / 1000),
            {{"event", "call"}, {"destination", event.destination}, {"distance_m", event.metres}}};
  }
  Told operator()(const police::ActivityChanged& event) const {
    const std::string_view activity = crew_text(event.activity);
    return {fmt::format("crew: {}", activity), {{"event", "crew"}, {"crew", activity}}};
  }
  Told operator()(const police::SignalsChanged& event) const {
    return {fmt::format("blue light {}, siren {}", event.is_blue ? "flashes" : "off",
                        event.has_siren ? "sounds" : "off"),
            {{"event", "signals"}, {"blue_light", event.is_blue}, {"siren", event.has_siren}}};
  }
  Told operator()(const police::TerminalTaken& event) const {
    const std::string_view client = client_text(event.client);
    return {fmt::format("display 1: {}", client), {{"event", "terminal"}, {"client", client}}};
  }
  Told operator()(const police::StatusSent& event) const {
    return {fmt::format("control room: status {}", event.status),
            {{"event", "status"}, {"status", event.status}}};
  }
  Told operator()(const police::PowerSwitched& event) const {
    const std::string_view supply = event.is_radio ? "radio" : "periphery";
    return {fmt::format("{}: power {}", supply, event.is_on ? "on" : "off"),
            {{"event", "power"}, {"supply", supply}, {"on", event.is_on}}};
  }
};

/// The roof from above: `[*] [ ]`.
template <class Lamps>
std::string lamps_text(const Lamps& lamps) {
  std::string text;
  for (const bool is_lit : lamps) text += is_lit ? "[*]" : "[ ]";
  return text;
}

/// The lines of a display, padded to its width.
std::vector<std::string> display_lines(std::string_view text, std::size_t lines,
                                       std::size_t columns) {
  std::vector<std::string> made;
  while (made.size() < lines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    made.push_back(fmt::format("{:<{}}", text.substr(0, std::min(end, columns)), columns));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return made;
}

std::string displays_text(const police::Surroundings& around) {
  constexpr std::size_t columns_1 = 20;
  constexpr std::size_t columns_2 = 16;
  const auto first = display_lines(around.title + "\n" + around.text_1, 2, columns_1);
  const auto second = display_lines(around.text_2, 2, columns_2);
  const std::string frame =
      fmt::format("  +{:-<{}}+ +{:-<{}}+\n", "", columns_1 + 2, "", columns_2 + 2);
  std::string text = frame;
  for (std::size_t i = 0; i < first.size(); ++i) {
    text += fmt::format("  | {} | | {} |\n", first[i], second[i]);
  }
  return text + frame;
}

std::string_view speech_text(const PoliceSnapshot& now) {
  if (now.crew_speaks) return now.crew_is_heard ? "the crew is heard" : "nobody hears the crew";
  if (now.room_speaks) {
    return now.room_is_heard ? "the control room is heard" : "nobody hears the control room";
  }
  if (!now.around.radio_has_power) return "no power";
  return now.around.is_on_the_air() ? "on the air" : "silent";
}

double seconds_of(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// Mean of the calls that were attended to; 0 without calls.
double mean_response(const police::PoliceStatistics& statistics) {
  if (statistics.attended == 0) return 0;
  return seconds_of(statistics.response_time) / static_cast<double>(statistics.attended);
}

Json statistics_json(const police::PoliceStatistics& statistics) {
  return {{"calls", statistics.calls},
          {"attended", statistics.attended},
          {"mean_response_s", mean_response(statistics)},
          {"keys", statistics.keys},
          {"status_messages", statistics.statuses},
          {"longest_wait_s", seconds_of(statistics.longest_wait)}};
}

Json police_look_json(PoliceNetwork& network, std::string_view event) {
  const PoliceSnapshot now = network.snapshot();
  const CarNames<PoliceNetwork> names(network);
  Json json = line_json(now.at, event);
  json["crew"] = crew_text(now.crew);
  json["wish"] = {{"blue_light", now.wish.is_blue},
                  {"siren", now.wish.has_siren},
                  {"work_light", now.wish.has_work_light},
                  {"locked", now.wish.is_locked}};
  json["asleep"] = now.is_asleep;
  json["terminal"] = {{"client", client_text(now.client)},
                      {"title", now.around.title},
                      {"display_1", now.around.text_1},
                      {"display_2", now.around.text_2}};
  json["plant"] = {{"blue_light", now.is_blue},
                   {"beacons", now.beacons},
                   {"flashers", now.flashers},
                   {"work_light", now.has_work_light},
                   {"siren", sound_text(now.around.sound.sound)},
                   {"locked", now.around.is_locked},
                   {"radio_power", now.around.radio_has_power},
                   {"periphery_power", now.around.periphery_has_power},
                   {"on_the_air", now.around.is_on_the_air()},
                   {"crew_speaks", now.crew_speaks},
                   {"crew_is_heard", now.crew_is_heard},
                   {"control_room_speaks", now.room_speaks},
                   {"control_room_is_heard", now.room_is_heard},
                   {"distance_m", now.metres},
                   {"speed_m_per_s", now.speed}};
  json["statistics"] = statistics_json(now.statistics);
  json["buses"] = buses_json(names, std::span(&now.bus, 1));
  json["nodes"] = nodes_json(names, now.nodes);
  return json;
}

Json call_json(const police::EmergencyCall& call) {
  const auto at = [](const std::optional<Time>& time) {
    return time ? Json(in_seconds(*time - Time{})) : Json();
  };
  return {{"made", in_seconds(call.made - Time{})},
          {"destination", call.destination},
          {"distance_m", call.metres},
          {"heard", at(call.heard)},
          {"acknowledged", at(call.acknowledged)},
          {"arrived", at(call.arrived)},
          {"reported", at(call.reported)}};
}

}  // namespace

ReportedEvent WorldText<police::PoliceNetwork>::event(const PoliceEvent& event,
                                                      const PoliceNetwork& network) {
  return reported_at(event.at, std::visit(PoliceTeller(network), event.what));
}

std::string WorldText<police::PoliceNetwork>::picture(PoliceNetwork& network, double speed) {
  const PoliceSnapshot now = network.snapshot();
  const CarNames<PoliceNetwork> names(network);
  constexpr double to_kmh = 3.6;
  std::string text = fmt::format(
      "Canvoy: a police car, CiA 447-3 at {} kbit/s    {}{}\n\n", network.options().bit_rate / 1000,
      text::duration_text(now.at - Time{}), speed > 0 ? fmt::format("  (x{:g})", speed) : "");
  text += fmt::format("  roof {}   flashers {}   siren {}\n", lamps_text(now.beacons),
                      lamps_text(now.flashers), sound_text(now.around.sound.sound));
  text += displays_text(now.around);
  text += fmt::format("  display 1 {:<12} radio {:<28} car {}\n", client_text(now.client),
                      speech_text(now), now.around.is_locked ? "locked" : "unlocked");
  text += fmt::format("  crew {}, {:.0f} km/h, {:.1f} km driven; {} of {} calls attended to\n\n",
                      now.is_asleep ? "away: the network sleeps" : crew_text(now.crew),
                      now.speed * to_kmh, now.metres / 1000, now.statistics.attended,
                      now.statistics.calls);
  for (const NodeSnapshot& node : now.nodes) {
    text += fmt::format("  {:<28}{}\n", names.device(0, node.id), tools::state_text(node));
  }
  text += fmt::format("  {:<28}{:.1f} %, {} frames, {} error frames\n\n", "bus load",
                      now.bus.load * 100, now.bus.frames, now.bus.error_frames);
  return text + last_events(network, 8);
}

Json WorldText<police::PoliceNetwork>::snapshot(PoliceNetwork& network) {
  return police_look_json(network, "snapshot");
}

std::string WorldText<police::PoliceNetwork>::summary_text(PoliceNetwork& network) {
  const PoliceSnapshot end = network.snapshot();
  const CarNames<PoliceNetwork> names(network);
  const std::vector<police::Invariant> all = network.invariants();
  const police::PoliceStatistics& statistics = end.statistics;
  return fmt::format(
             "{} simulated: {:.1f} km driven, {} of {} calls attended to and reported, {:.0f} s "
             "to the scene on average; {} keys pressed, {} status messages; {} frames, {} error "
             "frames\n",
             text::duration_text(end.at - Time{}), end.metres / 1000, statistics.attended,
             statistics.calls, mean_response(statistics), statistics.keys, statistics.statuses,
             end.bus.frames, end.bus.error_frames) +
         invariants_text(names, std::span<const police::Invariant>(all));
}

Json WorldText<police::PoliceNetwork>::summary(PoliceNetwork& network) {
  Json json = police_look_json(network, "summary");
  Json calls = Json::array();
  for (const police::EmergencyCall& call : network.calls()) calls.push_back(call_json(call));
  json["calls"] = std::move(calls);
  const std::vector<police::Invariant> all = network.invariants();
  add_invariants(json, CarNames(network), std::span<const police::Invariant>(all));
  return json;
}

}  // namespace canvoy::tools
