// The desk at which a device is tried: an SDO client, an NMT master and a listener, which wait for
// what they have asked for, and put back what they have changed.
//
//     Bench bench(line, 5);
//     Reply type = bench.read(0x1000, 0);
//     bench.set(0x1017, 0, 100, 2);               // put back by restore()
//     std::vector<Heard> came = bench.listen(1s);
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"
#include "canvoy/words/check/line.hpp"

namespace canvoy::formats {
struct DataSheet;
}
namespace canvoy {
struct Profile;
}

namespace canvoy::conformance {

/// As they stand in an SDO transfer.
using Bytes = std::vector<std::uint8_t>;

/// What a device has answered to a read or a write.
struct Reply {
  /// How a request ended.
  enum class Kind : std::uint8_t {
    done,
    aborted,
    silent,     ///< no answer in time, or the bus did not take the request
    malformed,  ///< an answer that is none to this request
  };
  /// How it ended.
  Kind kind = Kind::done;
  /// Of `aborted`.
  AbortCode abort = AbortCode::none;
  /// Of a read that is `done`.
  Bytes value = {};

  explicit operator bool() const { return kind == Kind::done; }
  /// Whether the device has refused with this code.
  bool has_aborted(AbortCode code) const { return kind == Kind::aborted && abort == code; }
  /// There is no such entry.
  bool is_absent() const { return kind == Kind::aborted && canvoy::is_absent(abort); }
  /// Little-endian, of the first eight bytes.
  std::uint64_t number() const;
  /// `abort 06010002h: ...`, `no answer`, `04 00`
  std::string text() const;
};

/// What the test is allowed, and what is known of the device.
struct BenchOptions {
  Duration time_out = 1s;                     ///< for an answer
  bool moves = false;                         ///< objects of the application may be written
  const formats::DataSheet* sheet = nullptr;  ///< null: none is given
  const Profile* profile = nullptr;           ///< null: the device's is not known
};

class Bench {
 public:
  /// Of the device with this node-ID, 1 to 127.
  Bench(Line line, NodeId node, const BenchOptions& options);

  /// Of the device, 1 to 127.
  NodeId node() const { return node_; }
  /// What the test is allowed.
  const BenchOptions& options() const { return options_; }
  /// The time of the line.
  Time now() const { return line_.now(); }
  /// The bus has not taken a frame, or somebody has interrupted the test.
  bool is_broken() const { return is_broken_; }
  /// Whether somebody has asked it to end.
  bool is_interrupted() const { return line_.is_interrupted && line_.is_interrupted(); }
  /// From here on what was changed is put back, and who asks to end waits for it.
  void go_on();

  /// Puts a frame on the bus; where that does not go, is_broken().
  void send(const Frame& frame);
  /// An NMT command for the device.
  void command(NmtCommand command) { command_node(command, node_); }
  /// One for another node; 0: for all.
  void command_node(NmtCommand command, NodeId node);
  /// All that comes from now on.
  std::vector<Heard> listen(Duration duration);
  /// The first frame with this CAN-ID, data or remote, from now on.
  std::optional<Heard> await(std::uint32_t id, Duration duration);
  /// What came before is forgotten.
  void drain();

  /// Eight bytes to the default SDO server, those that are not given are 0, and its answer.
  std::optional<Frame> ask(std::span<const std::uint8_t> request);
  /// The value of an entry, in one frame or in segments.
  Reply read(std::uint16_t index, std::uint8_t sub);
  /// Expedited where it has 1 to 4 bytes, else in segments with its size.
  Reply write(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  /// The lowest `bytes` of a number, 1 to 8.
  Reply write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t bytes);
  /// The same, and restore() writes back what was there.
  Reply set(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t bytes);
  /// The number that is there, of at most four bytes.
  std::optional<std::uint32_t> number(std::uint16_t index, std::uint8_t sub);
  /// Whether there is such an entry; asked once.
  bool has(std::uint16_t index, std::uint8_t sub = 0);

  /// Whether SDO is answered; waits no longer than a state takes to show.
  bool has_services_by_sdo();

  /// Writes back what set() has changed, the last first. What could not be is told by unrestored();
  /// where somebody interrupts it, the rest is for the next time.
  void restore();
  /// `1017h:00h` each; empty: all is as it was.
  const std::vector<std::string>& unrestored() const { return unrestored_; }
  /// Asks for the state by node guarding, or listens for a heartbeat.
  std::optional<NmtState> state();
  /// Error control that tells the state every 50 ms, where the device can: a heartbeat, else node
  /// guarding. False where it has neither.
  bool watch_state();

  /// Frames since the last forget(), both ways: the last of them.
  const std::deque<Heard>& frames() const { return frames_; }
  /// Of a case that begins.
  void forget() {
    frames_.clear();
    is_held_ = false;
  }
  /// What was heard stays, and what comes is not kept: until forget().
  void hold() { is_held_ = true; }

 private:
  /// Somebody has interrupted it.
  bool is_cut() const { return is_broken_ && !is_refused_; }
  static constexpr std::size_t frames_max = 48;
  static constexpr std::size_t value_max = 100'000;
  struct Changed {
    /// Of what was written.
    std::uint16_t index;
    /// Of the same.
    std::uint8_t sub;
    /// What was there.
    Bytes before;
  };

  std::optional<Heard> take(Time until);
  void note(const Heard& heard);
  Reply read_segments(std::uint32_t announced, bool has_size);
  Reply write_segments(std::span<const std::uint8_t> value);

  Line line_;
  NodeId node_;
  BenchOptions options_;
  std::deque<Heard> frames_;
  std::vector<Changed> changed_;
  std::vector<std::string> unrestored_;
  std::map<std::uint32_t, bool> known_;
  bool is_broken_ = false;
  bool is_refused_ = false;  ///< the bus has not taken a frame
  bool goes_on_ = false;     ///< after an interruption
  bool is_held_ = false;
};

}  // namespace canvoy::conformance
