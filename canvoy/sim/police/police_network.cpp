#include "canvoy/sim/police/police_network.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::police {

namespace {

CrewOptions crew_options(const PoliceOptions& options) {
  CrewOptions made;
  constexpr Duration evening = 1h;  // for the after-run, sleep and waking
  made.end = Time{} + std::max<Duration>(options.length - evening, options.length / 2);
  return made;
}

}  // namespace

PoliceNetwork::PoliceNetwork(PoliceOptions options)
    : options_(std::move(options)),
      bus_(world_.add_bus({.bit_rate = options_.bit_rate, .seed = options_.faults.seed})),
      crew_(crew_options(options_), options_.faults.seed, drive_, crew_hands(), terminal_hands()),
      bus_watch_(bus_, [this](Time now, const BusEvent& event) { heard(now, event); }) {
  add_nodes();
  world_.bus(bus_).observe(
      {.context = this,
       .on_frame = [](void* self, Time, ControllerId,
                      const Frame&) { static_cast<PoliceNetwork*>(self)->frame_sent(); },
       .on_state = nullptr});
  world_.bus(bus_).observe(bus_watch_.tap());
  crew_.on_change([this](Time now, Activity, Activity to) {
    if (to == Activity::listening) {
      const EmergencyCall& call = crew_.calls().back();
      note(now, CallMade{call.destination, call.metres});
    }
    if (to == Activity::responding) scene_at_ = drive_.metres() + crew_.calls().back().metres;
    note(now, ActivityChanged{to});
    if (crew_.is_over()) sleep_and_wake(now);
  });
  if (options_.sabotage.sleepy_crew) crew_.fall_asleep();
  undecided_ = undecided_kinds();
  for (const InvariantKind kind : undecided_) referee_.cannot_judge(kind);
  world_.add_plant(Callback<void(Time)>::to<&PoliceNetwork::step>(*this), Crew::step_time);
  plan_faults();
  for (const auto& node : nodes_) power(*node, true);
}

PoliceNetwork::~PoliceNetwork() = default;

bool PoliceNetwork::is_played(NodeId id) const {
  return std::ranges::find(options_.real, id) == options_.real.end();
}

/// What a real device does is not seen here, and its keys are out of the crew's reach.
std::vector<InvariantKind> PoliceNetwork::undecided_kinds() const {
  using Kind = InvariantKind;
  std::vector<Kind> kinds;
  const auto add = [&kinds](std::initializer_list<Kind> more) { kinds.insert(kinds.end(), more); };
  const bool has_keys = is_played(terminal_id) && is_played(roof_sound_id);
  if (!is_played(terminal_id)) add({Kind::keypad, Kind::terminal_wait});
  if (!is_played(radio_id) || !is_played(navigation_id)) add({Kind::terminal_wait});
  if (!has_keys) add({Kind::terminal_wait, Kind::blue_light, Kind::siren, Kind::display});
  if (!has_keys || !is_played(cia447::gateway_node_id)) add({Kind::locks});
  if (!is_played(roof_light_id) || !is_played(blue_light_id)) {
    add({Kind::blue_light, Kind::display});
  }
  if (!talks_are_played()) add({Kind::speech, Kind::carrier});
  if (!is_played(power_supply_id) || !is_played(cia447::gateway_node_id)) add({Kind::power});
  if (!is_played(cia447::gateway_node_id)) add({Kind::silence});  // who has all sleep
  return kinds;
}

/// All that a word goes through on its way.
bool PoliceNetwork::talks_are_played() const {
  return std::ranges::all_of(std::array{radio_id, audio_switch_id, hands_free_id, power_supply_id,
                                        inputs_id, NodeId{cia447::gateway_node_id}},
                             [this](NodeId id) { return is_played(id); });
}

void PoliceNetwork::step(Time now) {
  drive_.step(Crew::step_time);
  around_.step(now);
  look_for_client();
  crew_.step(now, room_hears_crew(), crew_hears_room());
  judge(now);
  tell_changes(now);
  check(now);
}

// What is heard and seen.

/// From the handset's microphone, or from that of the hands-free system, through the audio switch
/// into the radio, and on the air.
bool PoliceNetwork::room_hears_crew() const {
  if (!talks_are_played()) return crew_.speaks();
  const bool is_connected = around_.wires[hands_free_id][radio_id] ||
                            (around_.handset_is_pressed && around_.wires[inputs_id][radio_id]);
  return crew_.speaks() && around_.is_on_the_air() && is_connected;
}

bool PoliceNetwork::crew_hears_room() const {
  if (!talks_are_played()) return crew_.room_speaks();
  return crew_.room_speaks() && around_.radio_has_power && around_.radio_is_on &&
         !around_.radio_transmits && around_.wires[radio_id][hands_free_id];
}

/// How it is; where a real device has it in its hands, as it is wished.
Wish PoliceNetwork::look() const {
  Wish is = crew_.wish();
  const auto is_decided = [this](InvariantKind kind) {
    return std::ranges::find(undecided_, kind) == undecided_.end();
  };
  if (is_decided(InvariantKind::blue_light)) {
    is.is_blue = is.is_blue ? around_.all_blue_is_seen(now()) : around_.any_blue_is_seen(now());
  }
  if (is_decided(InvariantKind::siren)) is.has_siren = around_.siren_is_heard();
  if (is_decided(InvariantKind::locks)) is.is_locked = around_.is_locked;
  return is;
}

// Judged.

bool PoliceNetwork::is_excused(Time now) const {
  return faults_present_ != 0 || now < excused_until_ || waits_for_real_;
}

bool PoliceNetwork::is_asleep() const {
  return std::ranges::all_of(nodes_, [](const std::unique_ptr<car::CarNode>& node) {
    return !node->is_powered() || node->device().sleep().state() == cia447::SleepState::asleep;
  });
}

bool PoliceNetwork::anybody_sleeps() const {
  return std::ranges::any_of(nodes_, [](const std::unique_ptr<car::CarNode>& node) {
    return node->is_powered() && node->device().sleep().state() != cia447::SleepState::awake;
  });
}

/// As far as can be known of one that is not played.
bool PoliceNetwork::is_at_work(car::CarNode& node) {
  return canvoy::is_at_work(world_, node, bus_watch_, cia447::CarNetworkSettings{}.time_out);
}

void PoliceNetwork::judge(Time now) {
  const auto does_work = [this](car::CarNode& node) { return is_at_work(node); };
  waits_for_real_ = waits_for_real_ && car::waits_for_real(nodes_, now, does_work);
  const bool sleeps = anybody_sleeps();
  const bool was_asleep = std::exchange(is_asleep_, sleeps && is_asleep());
  if (is_asleep_ && !was_asleep) asleep_at_ = now;
  const bool is_free = sleeps || is_excused(now) || now < settled_at_;
  if (is_free) free_at_ = now;
  const auto judge_one = [&](InvariantKind kind, bool is_right) {
    referee_.judge(kind, now, is_free || is_right);
  };
  const Wish is = look();
  const Wish& wish = crew_.wish();
  judge_one(InvariantKind::blue_light, is.is_blue == wish.is_blue);
  judge_one(InvariantKind::siren, is.has_siren == wish.has_siren);
  judge_one(InvariantKind::locks, is.is_locked == wish.is_locked);
  judge_one(InvariantKind::speech,
            crew_.speaks() == room_hears_crew() && crew_.room_speaks() == crew_hears_room());
  judge_one(InvariantKind::carrier, !around_.is_on_the_air() || crew_.speaks());
  judge_one(InvariantKind::display, display_is_right());
  judge_one(InvariantKind::power, power_is_right(now));
  for (const Operator* person : {&crew_.driver(), &crew_.partner()}) {
    const Time since = person->waits_since(now);
    counted_.longest_wait = std::max(counted_.longest_wait, now - since);
    referee_.waits(now, std::max(since, free_at_));
  }
  for (const auto& node : nodes_) {
    const bool is_there = sleeps || is_excused(now) || is_at_work(*node);
    referee_.judge_device(node->place().id, now, is_there);
  }
  if (crew_.calls().empty() || crew_.calls().back().reported || is_excused(now)) return;
  crew_.calls().back().age += Crew::step_time;
}

/// What the crew reads there against what it has ordered, and against the lamps.
bool PoliceNetwork::display_is_right() const {
  const std::string& text = around_.text_2;
  const auto says = [&text](std::string_view word) { return text.find(word) != text.npos; };
  return says("BLUE") == crew_.wish().is_blue && says("READY") != says("BLUE") &&
         says("SIREN") == crew_.wish().has_siren &&
         says("LAMP") == is_present(FaultKind::burnt_lamp);
}

bool PoliceNetwork::power_is_right(Time now) const {
  const bool has_radio = around_.radio_has_power;
  const bool has_periphery = around_.periphery_has_power;
  if (crew_.is_ignited()) return has_radio && has_periphery;
  // Which of both is over. While it lasts a supply that boots may have forgotten it.
  const bool radio_is_over = now >= ignition_off_at_ + options_.supply.radio_after_run;
  const bool periphery_is_over = now >= ignition_off_at_ + options_.supply.periphery_after_run;
  return !(radio_is_over && has_radio) && !(periphery_is_over && has_periphery);
}

void PoliceNetwork::tell_changes(Time now) {
  const SignalsChanged signals{around_.any_blue_is_seen(now), around_.siren_is_heard()};
  if (signals != told_signals_) note(now, signals);
  told_signals_ = signals;
  const std::optional<Client> client = shown_client();
  if (client != told_client_) note(now, TerminalTaken{client});
  told_client_ = client;
}

/// Whose title is read on display 1.
std::optional<Client> PoliceNetwork::shown_client() const {
  for (unsigned i = 0; i < client_count; ++i) {
    if (around_.title == title_of(Client(i))) return Client(i);
  }
  return std::nullopt;
}

void PoliceNetwork::car_event(const cia447::CarEvent& event) {
  note(now(), car::NetworkChanged{event});
  // All boot.
  if (event.kind == cia447::CarEvent::Kind::awake) settled_at_ = now() + return_bound;
}

void PoliceNetwork::heard(Time now, const BusEvent& event) {
  std::visit([&](const auto& seen) { note(now, seen); }, event);
}

/// A frame that was under way when the last one fell asleep is not one of those; nor is that by
/// which the first one wakes the others up.
void PoliceNetwork::frame_sent() {
  constexpr Duration under_way = 5ms;
  if (!is_asleep_ || !is_asleep() || now() < asleep_at_ + under_way || is_excused(now())) return;
  referee_.frame_asleep();
}

/// When the after-run is over: then somebody opens a door, and the network wakes up.
void PoliceNetwork::sleep_and_wake(Time parked) {
  const Duration after_run =
      std::max(options_.supply.radio_after_run, options_.supply.periphery_after_run);
  const Time sleep = parked + after_run + 1min;
  const auto master = [this]() -> cia447::CarMaster* {
    const bool is_there = is_played(cia447::gateway_node_id);
    return is_there ? nodes_.front()->device().master() : nullptr;
  };
  world_.at(sleep, [this, master](Time) {
    if (master() != nullptr) master()->send_to_sleep();
    touched(cia447::gateway_node_id);
  });
  if (options_.sabotage.speaks_asleep) {
    const ControllerId stranger = world_.bus(bus_).attach({});
    world_.at(sleep + 2min, [this, stranger](Time) {
      world_.bus(bus_).send(stranger, {.id = 0x7DF, .length = 8});
    });
  }
  world_.at(sleep + 4min, [this, master](Time) {
    if (master() != nullptr) master()->wake_up();
    touched(cia447::gateway_node_id);
  });
}

std::vector<Invariant> PoliceNetwork::invariants() const {
  return referee_.verdicts(crew_.calls());
}

bool PoliceNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

/// Tells of each invariant once that it is broken, when it is.
void PoliceNetwork::check(Time now) {
  for (const Invariant& invariant : invariants()) {
    bool& told = told_.at(static_cast<std::size_t>(invariant.kind));
    if (invariant.held || std::exchange(told, true)) continue;
    note(now, InvariantBroken{invariant});
  }
}

PoliceSnapshot PoliceNetwork::snapshot() {
  const SimulatedBus& bus = world_.bus(bus_);
  PoliceSnapshot look{.at = now(),
                      .bus = {bus.load(nodes_.front()->controller()), bus.statistics().frames,
                              bus.statistics().error_frames},
                      .nodes = {},
                      .names = {},
                      .crew = crew_.activity(),
                      .wish = crew_.wish(),
                      .is_asleep = is_asleep_,
                      .statistics = counted_,
                      .around = around_,
                      .is_blue = around_.any_blue_is_seen(now()),
                      .client = shown_client(),
                      .crew_speaks = crew_.speaks(),
                      .crew_is_heard = room_hears_crew(),
                      .room_speaks = crew_.room_speaks(),
                      .room_is_heard = crew_hears_room(),
                      .metres = drive_.metres(),
                      .speed = drive_.speed()};
  for (unsigned i = 0; i < beacon_count; ++i) look.beacons[i] = around_.beacons.is_lit(now(), i);
  for (unsigned i = 0; i < flasher_count; ++i) {
    look.flashers[i] = around_.flashers.is_lit(now(), i);
  }
  look.statistics.calls = crew_.calls().size();
  for (const EmergencyCall& call : crew_.calls()) {
    if (!call.reported || !call.arrived) continue;
    ++look.statistics.attended;
    look.statistics.response_time += *call.arrived - call.made;
  }
  for (const auto& node : nodes_) {
    look.nodes.push_back(
        snapshot_of(world_, *node, bus_watch_, cia447::CarNetworkSettings{}.time_out));
    look.names.push_back(node->place().name);
  }
  return look;
}

}  // namespace canvoy::police
