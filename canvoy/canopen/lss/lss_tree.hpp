// Finds the addresses of all slaves that take part in Fastscan, and leaves them in state waiting
// (CiA 305).
//
// A waiting slave judges each message by itself: it answers where its upper bits are those that are
// asked for, in the part that it has got to. So both values of a bit can be asked for, one after
// the other, and the addresses are a tree of which each branch that answers is walked: zeros first,
// and back to the last place where both had answered. Nobody enters state configuration, which
// takes a message for the last part that goes back to an earlier one.
//
//     LssTree tree(node, master, options);
//     tree.begin(pattern, fastscan.pace(), LssTree::Done::to<&Tool::found>(tool));
#pragma once

#include "canvoy/canopen/lss/lss_fastscan.hpp"

namespace canvoy {

/// It takes two messages a bit, one of which nobody answers: LssFastscan is faster, and is for
/// slaves that do as CiA 305 says. Where a branch ends before its last bit, or an address is
/// nobody's, all is walked again with longer time-outs. How often is bounded, and so is the number
/// of messages.
class LssTree {
 public:
  using Result = LssFastscan::Result;
  using Outcome = LssFastscan::Outcome;
  using Done = LssFastscan::Done;

  LssTree(Node& node, LssMaster& master, const LssFastscan::Options& options);
  LssTree(const LssTree&) = delete;
  LssTree& operator=(const LssTree&) = delete;

  /// `done` is called with each address that is found, which goes on with next() or pass_over(), in
  /// it or later, and at last with `nobody`, or with `lost` where the tree contradicts itself
  /// still. An address may come again in a later walk.
  void begin(const LssPattern& pattern, const LssPace& pace, Done done);
  bool walking() const { return walking_; }
  void next();
  /// The same, where the address that was found last is nobody's.
  void pass_over();
  /// Gives up, without a call of `done`. A service of the master is left to its owner.
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
  void unsent(Time) { (this->*step_)({}); }
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
  Step step_ = nullptr;                  ///< what is done with the next reply
  LssAddress address_;                   ///< as far as it is known; all other bits are zero
  std::array<std::uint32_t, 4> ones_{};  ///< bits where ones answered, too, and wait for their walk
  std::uint8_t part_ = 0;
  std::uint8_t bit_ = 0;    ///< the lowest one that is known of this part
  std::uint8_t place_ = 0;  ///< the part that those who have all parts before it are asked for
  std::uint8_t walks_ = 0;
  std::uint8_t passed_over_ = 0;
  bool zero_answered_ = false;
  bool is_doubtful_ = false;  ///< an address was passed over in this walk
  bool walking_ = false;
};

}  // namespace canvoy
