// The gateway between any number of clients and CANopen networks, without sockets and clock (CiA
// 309-1, CiA 309-3).
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
  /// Makes a gateway without networks; `settings` apply to each session.
  explicit Gateway(const SessionSettings& settings = {}) : settings_(settings) {}
  Gateway(const Gateway&) = delete;
  Gateway& operator=(const Gateway&) = delete;

  /// Adds a network. `network` must outlive the gateway; its number must differ from all others.
  void add(Network& network);
  /// Network with this number; null if there is none.
  Network* find(std::uint32_t number) const;
  /// Default network of a client that names none and has set none: the only network, if there is
  /// one only.
  std::optional<std::uint32_t> only_network() const;

  /// Opens a session for a new client; valid until close().
  Session& open();
  /// Closes a session and cancels its commands. Must not be called from within on_settled().
  void close(Session& session);

  /// Sets the handler that is called when sessions may have something to send or can read again.
  void on_settled(std::function<void()> handler) { settled_ = std::move(handler); }
  /// Continues all sessions; call it after a session received something. A call from within another
  /// call makes that call repeat its work once.
  void settle(Time now);

  /// Time of the next call of advance(); never if no command waits for a time.
  Time deadline() const;
  /// Does what is due: commands take too long. Call it at deadline().
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
