// Commands of a few bytes that are written to another device by SDO, and repeated until it takes
// them. A device that was lost and returns gets all of them again, including "off".
//
//     CommandKeeper lights(network, {.server = 3});
//     lights.want(0, {.index = 0x6130, .sub = 1, .value = 0xFFFF'FFFD, .size = 4});
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"

namespace canvoy::cia447 {

/// A value of 1 to 4 bytes for an entry.
struct KeptCommand {
  std::uint16_t index = 0;  ///< of the object
  std::uint8_t sub = 0;     ///< sub-index
  std::uint32_t value = 0;  ///< little-endian in `size` bytes
  std::uint8_t size = 0;    ///< 0: none
  bool is_once = false;     ///< discarded when taken, or too old

  bool operator==(const KeptCommand&) const = default;
};

/// The other device, and times.
struct CommandKeeperSettings {
  NodeId server = 0;          ///< 1 to 16
  Duration retry = 500ms;     ///< period of repetitions of a command that was not taken
  Duration renewal = 10s;     ///< all are repeated then: a loss may be undetected
  Duration time_out = 500ms;  ///< of an answer
  /// A single command of this age is discarded: its request may be out of date.
  Duration lifetime = 3s;
};

/// Construct it before the node starts. It sets on_lost() of the network, and calls the former
/// callback.
class CommandKeeper {
 public:
  static constexpr unsigned commands_max = 8;  ///< entries of the other device

  /// Makes the keeper; `network` must outlive it.
  CommandKeeper(CarNetwork& network, const CommandKeeperSettings& settings);

  /// Replaces the command at `place`, 0 to commands_max - 1. Commands are sent in the order of
  /// their places. A single command that is set again is new.
  void want(unsigned place, const KeptCommand& command);
  /// True if the device has taken all of them that are not too old.
  bool is_done() const;

 private:
  struct Kept {
    KeptCommand wanted;
    bool is_told = false;
    Time until = never;
  };

  void reset(ResetScope scope);
  void lost(NodeId node);
  void report_all_anew(Duration after);
  void drop_old(Time now);
  void go_on(Time now);
  void taken(SdoClient::Outcome outcome);

  CarNetwork& network_;
  CommandKeeperSettings settings_;
  SdoClient client_;
  Callback<void(NodeId)> next_lost_;
  std::array<Kept, commands_max> kept_{};
  unsigned writing_ = 0;
  std::array<std::uint8_t, 4> bytes_{};
  Time not_before_{};
  Time renewal_due_{};
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
