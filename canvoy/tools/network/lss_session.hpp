// An LSS master on a real bus: it sends requests and waits for answers.
//
//     LssSession session("can0", {});
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
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/tools/argument/answer_time.hpp"

namespace canvoy::tools {

/// All functions throw Failure if no answer comes, or the answer is a refusal.
class LssSession {
 public:
  LssSession(std::string_view bus, AnswerTime time_out);
  ~LssSession();

  void switch_global(LssState state);
  void select(const LssAddress& address);
  /// Requires one node in state configuration: further commands go to all nodes in that state.
  void require_one_node();
  LssAddress inquire_address();
  NodeId inquire_node_id();
  void configure_node_id(NodeId id);
  void configure_bit_timing(std::uint8_t index);
  void activate_bit_timing(Duration delay);
  /// Runs the bus for this time; throws Failure on a signal.
  void wait(Duration duration);
  void store();
  /// True if a node has this address.
  bool identify(const LssAddress& address);
  bool identify_unconfigured();

  struct ScanCalls {
    LssScan::Choose choose;
    LssScan::Report found;
    std::function<void()> passed = {};  ///< called each second
  };
  /// Runs a scan and returns its outcome; a signal throws Failure.
  LssScan::Outcome scan(const LssScan::Options& options, const LssFastscan::Options& timing,
                        const ScanCalls& calls);
  /// True if an address came again in the last scan: see LssScan.
  bool came_again() const { return came_again_; }

 private:
  LssMaster::Reply ask(const std::function<bool(LssMaster::Done)>& begin);
  LssMaster::Reply ask_or_throw(lss::Command command,
                                const std::function<bool(LssMaster::Done)>& begin);
  void send(const std::function<bool()>& begin);
  void run_until_stopped();
  void finished(const LssMaster::Reply& reply);

  AnswerTime time_out_;
  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<host::HostBus> bus_;
  std::unique_ptr<host::Attachment> attachment_;
  std::array<Router::Route, 1 + LssMaster::routes> routes_{};
  std::array<Frame, 16> backlog_{};
  std::unique_ptr<Node> node_;
  std::unique_ptr<LssMaster> master_;
  LssMaster::Reply reply_;
  bool came_again_ = false;
  unsigned answers_ = 0;  ///< number of LSS answers heard, expected or not
};

}  // namespace canvoy::tools
