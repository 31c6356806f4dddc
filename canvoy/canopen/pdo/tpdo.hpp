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

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo.hpp"

namespace canvoy {

using Tpdo = Pdo;

/// What makes a multiplexed TPDO send.
enum class MpdoEvent : std::uint8_t {
  reset,  ///< parameters have their power-on values again
  begin,  ///< it begins to work, and waits for a change
  change,
  all,       ///< the application or the event timer wants everything to be sent
  end,       ///< it works no longer
  transmit,  ///< now is the time: told by MpdoCalls::transmit
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
class Tpdos : public PdoService {
 public:
  /// Whether event-driven TPDOs (types 0, 254, 255) are sent once when they begin to work: when the
  /// node becomes operational, or they become valid while it is.
  enum class AtStart : std::uint8_t { send, wait_for_event };

  /// PDO number n (from 1) has the objects 1800h + n - 1 and 1A00h + n - 1; it is off where they
  /// are absent. `pdos` are those with the number `first` and up. Each one can map an equal share
  /// of `values`, 64 at most. Without `sync` there is no SYNC. All must outlive this.
  constexpr Tpdos(Node& node, std::span<Tpdo> pdos, std::span<MappedValue> values,
                  Sync* sync = nullptr, AtStart at_start = AtStart::send, std::uint16_t first = 1,
                  PdoRecords records = PdoRecords::writable)
      : PdoService(
            is_small_machine && records == PdoRecords::constant
                ? Listener{told_of_constant}
                : Listener{told, object_index::tpdo_parameter, object_index::tpdo_mapping_last},
            Cares::for_values | Cares::for_sample | Cares::for_watch, node, kind, pdos, values,
            sync, first),
        may_begin_(at_start == AtStart::send ? nullptr : waits_for_event) {}

  /// Before the values of a PDO are sampled: the application may refresh them, through
  /// Dictionary::set.
  Callback<void(std::uint16_t number)> before_transmit;

  /// Of an event-driven TPDO that begins to work and would be sent for that: false, and it waits
  /// for an event. For profiles of which some values cause no events until they are allowed to.
  using MayBegin = bool (*)(const Dictionary& dictionary, std::uint16_t number);
  void ask_at_start(MayBegin may_begin) { may_begin_ = may_begin; }

  /// An event of the application: the PDO is sent as if a value had changed. False where its type
  /// knows no events (0, 254 and 255 do), it is not active, or the node is not operational. From
  /// outside of a callback, call Node::advance(now) before.
  bool trigger(std::uint16_t number);

  /// From here on TPDOs can be multiplexed. MpdoProducer calls it, before the node is started.
  /// `source` must outlive this.
  void use(const MpdoSource& source) {
    mpdos_ = &source;
    tell_mpdos_ = tell_mpdos;
    multiplexed_ = mode_bits;
  }
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
  static void answer_routed(void* pdo, const Frame& frame, Time now);
  static void told(NodeService& service, ServiceEvent& event);
  static void told(PdoService& service, Tpdo& pdo, ServiceEvent& event);
  bool values_changed(const ServiceEvent& event);
  void find_values(PlacesOfValues values);
  void find_watcher(ServiceEvent& event);
  void values_changed(Tpdo& pdo, std::uint32_t watchers);
  void tx_ready(Tpdo& pdo);
  void bus_recovered(Tpdo& pdo);
  void sync(std::uint8_t counter);
  void sync(Tpdo& pdo, std::uint8_t counter);
  bool is_plain(const Tpdo& pdo) const;
  void send_changed(Tpdo& pdo);
  void look_at_time(Tpdo& pdo);
  void answer(Tpdo& pdo);
  void parameter_written(const Entry& entry);

  /// Without it a PDO only begins and ends.
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
  static void tell_mpdos(const Tpdos& self, const Tpdo& pdo, MpdoEvent event);
  void tell_source(const Tpdo& pdo, MpdoEvent event) const {
    if (tell_mpdos_ != nullptr) tell_mpdos_(*this, pdo, event);
  }
  void occur(Tpdo& pdo);
  void event(Tpdo& pdo);
  void sample(Tpdo& pdo);
  void transmit(Tpdo& pdo);
  void transmit_sample(Tpdo& pdo);
  [[gnu::noinline]] void wait(Tpdo& pdo);

  static const PdoKind kind;
  const MpdoSource* mpdos_ = nullptr;
  void (*tell_mpdos_)(const Tpdos&, const Tpdo&, MpdoEvent) = nullptr;  ///< set with `mpdos_`
  MayBegin may_begin_;                                                  ///< null: each one may
};

}  // namespace canvoy
