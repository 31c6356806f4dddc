#include "canvoy/worlds/bus_line/display_server.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/profiles/cia407/passenger_information.hpp"

namespace canvoy::bus_line {

namespace {

constexpr Duration retry_after = 500ms;

}  // namespace

DisplayServer::DisplayServer(Node& node, const NmtMaster& master, cia407::TextSender& texts)
    : node_(node), master_(master), texts_(texts) {
  texts_.on_done(callback<&DisplayServer::arrived>(*this));
  texts_.on_read(callback<&DisplayServer::told>(*this));
}

DisplayServer::Served* DisplayServer::find(NodeId id) {
  const auto found =
      std::ranges::find(served_, id, [](const Served& each) { return each.display.node; });
  return found == served_.end() ? nullptr : &*found;
}

void DisplayServer::forget(NodeId id) {
  if (Served* const display = find(id); display != nullptr) forget(*display);
}

/// Another device with the same node-ID may have taken its place.
void DisplayServer::forget(Served& served) {
  served.feed.forget();
  served.has_told_sets = false;
  served.next_sub = 0;
  served.told_sets.clear();
}

void DisplayServer::forget_all() {
  for (Served& each : served_) forget(each);
}

void DisplayServer::serve() {
  const Time now = node_.now();
  for (Served& each : served_) {
    const NodeId id = each.display.node;
    if (master_.remote(id).state() == RemoteState::lost || now < each.paused_until) continue;
    if (each.asked_sub || ask(each)) continue;
    const std::optional<DisplayFeed::Write> write = each.feed.next();
    if (write && !texts_.send(id, write->index, write->sub, write->octets)) arrived(id, false);
  }
}

/// Displays outside have none (6.4).
bool DisplayServer::wants_sets(const Served& served) const {
  const DisplayUse use = served.display.use;
  const bool has_sets = use == DisplayUse::next_stop || use == DisplayUse::information;
  return asks_for_sets_ && has_sets && !served.has_told_sets && !served.feed.is_busy();
}

/// True: it is under way. A display that cannot be asked yet is asked the next time.
bool DisplayServer::ask(Served& served) {
  if (!wants_sets(served)) return false;
  const std::uint16_t index = cia407::character_set_object.index;
  if (!texts_.read(served.display.node, index, served.next_sub)) return false;
  served.asked_sub = served.next_sub;
  return true;
}

/// A display that does not answer, or has no such object, is not asked again before it returns.
void DisplayServer::told(NodeId server, std::optional<std::uint32_t> value) {
  Served* const display = find(server);
  if (display == nullptr || !display->asked_sub) return;
  constexpr std::uint8_t first_set = 2;
  const std::uint8_t sub = *std::exchange(display->asked_sub, std::nullopt);
  if (sub == display->next_sub) {
    if (sub == 0) {
      display->last_sub = value.value_or(0);
      display->next_sub = first_set;
    } else {
      if (value && *value != 0) display->told_sets.push_back(static_cast<std::uint16_t>(*value));
      ++display->next_sub;
    }
    display->has_told_sets = !value || display->next_sub > display->last_sub;
    if (display->has_told_sets) {
      display->sets = std::exchange(display->told_sets, {});
      learnt_();
    }
  }
  serve();
}

void DisplayServer::arrived(NodeId server, bool has_arrived) {
  Served* const display = find(server);
  if (display == nullptr) return;
  display->feed.done(has_arrived);
  if (!has_arrived) display->paused_until = node_.now() + retry_after;
  serve();
}

}  // namespace canvoy::bus_line
