#include "canvoy/gateway/gateway.hpp"

#include <algorithm>

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
  std::erase_if(sessions_, [&](const auto& other) { return other.get() == &session; });
}

void Gateway::settle(Time now) {
  const auto is_ready = [](const auto& session) { return session->is_ready(); };
  do {
    for (const auto& session : sessions_) session->settle(now);
    if (settled_) settled_();
    // Where there was no room for more answers, there may be now.
  } while (settled_ && std::ranges::any_of(sessions_, is_ready));
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
