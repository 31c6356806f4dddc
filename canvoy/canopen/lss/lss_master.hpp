// LSS master: asks for and changes node-IDs and bit rates of others (CiA 305), one service at a
// time.
//
//     LssMaster master(node);
//     master.select(address, {});
//     ...
//     master.configure_node_id(10, LssMaster::Done::to<&Tool::configured>(tool));
#pragma once

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// Addresses that LSS "identify remote slave" looks for: one vendor and product, and ranges with
/// their ends.
struct LssRange {
  LssAddress low;
  LssAddress high;  ///< vendor-ID and product code are those of `low`

  static constexpr LssRange exactly(const LssAddress& address) { return {address, address}; }
};

/// Services with an answer end by a call of `done`; each returns false, and does not call it, while
/// another one is under way or where its messages could not be sent. `done` may begin the next
/// service. It works whatever the NMT state of its node is, and needs no node-ID.
///
/// In state configuration there should be one slave, but for switch_global() and
/// activate_bit_timing(): the answers of several have one CAN-ID, and destroy each other where they
/// differ.
class LssMaster {
 public:
  static constexpr std::size_t routes = 1;
  static constexpr Duration default_time_out = 1s;

  enum class Outcome : std::uint8_t {
    answered,
    refused,   ///< see `error`
    time_out,  ///< nobody answered
  };
  struct Reply {
    Outcome outcome = Outcome::time_out;
    LssError error;
    std::uint32_t value = 0;   ///< of an inquiry
    std::uint8_t answers = 0;  ///< of fastscan(): how many came, 255 at most
    Duration first_answer{};   ///< since the request
    Duration last_answer{};    ///< since the request

    bool ok() const { return outcome == Outcome::answered; }
  };
  using Done = Callback<void(const Reply&)>;

  explicit LssMaster(Node& node);
  LssMaster(const LssMaster&) = delete;
  LssMaster& operator=(const LssMaster&) = delete;

  /// For the services that begin from now on, but for fastscan().
  void set_time_out(Duration time_out) { time_out_ = time_out; }
  bool idle() const { return !busy_; }
  /// Gives up the service that is under way, without a call of its `done`.
  void cancel();

  // Without an answer: false where the message could not be sent.

  bool switch_global(LssState state);
  /// All slaves in state configuration are silent for 0 to 65535 ms, switch, and are silent again.
  /// The master's own bit rate is the owner's to switch, see BitTimingSwitch.
  bool activate_bit_timing(Duration delay);

  // With one answer.

  /// The slave of this address enters state configuration.
  bool select(const LssAddress& address, Done done);
  bool configure_node_id(NodeId id, Done done);
  bool configure_bit_timing(std::uint8_t index, Done done, std::uint8_t table = 0);
  bool store(Done done);
  /// `part` as LssAddress counts them.
  bool inquire(std::size_t part, Done done);
  bool inquire_node_id(Done done);

  // Answered by any number of slaves; the first answer counts.

  bool identify(const LssRange& range, Done done);
  bool identify_unconfigured(Done done);
  /// Ends `settle` after the first answer, so that those of slower slaves are not taken for answers
  /// to the next request; after `time_out` at the latest.
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
