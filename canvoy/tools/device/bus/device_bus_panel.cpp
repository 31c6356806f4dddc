#include "canvoy/tools/device/bus/device_bus_panel.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration kept_each = 1s;

}  // namespace

BusPanel::BusPanel(std::span<const cia407::BusUnit* const> units,
                   const std::vector<std::string>& presses, const BusPanelOptions& options,
                   Environment& environment, const Place& place)
    : units_(units.begin(), units.end()),
      segment_(parse_bus_segment(options.segment)),
      store_(place.store),
      kept_(store_ != nullptr ? store_->load() : KeptBusValues{}),
      stored_(kept_),
      motion_(place.car, kept_.metres),
      displays_(display_names(units), parse_display_size(options.display), options.png, place.clock,
                place.output),
      loudspeakers_(parse_announcements(options.announcements), place.output),
      tickets_(place.output),
      computer_(motion_, kept_.assignment),
      console_(place.clock, place.output),
      vehicle_(motion_, console_, kept_.trip_begin),
      satellites_(motion_),
      counting_({.door = environment.door, .capacity = options.capacity, .kept = kept_.counts}),
      train_(place.output),
      wires_(errors_, place.output) {
  for (const std::string& text : presses) {
    if (has_bus_press(units, text)) plan_.push_back({parse_bus_press(units, text)});
  }
  segment_.is_started_by_first = environment.manages_network;
  join(environment);
}

void BusPanel::join(Environment& environment) {
  environment.provide(Callback<cia407::BusSegment()>::to<&BusPanel::segment>(*this));
  errors_.join(environment);
  displays_.join(environment);
  loudspeakers_.join(environment);
  tickets_.join(environment);
  computer_.join(environment);
  console_.join(environment);
  vehicle_.join(environment);
  satellites_.join(environment);
  counting_.join(environment);
  train_.join(environment);
  wires_.join(environment);
}

void BusPanel::take(std::string_view press) {
  std::erase_if(plan_, [](const Planned& each) { return each.is_done; });
  plan_.push_back({parse_bus_press(units_, press)});
}

void BusPanel::step(Node& node, Time now) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  if (now >= keep_at_) {
    keep_at_ = now + kept_each;
    keep();
  }
  for (Planned& each : plan_) {
    if (each.is_done || now - begin < each.press.at) continue;
    each.is_done = true;
    // An action from outside of the node: the node is advanced to the present.
    node.advance(now);
    act(each.press, node);
  }
  console_.step(now);
  displays_.look();
}

/// One of them performs the press, and the others ignore it.
void BusPanel::act(const BusPress& press, Node& node) {
  errors_.act(press);
  tickets_.act(press);
  computer_.act(press);
  console_.act(press);
  vehicle_.act(press);
  satellites_.act(press);
  counting_.act(press);
  train_.act(press, node);
  wires_.act(press);
}

/// Values that no device here counts are unchanged.
void BusPanel::keep() {
  if (store_ == nullptr) return;
  KeptBusValues now = kept_;
  now.metres = motion_.metres();
  now.trip_begin = vehicle_.trip_begin().value_or(kept_.trip_begin);
  now.counts = counting_.counts().value_or(kept_.counts);
  now.assignment = computer_.assignment();
  if (now == stored_) return;
  stored_ = now;
  store_->keep(now);
}

}  // namespace canvoy::tools
