// SDO channels of a bus: servers without answers, slow servers, and servers of which two devices
// answer (CiA 301, 7.2.4).
//
//     SdoWatch sdos;
//     sdos.hear(time, frame, decoder.decode(frame), true);
//     sdos.of(5).time_outs.count;
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/text/doctor/heartbeat_watch.hpp"
#include "canvoy/text/doctor/known_parameters.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

// PDOs of a bus by CAN-ID: lengths, senders, inhibit times (CiA 301, 7.5.2.37), and the window
// after SYNC (CiA 301, 7.5.2.7).
//
//     PdoWatch pdos;
//     pdos.hear_sync(time);
//     pdos.hear(time, frame, decoded, known);

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

/// PDOs of a bus by CAN-ID: lengths, senders, inhibit times (CiA 301, 7.2.2).
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

/// Compares devices with their data sheets (EDS, DCF, XDD, XDC), by the entries that are read from
/// them, or refused.
///
///     SheetWatch sheets;
///     sheets.add(5, sheet);
///     sheets.hear(time, frame, decoder.decode(frame));
class SheetWatch {
 public:
  /// Sets the data sheet of a node. `sheet` must outlive this.
  void add(NodeId node, const formats::DataSheet& sheet) { sheets_[node] = &sheet; }
  /// Adds the communication parameters of the sheet that are not known from the bus.
  static void tell(NodeId node, const formats::DataSheet& sheet, KnownParameters& known);
  /// Takes a frame and its decoded content: SDO answers of nodes with a sheet are compared.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded);

  /// An entry in which a device differs from its sheet.
  struct Difference {
    std::string text;  ///< description
    Tally tally;       ///< occurrences
  };
  /// By node, index and sub-index.
  using Differences = std::map<std::tuple<NodeId, std::uint16_t, std::uint8_t>, Difference>;
  /// Differences in the first 1024 entries; empty: none.
  const Differences& differences() const { return differences_; }

 private:
  void compare(Time at, NodeId node, const formats::DataSheet& sheet,
               const decoder::SdoTransfer& transfer);
  void refused(Time at, NodeId node, const formats::DataSheet& sheet, const Frame& frame);
  void differs(Time at, NodeId node, std::uint16_t index, std::uint8_t sub, std::string text);

  std::map<NodeId, const formats::DataSheet*> sheets_;
  Differences differences_;
};

/// Requests and answers of one server.
struct HeardServer {
  Tally time_outs = {};       ///< requests without an answer
  Tally slow = {};            ///< answers that took `slow_from` or longer
  Tally doubles = {};         ///< more answers than requests
  std::uint64_t answers = 0;  ///< all, including aborts and segments
  Duration slowest{};         ///< time of the slowest; zero: none
  std::uint16_t index = 0;    ///< of the last request without an answer, or of the slowest
  std::uint8_t sub = 0;       ///< of the same object
};

/// SDO channels of a bus: servers without answers, and slow ones (CiA 301, 7.2.4).
class SdoWatch {
 public:
  /// Time from which an answer is slow: most clients wait for half a second to some seconds.
  static constexpr Duration slow_from = 300ms;
  /// Time after which a request counts as unanswered.
  static constexpr Duration answer_most = 1s;

  /// Takes an SDO frame. `is_there`: the server is known to be active. Missing servers do not
  /// answer, and masters ask for them.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded, bool is_there);
  /// Ends listening: requests older than `answer_most` count as unanswered.
  void end(Time at);
  /// Discards the open requests of a server.
  void restarted(NodeId server);

  /// Requests and answers of `server`, 0 to 127.
  const HeardServer& of(NodeId server) const { return servers_.at(server); }

 private:
  struct Channel {
    NodeId server = 0;         ///< the server that the client waits for
    bool is_waiting = false;   ///< for an answer
    bool is_answered = false;  ///< the last message was an answer that ends a request
    /// Number of abandoned requests, which may still be answered.
    unsigned owed = 0;
    Time latest{};            ///< time of the last message
    std::uint16_t index = 0;  ///< of the object of the last message
    std::uint8_t sub = 0;     ///< of the object of the last message
  };

  void take_request(Channel& channel, Time at, const Frame& frame, const decoder::Decoded& decoded);
  void take_answer(Channel& channel, Time at, const decoder::Decoded& decoded);
  void missed(const Channel& channel, Time at);

  std::map<std::uint16_t, Channel> channels_;
  std::array<HeardServer, node_id_max + 1> servers_{};
};

}  // namespace canvoy::text
