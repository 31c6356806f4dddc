// LSS Fastscan: finds one of many unknown nodes without node-ID (CiA 305).
//
// The address is found bit by bit: each node with the bits so far and a zero next answers; silence
// until the time-out means a one. The time-out thus determines the speed. It is measured at the
// first answers, like the time from the fastest to the slowest of them, for which the next request
// must wait; both grow if they were too short, and for the last remaining node, its own time
// counts. The previous address is tried first, since nodes of one kind differ in their last part
// only.
//
//     LssFastscan fastscan(node, master);
//     fastscan.find({}, LssFastscan::Done::to<&Tool::found>(tool));
#pragma once

#include "canvoy/canopen/lss/lss_master.hpp"

namespace canvoy {

/// Known parts of the address to find.
struct LssPattern {
  LssAddress address;           ///< values of the known parts
  std::array<bool, 4> known{};  ///< parts that count
};

/// Time to wait for answers: the measured time, with a margin.
struct LssPace {
  Duration time_out{};         ///< for one answer
  Duration settle{};           ///< from one answer to the next request
  Duration recent_time_out{};  ///< time that would have sufficed since the last relax()
  Duration recent_settle{};    ///< the same for `settle`

  /// Learns from the times of an answer. Neither time grows beyond `max`.
  void measure(const LssMaster::Reply& reply, Duration max);
  /// Notes that the measured time was too short.
  void lengthen(Duration max);
  /// Goes back towards the time that would have sufficed lately, by half of the difference at most:
  /// a delay may be over, for example on a bus with much traffic for a while.
  void relax(Duration time_out_min);
};

/// Finds one node at most in each run, and leaves it in state configuration. A wrong bit, after a
/// lost frame or a late answer, shows in an unconfirmed address, and is searched again with a
/// longer time-out.
class LssFastscan {
 public:
  /// Bounds of the times, and of the effort of one run.
  struct Options {
    Duration first_time_out = 100ms;  ///< for the very first answer, before any measurement
    Duration time_out_min = 5ms;      ///< for each bit
    Duration time_out_max = 1s;       ///< limit of both times
    std::uint8_t attempts_max = 6;    ///< for one run, until the address is confirmed
  };
  /// How a run ended.
  enum class Outcome : std::uint8_t {
    found,
    nobody,  ///< no node takes part, or none with this pattern
    /// A node answered, but its address was not confirmed, or it fell silent; or the controller was
    /// full for so long that no node could be asked.
    lost,
  };
  /// What a run found.
  struct Result {
    Outcome outcome = Outcome::nobody;  ///< how it ended
    LssAddress address;                 ///< if found, or lost at its end
    bool duplicate = false;             ///< several nodes answered to this address
    bool checked = false;               ///< a node also answered to its address in another service
  };
  /// Called at the end of a run; may start the next.
  using Done = Callback<void(const Result&)>;

  /// Makes a search with default options. Both must outlive it.
  LssFastscan(Node& node, LssMaster& master);
  /// Makes a search. `node` is that of `master`; both must outlive it.
  LssFastscan(Node& node, LssMaster& master, const Options& options);
  LssFastscan(const LssFastscan&) = delete;
  LssFastscan& operator=(const LssFastscan&) = delete;

  /// Starts a run. False if a run or a service of the master is under way. No other service may
  /// begin until `done` was called. With other slaves in state configuration the address of the
  /// node cannot be inquired: "identify remote slave" checks it, if the node supports that.
  bool find(const LssPattern& pattern, Done done, bool others_in_configuration = false);
  /// True while a run is under way.
  bool running() const { return running_; }
  /// Stops the run, without a call of `done`.
  void cancel();

  /// Measured time-out of one bit.
  Duration time_out() const { return pace_.time_out; }
  /// Measured times; kept from run to run.
  const LssPace& pace() const { return pace_; }
  /// Number of messages sent since construction, without those of the last check.
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
  LssAddress guess_;               ///< the address found before
  std::array<bool, 4> guessed_{};  ///< parts of it to try first
  Step step_ = nullptr;            ///< handles the next reply
  LssPace pace_;
  Duration alone_latency_{};  ///< of the last remaining node
  std::uint32_t requests_ = 0;
  std::uint32_t number_ = 0;  ///< bits of this part so far
  std::uint8_t part_ = 0;
  std::uint8_t bit_ = 0;
  std::uint8_t silences_ = 0;
  std::uint8_t unsent_ = 0;  ///< questions whether any slave is there that were not sent
  std::uint8_t attempts_ = 0;
  std::uint8_t checks_ = 0;
  bool measured_ = false;
  bool alone_ = false;  ///< only one node has all bits so far
  bool trying_guess_ = false;
  bool confirmed_ = false;  ///< of the part that was found last
  bool running_ = false;
  bool others_in_configuration_ = false;
};

}  // namespace canvoy
