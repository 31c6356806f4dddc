// Program download, the end that programs another node: stops its program, clears the memory, sends
// the new program, checks the result, and starts it (CiA 302-3).
//
//     SdoClient client(node);
//     SdoBlockClient blocks(client, buffer);
//     ProgramDownload download(node, client);
//     download.begin({.server = 5, .supply = ..., .size = size},
//                    ProgramDownload::Done::to<&Tool::programmed>(*this));
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/canopen/manager/program.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// Steps in their order.
enum class ProgramStep : std::uint8_t {
  stop,
  clear,
  wait_cleared,
  date,
  download,
  wait_programmed,
  identify,
  start,
  done,
};

/// What to do with one node.
struct ProgramPlan {
  NodeId server = 0;              ///< node-ID, 1 to 127
  std::uint8_t number = 1;        ///< of the program: the sub-index
  SdoClient::Supply supply = {};  ///< gives the program, in order
  std::uint32_t size = 0;         ///< of the program, in bytes
  /// Expected value of 1F56h afterwards, if the node has it.
  std::optional<std::uint32_t> identification = {};
  /// For 1F52h: days since 1984, and ms since midnight. A node that refuses them is accepted.
  std::optional<std::array<std::uint32_t, 2>> date = {};
  bool start = true;  ///< start it at the end
};

/// End of a download: step and reason.
struct ProgramOutcome {
  ProgramStep step = ProgramStep::done;  ///< done: success
  SdoEnd end = {};                       ///< how the last request ended
  FlashStatus status = {};               ///< 1F57h if it has the reason
  explicit operator bool() const { return step == ProgramStep::done; }
};

/// A download. 1F57h and 1F56h are optional in the node. A node that does not answer to "stop" may
/// be restarting with its bootloader: then clearing is tried until it answers. A node that does not
/// answer to "start" has left with its new program: that is success.
class ProgramDownload {
 public:
  /// Limits of waiting.
  struct Settings {
    Duration answer_time_out = 1s;    ///< of SDO
    Duration clear_time_out = 30s;    ///< for the answer to "clear": some nodes clear before it
    Duration poll_interval = 100ms;   ///< of 1F57h
    Duration flash_time_out = 60s;    ///< until 1F57h is not busy
    Duration restart_time_out = 10s;  ///< for a node that was stopped
  };
  /// Called once, at the end.
  using Done = Callback<void(const ProgramOutcome&)>;

  /// Makes the object. `client` must be idle while this object is busy. Both must outlive it.
  ProgramDownload(Node& node, SdoClient& client) : ProgramDownload(node, client, Settings{}) {}
  /// Like the above, with other limits of waiting.
  ProgramDownload(Node& node, SdoClient& client, const Settings& settings)
      : node_(node), client_(client), settings_(settings) {}
  ~ProgramDownload() { cancel(); }
  ProgramDownload(const ProgramDownload&) = delete;
  ProgramDownload& operator=(const ProgramDownload&) = delete;

  /// Begins a download; if the result is none, `done` is called once. Aborts: device_state while
  /// busy(), those of SdoClient.
  AbortCode begin(const ProgramPlan& plan, Done done);
  /// Ends it without calling `done`. If a download was begun, the node keeps no valid program.
  void cancel();
  /// Like cancel(), but for a client that belongs to another service already.
  void forget();

  /// True from begin() until `done` or cancel().
  bool busy() const { return step_ != ProgramStep::done; }
  /// Step that is under way; done before the first download and after the last.
  ProgramStep step() const { return step_; }
  /// Number of program bytes sent.
  std::size_t transferred() const;

 private:
  AbortCode enter(ProgramStep step);
  AbortCode ask();
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::size_t size,
                  Duration time_out);
  AbortCode command(ProgramCommand command, Duration time_out);
  AbortCode read(std::uint16_t index);
  void answered(SdoClient::Outcome outcome);
  void repeat(Time now);
  void cleared(SdoEnd answer);
  void status_came(SdoEnd answer);
  void identified(SdoEnd answer);
  void go_on();
  void finish(SdoEnd end, FlashStatus status = FlashStatus());

  Node& node_;
  SdoClient& client_;
  Settings settings_;
  ProgramPlan plan_;
  Done done_;
  ProgramStep step_ = ProgramStep::done;
  bool restarting_ = false;     ///< the node did not answer to "stop"
  std::uint8_t date_part_ = 0;  ///< sub-index of 1F52h
  Time step_ends_{};
  std::array<std::uint8_t, 4> value_{};
  Timer timer_{callback<&ProgramDownload::repeat>(*this)};
};

}  // namespace canvoy
