// Judges a patrol by what is seen, heard and read, and by the keys that people press: never by what
// a device reports of itself.
//
//     referee.pressed({.client = Client::radio, .key = 3});   // a person
//     referee.acted({.client = Client::radio, .key = 3});
//     referee.judge(InvariantKind::siren, now, is_right);
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/missing_devices.hpp"
#include "canvoy/sim/wrong_time.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/crew.hpp"
#include "canvoy/worlds/police/invariant.hpp"

namespace canvoy::police {

class PoliceReferee {
 public:
  /// From a call to its report, without excused times.
  static constexpr Duration call_bound = 35min;

  /// A key was pressed for this client. Earlier keys of the same pad are over by then, and must
  /// have no further effect; except with `may_come_late`, as where a fault keeps the bus.
  void pressed(const KeyAction& key, bool may_come_late = false);
  /// A client has acted on a key.
  void acted(const KeyAction& action);
  /// Judges whether something is as it must be; call it in each step.
  void judge_unless(bool is_free, InvariantKind kind, Time now, bool is_right) {
    wrong_[index(kind)].judge_unless(is_free, now, is_right);
  }
  /// Like judge_unless(), but for a device.
  void judge_device_unless(bool is_free, NodeId id, Time now, bool is_there) {
    is_free ? missing_.pass(id, now) : missing_.judge(id, now, is_there);
  }
  /// A person waits since `since`; if that is `now`, there is none.
  void waits(Time now, Time since) {
    longest_wait_ = std::max(longest_wait_, now - since);
    if (since < now) ++waits_;
  }
  /// All devices sleep, and the bus is observed.
  void is_quiet() { ++quiet_; }
  /// A frame was sent while all devices sleep.
  void frame_asleep() { ++frames_asleep_; }
  /// Something is lacking to judge it: its verdict says so.
  void cannot_judge(InvariantKind kind) { undecided_[index(kind)] = true; }

  /// One for each kind, in their order; `calls` are judged by their ages.
  std::vector<Invariant> verdicts(std::span<const EmergencyCall> calls) const;

 private:
  Duration worst(InvariantKind kind) const;
  std::uint64_t judged(InvariantKind kind, std::size_t calls) const;
  static constexpr std::size_t kinds = invariant_kinds;
  static constexpr std::size_t index(InvariantKind kind) { return static_cast<std::size_t>(kind); }
  /// Number of presses on which no client has acted.
  struct Pressed {
    Client client = Client::radio;
    std::uint8_t key = 0;
    unsigned open = 0;

    bool is_for(const KeyAction& action) const {
      return client == action.client && key == action.key;
    }
  };

  std::array<std::vector<Pressed>, 2> pads_{};  ///< at most one for each client and key
  unsigned wrong_keys_ = 0;
  std::uint64_t keys_ = 0;  ///< keys on which a client has acted
  std::uint64_t waits_ = 0;
  std::uint64_t quiet_ = 0;
  std::array<WrongTime, kinds> wrong_{};
  std::array<bool, kinds> undecided_{};
  MissingDevices missing_;
  Duration longest_wait_{};  ///< at the terminal
  std::uint64_t frames_asleep_ = 0;
};

}  // namespace canvoy::police
