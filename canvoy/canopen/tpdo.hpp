// Transmit PDOs: process data from the dictionary to the bus (CiA 301, 7.2.2, 7.5.2.37 and
// 7.5.2.38).
//
// A change of a mapped value is sent without a word from the application: whoever writes it through
// the dictionary has done all there is to do.
//
//     Tpdo pdos[4];
//     MappedValue values[4 * 8];
//     Tpdos tpdos(node, pdos, values, &sync);
//     dictionary.set(temperature, bytes);   // sent by the node's next advance()
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/mpdo.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/pdo_mapping.hpp"
#include "canvoy/canopen/pdo_parameter.hpp"
#include "canvoy/canopen/sync.hpp"

namespace canvoy {

class Tpdos;

/// What makes a multiplexed TPDO send.
enum class MpdoEvent : std::uint8_t {
  reset,  ///< parameters have their power-on values again
  begin,  ///< it begins to work, and waits for a change
  change,
  all,  ///< the application or the event timer wants everything to be sent
  end,  ///< it works no longer
};

/// How multiplexed TPDOs come to what they send: constant; each function takes the source first,
/// and then the number of the TPDO.
struct MpdoCalls {
  void (*event)(void*, std::uint16_t number, MpdoMode, MpdoEvent);
  /// Now is the time: Tpdos::send_mpdo() takes one frame after the other.
  void (*transmit)(void*, std::uint16_t number, MpdoMode);
  /// Objects of which a change is an event get these watchers.
  void (*watch)(void*, MpdoMode, std::uint32_t watchers);
};

/// What multiplexed TPDOs send: see MpdoProducer.
struct MpdoSource {
  const MpdoCalls* calls = nullptr;
  void* source = nullptr;
};

/// One TPDO.
class Tpdo {
 public:
  Tpdo() = default;
  Tpdo(const Tpdo&) = delete;
  Tpdo& operator=(const Tpdo&) = delete;

  /// Valid, and something is mapped.
  bool is_active() const { return length_ != 0; }

 private:
  friend class Tpdos;

  void answer(const Frame& frame, Time now);
  void inhibit_over(Time now);
  void event_timer_expired(Time now);

  Tpdos* owner_ = nullptr;
  PdoMapping mapping_;
  Timer inhibit_{Callback<void(Time)>::to<&Tpdo::inhibit_over>(*this)};
  Timer event_timer_{Callback<void(Time)>::to<&Tpdo::event_timer_expired>(*this)};
  PdoImage image_{};  ///< last sent, or sampled at SYNC
  Time sent_at_{};    ///< or began to work
  Duration inhibit_time_{};
  Duration event_period_{};
  CobId cob_id_;
  std::uint16_t number_ = 0;
  std::uint16_t route_ = 0;  ///< CAN-ID whose remote frames are answered; 0: none
  std::uint8_t type_ = 0;
  std::uint8_t sync_start_ = 0;
  std::uint8_t syncs_ = 0;   ///< SYNCs since the last transmission
  std::uint8_t length_ = 0;  ///< in bytes; 0 while it is not active
  MpdoMode mode_ = MpdoMode::none;
  bool sampled_ = false;   ///< `image_` is one
  bool sent_ = false;      ///< since it became active
  bool event_ = false;     ///< an event that waits for SYNC or the end of the inhibit time
  bool waiting_ = false;   ///< for room in the controller
  bool counting_ = false;  ///< the SYNC start value was seen
};

/// All TPDOs of a node. They transmit in NMT state operational only.
///
/// Types 254 and 255 are sent when a mapped value has changed, when the event timer expires, and by
/// trigger(); at most once in an inhibit time: an event within it is sent when it is over, with the
/// values of then. Type 0 is sent at the SYNC after such an event, 1 to 240 at every n-th SYNC. 252
/// is sampled at SYNC and sent on request, 253 is sent on request. A remote frame is answered where
/// bit 30 of the COB-ID allows it: by types 0 to 240 and 252 with the values of the last SYNC, by
/// the others with those of now.
///
/// Types 0 to 240 leave within the synchronous window (1007h): what finds no room in the controller
/// until the window is over is left out, and newer values are sent at the next turn. A remote frame
/// is answered outside of the window too.
class Tpdos {
 public:
  /// Whether event-driven TPDOs (types 0, 254, 255) are sent once when they begin to work: when the
  /// node becomes operational, or they become valid while it is.
  enum class AtStart : std::uint8_t { send, wait_for_event };

  /// PDO number n (from 1) has the objects 1800h + n - 1 and 1A00h + n - 1; it is off where they
  /// are absent. Each one can map an equal share of `values`, 64 at most. Without `sync` there is
  /// no SYNC. All must outlive this.
  Tpdos(Node& node, std::span<Tpdo> pdos, std::span<MappedValue> values, Sync* sync = nullptr,
        AtStart at_start = AtStart::send);
  Tpdos(const Tpdos&) = delete;
  Tpdos& operator=(const Tpdos&) = delete;

  /// Before the values of a PDO are sampled: the application may refresh them, through
  /// Dictionary::set.
  Callback<void(std::uint16_t number)> before_transmit;

  std::size_t size() const { return pdos_.size(); }
  /// `number` is 1 to size().
  Tpdo& operator[](std::uint16_t number) { return pdos_[number - 1U]; }

  /// An event of the application: the PDO is sent as if a value had changed. False where its type
  /// knows no events (0, 254 and 255 do), it is not active, or the node is not operational. From
  /// outside of a callback, call Node::advance(now) before.
  bool trigger(std::uint16_t number);

  /// From here on TPDOs can be multiplexed. MpdoProducer calls it, before the node is started.
  void use(const MpdoSource& source) { mpdos_ = source; }
  /// A multiplexed TPDO of this mode that is active in NMT state operational.
  bool is_ready(std::uint16_t number, MpdoMode mode) const;
  /// A TPDO beside this one has the mode.
  bool has_other(std::uint16_t number, MpdoMode mode) const;
  /// The MPDO source has something new for it.
  void announce_mpdos(std::uint16_t number) { event((*this)[number]); }
  /// Inhibit time and controller allow a frame of a multiplexed TPDO now. If not,
  /// MpdoCalls::transmit comes again.
  bool may_send_mpdo(std::uint16_t number);
  /// Sends one frame of a multiplexed TPDO that may send. False where it got lost, since there is
  /// no backlog.
  bool send_mpdo(std::uint16_t number, const PdoImage& image);
  /// Which objects a multiplexed TPDO of this mode sends has changed.
  void restart_mpdos(MpdoMode mode);

 private:
  friend class Tpdo;

  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void values_changed(std::uint32_t watchers);
  void tx_ready();
  bool is_in_time() const;
  void at_sync(std::uint8_t counter);
  AbortCode before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value);
  void parameter_written(const Entry& entry, Source source);
  AbortCode before_mapping_write(const Entry& entry, std::span<const std::uint8_t> value);

  AbortCode check_cob_id(const Tpdo& pdo, CobId wanted) const;

  void load(Tpdo& pdo);
  void read_parameters(Tpdo& pdo);
  void resolve(Tpdo& pdo);
  void listen(Tpdo& pdo, std::uint16_t can_id);
  void restart(Tpdo& pdo);
  void watch(const Tpdo& pdo);
  void begin(Tpdo& pdo);
  void end(Tpdo& pdo);
  void start_event_timer(Tpdo& pdo);

  void tell_source(const Tpdo& pdo, MpdoEvent event) const;
  void occur(Tpdo& pdo);
  void event(Tpdo& pdo);
  bool is_inhibited(Tpdo& pdo);
  bool has_changed(const Tpdo& pdo) const;
  void answer(Tpdo& pdo);
  bool is_turn(Tpdo& pdo, std::uint8_t counter);
  void sample(Tpdo& pdo);
  void transmit(Tpdo& pdo);
  void transmit_sample(Tpdo& pdo);
  bool has_source() const { return mpdos_.calls != nullptr; }
  bool owns(const Entry& entry) const { return (entry.index & 0x1FFU) < pdos_.size(); }
  Tpdo& at(const Entry& entry) { return pdos_[entry.index & 0x1FFU]; }

  Node& node_;
  std::span<Tpdo> pdos_;
  Sync* sync_;
  MpdoSource mpdos_;
  AtStart at_start_;
  bool operational_ = false;
  bool any_waits_ = false;
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls[2];
  ServiceLink service_{&service_calls, this};
  HookLink hooks_{hook_calls, this};
  SyncListener listener_;
};

}  // namespace canvoy
