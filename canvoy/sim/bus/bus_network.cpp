#include "canvoy/sim/bus/bus_network.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/bus/line_texts.hpp"

namespace canvoy::bus {

namespace {

constexpr Duration step_time = 100ms;
constexpr Duration log_in_again = 1s;
constexpr Duration press_after = 2s;
constexpr unsigned presses_max = 3;
constexpr unsigned second_car_every = 3;
constexpr Duration announcement_bound = 2s;
constexpr std::array<NodeId, 6> display_ids = {front_display_id,      next_stop_id,
                                               information_id,        side_display_id,
                                               second_destination_id, second_next_stop_id};
constexpr std::uint32_t driver_number = 1234;
/// Disturbances in the cars are not the same.
constexpr std::uint64_t second_bus_seed = 0x407;

BusOptions vehicle_options(const BusNetworkOptions& options) {
  BusOptions made = options.vehicle;
  made.seed = options.faults.seed;
  if (made.riders.second_car_every == 0) made.riders.second_car_every = second_car_every;
  return made;
}

/// As the display has it: without blanks at its end.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

BusNetwork::BusNetwork(BusNetworkOptions options)
    : options_(std::move(options)),
      service_begin_(options_.clock.service_begin(options_.date)),
      bus_(world_.add_bus({.bit_rate = options_.bit_rate, .seed = options_.faults.seed})),
      second_bus_(world_.add_bus(
          {.bit_rate = options_.bit_rate, .seed = options_.faults.seed + second_bus_seed})),
      train_(world_),
      bus_watch_(bus_, [this](Time now, const canvoy::BusEvent& event) { heard(now, event); }),
      second_watch_(second_bus_,
                    [this](Time now, const canvoy::BusEvent& event) { heard(now, event); }) {
  vehicle_ = std::make_unique<BusVehicle>(options_.line, options_.block, vehicle_options(options_),
                                          rider_hands());
  vehicle_->on_event(
      [this](Time now, BusEvent event, std::size_t stop) { happened(now, event, stop); });
  for (const BusRoute& route : options_.line.routes) {
    whole_texts_.push_back(latin_1_as_utf_8(trimmed(to_latin_1(route_text(options_.line, route)))));
  }
  add_nodes();
  messages_.name(node(computer_id).controller(), node(identification_id).controller());
  world_.bus(bus_).observe(
      {.context = this,
       .on_frame = [](void* self, Time now, ControllerId sender, const Frame& frame) {
         static_cast<BusNetwork*>(self)->frame_sent(now, sender, frame);
       }});
  world_.bus(bus_).observe(bus_watch_.tap());
  const ControllerId gateway = node(second_gateway_id).controller();
  second_messages_.name(gateway, gateway);
  world_.bus(second_bus_)
      .observe({.context = this,
                .on_frame = [](void* self, Time now, ControllerId sender, const Frame& frame) {
                  static_cast<BusNetwork*>(self)->frame_sent_in_second_car(now, sender, frame);
                }});
  world_.bus(second_bus_).observe(second_watch_.tap());
  referee_.cannot_judge(unknown_to_referees());
  vehicle_plant_ =
      world_.add_sleeping_plant(Callback<void(Time)>::to<&BusNetwork::move_vehicle>(*this));
  world_.add_plant(Callback<void(Time)>::to<&BusNetwork::step>(*this), step_time);
  world_.wake(vehicle_plant_, vehicle_->deadline());
  plan_faults();
  for (const auto& node : nodes_) power(*node, true);
  counted_.journeys = 1;
  learn_truth(Time{});
  log_in();
}

BusNetwork::~BusNetwork() = default;

Time end_of(const BusNetworkOptions& options) {
  constexpr Duration after_block = 10min;
  if (options.length > Duration::zero()) return Time(options.length);
  const Block& block = options.line.blocks[options.block];
  const Duration last = block.journeys.back().passings.back().arrival;
  return Time(last - start_of(block, vehicle_options(options)) + after_block);
}

// The vehicle and its people.

void BusNetwork::move_vehicle(Time now) {
  vehicle_->advance(now);
  learn_truth(now);
  world_.wake(vehicle_plant_, vehicle_->deadline());
}

void BusNetwork::happened(Time now, BusEvent event, std::size_t stop) {
  const BusTruth truth = vehicle_->truth();
  const auto reached = [&](StopReached::How how) {
    const std::string& name = options_.line.stop(truth.journey->route, stop).name;
    note(now, StopReached{how, name, vehicle_->delay(), truth.aboard});
    counted_.worst_delay = std::max(counted_.worst_delay, vehicle_->delay());
  };
  switch (event) {
    case BusEvent::journey_begins:
      ++counted_.journeys;
      note(now, JourneyBegan{truth.journey->number, truth.route->destination});
      wants_log_in_ = true;
      clear_counts(now);
      if (can_log_in()) needs_fix_ = false;
      return learn_truth(now), log_in();
    case BusEvent::arrives:
      ++counted_.stops;
      pressed_.fill({});
      return reached(StopReached::How::arrives);
    case BusEvent::leaves:
      return reached(StopReached::How::leaves);
    case BusEvent::passes:
      ++counted_.stops;
      return reached(StopReached::How::passes);
    case BusEvent::door_changes:
      return node(vehicle_gateway_id).with([] {});
    case BusEvent::stop_requested:
      return;
    case BusEvent::block_ends:
      return note(now, BlockEnded{});
  }
}

void BusNetwork::learn_truth(Time now) {
  const BusTruth truth = vehicle_->truth();
  const TrueData data = {.stop_point = truth.stop->number,
                         .fare_zone = truth.fare.zone,
                         .route_segment = truth.fare.segment,
                         .line = static_cast<std::uint16_t>(options_.line.number),
                         .route = static_cast<std::uint16_t>(truth.route->number),
                         .block = truth.block->number,
                         .journey = static_cast<std::uint16_t>(truth.journey->number),
                         .destination = options_.line.stops[truth.route->stops.back().stop].number,
                         .driver = driver_number};
  if (data == truth_.current()) return;
  if (data.stop_point != truth_.current().stop_point) {
    to_announce_.fill(data.stop_point);
    announce_since_ = now;
  }
  truth_.learn(now, data);
  displays_are_new_ = true;
}

/// The driver types what he drives; he tries again where the device does not take it.
void BusNetwork::log_in() {
  wants_log_in_ = true;
  next_log_in_ = now() + log_in_again;
  const TrueData& data = truth_.current();
  node(identification_id).with([&] {
    remembered_ = {.driver_id = data.driver,
                   .destination_number = data.destination,
                   .line_id = data.line,
                   .route_number = data.route,
                   .block_id = data.block,
                   .journey_number = data.journey};
    identification_->log_in(remembered_);
    wants_log_in_ = false;
  });
}

/// At the end of a journey nobody is aboard, and the driver sets the counts to 0.
void BusNetwork::clear_counts(Time) {
  if (vehicle_->truth().aboard != 0) return;
  node(counting_manager_id).with([this] { counting_->clear(); });
  counts_are_lost_ = !is_at_work(counting_manager_id) || !is_at_work(first_counter_id) ||
                     !is_at_work(second_counter_id) || !is_at_work(vehicle_gateway_id) ||
                     !is_at_work(computer_id);
}

RiderHands BusNetwork::rider_hands() {
  RiderHands hands;
  hands.press_stop = [this](Time now, const Rider& rider) { return press_stop(now, rider.car); };
  hands.cancel_ticket = [this](Time, const Rider&) {
    bool is_done = false;
    if (options_.sabotage.jammed_canceller) return false;
    node(canceller_id).with([&] {
      is_done = canceller_->insert_ticket() == cia407::TicketAnswer::done;
    });
    return is_done || !is_played(canceller_id);
  };
  hands.buy_ticket = [this](Time, const Rider&) {
    bool is_done = false;
    node(printer_id).with([&] { is_done = printer_->sell_ticket() == cia407::TicketAnswer::done; });
    return is_done || !is_played(printer_id);
  };
  hands.through = [this](Time now, std::size_t door, bool is_in) { passed(now, door, is_in); };
  return hands;
}

/// Buttons of the first car are wired to the on-board computer, those of the second one to its
/// train bus gateway.
bool BusNetwork::press_stop(Time now, unsigned car) {
  Pressed& pressed = pressed_.at(car - 1);
  pressed.last = now;
  ++pressed.times;
  if (car == 2) return !options_.sabotage.dead_second_button && train_.press_stop_button();
  bool is_taken = false;
  node(computer_id).with([&] { is_taken = line_control_->press_stop_button(); });
  return is_taken;
}

bool BusNetwork::is_stop_wanted() const {
  return std::ranges::any_of(pressed_, [](const Pressed& pressed) { return pressed.times != 0; });
}

/// Who has pressed the button, and sees no sign, presses it again; in the second car he goes and
/// presses one of the first when that does not help.
void BusNetwork::press_again(Time now, unsigned car) {
  const Pressed& pressed = pressed_.at(car - 1);
  if (pressed.times == 0 || now < pressed.last + press_after) return;
  const bool goes_forward = car == 2 && pressed.times >= presses_max;
  if (goes_forward && pressed_.front().times != 0) return;
  press_stop(now, goes_forward ? 1 : car);
}

bool BusNetwork::is_sign_lit(unsigned car) const {
  if (car == 2) return displays_.at(second_next_stop_id)->is_sign_lit();
  return displays_.at(next_stop_id)->is_sign_lit() ||
         displays_.at(information_id)->display().is_stop_requested();
}

/// By who has pressed the button. A real display shows what it was told.
bool BusNetwork::is_sign_seen(unsigned car) const {
  if (car == 2 && is_played(second_next_stop_id)) return is_sign_lit(car);
  return is_sign_lit(1) || has_unseen_sign();
}

/// The driver sees the signs that passengers of the first car see.
void BusNetwork::look_at_signs(Time now) {
  if (is_sign_seen(1) && vehicle_->state() == BusState::driving) vehicle_->request_stop(now);
  for (unsigned car = 1; car <= pressed_.size(); ++car) {
    if (!is_sign_seen(car)) press_again(now, car);
    const bool is_lit = is_sign_lit(car);
    if (std::exchange(told_signs_.at(car - 1), is_lit) != is_lit) {
      note(now, StopSignLit{is_lit, car});
    }
  }
}

// Judged.

void BusNetwork::step(Time now) {
  lead_vehicle(now);
  train_.step(now);
  if (wants_log_in_ && now >= next_log_in_) log_in();
  look_at_signs(now);
  judge(now);
  check(now);
}

void BusNetwork::judge(Time now) {
  judge_displays(now);
  judge_people(now);
  judge_passengers(now);
  judge_blindness(now);
  referee_.judge(InvariantKind::clock, now, false);
  judge_signs(now);
  for (unsigned car = 1; car <= to_announce_.size(); ++car) {
    std::optional<std::uint32_t>& expected = to_announce_.at(car - 1);
    if (!expected || now - announce_since_ <= announcement_bound) continue;
    expected.reset();
    referee_.count(announcements_in(car), now);
  }
  for (const auto& node : nodes_) {
    const NodeId id = node->place().id;
    // One that has no power by plan is missing, and so are all whose bus is broken.
    const bool is_excused =
        without_power_.at(id) != 0 || referee_.is_excused(InvariantKind::device_missing, now);
    referee_.judge_device(id, now, is_at_work(id) || is_excused || is_awaited(id, now));
  }
}

/// Who has pressed a button reads in his car that the bus will stop, and so do those of the other
/// car. In the first one two displays have a sign: that of the next stop has to be lit for its own
/// people, one of both for those of the second car. Where nobody has pressed, none is lit on the
/// way.
void BusNetwork::judge_signs(Time now) {
  const bool is_first_lit = displays_.at(next_stop_id)->is_sign_lit();
  referee_.judge(InvariantKind::stop_sign, now, pressed_[0].times == 0 || is_first_lit);
  const bool is_told_forward = pressed_[1].times == 0 || is_sign_lit(1);
  referee_.judge(InvariantKind::second_stop_sign, now,
                 !is_stop_wanted() || (is_sign_lit(2) && is_told_forward));
  const bool is_on_the_way = vehicle_->state() != BusState::at_stop;
  const bool is_false = is_on_the_way && !is_stop_wanted() && (is_sign_lit(1) || is_sign_lit(2));
  referee_.judge(InvariantKind::false_stop_sign, now, !is_false);
}

/// An on-board computer that begins anew learns where it is from satellites, or when a journey
/// begins.
void BusNetwork::judge_blindness(Time now) {
  if (!needs_fix_) return;
  for (const auto kind :
       {InvariantKind::next_stop, InvariantKind::announcements, InvariantKind::service,
        InvariantKind::second_car, InvariantKind::second_announcements}) {
    referee_.excuse(kind, now + BusReferee::return_bound);
  }
  const bool has_satellites = !is_present(FaultKind::no_satellites) && is_at_work(positioning_id);
  if (has_satellites && can_log_in()) needs_fix_ = false;
}

/// Identification is heard by the on-board computer.
bool BusNetwork::can_log_in() {
  return is_at_work(computer_id) && is_at_work(identification_id) &&
         !is_present(FaultKind::cable_cut) && !is_present(FaultKind::babbling_node);
}

void BusNetwork::judge_displays(Time now) {
  if (std::exchange(displays_are_new_, false)) {
    has_lie_ = false;
    for (const NodeId id : display_ids) {
      const std::string& text = displays_.at(id)->text();
      if (!is_led_by_us(id)) continue;
      const bool is_mangled = id == information_id && !is_whole_text(text);
      has_lie_ = has_lie_ || (!text.empty() && !is_mangled && text != expected_text(id));
    }
  }
  const auto is_lit = [this](NodeId id) {
    return !is_played(id) || !displays_.at(id)->text().empty();
  };
  referee_.judge(InvariantKind::next_stop, now, is_lit(next_stop_id));
  referee_.judge(InvariantKind::destination, now,
                 is_lit(front_display_id) && is_lit(side_display_id));
  referee_.judge(InvariantKind::information, now, is_lit(information_id));
  referee_.judge(InvariantKind::second_car, now,
                 is_lit(second_destination_id) && is_lit(second_next_stop_id));
  referee_.judge_honesty(now, !has_lie_);
}

std::string BusNetwork::expected_text(NodeId display) const {
  const BusTruth truth = vehicle_->truth();
  if (display == next_stop_id || display == second_next_stop_id)
    return latin_1_as_utf_8(trimmed(to_latin_1(truth.stop->name)));
  if (display == information_id) {
    return whole_texts_[static_cast<std::size_t>(truth.route - options_.line.routes.data())];
  }
  return trimmed(to_ascii(options_.line.name)) + "\n" + trimmed(to_ascii(truth.route->destination));
}

bool BusNetwork::is_whole_text(const std::string& text) const {
  return text.empty() || std::ranges::find(whole_texts_, text) != whole_texts_.end();
}

void BusNetwork::displays_changed() {
  displays_are_new_ = true;
  for (const NodeId id : display_ids) {
    if (!displays_.at(id)) continue;
    const std::string& text = displays_.at(id)->text();
    if (text == told_texts_.at(id)) continue;
    told_texts_.at(id) = text;
    note(now(), DisplayShows{id, text});
    if (!text.empty()) ++counted_.texts;
    if (id == information_id && !is_whole_text(text)) referee_.count(InvariantKind::texts, now());
  }
}

/// Carried past their stop, or without a ticket that they wanted.
void BusNetwork::judge_people(Time now) {
  const RiderStatistics& riders = vehicle_->riders().statistics();
  const std::uint64_t all = riders.carried_past + riders.without_ticket;
  for (; badly_served_ < all; ++badly_served_) referee_.count(InvariantKind::service, now);
}

bool BusNetwork::all_doors_closed() const {
  for (std::size_t i = 0; i < vehicle_->door_count(); ++i) {
    if (!vehicle_->door(i).is_closed()) return false;
  }
  return true;
}

void BusNetwork::judge_passengers(Time now) {
  if (counts_are_lost_) referee_.excuse(InvariantKind::passengers, now + 1s);
  const bool can_tell = all_doors_closed() && vehicle_->state() == BusState::driving;
  const std::uint32_t counted =
      node(computer_id).node().dictionary().word(cia407::counter_passenger_sum_object.index, 0);
  referee_.judge(InvariantKind::passengers, now,
                 !can_tell || counted == vehicle_->riders().aboard());
}

void BusNetwork::count_ticket(const cia407::TicketData& ticket, bool is_printed) {
  note(now(), TicketIssued{is_printed, ticket.fare_zone, ticket.route_segment_number});
  const bool is_right = truth_.is_true(now(), [&](const TrueData& data) {
    return ticket.fare_zone == data.fare_zone &&
           ticket.route_segment_number == data.route_segment && ticket.line_id == data.line &&
           ticket.block_id == data.block &&
           (!is_printed || ticket.stop_point_id == data.stop_point);
  });
  if (!is_right) referee_.count(InvariantKind::tickets, now());
}

void BusNetwork::frame_sent(Time now, ControllerId sender, const Frame& frame) {
  const std::optional<bool> is_right = messages_.is_right(now, sender, frame, truth_);
  if (is_right && !*is_right) referee_.count(InvariantKind::pdo_tables, now);
  if (frame.id != MessageReferee::time_id || !is_right) return;
  referee_.judge(InvariantKind::clock, now,
                 *is_right && MessageReferee::is_time(frame, true_time()));
}

void BusNetwork::frame_sent_in_second_car(Time now, ControllerId sender, const Frame& frame) {
  const std::optional<bool> is_right = second_messages_.is_right(now, sender, frame, truth_);
  if (is_right && !*is_right) referee_.count(InvariantKind::pdo_tables, now);
}

EpochSeconds BusNetwork::true_utc() const {
  const Duration of_day = vehicle_->time_of_day(world_.now());
  return service_begin_ + std::chrono::floor<std::chrono::seconds>(of_day).count();
}

cia407::CivilTime BusNetwork::true_time() const {
  return cia447::civil_time(options_.clock.local(true_utc()));
}

void BusNetwork::heard(Time now, const canvoy::BusEvent& event) {
  std::visit([&](const auto& seen) { note(now, seen); }, event);
}

bool BusNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

/// Tells of each invariant once that it is broken, when it is.
void BusNetwork::check(Time now) {
  if (!referee_.has_news()) return;
  for (const Invariant& invariant : invariants()) {
    bool& told = told_.at(static_cast<std::size_t>(invariant.kind));
    if (invariant.held || std::exchange(told, true)) continue;
    note(now, InvariantBroken{invariant});
  }
}

BusSnapshot BusNetwork::bus_snapshot(BusIndex index, NodeId id) {
  const SimulatedBus& bus = world_.bus(index);
  return {bus.load(node(id).controller()), bus.statistics().frames, bus.statistics().error_frames};
}

BusNetworkSnapshot BusNetwork::snapshot() {
  BusNetworkSnapshot look;
  look.at = now();
  look.buses = {bus_snapshot(bus_, computer_id), bus_snapshot(second_bus_, second_gateway_id)};
  for (const auto& node : nodes_) {
    look.nodes.push_back(
        snapshot_of(world_, *node, watch_of(node->place().id), LineControl::node_time_out));
    look.names.push_back(node->place().name);
  }
  for (const NodeId id : display_ids) {
    look.displays.push_back({id, displays_.at(id)->text(), displays_.at(id)->is_sign_lit()});
  }
  look.local_time = true_time();
  look.utc = true_utc();
  look.truth = vehicle_->truth();
  look.state = vehicle_->state();
  look.position = vehicle_->position();
  look.heading = vehicle_->heading();
  look.speed = vehicle_->speed();
  look.odometer = vehicle_->odometer();
  look.metres_on_route = vehicle_->metres_on_route();
  look.delay = vehicle_->delay();
  for (std::size_t i = 0; i < vehicle_->door_count(); ++i) {
    look.doors.push_back(vehicle_->door(i).state());
  }
  look.counted =
      node(computer_id).node().dictionary().word(cia407::counter_passenger_sum_object.index, 0);
  look.riders = vehicle_->riders().statistics();
  look.statistics = counted_;
  return look;
}

}  // namespace canvoy::bus
