// A bus behind an operator environment that `canvoy device` runs, through which hosts reach its
// devices (CiA 852, 5.2).
//
//     EmbeddedNetwork network(loop, module.node(), {.bus = "can1", .network = 2});
//     attachment.attach(network.access());    // in place of the node
#pragma once

#include <array>
#include <memory>
#include <string>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

struct EmbeddedOptions {
  std::string bus{};  ///< empty: none
  std::uint16_t network = RemoteSettings{}.network;
  unsigned indication = RemoteSettings{}.indication;
  std::string emergency{};  ///< CAN-ID; empty: not reported
};
void add_embedded_options(Verb& command, EmbeddedOptions& options);
/// Throws UsageError for options that are not valid for a device on `host_bus`.
void check_embedded(const EmbeddedOptions& options, const std::string& host_bus);

class EmbeddedNetwork {
 public:
  /// All arguments must outlive this. Throws Failure if the bus cannot be opened.
  EmbeddedNetwork(host::EventLoop& loop, Node& module, const EmbeddedOptions& options);
  EmbeddedNetwork(const EmbeddedNetwork&) = delete;
  EmbeddedNetwork& operator=(const EmbeddedNetwork&) = delete;

  RemoteAccess& access() { return access_; }

 private:
  /// Listener on that bus.
  struct Ear {
    RemoteAccess& access;
    void receive(const Frame& frame, Time now) { access.receive_embedded(frame, now); }
  };

  std::unique_ptr<host::HostBus> bus_;
  host::Attachment attachment_;
  std::array<RemoteChannel, 1> channels_;
  RemoteAccess access_;
  Ear ear_{access_};
};

}  // namespace canvoy::tools
