// Finds the addresses of all slaves that take part in Fastscan, and leaves them in state waiting
// (CiA 305).
//
// A waiting slave evaluates each message alone: it answers if its upper bits, in the part that it
// has reached, equal those of the request. Both values of a bit can thus be requested, one after
// the other, and the addresses form a tree of which each branch with an answer is walked: zeros
// first, and back to the last position where both were answered. No slave enters state
// configuration, which takes a message for the last part that returns to an earlier one.
//
//     LssTree tree(node, master, options);
//     tree.begin(pattern, fastscan.pace(), LssTree::Done::to<&Tool::found>(tool));
#pragma once

#include "canvoy/canopen/lss/lss_fastscan.hpp"

namespace canvoy {

/// A walk takes two messages a bit, one of them without an answer: LssFastscan is faster, and is
/// for slaves that follow CiA 305. If a branch ends before its last bit, or an address has no
/// slave, all is walked again with longer time-outs. The number of walks is limited, and so is the
/// number of messages.
class LssTree {
 public:
  /// An address of a slave, or the end.
  using Result = LssFastscan::Result;
  /// How a walk goes on, or ended.
  using Outcome = LssFastscan::Outcome;
  /// Called with each address, and at the end.
  using Done = LssFastscan::Done;

  /// Makes a tree. `node` is that of `master`; both must outlive it.
  LssTree(Node& node, LssMaster& master, const LssFastscan::Options& options);
  LssTree(const LssTree&) = delete;
  LssTree& operator=(const LssTree&) = delete;

  /// Begins a walk. `done` is called with each address found, and next() or pass_over() continues
  /// from it, at once or later; at the end it is called with `nobody`, or with `lost` if the tree
  /// still contradicts itself. An address may be found again in a later walk.
  void begin(const LssPattern& pattern, const LssPace& pace, Done done);
  /// True from begin() until the end or cancel().
  bool walking() const { return walking_; }
  /// Goes on to the next address, after a call of `done` with one.
  void next();
  /// Like next(), but for an address found that no slave has.
  void pass_over();
  /// Stops the walk, without a call of `done`. A service of the master is left to its owner.
  void cancel();

 private:
  using Step = void (LssTree::*)(const LssMaster::Reply&);

  void walk();
  void walk_again();
  void seek();
  void anybody_answered(const LssMaster::Reply& reply);
  void go_down();
  void part_answered(const LssMaster::Reply& reply);
  void descend();
  void zero_answered(const LssMaster::Reply& reply);
  void one_answered(const LssMaster::Reply& reply);
  void address_answered(const LssMaster::Reply& reply);

  void ask(Step step, const lss::FastscanRequest& request, Duration time_out, Duration settle);
  void ask(Step step, const lss::FastscanRequest& request);
  void unsent(Time);
  void take_reply(const LssMaster::Reply& reply);
  void finish(Outcome outcome);
  bool is_at_root() const;

  Node& node_;
  LssMaster& master_;
  LssFastscan::Options options_;
  Timer retry_;
  LssPattern pattern_;
  LssPace pace_;
  Done done_;
  Step step_ = nullptr;  ///< handles the next reply
  LssAddress address_;   ///< known part; all other bits are zero
  /// Bits where ones were answered too, and wait for their walk.
  std::array<std::uint32_t, 4> ones_{};
  std::uint8_t part_ = 0;
  std::uint8_t bit_ = 0;    ///< lowest known bit of this part
  std::uint8_t place_ = 0;  ///< part requested from slaves that match all parts before it
  std::uint8_t walks_ = 0;
  std::uint8_t passed_over_ = 0;
  bool zero_answered_ = false;
  bool is_doubtful_ = false;  ///< in this walk an address was passed over, or a request not sent
  bool walking_ = false;
};

}  // namespace canvoy
