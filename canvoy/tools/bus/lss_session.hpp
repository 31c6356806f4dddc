// A tool as LSS master on a real bus: it asks, and waits.
//
//     LssSession session("can0", 1s);
//     session.select(address);
//     session.configure_node_id(10);
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string_view>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy::tools {

/// All throw Failure where nobody answers, or the answer is a refusal.
class LssSession {
 public:
  LssSession(std::string_view bus, Duration time_out);
  ~LssSession();

  void switch_global(LssState state);
  void select(const LssAddress& address);
  /// Of those in state configuration: what is said next would be said to all of them.
  void require_one_node();
  LssAddress inquire_address();
  NodeId inquire_node_id();
  void configure_node_id(NodeId id);
  void configure_bit_timing(std::uint8_t index);
  void activate_bit_timing(Duration delay);
  /// Lets the bus go on for so long; throws Failure on a signal.
  void wait(Duration duration);
  void store();
  /// Whether anybody has this address.
  bool identify(const LssAddress& address);
  bool identify_unconfigured();

  struct ScanCalls {
    LssScan::Choose choose;
    LssScan::Report found;
    std::function<void()> passed = {};  ///< each second that it takes
  };
  /// What ended it: also a signal, as Failure.
  LssScan::Outcome scan(const LssScan::Options& options, const LssFastscan::Options& timing,
                        const ScanCalls& calls);
  /// In the last scan: see LssScan.
  bool came_again() const { return came_again_; }

 private:
  LssMaster::Reply ask(const std::function<bool(LssMaster::Done)>& begin);
  LssMaster::Reply ask_or_throw(lss::Command command,
                                const std::function<bool(LssMaster::Done)>& begin);
  void send(const std::function<bool()>& begin);
  void run_until_stopped();
  void finished(const LssMaster::Reply& reply);

  Duration time_out_;
  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<host::HostBus> bus_;
  std::unique_ptr<host::Attachment> attachment_;
  std::array<Router::Route, 1 + LssMaster::routes> routes_{};
  std::array<Frame, 16> backlog_{};
  std::unique_ptr<Node> node_;
  std::unique_ptr<LssMaster> master_;
  LssMaster::Reply reply_;
  bool came_again_ = false;
  unsigned answers_ = 0;  ///< of LSS slaves that were heard, wanted or not
};

}  // namespace canvoy::tools
