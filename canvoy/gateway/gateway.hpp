// The gateway between any number of clients and CANopen networks (CiA 309-1, 309-3), without
// sockets and clock.
//
//     Gateway gateway;
//     gateway.add(network);
//     Session& session = gateway.open();
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "canvoy/gateway/network.hpp"
#include "canvoy/gateway/session.hpp"

namespace canvoy::gateway {

class Gateway {
 public:
  explicit Gateway(const SessionSettings& settings = {}) : settings_(settings) {}
  Gateway(const Gateway&) = delete;
  Gateway& operator=(const Gateway&) = delete;

  /// `network` must outlive the gateway; its number is not that of another.
  void add(Network& network);
  /// Null where there is no such network.
  Network* find(std::uint32_t number) const;
  /// The network that is meant where a client names none and has set none: the only one.
  std::optional<std::uint32_t> only_network() const;

  Session& open();
  /// Commands of the session that are under way are cancelled. Not from within on_settled().
  void close(Session& session);

  /// Called whenever sessions may have something to say or to read again.
  void on_settled(std::function<void()> handler) { settled_ = std::move(handler); }
  /// Lets all sessions go on; call it after a session received something. A call from within
  /// another one has that go on once more.
  void settle(Time now);

  Time deadline() const;
  void advance(Time now) { settle(now); }

 private:
  void tell(const Event& event);

  SessionSettings settings_;
  std::map<std::uint32_t, Network*> networks_;
  std::vector<std::unique_ptr<Session>> sessions_;
  std::function<void()> settled_;
  bool settling_ = false;
  bool again_ = false;
};

}  // namespace canvoy::gateway
