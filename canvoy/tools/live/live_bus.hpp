// A real bus that people look at; nothing is sent but what they ask for.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/tools/live/heard_nodes.hpp"
#include "canvoy/tools/live/live_network.hpp"

namespace canvoy::tools {

class LiveBus : public LiveNetwork {
 public:
  /// `record`: the path of a log; empty: none. Throws Failure where the bus cannot be opened.
  LiveBus(const std::string& address, std::string record, const FramePrinterOptions& options,
          WritePermission permission, host::EventLoop& loop);
  ~LiveBus() override;

  Json description() override;
  void begin_log() override;
  void advance(Time clock) override;
  Json state() override;
  void act(std::string_view what, const Json& arguments, const Done& done) override;
  int finish() override;

 protected:
  void request(const BusRequest& request, const SdoDesk::Done& done) override;
  Duration epoch() const override { return loop_.epoch(); }

 private:
  void hear(const host::BusFrame& heard);

  host::EventLoop& loop_;
  std::unique_ptr<host::HostBus> bus_;
  host::Attachment attachment_;
  SdoDesk desk_;
  HeardNodes nodes_;
  std::string record_;
  std::optional<host::CandumpWriter> log_;
  std::optional<std::string> failure_;
  std::string trouble_;
};

}  // namespace canvoy::tools
