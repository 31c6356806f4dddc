#include "canvoy/worlds/police/patrol_watch.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::police {

PatrolWatch::PatrolWatch(PoliceCar& car, const PoliceOptions& options, Crew& crew,
                         const PoliceExcuses& excuses, PoliceReferee& referee)
    : car_(car),
      options_(options),
      crew_(crew),
      excuses_(excuses),
      referee_(referee),
      undecided_(undecided_kinds()),
      silence_(car.bus(), 5ms),
      settled_at_(car::return_bound),
      waits_for_real_(!options.real.empty()) {
  for (const InvariantKind kind : undecided_) referee_.cannot_judge(kind);
}

/// The actions of a real device cannot be seen, and its keys are out of the crew's reach.
std::vector<InvariantKind> PatrolWatch::undecided_kinds() const {
  using Kind = InvariantKind;
  std::vector<Kind> kinds;
  const auto add = [&kinds](std::initializer_list<Kind> more) { kinds.insert(kinds.end(), more); };
  const bool has_keys = is_played(terminal_id) && is_played(roof_sound_id);
  if (!is_played(terminal_id)) add({Kind::keypad, Kind::terminal_wait});
  if (!is_played(radio_id) || !is_played(navigation_id)) add({Kind::terminal_wait});
  if (!has_keys) add({Kind::terminal_wait, Kind::blue_light, Kind::siren, Kind::display});
  if (!has_keys || !is_played(cia447::gateway_node_id)) add({Kind::locks});
  if (!has_keys) add({Kind::siren_alone});
  if (!has_keys || !is_played(roof_light_id)) add({Kind::work_light});
  if (!is_played(roof_light_id) || !is_played(blue_light_id)) {
    add({Kind::blue_light, Kind::siren_alone, Kind::display});
  }
  if (!is_played(terminal_id) || !is_played(radio_id) || !is_played(power_supply_id)) {
    add({Kind::emergency});
  }
  if (!talks_are_played()) add({Kind::speech, Kind::carrier});
  if (!is_played(power_supply_id) || !is_played(cia447::gateway_node_id)) add({Kind::power});
  if (!is_played(cia447::gateway_node_id)) add({Kind::silence});  // it sends all to sleep
  return kinds;
}

/// True if all devices on the path of speech are simulated here.
bool PatrolWatch::talks_are_played() const {
  return std::ranges::all_of(std::array{radio_id, audio_switch_id, hands_free_id, power_supply_id,
                                        inputs_id, NodeId{cia447::gateway_node_id}},
                             [this](NodeId id) { return is_played(id); });
}

bool PatrolWatch::room_hears_crew() const {
  return crew_.speaks() && (!talks_are_played() || car_.radio().carries_from_car());
}

bool PatrolWatch::crew_hears_room() const {
  return crew_.room_speaks() && (!talks_are_played() || car_.radio().carries_to_car());
}

bool PatrolWatch::is_conversation_shown() const {
  return talks_are_played() ? car_.radio().led_is_lit() : crew_.activity() == Activity::conversing;
}

Wish PatrolWatch::look() const {
  Wish is = crew_.wish();
  const SignalDevices& signals = car_.signals();
  const Time now = car_.bus().world().now();
  const auto is_decided = [this](InvariantKind kind) {
    return std::ranges::find(undecided_, kind) == undecided_.end();
  };
  if (is_decided(InvariantKind::blue_light)) {
    is.is_blue = is.is_blue ? signals.all_blue_is_seen(now) : signals.any_blue_is_seen(now);
  }
  if (is_decided(InvariantKind::work_light)) {
    is.has_work_light =
        is.has_work_light ? signals.work_light_is_seen() : signals.any_work_light_is_seen();
  }
  if (is_decided(InvariantKind::siren)) is.has_siren = signals.siren_is_heard();
  if (is_decided(InvariantKind::locks)) is.is_locked = car_.is_locked();
  return is;
}

void PatrolWatch::frame_sent(Time now) {
  if (silence_.frame_sent(now, is_excused(InvariantKind::silence, now))) referee_.frame_asleep();
}

void PatrolWatch::step(Time now) {
  car::CarBus& bus = car_.bus();
  waits_for_real_ &= bus.waits_for_real();  // once all were present, no device is waited for again
  const bool sleeps = bus.any_sleeps();
  silence_.look(now);
  if (silence_.is_asleep() && !is_excused(InvariantKind::silence, now)) referee_.is_quiet();
  const bool is_free = sleeps || now < settled_at_;
  if (is_free || is_excused(InvariantKind::terminal_wait, now)) free_at_ = now;
  judge_wishes(now, is_free);
  judge_waits(now);
  for (const auto& node : bus.nodes()) {
    const NodeId id = node->place().id;
    const bool may_be_missing =
        excuses_.may_be_missing(id, now) || (waits_for_real_ && bus.may_come_yet(id));
    referee_.judge_device_unless(sleeps || may_be_missing, id, now, bus.is_at_work(*node));
  }
  if (crew_.calls().empty() || crew_.calls().back().reported) return;
  if (is_excused(InvariantKind::calls, now)) return;
  crew_.calls().back().age += Crew::step_time;
}

void PatrolWatch::judge_wishes(Time now, bool is_free) {
  const auto judge = [&](InvariantKind kind, bool is_right) {
    referee_.judge_unless(is_free || is_excused(kind, now), kind, now, is_right);
  };
  const Wish is = look();
  const Wish& wish = crew_.wish();
  judge(InvariantKind::blue_light, is.is_blue == wish.is_blue);
  judge(InvariantKind::siren, is.has_siren == wish.has_siren);
  const bool is_heard_alone =
      car_.signals().siren_is_heard() && !car_.signals().any_blue_is_seen(now);
  judge(InvariantKind::siren_alone, !is_heard_alone);
  judge(InvariantKind::work_light, is.has_work_light == wish.has_work_light);
  judge(InvariantKind::emergency, !crew_.waits_for_help());
  judge(InvariantKind::locks, is.is_locked == wish.is_locked);
  judge(InvariantKind::speech,
        crew_.speaks() == room_hears_crew() && crew_.room_speaks() == crew_hears_room());
  judge(InvariantKind::carrier, !car_.radio().is_on_the_air() || crew_.speaks());
  judge(InvariantKind::display, display_is_right());
  judge(InvariantKind::power, power_is_right(now));
}

void PatrolWatch::judge_waits(Time now) {
  for (const Operator* person : {&crew_.driver(), &crew_.partner()}) {
    const Time since = person->waits_since(now);
    longest_wait_ = std::max(longest_wait_, now - since);
    referee_.waits(now, std::max(since, free_at_));
  }
}

/// Compares the text that the crew reads with its commands, and with the lamps.
bool PatrolWatch::display_is_right() const {
  const std::string& text = car_.terminal().text_2();
  const auto says = [&text](std::string_view word) { return text.find(word) != text.npos; };
  return says("BLUE") == crew_.wish().is_blue && says("READY") != says("BLUE") &&
         says("SIREN") == crew_.wish().has_siren && says("LAMP") == car_.signals().has_burnt_lamp();
}

bool PatrolWatch::power_is_right(Time now) const {
  const bool has_radio = car_.supply().radio_has_power();
  const bool has_periphery = car_.supply().periphery_has_power();
  if (car_.is_ignited()) return has_radio && has_periphery;
  // The later one of both. While it lasts, a supply that boots may have lost it.
  const Time off_at = car_.ignition_off_at();
  const bool radio_is_over = now >= off_at + options_.supply.radio_after_run;
  const bool periphery_is_over = now >= off_at + options_.supply.periphery_after_run;
  return !(radio_is_over && has_radio) && !(periphery_is_over && has_periphery);
}

}  // namespace canvoy::police
