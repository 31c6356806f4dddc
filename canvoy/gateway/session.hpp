// One client of the gateway: its lines in, the lines for it out (CiA 309-3).
//
// Each session has its own default network and node. Commands to different nodes are carried out at
// the same time, commands to one node one after the other; answers come in the order of the
// commands.
//
//     Session& session = gateway.open();
//     session.receive("[1] 5 r 0x1000 0 u32\r\n");
//     gateway.settle(now);
//     send(session.output());
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "canvoy/can/time.hpp"
#include "canvoy/gateway/answer.hpp"
#include "canvoy/gateway/line_reader.hpp"
#include "canvoy/gateway/operation.hpp"

namespace canvoy::gateway {

class Gateway;
class Network;

/// Limits of a client, and the style of its lines.
struct SessionSettings {
  Style style = {};  ///< of the lines for it
  /// Characters of a line, until the client sets another number.
  std::size_t command_size = 64 * 1024;
  std::size_t command_size_max = 1024 * 1024;  ///< limit of what the client can set
  /// Bytes uploaded by commands that are not answered.
  std::size_t held_bytes_max = 4 * 1024 * 1024;
  std::size_t pending_max = 32;        ///< limit of commands that are not answered
  std::size_t output_max = 64 * 1024;  ///< bytes to send beyond which commands wait
  /// Bytes of events beyond which the client is too slow.
  std::size_t event_bytes_max = 256 * 1024;
};

class Session {
 public:
  /// Made by Gateway::open().
  Session(Gateway& gateway, const SessionSettings& settings);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Takes bytes from the client, in pieces of any size. Nothing happens before settle().
  void receive(std::string_view bytes) { reader_.append(bytes); }
  /// Notes the end of the input: text behind the last line end counts as a line.
  void end_input();
  /// False while input is better left in the socket.
  bool wants_input() const { return may_read(); }
  /// True if nothing is under way or left to read, and all output was sent.
  bool idle() const { return pending_.empty() && output_.empty() && !reader_.has_line(); }

  /// True if a command is not answered yet for a reason other than a client that does not read.
  bool is_busy() const;
  /// Bytes held for the client: its lines, its commands, their values and answers, and events.
  std::size_t held_bytes() const;

  /// True if settle() would do something at once.
  bool is_ready() const;
  /// Begins commands that can begin, answers those that are done, and ends those that take too
  /// long.
  void settle(Time now);
  /// Time at which a command takes too long.
  Time deadline() const;

  /// Queues the line of an event, at once; dropped once the client is too slow.
  void tell(const Event& event);
  /// Lines for the client; consume() removes what was sent.
  std::string_view output() const { return output_; }
  /// Removes bytes of output() that were sent; not more than there are.
  void consume(std::size_t size);
  /// True if the client does not read its events and must be dropped.
  bool is_too_slow() const { return too_slow_; }
  /// Number of commands that were answered with an error.
  std::uint64_t failures() const { return failures_; }

 private:
  struct Pending {
    Pending(std::uint32_t number, Request request, Budget& budget)
        : sequence(number), operation(std::move(request), budget) {}

    std::uint32_t sequence;
    Operation operation;
    Network* network = nullptr;
    Time until = never;
    bool begun = false;
    bool is_node_command() const;
    std::size_t held_bytes() const;
  };

  bool may_read() const;
  bool may_emit() const;
  bool read_lines();
  void take(const Line& line);
  std::optional<Answer> prepare(Request& request, Network*& network);
  std::optional<Answer> set_up(const Request& request);
  ErrorCode complete(Request& request, Network*& network) const;
  bool begin_ready(Time now);
  bool may_begin(std::size_t position) const;
  bool expire(Time now);
  bool emit();

  Gateway& gateway_;
  SessionSettings settings_;
  LineReader reader_;
  Budget budget_;
  std::deque<std::unique_ptr<Pending>> pending_;
  std::string output_;
  std::size_t event_bytes_ = 0;  ///< bytes of events since the output was empty
  bool too_slow_ = false;
  std::uint64_t failures_ = 0;

  std::optional<std::uint32_t> default_net_;
  std::optional<std::uint32_t> default_node_;
  std::optional<Duration> command_time_out_;
  std::set<std::uint32_t> without_boot_up_;  ///< networks without reports of boot-ups
};

}  // namespace canvoy::gateway
