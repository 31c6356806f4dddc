// LSS Fastscan: finds one of many nodes without node-ID that nobody knows (CiA 305).
//
// The address is found bit by bit: whoever has the bits so far and a zero next answers; silence
// until the time-out means a one. So the time-out decides on speed. It is measured at the first
// answers, as is the time from the fastest of them to the slowest, for which the next request has
// to wait; both grow where they were too short, and when one node is left, its own time counts.
// What was found before is tried first, since nodes of one kind differ in their last part only.
//
//     LssFastscan fastscan(node, master);
//     fastscan.find({}, LssFastscan::Done::to<&Tool::found>(tool));
#pragma once

#include "canvoy/canopen/lss/lss_master.hpp"

namespace canvoy {

/// What is known of the address that is looked for.
struct LssPattern {
  LssAddress address;
  std::array<bool, 4> known{};  ///< parts of it that count
};

/// How long answers are waited for: as long as they were measured to take, with a margin.
struct LssPace {
  Duration time_out{};         ///< for one answer
  Duration settle{};           ///< from one answer to the next request
  Duration recent_time_out{};  ///< what would have done since the last relax()
  Duration recent_settle{};

  void measure(const LssMaster::Reply& reply, Duration max);
  /// What was measured was too short.
  void lengthen(Duration max);
  /// Goes back to what would have done lately, by half of the way at most: what took long may be
  /// over, as on a bus on which all had much to say at once.
  void relax(Duration time_out_min);
};

/// One run finds one node at most, and leaves it in state configuration. A bit that went wrong, for
/// a lost frame or a late answer, is noticed since nobody confirms the address, and is looked for
/// again with a longer time-out.
class LssFastscan {
 public:
  struct Options {
    Duration first_time_out = 100ms;  ///< for the first answer of all, before anything is measured
    Duration time_out_min = 5ms;      ///< for each bit
    Duration time_out_max = 1s;
    std::uint8_t attempts_max = 6;  ///< of one run, until the address is confirmed
  };
  enum class Outcome : std::uint8_t {
    found,
    nobody,  ///< no node takes part, or none of this pattern
    lost,    ///< there was one, but its address was not confirmed, or it fell silent
  };
  struct Result {
    Outcome outcome = Outcome::nobody;
    LssAddress address;
    bool duplicate = false;  ///< several nodes answered that they have this address
    bool checked = false;    ///< a node answered to its address otherwise than by Fastscan, too
  };
  using Done = Callback<void(const Result&)>;

  LssFastscan(Node& node, LssMaster& master);
  LssFastscan(Node& node, LssMaster& master, const Options& options);
  LssFastscan(const LssFastscan&) = delete;
  LssFastscan& operator=(const LssFastscan&) = delete;

  /// False where a run or a service of the master is under way. No other service may begin until
  /// `done` was called. With others in state configuration the address cannot be inquired of the
  /// node that was found: "identify remote slave" checks it, where the node supports that.
  bool find(const LssPattern& pattern, Done done, bool others_in_configuration = false);
  bool running() const { return running_; }
  /// Gives up, without a call of `done`.
  void cancel();

  /// For one bit, as it was measured.
  Duration time_out() const { return pace_.time_out; }
  const LssPace& pace() const { return pace_; }
  /// Messages that were sent since construction, those of the last check left out.
  std::uint32_t requests() const { return requests_; }

 private:
  using Step = void (LssFastscan::*)(const LssMaster::Reply&);

  void begin_anew();
  void ask_anybody();
  void anybody_answered(const LssMaster::Reply& reply);
  void begin_part();
  void note_company(const LssMaster::Reply& reply);
  Duration next_time_out() const;
  Duration next_settle() const;
  void ask_bit();
  void bit_answered(const LssMaster::Reply& reply);
  void confirm();
  void part_confirmed(const LssMaster::Reply& reply);
  void not_confirmed();
  void check_address();
  void address_checked(const LssMaster::Reply& reply);
  void selected(const LssMaster::Reply& reply);

  void ask(const lss::FastscanRequest& request, Duration time_out, Duration settle);
  void give_up_request();
  void unsent(Time now);
  LssMaster::Done answered() { return LssMaster::Done::to<&LssFastscan::take_reply>(*this); }
  void take_reply(const LssMaster::Reply& reply);
  void finish(Outcome outcome);

  Node& node_;
  LssMaster& master_;
  Options options_;
  Done done_;
  Timer retry_;
  LssPattern pattern_;
  Result result_;
  LssAddress guess_;               ///< what was found before
  std::array<bool, 4> guessed_{};  ///< parts of it to try first
  Step step_ = nullptr;            ///< what is done with the next reply
  LssPace pace_;
  Duration alone_latency_{};  ///< of the one node that is left
  std::uint32_t requests_ = 0;
  std::uint32_t number_ = 0;  ///< bits of this part so far
  std::uint8_t part_ = 0;
  std::uint8_t bit_ = 0;
  std::uint8_t silences_ = 0;
  std::uint8_t attempts_ = 0;
  std::uint8_t checks_ = 0;
  bool measured_ = false;
  bool alone_ = false;  ///< one node is left that has all bits so far
  bool trying_guess_ = false;
  bool confirmed_ = false;  ///< the part that was found last
  bool running_ = false;
  bool others_in_configuration_ = false;
};

}  // namespace canvoy
