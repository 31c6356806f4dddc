#include "canvoy/worlds/bus_line/bus_network.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/worlds/bus_line/pdo_links.hpp"

namespace canvoy::bus_line {

namespace {

constexpr Duration step_time = 100ms;
constexpr Duration log_in_again = 1s;
constexpr std::uint32_t first_driver = 1234;

}  // namespace

BusNetwork::BusNetwork(BusNetworkOptions options)
    : options_(std::move(options)),
      nodes_(world_, options_, events_),
      vehicle_(options_.line, options_.block, vehicle_options(options_), rider_hands()),
      clock_(options_, world_, vehicle_),
      computer_(nodes_, options_, vehicle_, clock_),
      displays_(nodes_, options_.sabotage,
                Callback<void()>::to<&DisplayWatch::displays_changed>(display_watch_)),
      tickets_(nodes_, options_.sabotage,
               TicketDevices::Issued::to<&ServiceWatch::ticket_issued>(service_)),
      announcements_(nodes_, options_, truth_, referee_, events_),
      sensors_(nodes_, options_.sabotage, vehicle_, clock_),
      following_(nodes_, options_.sabotage),
      stop_requests_(nodes_, {displays_, computer_, following_, vehicle_, referee_}, events_),
      faults_(
          nodes_, options_.faults,
          {displays_, computer_, sensors_, tickets_, following_, vehicle_, referee_},
          {.began = Callback<void(const InvariantSet&)>::to<&ServiceWatch::fault_begins>(service_),
           .vehicle_touched = Callback<void()>::to<&BusNetwork::wake_vehicle>(*this)},
          events_),
      display_watch_(nodes_, options_.line, displays_, vehicle_, referee_, events_),
      service_(nodes_,
               {faults_, vehicle_, computer_, sensors_, truth_, referee_, capacity_of(options_)},
               events_),
      heard_(options_.line, options_.design) {
  vehicle_.on_event(
      [this](Time now, BusEvent event, std::size_t stop) { happened(now, event, stop); });
  add_nodes();
  hear_messages();
  referee_.cannot_judge(unknown_without(options_.real));
  vehicle_plant_ = world_.add_sleeping_plant(callback<&BusNetwork::move_vehicle>(*this));
  world_.add_plant(callback<&BusNetwork::step>(*this), step_time);
  wake_vehicle();
  faults_.plan();
  if (options_.sabotage.false_messages) send_false_message();
  for (const auto& node : nodes_.all()) node->power(true);
  counted_.journeys = 1;
  learn_truth(Time{});
  log_in();
}

BusNetwork::~BusNetwork() = default;

void BusNetwork::add_nodes() {
  computer_.add_nodes();
  displays_.add_first_car();
  tickets_.add_nodes();
  announcements_.add_car(1);
  sensors_.add_nodes();
  following_.add_nodes();
  for (unsigned car = 2; car <= nodes_.cars(); ++car) {
    displays_.add_following_car(car);
    announcements_.add_car(car);
  }
  nodes_.complete();
  configure(nodes_);
}

void BusNetwork::hear_messages() {
  messages_.name(nodes_.node(computer_id).controller(),
                 nodes_.node(identification_id).controller());
  nodes_.cable(1).observe(
      {.context = this,
       .on_frame = [](void* self, Time now, ControllerId sender, const Frame& frame) {
         static_cast<BusNetwork*>(self)->frame_sent(now, sender, frame);
       }});
  nodes_.listen(1);
  for (unsigned car = 2; car <= nodes_.cars(); ++car) {
    FollowingMessages& messages = following_messages_.emplace_back(*this);
    const ControllerId gateway = nodes_.node(gateway_of(car)).controller();
    messages.referee.name(gateway, gateway);
    nodes_.cable(car).observe(
        {.context = &messages,
         .on_frame = [](void* self, Time now, ControllerId sender, const Frame& frame) {
           static_cast<FollowingMessages*>(self)->frame_sent(now, sender, frame);
         }});
    nodes_.listen(car);
  }
}

/// Sends the driver's message as a foreign device.
void BusNetwork::send_false_message() {
  const ControllerId stranger = nodes_.cable(1).attach({});
  world_.at(Time(5min), [this, stranger](Time) {
    nodes_.cable(1).send(stranger, Frame::data_frame(0x201, {1, 2, 3, 4}));
  });
}

// The vehicle and its people.

RiderHands BusNetwork::rider_hands() {
  RiderHands hands;
  hands.press_stop = [this](Time now, const Rider& rider) {
    return stop_requests_.press(now, rider.car);
  };
  hands.cancel_ticket = [this](Time, const Rider&) { return tickets_.cancel(); };
  hands.buy_ticket = [this](Time, const Rider&) { return tickets_.buy(); };
  hands.through = [this](Time, std::size_t door, bool is_in) { sensors_.passed(door, is_in); };
  return hands;
}

void BusNetwork::move_vehicle(Time now) {
  vehicle_.advance(now);
  learn_truth(now);
  wake_vehicle();
}

/// Where the vehicle gateway is real and reports a speed, the vehicle follows it, as the on-board
/// computer receives it.
void BusNetwork::lead_vehicle(Time now) {
  if (nodes_.is_played(vehicle_gateway_id) || !nodes_.is_played(computer_id)) return;
  vehicle_.follow(now, computer_.heard_motion());
  wake_vehicle();
}

void BusNetwork::happened(Time now, BusEvent event, std::size_t stop) {
  switch (event) {
    case BusEvent::journey_begins:
      return begin_journey(now);
    case BusEvent::arrives:
      ++counted_.stops;
      stop_requests_.has_stopped();
      return reach_stop(now, StopReached::How::arrives, stop);
    case BusEvent::leaves:
      leave_stop(now, stop);
      return reach_stop(now, StopReached::How::leaves, stop);
    case BusEvent::passes:
      ++counted_.stops;
      leave_stop(now, stop);
      return reach_stop(now, StopReached::How::passes, stop);
    case BusEvent::door_changes:
      return sensors_.door_changed();
    case BusEvent::stop_requested:
      return;
    case BusEvent::block_ends:
      return events_.note(now, BlockEnded{});
  }
}

void BusNetwork::begin_journey(Time now) {
  const BusTruth truth = vehicle_.truth();
  ++counted_.journeys;
  events_.note(now, JourneyBegan{truth.journey->number, truth.route->destination_at(0)});
  service_.journey_begins();
  learn_truth(now);
  log_in();
}

void BusNetwork::leave_stop(Time now, std::size_t stop) {
  const Journey& journey = *vehicle_.truth().journey;
  const Passing& passing = journey.passings[stop];
  service_.stop_left(passing, vehicle_.time_of_day(now) - passing.departure);
  const FindAhead& find_ahead = options_.vehicle.riders.ahead;
  const auto ahead = find_ahead ? find_ahead(journey.number, stop) : std::nullopt;
  if (!ahead || !ahead->left || stop + 1 == journey.passings.size()) return;
  counted_.headways.add(ahead->headway, vehicle_.time_of_day(now) - *ahead->left);
}

void BusNetwork::reach_stop(Time now, StopReached::How how, std::size_t stop) {
  const BusTruth truth = vehicle_.truth();
  const std::string& name = options_.line.stop(truth.journey->route, stop).name;
  events_.note(now, StopReached{how, name, vehicle_.delay(), truth.aboard});
  display_watch_.truth_changed();
  counted_.worst_delay = std::max(counted_.worst_delay, vehicle_.delay());
}

void BusNetwork::learn_truth(Time now) {
  const BusTruth truth = vehicle_.truth();
  const TrueData data = {
      .stop_point = truth.stop->number,
      .fare_zone = truth.fare.zone,
      .route_segment = truth.fare.segment,
      .line = static_cast<std::uint16_t>(options_.line.names_of(*truth.route).number),
      .route = static_cast<std::uint16_t>(truth.route->number),
      .block = truth.block->number,
      .journey = static_cast<std::uint16_t>(truth.journey->number),
      .destination = options_.line.stops[truth.route->stops.back().stop].number,
      .driver = driver()};
  if (data == truth_.current()) return;
  const bool is_other_stop = data.stop_point != truth_.current().stop_point;
  if (is_other_stop) announcements_.stop_comes(now, data.stop_point);
  truth_.learn(now, data);
  display_watch_.truth_changed();
}

/// Number of the driver of this journey.
std::uint32_t BusNetwork::driver() const {
  const BusTruth truth = vehicle_.truth();
  std::uint32_t number = first_driver;
  for (const Journey& journey : truth.block->journeys) {
    const auto change = std::ranges::find(options_.drivers, journey.number, &DriverChange::journey);
    if (change != options_.drivers.end()) number = change->driver;
    if (&journey == truth.journey) break;
  }
  return number;
}

/// The driver enters the assignment, and tries again where the device does not accept it.
void BusNetwork::log_in() {
  next_log_in_ = now() + log_in_again;
  const TrueData& data = truth_.current();
  wants_log_in_ = !computer_.log_in({.driver_id = data.driver,
                                     .destination_number = data.destination,
                                     .line_id = data.line,
                                     .route_number = data.route,
                                     .block_id = data.block,
                                     .journey_number = data.journey});
}

// Judgements.

void BusNetwork::frame_sent(Time now, ControllerId sender, const Frame& frame) {
  heard_.hear(now, frame);
  const std::optional<bool> is_right = messages_.is_right(now, sender, frame, truth_);
  if (is_right) referee_.judge_one(InvariantKind::pdo_tables, now, *is_right);
  if (frame.id != MessageReferee::time_id || !is_right) return;
  referee_.judge(InvariantKind::clock, now,
                 *is_right && MessageReferee::is_time(frame, clock_.local()));
}

void BusNetwork::FollowingMessages::frame_sent(Time now, ControllerId sender, const Frame& frame) {
  const std::optional<bool> is_right = referee.is_right(now, sender, frame, network.truth_);
  if (is_right) network.referee_.judge_one(InvariantKind::pdo_tables, now, *is_right);
}

void BusNetwork::step(Time now) {
  lead_vehicle(now);
  following_.step(now);
  if (wants_log_in_ && now >= next_log_in_) log_in();
  stop_requests_.look(now);
  judge(now);
  if (!referee_.has_news()) return;
  told_.report_broken(invariants(),
                      [&](const Invariant& broken) { events_.note(now, InvariantBroken{broken}); });
}

void BusNetwork::judge(Time now) {
  display_watch_.judge(now);
  service_.step(now);
  referee_.judge(InvariantKind::clock, now, false);
  stop_requests_.judge(now);
  announcements_.step(now);
  service_.judge_devices(now);
}

std::vector<Invariant> BusNetwork::invariants() const {
  std::vector<Invariant> verdicts = referee_.verdicts();
  std::erase_if(verdicts, [this](const Invariant& invariant) {
    return car_of(invariant.kind) > options_.design.cars;
  });
  return verdicts;
}

bool BusNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

BusNetworkSnapshot BusNetwork::snapshot() {
  BusNetworkSnapshot look{.at = now(),
                          .buses = nodes_.cable_snapshots(),
                          .nodes = nodes_.node_snapshots(),
                          .names = nodes_.names(),
                          .displays = {},
                          .local_time = clock_.local(),
                          .utc = clock_.utc(),
                          .truth = vehicle_.truth(),
                          .state = vehicle_.state(),
                          .position = vehicle_.position(),
                          .heading = vehicle_.heading(),
                          .speed = vehicle_.speed(),
                          .odometer = vehicle_.odometer(),
                          .metres_on_route = vehicle_.metres_on_route(),
                          .delay = vehicle_.delay(),
                          .doors = {},
                          .counted = computer_.counted(),
                          .riders = vehicle_.riders().statistics(),
                          .statistics = counted_};
  for (const DeviceKey key : display_ids) {
    if (!nodes_.is_there(key)) continue;
    const ShownDisplay& shown = displays_.at(key);
    look.displays.push_back({nodes_.id(key), shown.text(), shown.is_sign_lit()});
  }
  for (std::size_t i = 0; i < vehicle_.door_count(); ++i) {
    look.doors.push_back(vehicle_.door(i).state());
  }
  look.statistics.announced = announcements_.heard();
  look.statistics.texts = display_watch_.texts();
  return look;
}

}  // namespace canvoy::bus_line
