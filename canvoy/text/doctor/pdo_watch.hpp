// PDOs of a bus by CAN-ID: lengths, senders, inhibit times (CiA 301, 7.5.2.37), and the window
// after SYNC (CiA 301, 7.5.2.7).
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
#include "canvoy/text/doctor/heartbeat_watch.hpp"
#include "canvoy/text/doctor/known_parameters.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

/// PDOs with one CAN-ID.
struct HeardPdo {
  NodeId node = 0;                      ///< the sender; 0: unknown
  std::uint16_t number = 0;             ///< of the TPDO; 0: unknown
  bool is_multiplexed = false;          ///< it is an MPDO
  std::uint64_t frames = 0;             ///< number of data frames, without remote frames
  Tally wrong_length = {};              ///< frames with a length other than mapped
  std::uint8_t length = 0;              ///< of the last frame
  std::uint8_t other_length = 0;        ///< of the last frame with another length
  unsigned lengths = 0;                 ///< number of lengths, up to 3
  Tally length_changes = {};            ///< frames with a length other than the previous one
  Tally too_early = {};                 ///< before half of the inhibit time
  Duration inhibit_time{};              ///< of the last one that was too early; zero: none
  Duration shortest = Duration::max();  ///< interval of those too early; max(): none
  Tally too_late = {};                  ///< after the window
  Duration window{};                    ///< (1007h) of the last one that was too late; zero: none
  Duration latest_in_cycle{};           ///< time after SYNC of those too late; zero: none
  Tally twice_in_cycle = {};            ///< second one between two SYNCs, where one is allowed
  RhythmWatch rhythm = {};              ///< of an event-driven TPDO
  Time latest{};                        ///< time of the last data frame
  Frame frame = {};                     ///< the last data frame
  Frame frame_before = {};              ///< the previous one
  bool is_asked = false;                ///< requested by a remote frame, since the last frame
  std::uint64_t cycle = 0;  ///< number of the SYNC before the last frame, from 1; 0: none
  unsigned in_cycle = 0;    ///< number of frames since the SYNC with this number
};

class PdoWatch {
 public:
  /// Takes a SYNC: starts a cycle.
  void hear_sync(Time at);
  /// Takes a frame that is no SDO: data or remote, of 11 bits, 181h to 6DFh, of `sender`; 0:
  /// unknown.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded, NodeId sender,
            const KnownParameters& known);

  /// By CAN-ID, 181h to 6DFh; including those only requested by a remote frame.
  const std::map<std::uint16_t, HeardPdo>& pdos() const { return pdos_; }

 private:
  static void judge_length(HeardPdo& pdo, Time at, std::uint8_t length);
  void judge_times(HeardPdo& pdo, Time at, const Frame& frame, const KnownTpdo& tpdo,
                   const std::optional<Duration>& window);
  void judge_cycle(HeardPdo& pdo, Time at, const std::optional<Duration>& window);

  std::map<std::uint16_t, HeardPdo> pdos_;
  Time sync_{};
  std::uint64_t cycle_ = 0;  ///< 0: no SYNC was heard
};

}  // namespace canvoy::text
