// Program download, the end that programs another node (CiA 302-3): stops what runs there, clears
// its place, sends the new program, looks what became of it, and starts it.
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

/// In their order.
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

struct ProgramPlan {
  NodeId server = 0;
  std::uint8_t number = 1;        ///< of the program: the sub-index
  SdoClient::Supply supply = {};  ///< gives the program, in order
  std::uint32_t size = 0;         ///< of the program, in bytes
  /// What 1F56h must say afterwards, where the node has it.
  std::optional<std::uint32_t> identification = {};
  /// For 1F52h: days since 1984, and ms since midnight. A node that does not take them is fine.
  std::optional<std::array<std::uint32_t, 2>> date = {};
  bool start = true;
};

/// How it ended: where, and why.
struct ProgramOutcome {
  ProgramStep step = ProgramStep::done;  ///< done: all is well
  SdoEnd end = {};                       ///< how the last request ended
  FlashStatus status = {};               ///< 1F57h where that says what is wrong
  explicit operator bool() const { return step == ProgramStep::done; }
};

/// Where 1F57h or 1F56h are not there they are not asked. A node that does not answer to "stop" may
/// be restarting with its bootloader: then clearing is tried until it answers. One that does not
/// answer to "start" is gone with its new program: that is done.
class ProgramDownload {
 public:
  struct Settings {
    Duration answer_time_out = 1s;    ///< of SDO
    Duration clear_time_out = 30s;    ///< of the answer to "clear": some nodes clear before it
    Duration poll_interval = 100ms;   ///< of 1F57h
    Duration flash_time_out = 60s;    ///< for 1F57h to be no more busy
    Duration restart_time_out = 10s;  ///< of a node that was stopped
  };
  using Done = Callback<void(const ProgramOutcome&)>;

  /// `client` must be idle while this is busy. Both must outlive this.
  ProgramDownload(Node& node, SdoClient& client) : ProgramDownload(node, client, Settings{}) {}
  ProgramDownload(Node& node, SdoClient& client, const Settings& settings)
      : node_(node), client_(client), settings_(settings) {}
  ~ProgramDownload() { cancel(); }
  ProgramDownload(const ProgramDownload&) = delete;
  ProgramDownload& operator=(const ProgramDownload&) = delete;

  /// `done` is called once where this answers none. Abort: device_state while busy(), or what
  /// SdoClient answers.
  AbortCode begin(const ProgramPlan& plan, Done done);
  /// Ends it without calling `done`. The node keeps no valid program where a download was begun.
  void cancel();
  /// The same where the client is no longer ours.
  void forget();

  bool busy() const { return step_ != ProgramStep::done; }
  ProgramStep step() const { return step_; }
  /// Bytes of the program that have gone.
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
  Timer timer_{Callback<void(Time)>::to<&ProgramDownload::repeat>(*this)};
};

}  // namespace canvoy
