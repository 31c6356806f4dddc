// The common part of receive and transmit PDOs: memory, parameters, mappings and routes (CiA 301,
// 7.5.2.35 to 7.5.2.38).
//
// A PDO keeps what a frame needs; all else is read from its records in the dictionary when it is
// needed. Applications use Rpdos and Tpdos:
//
//     Rpdo memory[4];
//     MappedValue values[4 * 8];
//     Rpdos rpdos(node, memory, values, &sync);
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/pdo_mapping.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/canopen/pdo/pdo_records.hpp"
#include "canvoy/canopen/sync/sync.hpp"

namespace canvoy {

class PdoService;

/// One PDO of either direction.
class Pdo {
 public:
  Pdo() = default;
  Pdo(const Pdo&) = delete;
  Pdo& operator=(const Pdo&) = delete;

  /// True if it is valid and something is mapped.
  bool is_active() const { return length_ != 0; }
  /// Unrolled copies for each size make a host fast. A small processor has no memory for their
  /// code, and copies byte by byte.
  static constexpr bool has_plans = !is_small_machine;
  /// Hosts find PDOs by routes. Small processors, which have few, search through them.
  static constexpr bool has_routes = !is_small_machine;
  /// How values without special handling are copied.
  enum Plan : std::uint8_t {
    mixed,     ///< one by one
    adjacent,  ///< as one value
    whole,     ///< as one value of eight bytes
    bytes,     ///< as eight bytes
    words,     ///< as four values of two bytes
    longs,     ///< as two values of four bytes
  };

  /// For an RPDO: true if one arrived since it became active in NMT state operational, and within
  /// the deadline.
  bool is_supervised() const { return supervised_; }

 private:
  friend class PdoService;
  friend class Rpdos;
  friend class Tpdos;

  MpdoMode mode() const {
    return mode_ == 0 ? MpdoMode::none : static_cast<MpdoMode>(mode_ | ~mode_mask);
  }
  static constexpr unsigned mode_mask = 3;
  static constexpr unsigned plan_mask = 7;

  /// Times of the communication record, which a host reads once.
  struct Times {
    std::uint16_t period = 0;   ///< event timer, or deadline, in ms; 0: none
    std::uint16_t inhibit = 0;  ///< in 100 us
  };

  /// For hosts: true if there is a time to wait for.
  bool has_times() const { return (times_.value.period | times_.value.inhibit) != 0; }

  [[no_unique_address]] HostOnly<PdoService*> owner_;    ///< for a receiver called by its route
  [[no_unique_address]] HostOnly<MappedValue*> values_;  ///< as many as it can map
  PdoImage image_{};  ///< RPDO: held until the next SYNC; TPDO: last sent, or sampled at SYNC
  std::uint32_t since_ = 0;   ///< time of reception, transmission or activation: see low_ticks()
  std::uint16_t can_id_ = 0;  ///< 0: not valid
  [[no_unique_address]] HostOnly<Times> times_;
  /// RPDO: combined deeds of all values, MappedValue::Deed; 0: they are copied by the plan.
  [[no_unique_address]] HostOnly<std::uint8_t> deeds_;
  std::uint8_t type_ = 0;
  std::uint8_t bits_ = 0;    ///< number of mapped bits
  std::uint8_t length_ = 0;  ///< in bytes; 0 while the PDO is not active
  /// TPDO: SYNCs since the last transmission. RPDO: bits of the errors present.
  std::uint8_t syncs_or_faults_ = 0;
  // Properties of the mapping and of the COB-ID.
  std::uint8_t plan_ : 3 = 0;
  std::uint8_t mode_ : 2 = 0;
  bool quick_ : 1 = false;  ///< RPDO: the next frame is taken at once: see Rpdos::take_any()
  bool stale_ : 1 = false;  ///< properties that depend on the values must be determined again
  bool routed_ : 1 = false;
  // State of a TPDO.
  bool sampled_ : 1 = false;  ///< `image_` is a sample
  bool sent_ : 1 = false;     ///< at since_; false if that is too long ago to matter
  bool event_ : 1 = false;    ///< an event waits for SYNC or the end of the inhibit time
  bool waiting_ : 1 = false;  ///< waits for room in the controller
  bool counts_ : 1 = false;   ///< the SYNC start value was seen
  /// RPDO: a value waits for the next SYNC. TPDO: an event, whatever the last value.
  bool holds_ : 1 = false;
  // State of an RPDO.
  bool supervised_ : 1 = false;
};
static_assert(!is_small_machine || sizeof(void*) > 4 || sizeof(Pdo) == 20,
              "small devices have many PDOs");

/// Differences between the two directions: constant.
struct PdoKind {
  PdoDirection direction;            ///< of the frames, as this node sees them
  Access mappable;                   ///< right that an entry needs to be mapped
  std::uint16_t parameter_first;     ///< index of the first communication record
  Router::Receiver::Function route;  ///< called with the Pdo as its object
  /// Handles an event for one PDO. Events of the whole service are passed to each.
  void (*on_event)(PdoService&, Pdo&, ServiceEvent&);
};

/// The common part of Rpdos and Tpdos.
class PdoService : protected NodeService {
 public:
  PdoService(const PdoService&) = delete;
  PdoService& operator=(const PdoService&) = delete;

  /// Number of PDOs with memory, 512 at most; not all need be in the dictionary.
  std::size_t size() const { return count_; }
  /// Lowest number with memory; size() - 1 more follow.
  std::uint16_t first() const { return first_; }
  /// True if the PDO `number`, counted from 1, has memory.
  bool has(std::uint16_t number) const { return position_of(number) < count_; }
  /// PDO of a number that exists.
  Pdo& operator[](std::uint16_t number) { return pdos_[position_of(number)]; }

 protected:
  /// Makes the service; its timer calls expire() with this object.
  constexpr PdoService(const NodeService::Listener& listener, std::uint32_t cares, Node& node,
                       const PdoKind& kind, std::span<Pdo> pdos, std::span<MappedValue> values,
                       Sync* sync, std::uint16_t first)
      : NodeService(listener, cares),
        node_(node),
        kind_(kind),
        pdos_(pdos.data()),
        sync_(sync),
        count_(static_cast<std::uint16_t>(std::min<std::size_t>(pdos.size(), pdo_count_max))),
        first_(first),
        timer_(Callback<void(Time)>(expire, this)) {
    can_id_ = every_id;
    if (Pdo::has_plans && count_ != 0) share(values);
    if (count_ != 0) node_.attach(*this);
  }
  ~PdoService() = default;

  std::span<Pdo> all() const { return {pdos_, count_}; }
  /// True if a PDO of this number is active in NMT state operational.
  bool works(std::uint16_t number) const;
  /// Position of a number; size() or above if there is none.
  unsigned position_of(std::uint16_t number) const {
    return static_cast<unsigned>(number) - first_;
  }
  std::uint16_t number_of(const Pdo& pdo) const {
    if constexpr (is_small_machine) return find_number(pdo);
    return static_cast<std::uint16_t>(&pdo - pdos_ + first_);
  }
  Pdo* find(const Entry& entry) const;
  static bool is_mapping(const Entry& entry) { return (entry.index & pdo_count_max) != 0; }
  /// Entry of its communication record, or `absent`; from sub-index `mapping` on, of its mapping
  /// record.
  std::uint32_t parameter(const Pdo& pdo, unsigned sub, std::uint32_t absent) const;
  /// Like parameter(), but of the mapping record; `nothing` if there is no such entry.
  std::uint32_t mapped(const Pdo& pdo, unsigned sub) const;
  static constexpr std::uint32_t nothing = UINT32_MAX;

  AbortCode check_write(const Entry& entry, std::uint32_t wanted);
  /// Passes an event to each PDO.
  void notify_each(ServiceEvent& event);
  /// For hosts: calls `notify` with the chosen PDOs, in their order.
  template <class Tell>
  void for_chosen(Tell notify) {
    const PdoSet& chosen = places_.value.chosen;
    for (unsigned i = 0; (i = chosen.next(i, count_)) < count_; ++i) notify(pdos_[i]);
  }
  void choose(const Pdo& pdo, bool is_chosen) {
    places_.value.chosen.set(static_cast<unsigned>(&pdo - pdos_), is_chosen);
  }
  /// Complete handler of events for constant records, on a small machine.
  static void on_constant_event(NodeService& service, ServiceEvent& event);
  /// Without routes: true if a received frame is for this PDO.
  bool takes(const Pdo& pdo, ServiceEvent& event) const;
  /// Handles the timer: passes the event to each PDO.
  static void expire(void* service, Time now);
  /// Reads all parameters again. True if the PDO has changed.
  bool reload(Pdo& pdo);
  void reload_all() {
    for (Pdo& pdo : all()) reload(pdo);
  }
  /// Like reload(), but for records that are constant and correct.
  void load(Pdo& pdo);

  /// Period in microseconds; 0: none.
  std::uint32_t period_of(const Pdo& pdo) const;
  std::uint32_t inhibit_time_of(const Pdo& pdo) const;
  std::uint32_t ticks() const { return low_ticks(node_.now()); }
  /// Time in microseconds until `limit` is over, counted from Pdo::since_.
  std::uint32_t time_left(const Pdo& pdo, std::uint32_t limit) const;
  /// Makes the timer expire after this time, or earlier.
  void wake_in(std::uint32_t microseconds);

  /// For hosts: true if properties that depend on the values may have changed.
  bool is_stale(const Pdo& pdo) const {
    return pdo.stale_ || places_.value.revision != node_.dictionary().revision();
  }
  /// Determines again what may have changed, without reading the mapping record.
  void renew(Pdo& pdo) {
    if (Pdo::has_plans && is_stale(pdo)) look_again(pdo);
  }
  /// Packs the present values. If `asks`, hooks may refresh them before.
  void pack(const Pdo& pdo, PdoImage& image, bool asks) {
    if (Pdo::has_plans && pdo.plan_ == Pdo::whole) {
      store(image.data(), canvoy::load<std::uint64_t>(values_of(pdo)->value()));
    } else {
      pack_any(pdo, image, asks);
    }
  }
  static MappedValue* values_of(const Pdo& pdo) { return pdo.values_.value; }
  /// Operation on all values of a PDO.
  enum class Step : std::uint8_t { read, refresh, check, write, announce };
  /// Copies values to `image` (read, refresh: after hooks), or from it. Returns the object that
  /// cannot take its value, as index and sub-index in the upper three bytes like a mapping entry;
  /// otherwise 0.
  std::uint32_t go_through(const Pdo& pdo, std::uint8_t* image, Step step);
  /// Carries out one step for received data.
  std::uint32_t unpack(const Pdo& pdo, PdoImage& image, Step step) {
    if constexpr (!Pdo::has_plans) return go_through(pdo, image.data(), step);
    return carry_out(pdo, image, step);
  }
  /// Like go_through(), but for hosts, with the resolved mapping.
  std::uint32_t carry_out(const Pdo& pdo, const PdoImage& image, Step step);
  // Its steps, of which only ask_for_values() and announce_values() call services.
  static bool are_within_limits(const Pdo& pdo, const std::int64_t* numbers, std::uint64_t image);
  bool are_doubtful(const Pdo& pdo, std::uint64_t image) const;
  std::uint32_t ask_for_values(const Pdo& pdo, const PdoImage& image) const;
  void note_changes(const Pdo& pdo, std::uint64_t image);
  void write_one_by_one(const Pdo& pdo, const PdoImage& image);
  void write_values(const Pdo& pdo, const PdoImage& image);
  void announce_values(const Pdo& pdo) const;
  void announce_rest(const Pdo& pdo, const MappedValue* first, unsigned start) const;
  /// For hosts: copies received values by the plan.
  [[gnu::always_inline]] static void copy(const Pdo& pdo, const PdoImage& image) {
    const MappedValue* const values = values_of(pdo);
    if (pdo.plan_ == Pdo::whole) [[likely]] {
      std::memcpy(values->value(), image.data(), pdo_bytes_max);
      return;
    }
    switch (pdo.plan_) {
      case Pdo::bytes:
        return scatter<std::uint8_t>(values, image);
      case Pdo::words:
        return scatter<std::uint16_t>(values, image);
      case Pdo::longs:
        return scatter<std::uint32_t>(values, image);
      default:
        std::memcpy(values->value(), image.data(), pdo.length_);
    }
  }
  /// Calls `act(value, start)` for the values of an active PDO, in their order, while it returns
  /// true. The mapping may change in between; the loop then continues with the new values.
  template <class Act>
  void for_values(const Pdo& pdo, Act act) const {
    for_values_from(values_of(pdo), 0, pdo, act);
  }
  /// The same from the value on that begins at this bit.
  template <class Act>
  void for_values_from(const MappedValue* value, unsigned start, const Pdo& pdo, Act act) const {
    const MappedValue* const end = values_of(pdo) + places_.value.share;
    for (; start < pdo.bits_ && value != end; ++value) {
      const unsigned bits = value->bits();
      if (bits == 0 || start + bits > pdo.bits_ || !act(*value, start)) return;
      start += bits;
    }
  }
  /// Calls `act(start, bits)` for the positions of an entry in an active PDO.
  template <class Act>
  void for_places(const Pdo& pdo, const Entry& entry, Act act) const {
    const auto look_at = [&](unsigned index, unsigned sub, unsigned start, unsigned bits) {
      if (index == entry.index && sub == entry.sub) act(start, bits);
    };
    if constexpr (Pdo::has_plans) {
      for_values(pdo, [&](const MappedValue& value, unsigned start) {
        look_at(value.entry().index, value.entry().sub, start, value.bits());
        return true;
      });
    } else {
      for (unsigned sub = 1, start = 0; start < pdo.bits_; ++sub) {
        const std::uint32_t value = mapped(pdo, sub);
        look_at(value >> 16, value >> 8 & 0xFF, start, value & 0xFF);
        start += value & 0xFF;
      }
    }
  }
  /// Data of a host about mapped values.
  struct Places {
    MappedValue* values = nullptr;
    const Pdo* watching = nullptr;  ///< for RPDOs: the TPDOs that MappedValue::watcher() counts
    std::uint32_t revision = 0;     ///< Dictionary::revision() at the last renew()
    std::uint16_t share = 0;        ///< limit of values for each PDO
    bool are_found = false;         ///< for TPDOs: by PlacesOfValues
    PdoSet chosen;                  ///< TPDOs that wait for SYNC; RPDOs that may hold values for it
  };

  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
  bool operational_ = false;
  bool any_waits_ = false;  ///< for hosts: a TPDO waits for room in the controller
  Node& node_;
  const PdoKind& kind_;
  Pdo* pdos_;
  Sync* sync_;
  [[no_unique_address]] HostOnly<Places> places_;
  std::uint16_t count_;  ///< of `pdos_`
  std::uint16_t first_;  ///< number of the first of `pdos_`
  /// Bits of Pdo::mode_ that follow from transmission type and number of entries. Set together with
  /// the service of multiplexed PDOs, so that a program without them links none of it.
  unsigned (*multiplexed_)(std::uint8_t type, unsigned count) = nullptr;
  static unsigned mode_bits(std::uint8_t type, unsigned count);

 private:
  void share(std::span<MappedValue> values);
  std::uint16_t find_number(const Pdo& pdo) const;
  static constexpr unsigned mapping = 0x100;
  bool is_receive() const { return kind_.direction == PdoDirection::receive; }
  bool is_reserved_type(std::uint32_t type) const {
    return canvoy::is_reserved_type(type, kind_.direction);
  }
  AbortCode check_cob_id(const Pdo& pdo, CobId present, CobId wanted) const;
  AbortCode check_mapping(Pdo& pdo, const Entry& entry, std::uint32_t wanted);
  /// Sets the acceptance filter if there are no routes, and no other PDO has the CAN-ID.
  void listen(Pdo& pdo, bool wanted);
  void route(Pdo& pdo, std::uint16_t can_id, bool wanted);
  bool listens(std::uint16_t can_id) const;

  AbortCode find_mapped(std::uint32_t mapped, Entry& entry) const;
  AbortCode map(Pdo& pdo, unsigned count);
  struct BitField {
    unsigned start;
    unsigned bits;
  };
  bool access(std::uint8_t* image, BitField field, Step step, Entry& entry);
  /// Copies values of one size that fill the PDO. Its bytes are loaded once: single loads, each
  /// after a store, take twice the time.
  template <class Unit, std::size_t... i>
  static void scatter(const MappedValue* values, const PdoImage& image, std::index_sequence<i...>) {
    const auto bytes = canvoy::load<std::uint64_t>(image.data());
    (store(values[i].value(), static_cast<Unit>(bytes >> (i * sizeof(Unit) * 8))), ...);
  }
  template <class Unit>
  static void scatter(const MappedValue* values, const PdoImage& image) {
    scatter<Unit>(values, image, std::make_index_sequence<pdo_bytes_max / sizeof(Unit)>());
  }
  void pack_values(const Pdo& pdo, PdoImage& image, bool asks);
  void pack_any(const Pdo& pdo, PdoImage& image, bool asks);
  void look_again(Pdo& pdo);
  void forget_plan(Pdo& pdo);
  void keep_place(Pdo& pdo, unsigned position, const Entry& entry, unsigned bits);
  bool is_there(std::uint32_t mapped, Entry& entry) const;
  void resolve(Pdo& pdo);
  unsigned resolve(MappedValue& value);
  unsigned find_watcher(const EntryWatchers& watchers);
  std::uint8_t plan_copies(const Pdo& pdo) const;

  Timer timer_;
};

}  // namespace canvoy
