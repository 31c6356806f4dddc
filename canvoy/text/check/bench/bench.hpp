// The bench on which a device is tested: an SDO client, an NMT master and a listener, which wait
// for answers and restore what they have changed.
//
//     Bench bench(line, 5);
//     Reply type = bench.read(0x1000, 0);
//     bench.set(0x1017, 0, 100, 2);               // put back by restore()
//     std::vector<Heard> came = bench.listen(1s);
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/text/check/bench/line.hpp"

namespace canvoy::formats {
struct DataSheet;
}
namespace canvoy {
struct Profile;
}

namespace canvoy::conformance {

/// Bytes of an SDO transfer.
using Bytes = std::vector<std::uint8_t>;

/// Answer of a device to a read or a write.
struct Reply {
  /// Result of a request.
  enum class Kind : std::uint8_t {
    done,
    aborted,
    silent,     ///< no answer in time, or the bus did not accept the request
    malformed,  ///< an answer that does not fit the request
  };
  /// Result of the request.
  Kind kind = Kind::done;
  /// Abort code, if the kind is `aborted`.
  AbortCode abort = AbortCode::none;
  /// Value of a read, if the kind is `done`.
  Bytes value = {};

  explicit operator bool() const { return kind == Kind::done; }
  /// True if the device has aborted with this code.
  bool has_aborted(AbortCode code) const { return kind == Kind::aborted && abort == code; }
  /// True if the entry does not exist.
  bool is_absent() const { return kind == Kind::aborted && canvoy::is_absent(abort); }
  /// The number in the first eight bytes, little-endian.
  std::uint64_t number() const;
  /// `abort 06010002h: ...`, `no answer`, `04 00`
  std::string text() const;
};

/// A request to a person at the device.
struct HandRequest {
  std::string_view words = {};  ///< `press push-button 1 of cluster 1`, `indicator 1 is lit`
  bool is_question = false;     ///< a question instead of an action
};
/// Answer to a request to a person.
enum class HandAnswer : std::uint8_t {
  done,    ///< of a question: yes
  no,      ///< of a question: no
  cannot,  ///< not possible
};

/// Permissions of the test, and what is known about the device.
struct BenchOptions {
  Duration time_out = 1s;                     ///< time limit for an answer
  bool moves = false;                         ///< objects of the application may be written
  bool stores = false;                        ///< non-volatile data may change
  const formats::DataSheet* sheet = nullptr;  ///< null: none
  const Profile* profile = nullptr;           ///< null: the profile of the device is unknown
  /// Passes a request or a question to a person at the device. Empty: none is present.
  std::function<HandAnswer(const HandRequest&)> hand = {};
};

/// A further participant of the bench while it waits: a listener, or a node that the test plays.
struct Player {
  std::function<void(const Heard&)> hears = {};  ///< called with each received frame; may be empty
  std::function<Time()> due = {};                ///< time of the next action; may be empty
  std::function<void(Time)> act = {};  ///< called when `due`; then `due` must give a later time
};

class Bench {
 public:
  /// Tests the device with this node-ID, 1 to 127.
  Bench(Line line, NodeId node, BenchOptions options);

  /// Node-ID of the device, 1 to 127.
  NodeId node() const { return node_; }
  /// Permissions of the test.
  const BenchOptions& options() const { return options_; }
  /// Time of the line.
  Time now() const { return line_.now(); }
  /// True if the bus has not accepted a frame, or the test was interrupted.
  bool is_broken() const { return is_broken_; }
  /// True if the test was asked to end.
  bool is_interrupted() const { return line_.is_interrupted && line_.is_interrupted(); }
  /// Starts the restore phase: changes are undone, and a request to end waits for it.
  void go_on();

  /// Sends a frame; on failure, is_broken() becomes true.
  void send(const Frame& frame);
  /// Sends an NMT command to the device.
  void command(NmtCommand command) { command_node(command, node_); }
  /// Sends an NMT command to another node; 0: to all.
  void command_node(NmtCommand command, NodeId node);
  /// Collects all frames from now on for this time.
  std::vector<Heard> listen(Duration duration);
  /// Waits for the first frame with this CAN-ID, data or remote, from now on.
  std::optional<Heard> await(std::uint32_t id, Duration duration);
  /// Discards all received frames.
  void drain();
  /// Adds a participant until leave(); it must not move meanwhile.
  void join(const Player& player) { players_.push_back(&player); }
  /// Removes a participant.
  void leave(const Player& player) { std::erase(players_, &player); }

  /// Sends eight bytes to the default SDO server, missing bytes as 0, and returns its answer.
  std::optional<Frame> ask(std::span<const std::uint8_t> request);
  /// Reads the value of an entry, expedited or in segments.
  Reply read(std::uint16_t index, std::uint8_t sub);
  /// Writes an entry, expedited if it has 1 to 4 bytes, else in segments with its size.
  Reply write(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  /// Writes the lowest `bytes` of a number, 1 to 8.
  Reply write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t bytes);
  /// Like write(), but restore() writes back the previous value.
  Reply set(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t bytes);
  /// Makes restore() write the present value, without an error if the device refuses it.
  void keep(std::uint16_t index, std::uint8_t sub);
  /// The number in an entry of at most four bytes.
  std::optional<std::uint32_t> number(std::uint16_t index, std::uint8_t sub);
  /// True if the entry exists; requested once.
  bool has(std::uint16_t index, std::uint8_t sub = 0);

  /// True if the device answers SDO requests; waits no longer than a state takes to appear.
  bool has_services_by_sdo();

  /// Notes that a case has stored or restored the parameters of this sub-index of 1010h: they are
  /// stored again at the end.
  void note_stored(std::uint8_t group) { stored_ = group; }
  /// The last noted sub-index.
  std::optional<std::uint8_t> stored() const { return stored_; }

  /// Writes back what set() has changed, in reverse order. unrestored() lists what failed; after an
  /// interruption, the rest is left for the next call.
  void restore();
  /// Entries that were not restored, as `1017h:00h`; empty: none.
  const std::vector<std::string>& unrestored() const { return unrestored_; }
  /// Requests the state by node guarding, or waits for a heartbeat.
  std::optional<NmtState> state();
  /// Sets up error control that gives the state every 50 ms, if possible: a heartbeat, else node
  /// guarding. False if the device has neither.
  bool watch_state();

  /// The last frames since forget(), in both directions.
  const std::deque<Heard>& frames() const { return frames_; }
  /// Clears the frames at the start of a case.
  void forget() {
    frames_.clear();
    is_held_ = false;
  }
  /// Keeps the present frames and records no others until forget().
  void hold() { is_held_ = true; }

 private:
  /// True if the test was interrupted.
  bool is_cut() const { return is_broken_ && !is_refused_; }
  static constexpr std::size_t frames_max = 48;
  static constexpr std::size_t value_max = 100'000;
  struct Changed {
    /// Index of the written entry.
    std::uint16_t index;
    /// Sub-index of the written entry.
    std::uint8_t sub;
    /// Previous value.
    Bytes before;
    bool may_be_refused = false;  ///< a failure is no error
  };

  std::optional<Heard> take(Time until);
  Time next_of_players(Time until) const;
  bool let_players_act();
  void note(const Heard& heard);
  Reply read_segments(std::uint32_t announced, bool has_size);
  Reply write_segments(std::span<const std::uint8_t> value);

  Line line_;
  NodeId node_;
  BenchOptions options_;
  std::deque<Heard> frames_;
  std::vector<const Player*> players_;
  std::vector<Changed> changed_;
  std::vector<std::string> unrestored_;
  std::map<std::uint32_t, bool> known_;
  std::optional<std::uint8_t> stored_;
  bool is_broken_ = false;
  bool is_refused_ = false;  ///< the bus has not accepted a frame
  bool goes_on_ = false;     ///< continues after an interruption
  bool is_held_ = false;
};

}  // namespace canvoy::conformance
