// LSS master: reads and changes node-IDs and bit rates of other nodes, one service at a time (CiA
// 305).
//
//     LssMaster master(node);
//     master.select(address, {});
//     ...
//     master.configure_node_id(10, LssMaster::Done::to<&Tool::configured>(tool));
#pragma once

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Addresses for LSS "identify remote slave": one vendor and product, and ranges with their ends.
struct LssRange {
  LssAddress low;
  LssAddress high;  ///< vendor-ID and product code equal those of `low`

  static constexpr LssRange exactly(const LssAddress& address) { return {address, address}; }
};

/// Services with an answer end with a call of `done`; each returns false, without that call, if
/// another one is under way or its messages could not be sent. `done` may begin the next service.
/// The master works in every NMT state of its node, and needs no node-ID.
///
/// Only one slave should be in state configuration, except for switch_global() and
/// activate_bit_timing(): the answers of several slaves have one CAN-ID, and destroy each other if
/// they differ.
class LssMaster {
 public:
  static constexpr std::size_t routes = 1;
  static constexpr Duration default_time_out = 1s;

  enum class Outcome : std::uint8_t {
    answered,
    refused,   ///< see `error`
    time_out,  ///< no answer
  };
  struct Reply {
    Outcome outcome = Outcome::time_out;
    LssError error;
    std::uint32_t value = 0;   ///< result of an inquiry
    std::uint8_t answers = 0;  ///< for fastscan(): number of answers, 255 at most
    Duration first_answer{};   ///< since the request
    Duration last_answer{};    ///< since the request

    bool ok() const { return outcome == Outcome::answered; }
  };
  using Done = Callback<void(const Reply&)>;

  explicit LssMaster(Node& node);
  LssMaster(const LssMaster&) = delete;
  LssMaster& operator=(const LssMaster&) = delete;

  /// Sets the time-out of later services, except fastscan().
  void set_time_out(Duration time_out) { time_out_ = time_out; }
  bool idle() const { return !busy_; }
  /// Stops the service that is under way, without a call of its `done`.
  void cancel();

  // Services without an answer: false if the message could not be sent.

  bool switch_global(LssState state);
  /// All slaves in state configuration are silent for 0 to 65535 ms, switch, and are silent again.
  /// The owner switches the master's own bit rate, see BitTimingSwitch.
  bool activate_bit_timing(Duration delay);

  // Services with one answer.

  /// Puts the slave with this address into state configuration.
  bool select(const LssAddress& address, Done done);
  bool configure_node_id(NodeId id, Done done);
  bool configure_bit_timing(std::uint8_t index, Done done, std::uint8_t table = 0);
  bool store(Done done);
  /// Inquires a part of the address; `part` is numbered as in LssAddress.
  bool inquire(std::size_t part, Done done);
  bool inquire_node_id(Done done);

  // Services that any number of slaves answer; the first answer counts.

  bool identify(const LssRange& range, Done done);
  bool identify_unconfigured(Done done);
  /// Sends a message of Fastscan. Ends `settle` after the first answer, so that late answers are
  /// not taken for answers to the next request; after `time_out` at the latest.
  bool fastscan(const lss::FastscanRequest& request, Duration time_out, Duration settle, Done done);

 private:
  bool send(lss::Command command, std::uint32_t value);
  bool send(const Frame& frame) { return node_.transmitter().send(frame); }
  bool ask(lss::Command command, std::uint32_t value, lss::Command answer, Done done);
  bool ask(const Frame& frame, lss::Command answer, Duration time_out, Duration settle, Done done);
  void wait(lss::Command answer, Duration time_out, Duration settle, Done done);
  void receive(const Frame& frame, Time now);
  void expired(Time now);
  void finish(Outcome outcome);

  Node& node_;
  Timer timer_;
  Done done_;
  Duration time_out_ = default_time_out;
  Time sent_at_{};
  Duration settle_{};
  Reply reply_;
  lss::Command expected_{};
  bool busy_ = false;
};

}  // namespace canvoy
