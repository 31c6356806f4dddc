// A CAN bus of another machine, served there by a socketcand over TCP; this is its client, in raw
// mode.
//
//     Result<std::unique_ptr<Carrier>> carrier =
//         Socketcand::open(loop, *parse_bus_address("tcp:bench.local/can0"));
#pragma once

#include <sys/socket.h>

#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/can/host/carrier.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/socketcand_message.hpp"

namespace canvoy::host {

/// The client. A server does not return the frames of its own client: a frame counts as having been
/// on the bus when it was passed to the connection. The only bus state is the loss of the
/// connection, also if the server disappears silently: then after 10 s. The connection is tried
/// again every second, or 4 s after a server accepted it and refused the bus. Frames are stamped at
/// arrival here, since the server has a different clock.
class Socketcand final : public Carrier {
 public:
  /// Connects, and waits up to three seconds for the server to open the bus. Fails with advice if
  /// there is no such server, or it refuses the bus.
  static Result<std::unique_ptr<Carrier>> open(EventLoop& loop, const BusAddress& address);
  ~Socketcand() override;

  std::string_view name() const override { return name_; }
  SendResult send(const Frame& frame) override;

 private:
  enum class Stage : std::uint8_t { connecting, greeting, opening, choosing_raw, up };

  Socketcand(EventLoop& loop, const BusAddress& address);

  Result<void> resolve();
  Result<void> connect();
  Result<void> wait_until_up();
  Result<void> watch();
  void on_ready(Readiness ready);
  bool finish_connecting();
  void receive();
  void message_arrived(std::string_view message);
  void answer(std::string_view message);
  void say(std::string_view text);
  void flush();
  void confirm();
  Error failure(std::string_view what) const;
  void lost(std::string_view what);
  void try_again();

  EventLoop& loop_;
  BusAddress address_;
  std::string name_;
  sockaddr_storage server_{};
  socklen_t server_size_ = 0;
  Descriptor socket_;
  Stage stage_ = Stage::connecting;
  SocketcandMessages messages_;
  std::string unsent_;
  std::deque<Frame> unconfirmed_;
  std::string refusal_;   ///< answer of the server in place of `ok`
  bool is_open_ = false;  ///< it has been connected once: from then on it reconnects by itself
  bool is_down_ = false;
  EventLoop::Id watch_ = 0;
  EventLoop::Id retry_ = 0;  ///< time of the next try, or limit of the present one
  EventLoop::Id confirmation_ = 0;
};

}  // namespace canvoy::host
