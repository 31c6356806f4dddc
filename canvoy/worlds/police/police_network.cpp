#include "canvoy/worlds/police/police_network.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "canvoy/worlds/car/sleep_plan.hpp"

namespace canvoy::police {

PoliceFaults::PoliceFaults(PoliceCar& car, const FaultPlan& plan, PoliceExcuses& excuses,
                           EventLog<PoliceEvent>& events)
    : car_(car),
      excuses_(excuses),
      events_(events),
      faults_(plan.faults, Engine::of(*this)),
      trouble_(car.bus().bus()),
      cuts_(PowerCuts::Switch::to<&PoliceFaults::power>(*this)) {}

void PoliceFaults::plan() {
  if (faults_.has_any(FaultKind::babbling_node)) trouble_.attach_babbler();
  faults_.plan(car_.bus().world());
}

void PoliceFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultBegan{fault, it.kind, {.bus = car_.bus().index(), .node = node_of(it)}});
  excuses_.begins(it, now());
}

void PoliceFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultEnded{fault, it.kind, {.bus = car_.bus().index(), .node = node_of(it)}});
  excuses_.ends(it, now());
}

void PoliceFaults::set(std::size_t number, bool is_present) {
  const ScheduledFault& fault = faults_[number];
  switch (fault.kind) {
    case FaultKind::lost_node:
      return cuts_.set_power(node_of(fault), !is_present);
    case FaultKind::restart:
      return is_present ? cuts_.restart(node_of(fault)) : void();
    case FaultKind::cable_cut:
      return trouble_.cut_cable(car_.bus().node(node_of(fault)).controller(), is_present);
    case FaultKind::babbling_node:
      return trouble_.babble(is_present);
    case FaultKind::corrupted_frames:
      return trouble_.disturb(is_present ? corrupted_share : 0);
    case FaultKind::burnt_lamp:
      return car_.signals().burn_lamp(is_present);
    case FaultKind::overload:
      return car_.supply().overload(is_present);
    case FaultKind::dead_client:
      return let_client_die(is_present);
  }
}

void PoliceFaults::let_client_die(bool shall_die) {
  client_shall_die_ = shall_die;
  if (!shall_die && dead_client_ != 0)
    cuts_.set_power(std::exchange(dead_client_, NodeId{0}), true);
}

void PoliceFaults::step() {
  const std::optional<Client> client = car_.terminal().client();
  if (!client_shall_die_ || !client) return;
  constexpr std::array<NodeId, client_count> nodes = {radio_id, roof_sound_id, navigation_id};
  client_shall_die_ = false;
  dead_client_ = nodes.at(static_cast<std::size_t>(*client));
  cuts_.set_power(dead_client_, false);
}

namespace {

CrewOptions crew_options(const PoliceOptions& options) {
  CrewOptions made;
  constexpr Duration evening = 1h;  // for the after-run, sleep and waking
  made.end = Time{} + std::max<Duration>(options.length - evening, options.length / 2);
  return made;
}

car::CarBus::Settings bus_settings(const PoliceOptions& options) {
  return {.bit_rate = options.bit_rate,
          .seed = options.faults.seed,
          .names = armoured_names,
          .serial_numbers = 2000,
          .real = options.real,
          .identities = options.identities,
          .time_out = cia447::CarNetworkSettings{}.time_out};
}

}  // namespace

PoliceNetwork::PoliceNetwork(PoliceOptions options)
    : options_(std::move(options)),
      bus_(world_, bus_settings(options_),
           [this](Time now, const BusEvent& heard) { events_.hear(now, heard); }),
      car_(bus_, options_, Acted::to<&PoliceReferee::acted>(referee_), events_),
      crew_(crew_options(options_), options_.faults.seed, car_.drive(), crew_hands(),
            terminal_hands()),
      faults_(car_, options_.faults, excuses_, events_),
      watch_(car_, options_, crew_, excuses_, referee_) {
  bus_.bus().observe({.context = this,
                      .on_frame =
                          [](void* self, Time, ControllerId, const Frame&) {
                            auto* network = static_cast<PoliceNetwork*>(self);
                            network->watch_.frame_sent(network->now());
                          },
                      .on_state = nullptr});
  bus_.listen();
  car_.radio().on_status(callback<&PoliceNetwork::status_heard>(*this));
  car_.on_event(callback<&PoliceNetwork::car_event>(*this));
  crew_.on_change([this](Time now, Activity, Activity to) { crew_changed(now, to); });
  if (options_.sabotage.sleepy_crew) crew_.fall_asleep();
  world_.add_plant(callback<&PoliceNetwork::step>(*this), Crew::step_time);
  faults_.plan();
  for (const auto& node : bus_.nodes()) car_.power(*node, true);
}

PoliceNetwork::~PoliceNetwork() = default;

// Hands of the crew.

CrewHands PoliceNetwork::crew_hands() {
  return {.press = [this](cia447::FunctionKey key) { press(key); },
          .press_handset = [this](bool is_pressed) { car_.radio().lift_handset(is_pressed); },
          .press_hands_free = [this] { car_.radio().press_hands_free(); },
          .sees_led = [this] { return watch_.is_conversation_shown(); },
          .turn_ignition = [this](bool is_on) { car_.turn_ignition(is_on); },
          .turn_key = [this](bool is_locked) { car_.turn_key(is_locked); },
          .press_emergency = [this] { press_emergency(); },
          .look = [this] { return watch_.look(); }};
}

TerminalHands PoliceNetwork::terminal_hands() {
  return {.open = [this](Client client) { open(client); },
          .press = [this](Client client, cia447::NumberPadKey key) { press(client, key); },
          .title = [this] { return car_.terminal().title(); },
          .text = [this] { return car_.terminal().text_1(); }};
}

void PoliceNetwork::open(Client client) {
  switch (client) {
    case Client::signals:
      return press(SignalControl::sound_key);
    case Client::radio:
      return car_.radio().press_button();
    case Client::navigation:
      return car_.navigation().press_button();
  }
}

void PoliceNetwork::press(Client client, cia447::NumberPadKey key) {
  if (!bus_.has_power(terminal_id)) return;
  referee_.pressed({.client = client, .key = static_cast<std::uint8_t>(key)},
                   watch_.may_come_late(now()));
  car_.terminal().press(key);
}

void PoliceNetwork::press(cia447::FunctionKey key) {
  if (!bus_.has_power(terminal_id)) return;
  referee_.pressed({Client::signals, true, static_cast<std::uint8_t>(key)},
                   watch_.may_come_late(now()));
  car_.terminal().press(key);
}

void PoliceNetwork::press_emergency() {
  if (bus_.has_power(terminal_id)) car_.terminal().press_emergency_key();
}

// Events.

void PoliceNetwork::step(Time now) {
  car_.drive().step(Crew::step_time);
  car_.signals().step(now);
  faults_.step();
  crew_.step(now, watch_.room_hears_crew(), watch_.crew_hears_room());
  watch_.step(now);
  report_changes(now);
  told_.report_broken(invariants(),
                      [&](const Invariant& broken) { events_.note(now, InvariantBroken{broken}); });
}

void PoliceNetwork::crew_changed(Time now, Activity to) {
  if (to == Activity::listening) {
    const EmergencyCall& call = crew_.calls().back();
    events_.note(now, CallMade{call.destination, call.metres});
    car_.navigation().know(call.destination);
  }
  if (to == Activity::responding) {
    car_.navigation().scene_lies_ahead(crew_.calls().back().metres);
  }
  events_.note(now, ActivityChanged{to});
  if (crew_.is_over()) sleep_and_wake(now);
}

/// After the after-run.
void PoliceNetwork::sleep_and_wake(Time parked) {
  const Duration after_run =
      std::max(options_.supply.radio_after_run, options_.supply.periphery_after_run);
  const Time sleep = parked + after_run + 1min;
  car::SleepPlan plan{.sleep = sleep, .wake = sleep + 4min};
  if (options_.sabotage.speaks_asleep) plan.stranger_speaks = sleep + 2min;
  car::plan_sleep(bus_, plan);
}

void PoliceNetwork::car_event(const cia447::CarEvent& event) {
  events_.note(now(), car::NetworkChanged{event});
  const bool awakes = event.kind == cia447::CarEvent::Kind::awake;
  if (awakes) watch_.all_boot(now() + car::return_bound);
}

void PoliceNetwork::report_changes(Time now) {
  const SignalDevices& signals = car_.signals();
  const SignalsChanged seen{signals.any_blue_is_seen(now), signals.siren_is_heard()};
  if (seen != told_signals_) events_.note(now, seen);
  told_signals_ = seen;
  const std::optional<Client> client = car_.terminal().client();
  if (client != told_client_) events_.note(now, TerminalTaken{client});
  told_client_ = client;
}

bool PoliceNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

PoliceStatistics PoliceNetwork::statistics() const {
  PoliceStatistics made{.calls = crew_.calls().size(),
                        .keys = car_.terminal().keys(),
                        .statuses = car_.radio().statuses(),
                        .longest_wait = watch_.longest_wait()};
  for (const EmergencyCall& call : crew_.calls()) {
    if (!call.reported || !call.arrived) continue;
    ++made.attended;
    made.response_time += *call.arrived - call.made;
  }
  return made;
}

PoliceSnapshot PoliceNetwork::snapshot() const {
  const SignalDevices& signals = car_.signals();
  PoliceSnapshot look{.at = now(),
                      .bus = bus_.snapshot(),
                      .nodes = bus_.node_snapshots(),
                      .names = bus_.names(),
                      .crew = crew_.activity(),
                      .wish = crew_.wish(),
                      .is_asleep = watch_.is_asleep(),
                      .statistics = statistics(),
                      .around = car_.around(),
                      .is_blue = signals.any_blue_is_seen(now()),
                      .has_work_light = signals.work_light_is_seen(),
                      .client = car_.terminal().client(),
                      .crew_speaks = crew_.speaks(),
                      .crew_is_heard = watch_.room_hears_crew(),
                      .room_speaks = crew_.room_speaks(),
                      .room_is_heard = watch_.crew_hears_room(),
                      .metres = car_.drive().metres(),
                      .speed = car_.drive().speed()};
  for (unsigned i = 0; i < beacon_count; ++i) look.beacons[i] = signals.beacons().is_lit(now(), i);
  for (unsigned i = 0; i < flasher_count; ++i) {
    look.flashers[i] = signals.flashers().is_lit(now(), i);
  }
  return look;
}

}  // namespace canvoy::police
