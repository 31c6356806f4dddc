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
  NodeId node = 0;                      ///< who sends it, where it is known; else 0
  std::uint16_t number = 0;             ///< of the TPDO; 0: not known
  bool is_multiplexed = false;          ///< it is an MPDO
  std::uint64_t frames = 0;             ///< data frames, without remote ones
  Tally wrong_length = {};              ///< frames of another length than is mapped
  std::uint8_t length = 0;              ///< of the latest
  std::uint8_t other_length = 0;        ///< of the latest one that was of another length
  unsigned lengths = 0;                 ///< how many there were, up to 3
  Tally length_changes = {};            ///< frames of another length than the one before
  Tally too_early = {};                 ///< before the inhibit time was over by half
  Duration inhibit_time{};              ///< as of the latest that was too early; zero: none was
  Duration shortest = Duration::max();  ///< interval of those too early; max(): none was
  Tally too_late = {};                  ///< behind the window
  Duration window{};                    ///< (1007h) of the latest that was too late; zero: none was
  Duration latest_in_cycle{};           ///< behind SYNC, of those too late; zero: none was
  Tally twice_in_cycle = {};            ///< between two SYNC, where there may be one
  RhythmWatch rhythm = {};              ///< of an event-driven TPDO
  Time latest{};                        ///< when the latest data frame came
  Frame frame = {};                     ///< the latest data frame
  Frame frame_before = {};              ///< the one before it
  bool is_asked = false;                ///< by a remote frame, since the latest
  std::uint64_t cycle = 0;  ///< number of the SYNC before the latest, from 1; 0: it follows none
  unsigned in_cycle = 0;    ///< frames since the SYNC with this number
};

class PdoWatch {
 public:
  /// A SYNC: a cycle begins.
  void hear_sync(Time at);
  /// A frame that is no SDO: data or remote, of 11 bits, 181h to 6DFh; of `sender`, 0: not known.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded, NodeId sender,
            const KnownParameters& known);

  /// By CAN-ID, 181h to 6DFh; also those only asked for by a remote frame.
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

}  // namespace canvoy::words
