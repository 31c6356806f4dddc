// A CAN bus between programs and machines without CAN hardware: frames as datagrams to a multicast
// group, like the interface `udp_multicast` of python-can.
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

/// The bus. It has two sockets: one listens on the group, as other programs of the machine do; the
/// other sends, and its port identifies own datagrams when they come back. With a time to live of 0
/// in its address, the bus is limited to this machine in both directions: frames of others are
/// counted, and reported once. No arbitration, no bit rate, no acknowledgement, no bus state.
class UdpMulticast final : public Carrier {
 public:
  /// Opens the bus. Fails with advice if there is no route for multicast, or another program has
  /// the port.
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
