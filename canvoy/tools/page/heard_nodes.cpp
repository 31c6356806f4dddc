#include "canvoy/tools/page/heard_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration look_period = 1s;

}  // namespace

struct HeardNodes::Bus {
  Bus(std::string bus_name, std::size_t number, BusWatch::Note note)
      : name(std::move(bus_name)),
        index(static_cast<BusIndex>(number)),
        watch(number, std::move(note)),
        tap(watch.tap()) {}
  std::string name;
  BusIndex index;
  BusWatch watch;
  BusTap tap;
};

class HeardNodes::Names : public WorldNames {
 public:
  explicit Names(HeardNodes& heard) : heard_(heard) {}

  std::string bus(BusIndex bus) const override { return heard_.buses_[bus]->name; }
  std::string device(BusIndex bus, NodeId id) const override {
    const Profile& profile = heard_.feed_.profile(heard_.buses_[bus]->name, id);
    if (&profile == &base_profile()) return text::node_text(id);
    return fmt::format("{} ({})", profile.name, id);
  }
  std::string fault(std::size_t) const override { return {}; }
  std::string_view emergency(std::uint16_t code) const override {
    return text::emergency_text(code);
  }

 private:
  HeardNodes& heard_;
};

HeardNodes::HeardNodes(FrameFeed& feed, Tell tell)
    : feed_(feed), tell_(std::move(tell)), names_(std::make_unique<Names>(*this)) {}

HeardNodes::~HeardNodes() = default;

HeardNodes::Bus* HeardNodes::bus_of(std::string_view name) {
  for (const auto& known : buses_) {
    if (known->name == name) return known.get();
  }
  if (buses_.size() == FrameFeed::buses_max) return nullptr;
  const BusWatch::Note note_it = [this](Time now, const BusEvent& event) { note(now, event); };
  return buses_.emplace_back(std::make_unique<Bus>(std::string(name), buses_.size(), note_it))
      .get();
}

void HeardNodes::hear(Duration time, std::string_view bus, const Frame& frame) {
  if (frame.is_error()) return;
  const Bus* const heard_on = bus_of(bus);
  if (heard_on == nullptr) return;
  if (time >= next_look_ || time + look_period < next_look_) look(time);
  const BusTap& tap = heard_on->tap;
  tap.on_frame(tap.context, Time{} + time, no_controller, frame);
  hear_heartbeat(time, heard_on->index, frame);
}

void HeardNodes::hear_heartbeat(Duration time, BusIndex bus, const Frame& frame) {
  const std::uint32_t node = frame.id - can_id::error_control;
  if (!frame.is_plain() || frame.length != 1 || !is_node_id(node)) return;
  nodes_[{bus, static_cast<NodeId>(node)}].heartbeat.hear(time, frame.data[0] == 0);
}

void HeardNodes::note(Time now, const BusEvent& event) {
  const auto say = [&](const auto& seen) {
    using Seen = std::decay_t<decltype(seen)>;
    if (seen.node != 0) {
      Said& said = nodes_[{seen.bus, seen.node}];
      if constexpr (std::is_same_v<Seen, NmtStateSeen>)
        said.state = text::nmt_state_text(seen.state);
      if constexpr (std::is_same_v<Seen, BootedUp>) {
        said.state = text::nmt_state_text(NmtState::initialisation);
      }
      if constexpr (std::is_same_v<Seen, EmergencySeen>) said.error_register = seen.error_register;
    }
    tell_(reported_at(now, told(*names_, seen)));
  };
  std::visit(say, event);
}

void HeardNodes::look(Duration now) {
  next_look_ = now + look_period;
  for (auto& [place, said] : nodes_) {
    const bool is_silent = said.heartbeat.is_silent(now);
    if (std::exchange(said.told_silent, is_silent) == is_silent) continue;
    const auto& [bus, node] = place;
    const std::string_view text = is_silent ? "no heartbeat any more" : "its heartbeat is back";
    Json json{{"event", is_silent ? "silent" : "heard-again"},
              {"bus", buses_[bus]->name},
              {"node", node},
              {"text", text}};
    tell_(reported_at(Time{} + now, Told(fmt::format("{}: {}", names_->device(bus, node), text),
                                         std::move(json))));
  }
}

Json HeardNodes::nodes_json(Duration now) {
  Json all = Json::array();
  for (const auto& [place, said] : nodes_) {
    const auto& [bus, node] = place;
    all.push_back({{"bus", buses_[bus]->name},
                   {"node", node},
                   {"device", names_->device(bus, node)},
                   {"state", said.heartbeat.is_silent(now) ? "silent"
                             : said.state.empty()          ? "unknown"
                                                           : said.state},
                   {"error_register", fmt::format("{:02X}", said.error_register)}});
  }
  return all;
}

}  // namespace canvoy::tools
