// Layer setting services of a client (CiA 309-1; CiA 305): one at a time on a network.
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
  explicit LssAccess(Node& node) : node_(node), master_(node) {}
  LssAccess(const LssAccess&) = delete;
  LssAccess& operator=(const LssAccess&) = delete;

  /// False where the command is none of LSS. Commands are served in the order in which they begin.
  bool begin(Operation& operation);
  /// Begins the next command where one has ended; not from a callback of the node, where that one
  /// may still be at its end.
  void go_on();
  /// False where the operation is none of those under way.
  bool cancel(Operation& operation);
  /// Answers all that are under way.
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
  std::size_t part_ = 0;  ///< of an address that is inquired
  std::string parts_;     ///< that came
};

}  // namespace canvoy::gateway
