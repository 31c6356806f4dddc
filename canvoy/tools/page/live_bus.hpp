// A real bus for viewers; only what they request is sent.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/tools/page/heard_nodes.hpp"
#include "canvoy/tools/page/live_network.hpp"
#include "canvoy/tools/page/trend.hpp"
#include "canvoy/tools/watch/log_writer.hpp"

namespace canvoy::tools {

class LiveBus : public LiveNetwork {
 public:
  /// `record`: path of a log; empty: none. Throws Failure if the bus cannot be opened.
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
  void request(const BusRequest& request, const SdoRequests::Done& done) override;
  Duration epoch() const override { return loop_.epoch(); }

 private:
  void hear(const host::BusFrame& heard);
  /// Adds an event of the bus itself: `the bus is back`.
  void tell(std::string_view event, const std::string& text);
  /// Once a second: the rate of frames, and what has gone silent or was lost.
  void look_back();

  host::EventLoop& loop_;
  std::unique_ptr<host::HostBus> bus_;
  host::Attachment attachment_;
  SdoRequests desk_;
  HeardNodes nodes_;
  std::string record_;
  std::optional<LogWriter> log_;
  std::optional<std::string> failure_;
  std::string trouble_;
  Trend trend_;  ///< by the time of the loop
  std::uint64_t heard_ = 0;
  std::uint64_t counted_ = 0;  ///< of heard_, at counted_at_
  Time counted_at_{};
  double frames_per_second_ = 0;
  std::uint64_t lost_ = 0;  ///< reported as events
};

}  // namespace canvoy::tools
