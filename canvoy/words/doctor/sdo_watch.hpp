// The SDO channels of a bus: who does not answer, who is slow, and to whom two devices answer
// (CiA 301, 7.2.4).
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
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

/// What was heard of one server.
struct HeardServer {
  Tally time_outs = {};       ///< requests that got no answer
  Tally slow = {};            ///< answers that took `slow_from` or longer
  Tally doubles = {};         ///< more answers than requests
  std::uint64_t answers = 0;  ///< all, aborts and segments too
  Duration slowest{};         ///< of the slow ones; zero: none was slow
  std::uint16_t index = 0;    ///< that was asked for last where there was no answer, or the slowest
  std::uint8_t sub = 0;       ///< of the same object
};

class SdoWatch {
 public:
  /// A server that takes longer is slow: most clients wait for half a second to some seconds.
  static constexpr Duration slow_from = 300ms;
  /// Who is not answered for so long is not.
  static constexpr Duration answer_most = 1s;

  /// `is_there`: the server is known to be there. Who is not answers nobody, and masters ask for
  /// those.
  void hear(Time at, const Frame& frame, const decoder::Decoded& decoded, bool is_there);
  /// The listening ends: what was asked `answer_most` before or earlier got no answer.
  void end(Time at);
  /// Of what it was asked it knows nothing.
  void restarted(NodeId server);

  /// What was heard of `server`, 0 to 127.
  const HeardServer& of(NodeId server) const { return servers_.at(server); }

 private:
  struct Channel {
    NodeId server = 0;         ///< whose answers it waits for
    bool is_waiting = false;   ///< for an answer
    bool is_answered = false;  ///< the latest message was an answer that ends a request
    /// Requests that were given up: their answers may still come.
    unsigned owed = 0;
    Time latest{};            ///< when the latest message came
    std::uint16_t index = 0;  ///< of the object that the latest message is about
    std::uint8_t sub = 0;     ///< of the same object
  };

  void take_request(Channel& channel, Time at, const Frame& frame, const decoder::Decoded& decoded);
  void take_answer(Channel& channel, Time at, const decoder::Decoded& decoded);
  void missed(const Channel& channel, Time at);

  std::map<std::uint16_t, Channel> channels_;
  std::array<HeardServer, node_id_max + 1> servers_{};
};

}  // namespace canvoy::words
