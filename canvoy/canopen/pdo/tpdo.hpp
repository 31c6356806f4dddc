// Transmit PDOs: process data from the dictionary to the bus (CiA 301, 7.2.2, 7.5.2.37 and
// 7.5.2.38).
//
// A change of a mapped value is sent automatically: a write through the dictionary is all that is
// needed.
//
//     Tpdo pdos[4];
//     MappedValue values[4 * 8];
//     Tpdos tpdos(node, pdos, values, &sync);
//     dictionary.set(temperature, bytes);   // sent by the node's next advance()
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo.hpp"

namespace canvoy {

/// A transmit PDO: memory for Tpdos.
using Tpdo = Pdo;

/// An event for a multiplexed TPDO.
enum class MpdoEvent : std::uint8_t {
  reset,  ///< parameters have their power-on values again
  begin,  ///< it becomes active, and waits for a change
  change,
  all,       ///< the application or the event timer requests transmission of everything
  end,       ///< it becomes inactive
  transmit,  ///< it may transmit: passed to MpdoCalls::transmit
};

/// Functions by which multiplexed TPDOs obtain what they send: constant; each takes the source
/// first, then the number of the TPDO.
struct MpdoCalls {
  /// Notifies of an event; all but MpdoEvent::transmit.
  void (*event)(void*, std::uint16_t number, MpdoMode, MpdoEvent);
  /// Called when transmission is possible: Tpdos::send_mpdo() takes one frame after the other.
  void (*transmit)(void*, std::uint16_t number, MpdoMode);
  /// Sets these watchers for objects with changes that are events.
  void (*watch)(void*, MpdoMode, std::uint32_t watchers);
};

/// Source of multiplexed TPDOs: see MpdoProducer.
struct MpdoSource {
  const MpdoCalls* calls = nullptr;  ///< null: no TPDO can be multiplexed
  void* source = nullptr;            ///< first argument of each call
};

/// All TPDOs of a node. They transmit in NMT state operational only.
///
/// Types 254 and 255 are sent when a mapped value has changed, when the event timer expires, and by
/// trigger(); for a value set with or without an explicit event (Dictionary::set_with_event()),
/// that decides, not whether it has changed. They are sent at most once in an inhibit time: an
/// event within it is sent at its end, with the values of that moment. Type 0 is sent at the SYNC
/// after such an event, 1 to 240 at every n-th SYNC. 252 is sampled at SYNC and sent on request,
/// 253 is sent on request. A remote frame is answered if bit 30 of the COB-ID allows it: by types 0
/// to 240 and 252 with the values of the last SYNC, by the others with the present values.
///
/// Types 0 to 240 leave within the synchronous window (1007h): a PDO that finds no room in the
/// controller until the window is over is skipped, and newer values are sent at the next turn. A
/// remote frame is answered outside of the window too.
class Tpdos : public PdoService {
 public:
  /// Whether event-driven TPDOs (types 0, 254, 255) are sent once when they become active: when the
  /// node becomes operational, or when they become valid in that state.
  enum class AtStart : std::uint8_t { send, wait_for_event };

  /// Makes the TPDOs. PDO number n (from 1) has the objects 1800h + n - 1 and 1A00h + n - 1; it is
  /// disabled if they are absent. `pdos` are those with the number `first` and up. Each can map an
  /// equal share of `values`, 64 at most. Without `sync` there is no SYNC. All arguments must
  /// outlive this object.
  constexpr Tpdos(Node& node, std::span<Tpdo> pdos, std::span<MappedValue> values,
                  Sync* sync = nullptr, AtStart at_start = AtStart::send, std::uint16_t first = 1,
                  PdoRecords records = PdoRecords::writable)
      : PdoService(
            is_small_machine && records == PdoRecords::constant
                ? Listener{on_constant_event}
                : Listener{on_event, object_index::tpdo_parameter, object_index::tpdo_mapping_last},
            EventMask::values | EventMask::sample | EventMask::watch, node, kind, pdos, values,
            sync, first),
        may_begin_(at_start == AtStart::send ? nullptr : waits_for_event) {}

  /// Called before the values of a PDO are sampled: the application may refresh them with
  /// Dictionary::set.
  Callback<void(std::uint16_t number)> before_transmit;

  /// Decides whether an event-driven TPDO that becomes active is sent for that; false: it waits for
  /// an event. For profiles with values that cause no events until they are enabled.
  using MayBegin = bool (*)(const Dictionary& dictionary, std::uint16_t number);
  /// Replaces the choice that AtStart made. `may_begin` is asked each time; null: always sent.
  void ask_at_start(MayBegin may_begin) { may_begin_ = may_begin; }

  /// Reports an event of the application: the PDO is sent as if a value had changed. False if its
  /// type has no events (0, 254 and 255 have), it is not active, or the node is not operational.
  /// Outside of a callback, call Node::advance(now) before.
  bool trigger(std::uint16_t number);

  /// Enables multiplexed TPDOs. MpdoProducer calls it before the node is started. `source` must
  /// outlive this object.
  void use(const MpdoSource& source) {
    mpdos_ = &source;
    notify_mpdos_ = notify_mpdos;
    multiplexed_ = mode_bits;
  }
  /// True if a multiplexed TPDO of this number and mode is active in NMT state operational.
  bool is_ready(std::uint16_t number, MpdoMode mode) const;
  /// True if another TPDO has the mode.
  bool has_other(std::uint16_t number, MpdoMode mode) const;
  /// Notes that the MPDO source has something new for this TPDO.
  void announce_mpdos(std::uint16_t number) { event((*this)[number]); }
  /// True if inhibit time and controller allow a frame of a multiplexed TPDO. If false,
  /// MpdoCalls::transmit is called again later.
  bool may_send_mpdo(std::uint16_t number);
  /// Sends one frame of a multiplexed TPDO that may send. False if it is lost for lack of a
  /// backlog.
  bool send_mpdo(std::uint16_t number, const PdoImage& image);
  /// Notes that the set of objects for multiplexed TPDOs of this mode has changed.
  void restart_mpdos(MpdoMode mode);

 private:
  static void answer_routed(void* pdo, const Frame& frame, Time now);
  static void on_event(NodeService& service, ServiceEvent& event);
  static void on_event(PdoService& service, Tpdo& pdo, ServiceEvent& event);
  bool values_changed(const ServiceEvent& event);
  void find_values(PlacesOfValues values);
  void find_watcher(ServiceEvent& event);
  bool values_changed(const ChangedPlaces& changed, const PlacesOfValues& values);
  void values_changed(Tpdo& pdo, std::uint32_t watchers);
  void value_changed(Tpdo& pdo);
  bool value_set(const ServiceEvent& event);
  void value_set(Tpdo& pdo, const Entry& entry, bool is_event);
  /// True for a value that was set with an event.
  static bool has_event(const Tpdo& pdo) { return !is_small_machine && pdo.holds_; }
  void tx_ready(Tpdo& pdo);
  void bus_recovered(Tpdo& pdo);
  void sync(std::uint8_t counter);
  void sync(Tpdo& pdo, std::uint8_t counter);
  bool is_plain(const Tpdo& pdo) const;
  void send_changed(Tpdo& pdo);
  void look_at_time(Tpdo& pdo);
  void answer(Tpdo& pdo);
  void parameter_written(const Entry& entry);

  /// True if it is active; otherwise a PDO only begins and ends.
  bool is_at_work(const Tpdo& pdo) const { return operational_ && pdo.is_active(); }
  static std::uint32_t watcher_of(std::uint16_t number);
  void watch(std::uint32_t watchers);
  void begin(Tpdo& pdo);
  void end(Tpdo& pdo);

  bool is_in_time() const;
  bool has_changed(const Tpdo& pdo);
  bool differs(const Tpdo& pdo);
  bool is_turn(Tpdo& pdo, std::uint8_t counter);
  bool is_inhibited(const Tpdo& pdo) const;
  static constexpr std::uint32_t no_limit = UINT32_MAX;
  std::uint32_t time_left(const Tpdo& pdo) const;
  void wake(const Tpdo& pdo);
  void be_due(Tpdo& pdo);
  void begin_anew(Tpdo& pdo);
  bool keep_inhibited(Tpdo& pdo);

  static bool waits_for_event(const Dictionary&, std::uint16_t) { return false; }
  static void notify_mpdos(const Tpdos& self, const Tpdo& pdo, MpdoEvent event);
  void notify_source(const Tpdo& pdo, MpdoEvent event) const {
    if (notify_mpdos_ != nullptr) notify_mpdos_(*this, pdo, event);
  }
  void occur(Tpdo& pdo);
  void event(Tpdo& pdo);
  void sample(Tpdo& pdo);
  void transmit(Tpdo& pdo);
  void transmit_sample(Tpdo& pdo);
  [[gnu::noinline]] void wait(Tpdo& pdo);

  static const PdoKind kind;
  const MpdoSource* mpdos_ = nullptr;
  /// Set together with `mpdos_`.
  void (*notify_mpdos_)(const Tpdos&, const Tpdo&, MpdoEvent) = nullptr;
  MayBegin may_begin_;  ///< null: every TPDO may begin
};

}  // namespace canvoy
