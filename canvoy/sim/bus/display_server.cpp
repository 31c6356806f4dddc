#include "canvoy/sim/bus/display_server.hpp"

#include <algorithm>

namespace canvoy::bus {

namespace {

constexpr Duration retry_after = 500ms;

}  // namespace

DisplayServer::DisplayServer(Node& node, const NmtMaster& master, cia407::TextSender& texts)
    : node_(node), master_(master), texts_(texts) {
  texts_.on_done(Callback<void(NodeId, bool)>::to<&DisplayServer::arrived>(*this));
}

DisplayServer::Served* DisplayServer::find(NodeId id) {
  const auto found =
      std::ranges::find(served_, id, [](const Served& each) { return each.display.node; });
  return found == served_.end() ? nullptr : &*found;
}

void DisplayServer::forget(NodeId id) {
  if (Served* const display = find(id); display != nullptr) display->feed.forget();
}

void DisplayServer::forget_all() {
  for (Served& each : served_) each.feed.forget();
}

void DisplayServer::serve() {
  const Time now = node_.now();
  for (Served& each : served_) {
    const NodeId id = each.display.node;
    if (master_.remote(id).state() == RemoteState::lost || now < each.paused_until) continue;
    const std::optional<DisplayFeed::Write> write = each.feed.next();
    if (write && !texts_.send(id, write->index, write->sub, write->octets)) arrived(id, false);
  }
}

void DisplayServer::arrived(NodeId server, bool has_arrived) {
  Served* const display = find(server);
  if (display == nullptr) return;
  display->feed.done(has_arrived);
  if (!has_arrived) display->paused_until = node_.now() + retry_after;
  serve();
}

}  // namespace canvoy::bus
