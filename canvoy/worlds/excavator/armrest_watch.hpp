// State of the armrest in the host: an input and output module (CiA 401) on the network behind the
// seat, with safety lever, seat switch and emergency stop at its first inputs. The host reads it
// through the seat, again and again; a value is as old as the request for it. An armrest that does
// not answer counts as missing, and its contacts as unknown.
//
//     ArmrestWatch armrest(node, changed);
//     armrest.begin();                       // the seat is set up
//     if (!armrest.is_released()) close_all_valves();
#pragma once

#include <array>

#include "canvoy/canopen/remote/remote_indication.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::excavator {

/// Node-ID of the armrest, on the network behind the seat.
inline constexpr NodeId armrest_id = 7;
inline constexpr std::uint16_t armrest_network = 2;  ///< number of the network behind the seat
// Bits of 6000h:01h: contacts that are closed while the machine may move. One with a broken wire is
// open.
inline constexpr std::uint8_t lever_bit = 1;  ///< the safety lever is down
inline constexpr std::uint8_t seat_bit = 2;   ///< a person sits on the seat
inline constexpr std::uint8_t stop_bit = 4;   ///< the emergency stop is not pressed
/// With all of them closed, the machine may move.
inline constexpr std::uint8_t released_bits = lever_bit | seat_bit | stop_bit;
/// Longest time for an answer of the armrest to the seat: shorter than the host waits for both.
inline constexpr RemoteSettings armrest_access{.network = armrest_network, .time_out = 80ms};

class ArmrestWatch {
 public:
  /// What `node` and `changed` refer to must outlive this object.
  ArmrestWatch(Node& node, Callback<void()> changed)
      : node_(node), changed_(changed), indication_(node, armrest_access), client_(node) {}
  ArmrestWatch(const ArmrestWatch&) = delete;
  ArmrestWatch& operator=(const ArmrestWatch&) = delete;

  /// Starts to read: call it when the seat answers.
  void begin();
  /// Stops to read, and forgets the state.
  void stop();
  /// True if it was read within consumer_time, and has answered.
  bool is_there() const { return lost_timer_.armed(); }
  /// True if it answers, and all of its contacts are closed.
  bool is_released() const { return is_there() && is_released_; }
  /// True if all contacts were closed at its last answer.
  bool was_released() const { return is_released_; }

 private:
  void ask(Time now);
  void confirmed(SdoEnd outcome);
  void answered(SdoClient::Outcome outcome);
  void lost(Time now);

  Node& node_;
  Callback<void()> changed_;
  RemoteIndication indication_;
  SdoClient client_;
  std::array<std::uint8_t, 4> buffer_{};
  Time asked_at_{};
  bool is_released_ = false;
  Timer ask_timer_{callback<&ArmrestWatch::ask>(*this)};
  Timer lost_timer_{callback<&ArmrestWatch::lost>(*this)};
};

}  // namespace canvoy::excavator
