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
#include <utility>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

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
