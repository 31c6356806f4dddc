// What another device is to be told by SDO, and be told again until it takes it: commands of a few
// bytes. A device that was lost and comes back is told all of them anew, "off" as well.
//
//     CommandKeeper lights(network, {.server = 3});
//     lights.want(0, {.index = 0x6130, .sub = 1, .value = 0xFFFF'FFFD, .size = 4});
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/car_network.hpp"

namespace canvoy::cia447 {

/// A value of 1 to 4 bytes for an entry.
struct KeptCommand {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint32_t value = 0;
  std::uint8_t size = 0;  ///< 0: there is none
  bool is_once = false;   ///< forgotten when it was taken, or is too old

  bool operator==(const KeptCommand&) const = default;
};

struct CommandKeeperSettings {
  NodeId server = 0;          ///< 1 to 16
  Duration retry = 500ms;     ///< of what was not taken
  Duration renewal = 10s;     ///< all is told again: a loss may have been too short to be seen
  Duration time_out = 500ms;  ///< of an answer
  /// So old a command that is for once is dropped: who wanted it may have gone.
  Duration lifetime = 3s;
};

/// It has to be made before the node starts. It takes on_lost() of the network, and calls who was
/// called before.
class CommandKeeper {
 public:
  static constexpr unsigned commands_max = 8;

  CommandKeeper(CarNetwork& network, const CommandKeeperSettings& settings);
  CommandKeeper(const CommandKeeper&) = delete;
  CommandKeeper& operator=(const CommandKeeper&) = delete;

  /// Takes the place of what stood at `place`, 0 to commands_max - 1. Commands are told in the
  /// order of their places. One for once that is wanted again is as new.
  void want(unsigned place, const KeptCommand& command);
  /// The device has taken all of them that are not too old.
  bool is_done() const;

 private:
  struct Kept {
    KeptCommand wanted;
    bool is_told = false;
    Time until = never;
  };

  void reset(ResetScope scope);
  void lost(NodeId node);
  void tell_all_anew(Duration after);
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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
