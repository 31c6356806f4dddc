#include "canvoy/tools/player/actor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

/// A node on a bus of the network that sends requests.
struct Actor::Desk {
  Desk(World& world, BusIndex bus) : slot(world.add_slot(bus)), port(world.port(slot)), desk(port) {
    world.occupy(slot, desk.node());
    world.start(slot);
  }
  SlotIndex slot;
  Port port;
  SdoRequests desk;
};

Actor::Actor(PlayedNetwork& network, std::vector<Act> acts)
    : network_(network),
      buses_(network.bus_names()),
      desks_(buses_.size()),
      acts_(std::move(acts)) {
  for (const Act& act : acts_) check(act);
}

Actor::~Actor() = default;

void Actor::check(const Act& act) const {
  if (act.request) {
    static_cast<void>(bus_of(act.request->bus));
  } else if (!network_.takes_visitors()) {
    throw UsageError(fmt::format("act '{}': nobody visits this network", act_text(act)));
  } else if (!network_.has_way(act.from, act.to)) {
    throw UsageError(fmt::format("there is no way between floors {} and {}", act.from, act.to));
  }
}

void Actor::run_until(Time until) {
  while (done_ < acts_.size() && acts_[done_].at <= until) {
    network_.run_until(acts_[done_].at);
    perform(acts_[done_++], {});
  }
  network_.run_until(until);
}

void Actor::act(Act act, const SdoRequests::Done& done) {
  check(act);
  const auto later = acts_.begin() + static_cast<std::ptrdiff_t>(done_);
  acts_.erase(std::remove_if(later, acts_.end(), [](const Act& each) { return each.is_added; }),
              acts_.end());
  act.at = network_.world().now();
  act.is_added = true;
  acts_.insert(acts_.begin() + static_cast<std::ptrdiff_t>(done_++), act);
  perform(act, done);
}

std::vector<std::string> Actor::added() const {
  std::vector<std::string> texts;
  for (const Act& act : acts_) {
    if (act.is_added) texts.push_back(act_text(act));
  }
  return texts;
}

void Actor::perform(const Act& act, const SdoRequests::Done& done) {
  if (!act.request) return network_.visit(act.from, act.to);
  const SdoRequests::Done told = done ? done : [](const SdoRequests::Answer&) {};
  const BusRequest& wanted = *act.request;
  Desk& desk = desk_of(wanted.bus);
  if (wanted.kind == BusRequest::Kind::nmt) {
    desk.port.send(desk.port.context,
                   Frame::data_frame(can_id::nmt, {wanted.bytes[0], wanted.node}));
    return;
  }
  desk.desk.node().advance(network_.world().now());
  if (wanted.kind == BusRequest::Kind::read) {
    desk.desk.read(wanted.node, wanted.index, wanted.sub, told);
  } else {
    desk.desk.write(wanted.node, wanted.index, wanted.sub, wanted.bytes, told);
  }
  network_.world().touched(desk.slot);
}

BusIndex Actor::bus_of(const std::string& name) const {
  const auto found = std::ranges::find(buses_, name);
  if (found == buses_.end()) {
    throw UsageError(
        fmt::format("there is no bus '{}': the buses are {}", name, fmt::join(buses_, ", ")));
  }
  return static_cast<BusIndex>(found - buses_.begin());
}

Actor::Desk& Actor::desk_of(const std::string& bus) {
  const BusIndex index = bus_of(bus);
  if (!desks_[index]) desks_[index] = std::make_unique<Desk>(network_.world(), index);
  return *desks_[index];
}

}  // namespace canvoy::tools
