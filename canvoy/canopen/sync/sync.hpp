// SYNC: the signal at which synchronous PDOs are taken over and sent; consumer and producer (CiA
// 301, 7.2.5 and objects 1005h, 1006h, 1007h, 1019h).
//
//     Sync sync(node);
//     Rpdos rpdos(node, rpdo_memory, rpdo_values, &sync);
//     Tpdos tpdos(node, tpdo_memory, tpdo_values, &sync);
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// An application that is notified of SYNC (between ServiceEvent::actuate and sample). It must
/// outlive the Sync.
struct SyncListener {
  /// Called for each SYNC; the counter is 0 if SYNC carries none.
  Callback<void(std::uint8_t counter)> received;
  SyncListener* next = nullptr;  ///< set by Sync::attach()
};

/// Consumes and produces SYNC. Without 1005h it listens to CAN-ID 080h; without 1006h it produces
/// nothing. It works in NMT states pre-operational and operational. A SYNC with a length other than
/// 1019h requires is ignored, and raises 8240h until a valid one arrives. A producer also consumes
/// its own SYNC.
///
/// If 1006h is not zero, a consumer monitors SYNC from the first one on: it is lost if none came
/// for one and a half periods. CiA 301 has no such monitoring and no error code for it; the
/// indicators show it (CiA 303-3).
///
/// The counter of a received SYNC is passed to the listeners unchanged. A missing or unexpected
/// counter has no effect: it only determines where TPDOs with a SYNC start value begin.
///
/// The produced counter starts with 1 when production begins, and when the node leaves NMT state
/// stopped. The first SYNC follows one period after production begins; periods are kept without
/// drift.
///
/// If masters can write none of the four objects, the code that handles a write is not linked, and
/// without 1006h neither producer nor monitoring.
class Sync : private NodeService {
  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
  std::uint8_t overflow_ = 0;
  std::uint8_t counter_ = 0;  ///< of the last SYNC produced
  bool is_producer_ = false;
  enum class Life : std::uint8_t {
    rests,
    waits,  ///< in NMT state pre-operational or operational, without a SYNC yet
    beats,
  };
  Life life_ = Life::rests;
  bool bad_length_ = false;
  bool lost_ = false;

 public:
  /// Objects in the dictionary.
  struct Objects {
    bool writable = true;  ///< a master may write 1005h, 1006h, 1007h or 1019h
    bool period = true;    ///< 1006h
  };

  /// Attaches to the node. `objects` says what the dictionary has; by default all is linked.
  constexpr explicit Sync(Node& node, const Objects& objects = {true, true})
      : NodeService(objects.writable ? Listener{on_event, first_object, last_object}
                                     : Listener{on_constant_event},
                    EventMask::none),
        node_(node),
        timer_(objects.period ? Callback<void(Time)>(expire, this) : Callback<void(Time)>()),
        keep_period_(objects.period ? keep_period : nullptr) {
    node_.attach(*this);
  }
  Sync(const Sync&) = delete;
  Sync& operator=(const Sync&) = delete;

  /// Called when is_lost() has changed: the application may raise an error of its own choice.
  Callback<void(bool is_lost)> lost_changed;

  /// True if no SYNC came for too long.
  bool is_lost() const { return lost_; }

  /// Attaches a listener. Listeners are called in the order of attachment.
  void attach(SyncListener& listener);

  /// False if the synchronous window (1007h) of the last SYNC is over: synchronous RPDOs that
  /// arrive then are too late for the next one. True before the first SYNC.
  bool is_window_open() const;

 private:
  /// Objects in between do not belong to it: a write to them only reads the same parameters again.
  static constexpr std::uint16_t first_object = object_index::cob_id_sync;
  static constexpr std::uint16_t last_object = object_index::sync_counter_overflow;

  /// Cause of a change in production and monitoring.
  enum class Beat : std::uint8_t { configured, restart, received };

  static void on_event(NodeService& service, ServiceEvent& event);
  static void on_constant_event(NodeService& service, ServiceEvent& event);
  void state_entered(NmtState state);
  AbortCode check(const Entry& entry, std::uint32_t wanted) const;
  void parameter_written();

  CobId cob_id() const;
  void read_parameters() { use(has_free_id(cob_id()) ? cob_id() : CobId{0}); }
  void use(CobId cob_id);
  bool fits(CobId present, CobId wanted) const;
  void beat(Beat beat) {
    if (keep_period_ != nullptr) keep_period_(*this, beat);
  }
  static void keep_period(Sync& self, Beat beat);
  void schedule(std::uint32_t late);
  static void expire(void* sync, Time now);
  void produce();
  void set_lost(bool lost);
  void receive(const Frame& frame, Time now);
  void announce(std::uint8_t counter);

  Node& node_;
  Timer timer_;
  void (*keep_period_)(Sync&, Beat);
  SyncListener* listeners_ = nullptr;
  StoredTime received_at_{Time{}};
  std::uint32_t due_ = 0;  ///< time of the next SYNC produced: see low_ticks()
  std::uint32_t period_ = 0;
  std::uint32_t window_ = 0;
};

}  // namespace canvoy
