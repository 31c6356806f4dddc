#include "canvoy/sim/world.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

constexpr std::size_t plan_actor = 0;

}  // namespace

World::World() {
  actors_.push_back({Actor::Kind::plan, 0});
  deadlines_.add();
}

BusIndex World::add_bus(const SimulatedBusOptions& options) {
  buses_.push_back(std::make_unique<SimulatedBus>(options));
  buses_.back()->advance(now_);
  return buses_.size() - 1;
}

SlotIndex World::add_slot(BusIndex bus, const SlotOptions& options) {
  Slot& slot = slots_.emplace_back();
  slot.world = this;
  slot.bus = bus;
  slot.clock = DriftingClock(options.clock_drift_ppm);
  slot.controller = buses_[bus]->attach({.listener = listener_of(slot),
                                         .transmit_order = options.transmit_order,
                                         .bit_rate = options.bit_rate,
                                         .listen_only = options.listen_only,
                                         .accept_all = options.accept_all,
                                         .clock_drift_ppm = options.clock_drift_ppm});
  buses_[bus]->power(slot.controller, false);
  slot.actor = deadlines_.add();
  check_invariant(slot.actor == actors_.size());
  actors_.push_back({Actor::Kind::node, slots_.size() - 1});
  return slots_.size() - 1;
}

Port World::port(SlotIndex slot) {
  return buses_[slots_[slot].bus]->port(slots_[slot].controller);
}

/// Passes something to the node of a slot, if it has power, and reads its deadline again.
template <class Call>
void World::tell(void* context, Time now, const Call& call) {
  Slot& slot = *static_cast<Slot*>(context);
  if (!slot.runs) return;
  slot.world->now_ = now;
  call(slot, slot.node_time(now));
  slot.world->update_deadline(slot);
}

BusListener World::listener_of(Slot& slot) {
  return {.context = &slot,
          .on_frame =
              [](void* context, Time now, const Frame& frame) {
                tell(context, now, [&](const Slot& self, Time node_now) {
                  self.calls->receive(self.node, frame, node_now);
                });
              },
          .on_sent =
              [](void* context, Time now, const Frame&) {
                tell(context, now, [](const Slot& self, Time node_now) {
                  self.calls->tx_ready(self.node, node_now);
                });
              },
          .on_state =
              [](void* context, Time now, BusState state) {
                tell(context, now, [&](const Slot& self, Time node_now) {
                  self.calls->bus_state(self.node, state, node_now);
                });
              },
          .on_overrun =
              [](void* context, Time now) {
                tell(context, now, [](const Slot& self, Time node_now) {
                  self.calls->overrun(self.node, node_now);
                });
              }};
}

void World::start(SlotIndex index) {
  Slot& slot = slots_[index];
  if (slot.runs) stop(index);
  buses_[slot.bus]->power(slot.controller, true);
  slot.runs = true;
  slot.calls->start(slot.node, slot.node_time(now_));
  // A controller without power has lost its errors; the node receives its initial state.
  slot.calls->bus_state(slot.node, buses_[slot.bus]->state(slot.controller), slot.node_time(now_));
  update_deadline(slot);
}

void World::stop(SlotIndex index) {
  Slot& slot = slots_[index];
  slot.runs = false;
  buses_[slot.bus]->power(slot.controller, false);
  update_deadline(slot);
}

void World::set_clock_drift(SlotIndex index, std::int32_t drift_ppm) {
  Slot& slot = slots_[index];
  slot.clock_zero_node = slot.node_time(now_);
  slot.clock_zero_world = now_;
  slot.clock = DriftingClock(drift_ppm);
  update_deadline(slot);
}

PlantIndex World::add_plant(Callback<void(Time)> step, Duration period) {
  return add({step, period, now_ + period});
}

PlantIndex World::add_sleeping_plant(Callback<void(Time)> step) {
  return add({step, Duration{0}, never});
}

PlantIndex World::add(const Plant& plant) {
  plants_.push_back(plant);
  plants_.back().actor = actors_.size();
  actors_.push_back({Actor::Kind::plant, plants_.size() - 1});
  const std::size_t actor = deadlines_.add(plant.next);
  check_invariant(actor == plants_.back().actor);
  return plants_.size() - 1;
}

void World::wake(PlantIndex index, Time when) {
  Plant& plant = plants_[index];
  plant.next = std::max(when, now_);
  set_deadline(plant.actor, plant.next);
}

void World::wake_before(PlantIndex index, Time when) {
  if (when < plants_[index].next) wake(index, when);
}

void World::at(Time when, Action action) {
  plan_.push({std::max(when, now_), plan_order_++, std::move(action)});
  set_deadline(plan_actor, plan_.top().when);
}

void World::run_until(Time until) {
  call_due();
  while (now_ < until) {
    advance_buses(std::min(until, deadlines_.earliest()));
    call_due();
  }
}

/// Runs to `limit`, or to the first time before it at which an actor is due.
void World::advance_buses(Time limit) {
  limit_ = limit;
  if (buses_.size() == 1) {
    buses_.front()->advance(limit);
    check_invariant(buses_.front()->now() >= now_ && buses_.front()->now() <= limit);
    now_ = buses_.front()->now();
    return;
  }
  std::int64_t next_ns = never_ns;
  for (const auto& bus : buses_) next_ns = std::min(next_ns, bus->next_event_ns());
  limit = std::min(limit, to_time(next_ns));
  check_invariant(limit >= now_);
  // Gateways send on one bus as they receive on another: all have waited until then.
  for (const auto& bus : buses_) bus->wait(limit);
  for (const auto& bus : buses_) bus->advance(limit);
  now_ = limit;
}

std::uint64_t World::mapping_reads() const {
  std::uint64_t reads = 0;
  for (const Slot& slot : slots_) {
    if (slot.calls != nullptr) reads += slot.calls->mapping_reads(slot.node);
  }
  return reads;
}

void World::call_due() {
  while (deadlines_.earliest() <= now_) call(actors_[deadlines_.winner()]);
}

void World::call(const Actor& actor) {
  switch (actor.kind) {
    case Actor::Kind::plan:
      return do_planned();
    case Actor::Kind::plant:
      return call_plant(plants_[actor.index]);
    case Actor::Kind::node:
      return call_node(slots_[actor.index]);
  }
}

/// The next step is set before this one is made, since the plant may choose another time.
void World::call_plant(Plant& plant) {
  check_invariant(plant.next <= now_);
  plant.next = plant.period == Duration{0} ? never : plant.next + plant.period;
  deadlines_.set(plant.actor, plant.next);
  plant.step(now_);
}

void World::do_planned() {
  // Removed before it is done, since it may plan further actions.
  check_invariant(!plan_.empty() && plan_.top().when <= now_);
  const Planned planned = plan_.top();
  plan_.pop();
  deadlines_.set(plan_actor, plan_.empty() ? never : plan_.top().when);
  planned.action(now_);
}

void World::call_node(Slot& slot) {
  const Time now = slot.node_time(now_);
  int calls = 0;
  while (slot.calls->deadline(slot.node) <= now) {
    if (calls++ == calls_max) {
      ++livelocks_;
      return deadlines_.set(slot.actor, now_ + Duration(1));
    }
    slot.calls->advance(slot.node, now);
  }
  update_deadline(slot);
}

void World::update_deadline(const Slot& slot) {
  if (!slot.runs) return set_deadline(slot.actor, never);
  const Time deadline = slot.calls->deadline(slot.node);
  if (deadline == never) return set_deadline(slot.actor, never);
  // A deadline in the past is due at once; a node expresses that by the lowest time, which has no
  // other meaning on a clock that drifts.
  if (deadline <= slot.node_time(now_)) return set_deadline(slot.actor, now_);
  set_deadline(slot.actor, slot.world_time(deadline));
}

/// A frame may bring a deadline before the limit of the buses.
void World::set_deadline(std::size_t actor, Time deadline) {
  deadlines_.set(actor, deadline);
  if (deadline < limit_ && buses_.size() == 1) buses_.front()->interrupt();
}

}  // namespace canvoy
