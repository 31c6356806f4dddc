// SYNC: the beat to which synchronous PDOs are taken over and sent; consumer and producer (CiA 301,
// 7.2.5 and objects 1005h, 1006h, 1007h, 1019h).
//
//     Sync sync(node);
//     Rpdos rpdos(node, rpdo_memory, rpdo_values, &sync);
//     Tpdos tpdos(node, tpdo_memory, tpdo_values, &sync);
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// An application that waits for SYNC (between ServiceEvent::actuate and sample). Owned by the
/// waiting one, for as long as the Sync lives.
struct SyncListener {
  /// The counter is 0 where SYNC carries none.
  Callback<void(std::uint8_t counter)> received;
  SyncListener* next = nullptr;
};

/// Without 1005h it listens to CAN-ID 080h; without 1006h it produces nothing. It works in NMT
/// states pre-operational and operational. A SYNC with another length than 1019h asks for is
/// ignored, and raises 8240h until a good one comes. As a producer it is a consumer of its own
/// SYNC.
///
/// Where 1006h is not zero a consumer supervises SYNC from the first one on: it is lost while none
/// came for one and a half periods. CiA 301 has no such supervision and no error code for it; the
/// indicators of CiA 303-3 show it.
///
/// The counter of a received SYNC is told to the listeners as it is. One that is missing or out of
/// turn changes nothing: the message is the beat, and the counter only says where TPDOs with a SYNC
/// start value begin.
///
/// The counter that is produced starts with 1 when production begins, and when the node leaves NMT
/// state stopped. The first SYNC follows one period after production begins; periods are kept
/// without drift.
///
/// Where masters can write none of the four objects nothing that follows a write is linked, and
/// without 1006h neither producer nor supervision.
class Sync : private NodeService {
  // What is small comes first: a Cortex-M0+ reaches it with shorter instructions.
  std::uint8_t overflow_ = 0;
  std::uint8_t counter_ = 0;  ///< of the last SYNC that was produced
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
  /// What the dictionary has.
  struct Objects {
    bool writable = true;
    bool period = true;  ///< 1006h
  };

  constexpr explicit Sync(Node& node, const Objects& objects = {true, true})
      : NodeService(objects.writable ? Listener{told, first_object, last_object}
                                     : Listener{told_of_constant},
                    Cares::for_nothing_frequent),
        node_(node),
        timer_(objects.period ? Callback<void(Time)>(expire, this) : Callback<void(Time)>()),
        keep_period_(objects.period ? keep_period : nullptr) {
    node_.attach(*this);
  }
  Sync(const Sync&) = delete;
  Sync& operator=(const Sync&) = delete;

  /// is_lost() has changed: the application may raise an error of its own choice.
  Callback<void(bool is_lost)> lost_changed;

  /// No SYNC came for too long.
  bool is_lost() const { return lost_; }

  /// Listeners are called in the order in which they were attached.
  void attach(SyncListener& listener);

  /// False where the synchronous window (1007h) of the last SYNC is over: synchronous RPDOs that
  /// come now are too late for the next one. Before the first one there is none that could be over.
  bool is_window_open() const;

 private:
  /// What lies between is nothing to it: a write there has it read the same parameters again.
  static constexpr std::uint16_t first_object = object_index::cob_id_sync;
  static constexpr std::uint16_t last_object = object_index::sync_counter_overflow;

  /// What becomes of producer and supervision.
  enum class Beat : std::uint8_t { configured, restart, received };

  static void told(NodeService& service, ServiceEvent& event);
  static void told_of_constant(NodeService& service, ServiceEvent& event);
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
  std::uint32_t due_ = 0;  ///< the next SYNC that is produced: see low_ticks()
  std::uint32_t period_ = 0;
  std::uint32_t window_ = 0;
};

}  // namespace canvoy
