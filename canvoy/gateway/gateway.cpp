#include "canvoy/gateway/gateway.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::gateway {

void Gateway::add(Network& network) {
  networks_[network.number()] = &network;
  network.on_event([this](const Event& event) { tell(event); });
  network.on_progress([this](Time now) { settle(now); });
}

Network* Gateway::find(std::uint32_t number) const {
  const auto found = networks_.find(number);
  return found == networks_.end() ? nullptr : found->second;
}

std::optional<std::uint32_t> Gateway::only_network() const {
  return networks_.size() == 1 ? std::optional(networks_.begin()->first) : std::nullopt;
}

Session& Gateway::open() {
  sessions_.push_back(std::make_unique<Session>(*this, settings_));
  return *sessions_.back();
}

void Gateway::close(Session& session) {
  const auto found =
      std::ranges::find_if(sessions_, [&](const auto& other) { return other.get() == &session; });
  if (found == sessions_.end()) return;
  // The cancellation lets others continue, which need all sessions in their places.
  const std::unique_ptr<Session> closed = std::move(*found);
  sessions_.erase(found);
}

/// A network with immediate answers calls again during a session's work.
void Gateway::settle(Time now) {
  again_ = true;
  if (std::exchange(settling_, true)) return;
  const auto is_ready = [](const auto& session) { return session->is_ready(); };
  while (std::exchange(again_, false)) {
    for (const auto& session : sessions_) session->settle(now);
    if (settled_) settled_();
    // There may be room for answers that had none.
    again_ = again_ || (settled_ && std::ranges::any_of(sessions_, is_ready));
  }
  settling_ = false;
}

Time Gateway::deadline() const {
  Time earliest = never;
  for (const auto& session : sessions_) earliest = std::min(earliest, session->deadline());
  return earliest;
}

void Gateway::tell(const Event& event) {
  for (const auto& session : sessions_) session->tell(event);
}

}  // namespace canvoy::gateway
