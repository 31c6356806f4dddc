// Judges a patrol by what is seen, heard and read, and by whose fingers were where: never by what a
// device says of itself.
//
//     referee.pressed(Client::radio, false, 3);   // a person
//     referee.acted({.client = Client::radio, .key = 3});
//     referee.judge(InvariantKind::siren, now, is_right);
#pragma once

#include <array>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/sim/police/client.hpp"
#include "canvoy/sim/police/crew.hpp"
#include "canvoy/sim/police/invariant.hpp"

namespace canvoy::police {

class PoliceReferee {
 public:
  static constexpr Duration call_bound = 35min;

  /// A key was pressed for this client.
  void pressed(Client client, bool is_function_key, std::uint8_t key);
  void acted(const KeyAction& action);
  /// Whether something is as it shall be; called in each step.
  void judge(InvariantKind kind, Time now, bool is_right);
  /// The same of a device.
  void judge_device(NodeId id, Time now, bool is_there);
  /// Somebody waits since then.
  void waits(Time now, Time since);
  void frame_asleep() { ++frames_asleep_; }
  void cannot_judge(InvariantKind kind) { undecided_[index(kind)] = true; }

  std::vector<Invariant> verdicts(std::span<const EmergencyCall> calls) const;

 private:
  static constexpr std::size_t kinds = static_cast<std::size_t>(InvariantKind::device_missing) + 1;
  static constexpr std::size_t index(InvariantKind kind) { return static_cast<std::size_t>(kind); }
  /// Of a pad: what was pressed last, and how often nobody has acted on it.
  struct Pressed {
    Client client = Client::radio;
    std::uint8_t key = 0;
    unsigned open = 0;
  };

  std::array<Pressed, 2> pads_{};
  unsigned wrong_keys_ = 0;
  std::array<Time, kinds> right_at_{};
  std::array<Duration, kinds> worst_{};
  std::array<bool, kinds> undecided_{};
  std::array<Time, cia447::node_id_max + 1> there_at_{};
  std::uint64_t frames_asleep_ = 0;
};

}  // namespace canvoy::police
