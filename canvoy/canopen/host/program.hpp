// A program that is one device on one bus: bus and node-ID in the notation of the user, and a loop
// until a signal ends it.
//
//     auto bus = canvoy::open(arguments[1]);
//     if (!bus) return canvoy::fail(bus.error());
//     const auto id = canvoy::read_node_id(arguments[2]);
//     if (!id) return canvoy::fail(id.error());
//     cia419::ChargerDevice<> charger(bus->port(), *id, stage);
//     return bus->run(charger);
#pragma once

#include <memory>
#include <utility>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// A bus with a loop, and a connection for one node.
class OpenBus {
 public:
  /// Takes the loop and the bus; open() makes both.
  OpenBus(std::unique_ptr<host::EventLoop> loop, std::unique_ptr<host::HostBus> bus)
      : loop_(std::move(loop)),
        bus_(std::move(bus)),
        attachment_(std::make_unique<host::Attachment>(*loop_, *bus_)) {}

  /// Port for the device, which must be constructed after this object and destroyed before it.
  Port port() { return attachment_->port(); }
  /// Loop that run() serves, for timers and files of the application.
  host::EventLoop& loop() { return *loop_; }
  /// The bus, for statistics and for further connections.
  host::HostBus& bus() { return *bus_; }

  /// Starts a device (which has node()) or a node, and serves it until SIGINT, SIGTERM or SIGHUP.
  /// To be called once. Returns the exit status of the program: 0, or 1 after a line on the
  /// standard error output.
  template <class Device>
  int run(Device& device) {
    if constexpr (requires { device.node(); }) {
      return run(device.node());
    } else {
      attachment_->attach(device);
      device.start(loop_->now());
      return wait();
    }
  }

 private:
  int wait();

  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<host::HostBus> bus_;
  std::unique_ptr<host::Attachment> attachment_;
};

/// Opens a bus. `name` is as for `canvoy`: can0, udp:239.74.163.2:43113, tcp:HOST:PORT/can0. Null,
/// the value of a missing argument of a program, is an error as well.
host::Result<OpenBus> open(const char* name);

/// Reads a node-ID, 1 to 127, in decimal or, with 0x, in hexadecimal digits; anything else is an
/// error.
host::Result<NodeId> read_node_id(const char* text);

/// Writes the error as one line to the standard error output; returns the exit status of a program
/// that failed.
int fail(const host::Error& error);

}  // namespace canvoy
