// SocketCAN: a CAN interface of the Linux kernel, real (can0) or virtual (vcan0), as a carrier.
//
//     Result<std::unique_ptr<Carrier>> carrier = SocketCan::open(loop, "can0");
#pragma once

#include <linux/can.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/carrier.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/receive_batch.hpp"

namespace canvoy::host {

/// One CAN_RAW socket. Error frames of the controller become bus states, and are passed on for
/// logs. Own frames come back after they have been on the bus. An interface that is down, bus-off
/// or unplugged is bus-off for the nodes; a down or unplugged one is checked every 100 ms, and
/// served again when it returns under the same name.
class SocketCan final : public Carrier {
 public:
  /// Opens the interface. Fails with advice if the kernel has no CAN, or the interface does not
  /// exist, is not CAN, or is down.
  static Result<std::unique_ptr<Carrier>> open(EventLoop& loop, std::string_view interface);
  ~SocketCan() override;

  std::string_view name() const override { return interface_; }
  SendResult send(const Frame& frame) override;
  void accept(const AcceptedIds* ids) override;

 private:
  SocketCan(EventLoop& loop, std::string_view interface, Descriptor socket);

  Result<void> configure();
  void set_filters();
  void report_present_state();
  Result<void> watch();
  void on_ready(Readiness ready);
  void receive();
  void packet_arrived(const ReceivedPacket& packet);
  void search_soon(int error);
  void went_down(int error);
  void look_for_interface();

  EventLoop& loop_;
  std::string interface_;
  Descriptor socket_;
  EventLoop::Id watch_ = 0;
  EventLoop::Id retry_ = 0;
  EventLoop::Id search_ = 0;
  EventLoop::Id report_ = 0;
  std::vector<can_filter> filters_;  ///< in the kernel; none: all frames pass
  bool down_ = false;
  ReceiveBatch batch_;
};

}  // namespace canvoy::host
