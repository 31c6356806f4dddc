// What a host knows of the armrest: an input and output module (CiA 401) on the network behind the
// seat, with the safety lever at its first input. The host reads it through the seat, again and
// again, and a value is as old as the request for it: an armrest that has vanished is not there
// any more, and its lever is not known.
//
//     ArmrestWatch armrest(node, changed);
//     armrest.begin();                       // the seat is set up
//     if (!armrest.is_lowered()) close_all_valves();
#pragma once

#include <array>

#include "canvoy/canopen/remote/remote_indication.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::excavator {

/// The armrest, on the network behind the seat.
inline constexpr NodeId armrest_id = 7;
inline constexpr std::uint16_t armrest_network = 2;
/// 6000h:01h: the lever is down, and the machine may move.
inline constexpr std::uint8_t lever_bit = 1;
/// How long the armrest may take to answer the seat: shorter than the host waits for both.
inline constexpr RemoteSettings armrest_access{.network = armrest_network, .time_out = 80ms};

class ArmrestWatch {
 public:
  /// What `node` and `changed` refer to must outlive this.
  ArmrestWatch(Node& node, Callback<void()> changed)
      : node_(node), changed_(changed), indication_(node, armrest_access), client_(node) {}
  ArmrestWatch(const ArmrestWatch&) = delete;
  ArmrestWatch& operator=(const ArmrestWatch&) = delete;

  /// The seat answers: from now on it is asked.
  void begin();
  /// Nothing is known any more, and nobody asked.
  void stop();
  /// It was asked within consumer_time, and has answered.
  bool is_there() const { return lost_timer_.armed(); }
  /// It is there, and its lever is down.
  bool is_lowered() const { return is_there() && is_lowered_; }
  /// It was, when the armrest was heard last.
  bool was_lowered() const { return is_lowered_; }

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
  bool is_lowered_ = false;
  Timer ask_timer_{Callback<void(Time)>::to<&ArmrestWatch::ask>(*this)};
  Timer lost_timer_{Callback<void(Time)>::to<&ArmrestWatch::lost>(*this)};
};

}  // namespace canvoy::excavator
