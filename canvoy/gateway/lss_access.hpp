// Layer setting services of a client, one at a time on a network (CiA 309-1; CiA 305).
//
//     LssAccess lss(node);
//     lss.begin(operation);
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "canvoy/canopen/lss/lss_fastscan.hpp"
#include "canvoy/gateway/operation.hpp"

namespace canvoy::gateway {

class LssAccess {
 public:
  /// Makes the service; `node` must outlive it and needs a route.
  explicit LssAccess(Node& node) : node_(node), master_(node) {}

  /// Begins a command. False if it is not a command of LSS. Commands are served in the order in
  /// which they begin.
  bool begin(Operation& operation);
  /// Begins the next command if one has ended. Must not be called from a callback of the node,
  /// where that command may not have ended completely.
  void go_on();
  /// Cancels an operation. False if it is not under way.
  bool cancel(Operation& operation);
  /// Answers all operations that are under way.
  void fail_all(const Answer& answer);

 private:
  bool start();
  bool configure_node_id();
  bool inquire();
  bool find();
  bool answer_at_once(bool sent);
  void replied(const LssMaster::Reply& reply);
  void inquired(const LssMaster::Reply& reply);
  void found(const LssFastscan::Result& result);
  void finish(const Answer& answer);

  Node& node_;
  LssMaster master_;
  std::optional<LssFastscan> fastscan_;
  std::deque<Operation*> waiting_;
  Operation* current_ = nullptr;
  std::size_t part_ = 0;  ///< part of the address that is being inquired
  std::string parts_;     ///< parts received so far
};

}  // namespace canvoy::gateway
