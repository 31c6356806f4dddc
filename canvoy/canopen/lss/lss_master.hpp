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
  LssAddress low;   ///< the lowest revision and serial number
  LssAddress high;  ///< vendor-ID and product code equal those of `low`

  /// Range with one address only.
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
  static constexpr std::size_t routes = 1;          ///< of the node, for the answers of slaves
  static constexpr Duration default_time_out = 1s;  ///< for an answer

  /// How a service ended.
  enum class Outcome : std::uint8_t {
    answered,
    refused,   ///< see `error`
    time_out,  ///< no answer
  };
  /// End of a service, with what the slave reported.
  struct Reply {
    Outcome outcome = Outcome::time_out;  ///< answered, refused or without an answer
    LssError error;                       ///< of the slave, if refused
    std::uint32_t value = 0;              ///< result of an inquiry
    std::uint8_t answers = 0;             ///< for fastscan(): number of answers, 255 at most
    Duration first_answer{};              ///< since the request
    Duration last_answer{};               ///< since the request

    /// True if the slave answered and did not refuse.
    bool ok() const { return outcome == Outcome::answered; }
  };
  /// Called once for each service that was begun.
  using Done = Callback<void(const Reply&)>;

  /// Makes a master; `node` must outlive it and needs one free route.
  explicit LssMaster(Node& node);
  LssMaster(const LssMaster&) = delete;
  LssMaster& operator=(const LssMaster&) = delete;

  /// Sets the time-out of later services, except fastscan().
  void set_time_out(Duration time_out) { time_out_ = time_out; }
  /// True if no service is under way.
  bool idle() const { return !busy_; }
  /// Stops the service that is under way, without a call of its `done`.
  void cancel();

  // Services without an answer: false if the message could not be sent.

  /// Puts all slaves into this state. The address of a selection is forgotten by them.
  bool switch_global(LssState state);
  /// All slaves in state configuration are silent for 0 to 65535 ms, switch, and are silent again.
  /// The owner switches the master's own bit rate, see BitTimingSwitch.
  bool activate_bit_timing(Duration delay);

  // Services with one answer.

  /// Puts the slave with this address into state configuration.
  bool select(const LssAddress& address, Done done);
  /// Gives a node-ID, 1 to 127 or node_id_unconfigured, to the slave in state configuration. It
  /// applies from its next NMT reset communication on; a node without one boots when it returns to
  /// waiting.
  bool configure_node_id(NodeId id, Done done);
  /// Gives a bit timing of `table`, 0 for that of CiA 305, to the slave in state configuration. It
  /// applies from activate_bit_timing() on.
  bool configure_bit_timing(std::uint8_t index, Done done, std::uint8_t table = 0);
  /// Has the slave in state configuration store node-ID and bit timing. May take as long as its
  /// flash.
  bool store(Done done);
  /// Inquires a part of the address; `part` is numbered as in LssAddress.
  bool inquire(std::size_t part, Done done);
  /// Inquires the node-ID of the slave in state configuration: the one in use, or FFh.
  bool inquire_node_id(Done done);

  // Services that any number of slaves answer; the first answer counts.

  /// Asks whether any slave has an address in the range; time_out if there is none.
  bool identify(const LssRange& range, Done done);
  /// Asks whether any slave has no node-ID; time_out if all have one.
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
