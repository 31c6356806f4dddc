// A CAN bus between programs and machines without any CAN hardware: frames as datagrams to a
// multicast group, as python-can's interface `udp_multicast` has them.
//
//     Result<std::unique_ptr<Carrier>> carrier = UdpMulticast::open(loop, UdpGroup{});
#pragma once

#include <netinet/in.h>

#include <memory>
#include <string>
#include <string_view>

#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/can/host/carrier.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/local_addresses.hpp"
#include "canvoy/can/host/receive_batch.hpp"

namespace canvoy::host {

/// Two sockets: one listens on the group, which other programs of the machine do as well; the other
/// sends, and by its port own datagrams are known when they come back. Without a time to live in
/// its address the bus is of this machine in both directions: what others send is counted, and told
/// of once. No arbitration, no bit rate, no acknowledgement, no bus state.
class UdpMulticast final : public Carrier {
 public:
  /// Fails with what to do where there is no route for multicast, or the port belongs to something
  /// else.
  static Result<std::unique_ptr<Carrier>> open(EventLoop& loop, const UdpGroup& group);
  ~UdpMulticast() override;

  std::string_view name() const override { return name_; }
  SendResult send(const Frame& frame) override;

 private:
  UdpMulticast(EventLoop& loop, const UdpGroup& group);

  bool open_receiver();
  bool open_sender();
  Result<void> watch();
  Error failure(int error) const;
  void tell_soon(int error);
  void on_receivable(Readiness ready);
  void on_sendable(Readiness ready);
  bool is_foreign(const sockaddr_in& sender);
  void tell_foreign(const sockaddr_in& sender);
  void datagram_arrived(const ReceivedPacket& packet);

  EventLoop& loop_;
  UdpGroup group_;
  std::string name_;
  Descriptor receiver_;
  Descriptor sender_;
  EventLoop::Id receive_watch_ = 0;
  EventLoop::Id send_watch_ = 0;
  EventLoop::Id retry_ = 0;
  EventLoop::Id telling_ = 0;
  sockaddr_in own_{};
  LocalAddresses local_;
  bool in_trouble_ = false;
  ReceiveBatch batch_;
};

}  // namespace canvoy::host
