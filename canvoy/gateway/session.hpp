// What one client of the gateway says and is told: lines in, lines out (CiA 309-3).
//
// It has a default network and node of its own. Commands to different nodes are carried out at the
// same time, those to one node one after the other; answers come in the order of the commands.
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

struct SessionSettings {
  Style style = {};
  std::size_t command_size = 64 * 1024;          ///< characters of a line, until the client sets it
  std::size_t command_size_max = 1024 * 1024;    ///< that the client can set
  std::size_t held_bytes_max = 4 * 1024 * 1024;  ///< uploaded, by commands that are not answered
  std::size_t pending_max = 32;                  ///< commands that are not answered
  std::size_t output_max = 64 * 1024;            ///< with more to send, commands wait
  std::size_t event_bytes_max = 256 * 1024;      ///< of events; with more, the client is too slow
};

class Session {
 public:
  Session(Gateway& gateway, const SessionSettings& settings);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// What the client sent, cut anywhere. Nothing happens before settle().
  void receive(std::string_view bytes) { reader_.append(bytes); }
  /// The client has said all: what stands behind the last end of a line counts as a line as well.
  void end_input();
  /// False while it is better to leave what the client sends in the socket.
  bool wants_input() const { return may_read(); }
  /// Nothing is under way or left to read, and all was sent.
  bool idle() const { return pending_.empty() && output_.empty() && !reader_.has_line(); }

  /// A command is not answered yet, for another reason than that the client does not read.
  bool is_busy() const;
  /// What is kept for the client: its lines, its commands, their values and answers, and events.
  std::size_t held_bytes() const;

  /// There is something that settle() would do at once.
  bool is_ready() const;
  /// Begins what can begin, answers what is done, and ends what takes too long.
  void settle(Time now);
  /// When a command takes too long.
  Time deadline() const;

  void tell(const Event& event);
  /// Lines for the client; consume() takes away what was sent.
  std::string_view output() const { return output_; }
  void consume(std::size_t size);
  /// The client does not read its events: it is to be dropped.
  bool is_too_slow() const { return too_slow_; }
  /// Commands that were answered with an error.
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
  std::size_t event_bytes_ = 0;  ///< since the output was empty
  bool too_slow_ = false;
  std::uint64_t failures_ = 0;

  std::optional<std::uint32_t> default_net_;
  std::optional<std::uint32_t> default_node_;
  std::optional<Duration> command_time_out_;
  std::set<std::uint32_t> without_boot_up_;  ///< networks of which boot-ups are not told
};

}  // namespace canvoy::gateway
