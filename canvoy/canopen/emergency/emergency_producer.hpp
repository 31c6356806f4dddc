// Emergency producer: tells the others when an error comes and when it goes, and keeps the error
// register 1001h and the history 1003h (CiA 301, 7.2.7, 7.5.2.2, 7.5.2.4, 7.5.2.17 and 7.5.2.18).
//
//     Error present[8];
//     Emergency waiting[8];
//     EmergencyProducer emergency_producer(node, present, waiting);
//     node.raise({.code = 0x4210, .register_bits = error_register::temperature});
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/emergency/emergency.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// An error that comes is told with its code, one that goes with code 0000h, both with what is left
/// in the register; an error that is present already is not told again. Messages leave in NMT
/// states pre-operational and operational only, not while bus-off, and 1015h apart; until they may
/// they wait. While 1014h is invalid or absent nothing is told and nothing waits.
///
/// Bytes 3 to 7 are Error::info, or where that is all zero the instance in bytes 3 and 4.
///
/// The producer itself raises error-passive (8120h) and recovered from bus-off (8140h, gone at
/// once) by the controller's state, and ends an overrun (8110h) a second after the last one. An NMT
/// reset ends all errors of communication; reset node ends all.
class EmergencyProducer : private NodeService {
 public:
  static constexpr Duration overrun_time = 1s;

  /// `present` bounds the errors that are present at a time: one beyond is told, but does not count
  /// in 1001h. `waiting` bounds the messages that wait, with one at least. Both must outlive the
  /// producer.
  ///
  /// Where masters can write neither 1014h nor 1015h (`writable` is false) nothing that follows a
  /// write there is linked.
  constexpr EmergencyProducer(Node& node, std::span<Error> present, std::span<Emergency> waiting,
                              bool writable = true)
      : NodeService(writable ? Listener{told, first_object, last_object}
                             : Listener{told_of_constant, first_object, first_object},
                    Cares::for_nothing_frequent),
        present_max_(static_cast<std::uint16_t>(present.size())),
        waiting_max_(static_cast<std::uint16_t>(waiting.size())),
        node_(node),
        waiting_(waiting.data()),
        present_(present.data()),
        timer_(Callback<void(Time)>(&EmergencyProducer::expire, this)),
        overrun_timer_(Callback<void(Time)>(&EmergencyProducer::end_overrun, this)) {
    node_.attach(*this);
  }
  EmergencyProducer(const EmergencyProducer&) = delete;
  EmergencyProducer& operator=(const EmergencyProducer&) = delete;

  /// The errors that are present, in the order in which they came.
  std::span<const Error> present() const { return {present_, present_count_}; }
  /// Messages that were never told, since too many waited. The last one that waits always tells
  /// the latest register.
  std::uint32_t coalesced() const { return coalesced_; }

 private:
  static constexpr std::uint16_t first_object = object_index::error_history;
  static constexpr std::uint16_t last_object = object_index::emergency_inhibit_time;

  static void told(NodeService& service, ServiceEvent& event);
  static void told_of_constant(NodeService& service, ServiceEvent& event);
  void reset(ResetScope scope);
  void bus_state_changed(BusState state);
  void come(const Error& error);
  void go(const Error& error);

  bool is_empty(const Entry& entry) const;
  void cob_id_or_inhibit_time_written();
  void clear_history();

  Error* find(const Error& error) const;
  void update_register();
  void keep_in_history(const Emergency& emergency);
  void tell(const Emergency& emergency);
  void make_room();
  void flush();
  bool send_next();
  static void expire(void* producer, Time now);
  static void end_overrun(void* producer, Time now);
  /// Invalid where there is none that we could send with.
  CobId cob_id() const;
  bool may_send() const;
  void drop_waiting(std::size_t position);

  // What is small comes first: a Cortex-M0+ reaches it with shorter instructions.
  std::uint8_t register_ = 0;
  BusState bus_state_ = BusState::error_active;
  std::uint16_t present_count_ = 0;
  std::uint16_t waiting_count_ = 0;
  std::uint16_t present_max_;
  std::uint16_t waiting_max_;
  std::uint32_t coalesced_ = 0;
  Node& node_;
  Emergency* waiting_;
  Error* present_;
  StoredTime sent_at_{Time::min()};
  Timer timer_;          ///< for the end of the inhibit time
  Timer overrun_timer_;  ///< for the end of the overrun
};

}  // namespace canvoy
