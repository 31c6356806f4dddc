#include "canvoy/tools/session/bus_news.hpp"

#include <fmt/format.h>

#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

std::string frames_text(std::uint64_t count) {
  return fmt::format("{} frame{} lost before {} read", count, count == 1 ? " was" : "s were",
                     count == 1 ? "it was" : "they were");
}

void add(std::string& all, const std::string& text) {
  all += (all.empty() ? "" : "; ") + text;
}

}  // namespace

void BusNews::follow(host::HostBus& bus, bool with_nodes) {
  Bus& followed = buses_.emplace_back(Bus{.host = &bus});
  bus.on_state([this, &followed](BusState state, Time) { tell_state(followed, state); });
  bus.on_trouble([this, &followed](const host::Error& error) {
    followed.trouble = error.line();
    followed.is_lost = true;
    tell_(fmt::format("canvoy: {}", error.line()));
  });
  if (with_nodes) {
    bus.on_frame([this, &followed](const host::BusFrame& heard) { hear(followed, heard); });
  }
}

/// A lost bus tells its trouble first, and then that it is off.
void BusNews::tell_state(Bus& bus, BusState state) {
  const std::string now = fmt::format("{} is {}", bus.host->name(), text::bus_state_text(state));
  const bool is_active = state == BusState::error_active;
  const bool is_back = is_active && !bus.trouble.empty();
  if (is_active || !bus.is_lost) bus.trouble = is_active ? "" : now;
  if (is_active) bus.is_lost = false;
  tell_(is_back ? fmt::format("{} is back", bus.host->name()) : now);
}

void BusNews::hear(Bus& bus, const host::BusFrame& heard) {
  const Frame& frame = heard.frame;
  if (frame.is_error()) return;
  // A bus without states, as UDP, has come back where a frame comes.
  if (bus.is_lost && bus.host->state() == BusState::error_active) {
    bus.trouble.clear();
    bus.is_lost = false;
  }
  const std::uint32_t node = frame.id - can_id::error_control;
  if (!frame.is_plain() || frame.length != 1 || !is_node_id(node)) return;
  bus.nodes[static_cast<NodeId>(node)].heartbeat.hear(heard.time.time_since_epoch(),
                                                      frame.data[0] == 0);
}

void BusNews::look(Time now) {
  for (Bus& bus : buses_) look_at(bus, now.time_since_epoch());
}

void BusNews::look_at(Bus& bus, Duration now) {
  const std::uint64_t lost = bus.host->counters().carrier.overrun;
  if (lost > bus.lost) tell_(fmt::format("{}: {}", bus.host->name(), frames_text(lost - bus.lost)));
  bus.lost = lost;
  for (auto& [id, node] : bus.nodes) {
    const bool is_silent = node.heartbeat.is_silent(now);
    if (is_silent == node.is_silent) continue;
    node.is_silent = is_silent;
    tell_(fmt::format("{}: {}: {}", bus.host->name(), text::node_text(id),
                      is_silent ? "no heartbeat any more" : "its heartbeat is back"));
  }
}

std::string BusNews::place(const Bus& bus) const {
  return buses_.size() > 1 ? fmt::format("{}: ", bus.host->name()) : "";
}

std::string BusNews::trouble() const {
  std::string all;
  for (const Bus& bus : buses_) {
    if (!bus.trouble.empty()) add(all, bus.trouble);
  }
  return all;
}

std::string BusNews::text(Time now) const {
  std::string all = trouble();
  for (const Bus& bus : buses_) {
    for (const auto& [id, node] : bus.nodes) {
      if (!node.is_silent) continue;
      const Duration silent = now.time_since_epoch() - node.heartbeat.heard_at();
      add(all, fmt::format("{}{} is silent for {} s", place(bus), text::node_text(id),
                           std::chrono::floor<std::chrono::seconds>(silent).count()));
    }
  }
  if (const std::uint64_t lost = frames_lost(); lost != 0) add(all, frames_text(lost));
  return all;
}

std::uint64_t BusNews::frames_lost() const {
  std::uint64_t lost = 0;
  for (const Bus& bus : buses_) lost += bus.host->counters().carrier.overrun;
  return lost;
}

}  // namespace canvoy::tools
