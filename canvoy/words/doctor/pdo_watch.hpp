// The PDOs of a bus by their CAN-ID: lengths, senders, inhibit times (CiA 301, 7.5.2.37), and the
// window behind SYNC (7.5.2.7).
//
//     PdoWatch pdos;
//     pdos.hear_sync(time);
//     pdos.hear(time, frame, decoded, known);
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/words/doctor/heartbeat_watch.hpp"
#include "canvoy/words/doctor/known_parameters.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

/// What was heard with one CAN-ID.
struct HeardPdo {
  NodeId node = 0;           ///< who sends it, where it is known; else 0
  std::uint16_t number = 0;  ///< of the TPDO; 0: not known
  bool is_multiplexed = false;
  std::uint64_t frames = 0;
  Tally wrong_length = {};
  std::uint8_t length = 0;        ///< of the latest
  std::uint8_t other_length = 0;  ///< of the latest one that was of another length
  unsigned lengths = 0;           ///< how many there were, up to 3
  Tally length_changes = {};
  Tally too_early = {};  ///< before the inhibit time was over by half
  Duration inhibit_time{};
  Duration shortest = Duration::max();
  Tally too_late = {};  ///< behind the window
  Duration window{};
  Duration latest_in_cycle{};
  Tally twice_in_cycle = {};  ///< between two SYNC, where there may be one
  RhythmWatch rhythm = {};
  Time latest{};
  bool is_asked = false;  ///< by a remote frame, since the latest
  std::uint64_t cycle = 0;
  unsigned in_cycle = 0;  ///< frames since the SYNC with this number
};

class PdoWatch {
 public:
  void hear_sync(Time at);
  /// A frame that is no SDO: data or remote, of 11 bits, 181h to 6DFh; of `sender`, 0: not known.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded, NodeId sender,
            const KnownParameters& known);

  const std::map<std::uint16_t, HeardPdo>& pdos() const { return pdos_; }

 private:
  static void judge_length(HeardPdo& pdo, Time at, std::uint8_t length);
  void judge_times(HeardPdo& pdo, Time at, const KnownTpdo& tpdo,
                   const std::optional<Duration>& window);
  void judge_cycle(HeardPdo& pdo, Time at, const std::optional<Duration>& window);

  std::map<std::uint16_t, HeardPdo> pdos_;
  Time sync_{};
  std::uint64_t cycle_ = 0;  ///< 0: no SYNC was heard
};

}  // namespace canvoy::words
