// Emergency producer: sends messages when errors appear and disappear, and maintains the error
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
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Sends an error that appears with its code, and one that disappears with code 0000h, both with
/// the remaining register; an error that is present already is not sent again. Messages leave only
/// in NMT states pre-operational and operational, not during bus-off, and separated by the inhibit
/// time 1015h; until then they wait. While 1014h is invalid or absent, no message is sent or waits.
///
/// Bytes 3 to 7 are Error::info, or, if that is all zero, the instance in bytes 3 and 4.
///
/// The producer itself raises error-passive (8120h) and recovered from bus-off (8140h, which
/// disappears at once) by the controller's state, and ends an overrun (8110h) one second after the
/// last one. An NMT reset ends all communication errors; reset node ends all errors.
class EmergencyProducer : private NodeService {
 public:
  static constexpr Duration overrun_time = 1s;  ///< from the last overrun to its end

  /// Makes the producer. The size of `present` limits the errors that are present at a time: one
  /// beyond is sent, but does not count in 1001h. The size of `waiting`, at least one, limits the
  /// messages that wait. Both must outlive the producer.
  ///
  /// If masters can write neither 1014h nor 1015h (`writable` is false), the code that handles a
  /// write there is not linked.
  constexpr EmergencyProducer(Node& node, std::span<Error> present, std::span<Emergency> waiting,
                              bool writable = true)
      : NodeService(writable ? Listener{on_event, first_object, last_object}
                             : Listener{on_constant_event, first_object, first_object},
                    EventMask::none),
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

  /// Errors that are present, in the order of appearance.
  std::span<const Error> present() const { return {present_, present_count_}; }
  /// Number of messages that were merged because too many waited. The last one that waits always
  /// has the latest register.
  std::uint32_t coalesced() const { return coalesced_; }

 private:
  static constexpr std::uint16_t first_object = object_index::error_history;
  static constexpr std::uint16_t last_object = object_index::emergency_inhibit_time;

  static void on_event(NodeService& service, ServiceEvent& event);
  static void on_constant_event(NodeService& service, ServiceEvent& event);
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
  void notify(const Emergency& emergency);
  void make_room();
  void flush();
  bool send_next();
  static void expire(void* producer, Time now);
  static void end_overrun(void* producer, Time now);
  /// COB-ID of the messages; invalid if there is none that the node can use.
  CobId cob_id() const;
  bool may_send() const;
  void drop_waiting(std::size_t position);

  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
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
  Timer timer_;          ///< end of the inhibit time
  Timer overrun_timer_;  ///< end of the overrun
};

}  // namespace canvoy
