// What receive and transmit PDOs have in common: their memory, parameters, mappings and routes (CiA
// 301, 7.5.2.35 to 7.5.2.38).
//
// A PDO keeps what a frame needs; all else is read from its records in the dictionary when it is
// asked for. Applications use Rpdos and Tpdos:
//
//     Rpdo memory[4];
//     MappedValue values[4 * 8];
//     Rpdos rpdos(node, memory, values, &sync);
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
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

  /// Valid, and something is mapped.
  bool is_active() const { return length_ != 0; }
  /// Copies that are unrolled for each size make a host fast. A small processor has not the memory
  /// for their code, and goes byte by byte.
  static constexpr bool has_plans = !is_small_machine;
  /// Hosts find PDOs by routes. Small processors, which have few, look through them.
  static constexpr bool has_routes = !is_small_machine;
  /// How the values are copied where none of them is special; else, of an RPDO, what is to be done
  /// with any of them: MappedValue::Deed.
  enum Plan : std::uint8_t {
    mixed,     ///< one by one
    adjacent,  ///< as one
    whole,     ///< as one of eight bytes
    bytes,     ///< as eight
    words,     ///< as four of two bytes
    longs,     ///< as two of four bytes
  };

  /// Of an RPDO: it came since it became active in NMT state operational, and not too long ago.
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

  /// For hosts: there is a time to wait for.
  bool has_times() const { return (times_.value.period | times_.value.inhibit) != 0; }

  [[no_unique_address]] HostOnly<PdoService*> owner_;  ///< for who has come by its route
  PdoImage image_{};  ///< RPDO: held until the next SYNC; TPDO: last sent, or sampled at SYNC
  std::uint32_t since_ = 0;   ///< when it was received or sent, or began to work: see low_ticks()
  std::uint16_t can_id_ = 0;  ///< 0: not valid
  [[no_unique_address]] HostOnly<Times> times_;
  std::uint8_t type_ = 0;
  std::uint8_t bits_ = 0;    ///< that are mapped
  std::uint8_t length_ = 0;  ///< in bytes; 0 while it is not active
  /// TPDO: SYNCs since the last transmission. RPDO: errors that are present.
  std::uint8_t syncs_or_faults_ = 0;
  // What is known of the mapping, and of the COB-ID.
  std::uint8_t plan_ : 3 = 0;
  std::uint8_t mode_ : 2 = 0;
  bool special_ : 1 = false;  ///< one of the values is: see MappedValue
  bool stale_ : 1 = false;    ///< what hangs on the values is to be found out
  bool routed_ : 1 = false;
  // State of a TPDO.
  bool sampled_ : 1 = false;  ///< `image_` is one
  bool sent_ : 1 = false;     ///< at since_; not, where that is so long ago that nobody asks
  bool event_ : 1 = false;    ///< one that waits for SYNC or the end of the inhibit time
  bool waiting_ : 1 = false;  ///< for room in the controller
  /// TPDO: the SYNC start value was seen. RPDO: as `simple_`, but what the plan says is more than
  /// to copy.
  bool counts_or_goes_ : 1 = false;
  // State of an RPDO.
  bool holds_ : 1 = false;
  bool supervised_ : 1 = false;
  bool simple_ : 1 = false;  ///< nothing to do but to copy: see Rpdos::take_any()
};
static_assert(!is_small_machine || sizeof(void*) > 4 || sizeof(Pdo) == 20,
              "small devices have many PDOs");

/// What tells the two directions apart: constant.
struct PdoKind {
  PdoDirection direction;
  Access mappable;
  std::uint16_t parameter_first;     ///< index of the first communication record
  Router::Receiver::Function route;  ///< its object is the Pdo
  /// What happens to one PDO. What is told to the whole service is told to each.
  void (*told)(PdoService&, Pdo&, ServiceEvent&);
};

/// The common half of Rpdos and Tpdos.
class PdoService : protected NodeService {
 public:
  PdoService(const PdoService&) = delete;
  PdoService& operator=(const PdoService&) = delete;

  std::size_t size() const { return count_; }
  /// The lowest number that there is room for; size() - 1 more follow.
  std::uint16_t first() const { return first_; }
  bool has(std::uint16_t number) const { return position_of(number) < count_; }
  /// For hosts: how often an entry of a mapping record was read since the start: it is when a
  /// mapping is set, and never for a frame.
  std::uint32_t mapping_reads() const { return places_.value.reads; }
  /// One that it has.
  Pdo& operator[](std::uint16_t number) { return pdos_[position_of(number)]; }

 protected:
  /// `expired` is called with this.
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
  /// A PDO of this number is active in NMT state operational.
  bool works(std::uint16_t number) const;
  /// Not below size() where there is none of this number.
  unsigned position_of(std::uint16_t number) const {
    return static_cast<unsigned>(number) - first_;
  }
  std::uint16_t number_of(const Pdo& pdo) const {
    if constexpr (is_small_machine) return find_number(pdo);
    return static_cast<std::uint16_t>(&pdo - pdos_ + first_);
  }
  Pdo* find(const Entry& entry) const;
  static bool is_mapping(const Entry& entry) { return (entry.index & pdo_count_max) != 0; }
  /// An entry of its communication record, or `absent`; of its mapping record from sub-index
  /// `mapping` on.
  std::uint32_t parameter(const Pdo& pdo, unsigned sub, std::uint32_t absent) const;
  /// The same of the mapping record; `nothing` where it has no such entry.
  std::uint32_t mapped(const Pdo& pdo, unsigned sub) const;
  static constexpr std::uint32_t nothing = UINT32_MAX;

  AbortCode check_write(const Entry& entry, std::uint32_t wanted);
  /// Tells each PDO.
  void tell_each(ServiceEvent& event);
  /// For hosts: `tell` is called with those that are chosen, in their order.
  template <class Tell>
  void for_chosen(Tell tell) {
    const PdoSet& chosen = places_.value.chosen;
    for (unsigned i = 0; (i = chosen.next(i, count_)) < count_; ++i) tell(pdos_[i]);
  }
  void choose(const Pdo& pdo, bool is_chosen) {
    places_.value.chosen.set(static_cast<unsigned>(&pdo - pdos_), is_chosen);
  }
  /// The whole of it where records are constant, on a small machine.
  static void told_of_constant(NodeService& service, ServiceEvent& event);
  /// A frame came where there are no routes: whether it is for this PDO.
  bool takes(const Pdo& pdo, ServiceEvent& event) const;
  /// The timer, which is told to each PDO.
  static void expire(void* service, Time now);
  /// Reads all parameters anew. True where it is another PDO now.
  bool reload(Pdo& pdo);
  void reload_all() {
    for (Pdo& pdo : all()) reload(pdo);
  }
  /// The same of records that are constant and right.
  void load(Pdo& pdo);

  /// In microseconds; 0: none.
  std::uint32_t period_of(const Pdo& pdo) const;
  std::uint32_t inhibit_time_of(const Pdo& pdo) const;
  std::uint32_t ticks() const { return low_ticks(node_.now()); }
  /// Until `limit` microseconds are over since Pdo::since_.
  std::uint32_t time_left(const Pdo& pdo, std::uint32_t limit) const;
  /// The timer expires after this time, or earlier.
  void wake_in(std::uint32_t microseconds);

  /// For hosts: what is known of what hangs on the values may be no longer so.
  bool is_stale(const Pdo& pdo) const {
    return pdo.stale_ || places_.value.revision != node_.dictionary().revision();
  }
  /// Finds out anew what may have changed, without a look at the mapping record.
  void renew(Pdo& pdo) {
    if (Pdo::has_plans && is_stale(pdo)) look_again(pdo);
  }
  /// The present values. Where `asks`, hooks may refresh them before.
  void pack(const Pdo& pdo, PdoImage& image, bool asks) {
    if (Pdo::has_plans && pdo.plan_ == Pdo::whole) {
      store(image.data(),
            canvoy::load<std::uint64_t>(node_.dictionary().values() + values_of(pdo)->offset()));
    } else {
      pack_any(pdo, image, asks);
    }
  }
  MappedValue* values_of(const Pdo& pdo) const {
    return places_.value.values + static_cast<unsigned>(&pdo - pdos_) * places_.value.share;
  }
  /// What is done with all values of a PDO.
  enum class Step : std::uint8_t { read, refresh, check, write, announce };
  /// To `image` (read; refresh: hooks may do so before), or from it. Which object cannot have its
  /// value, as index and sub-index in the upper three bytes, as a mapping entry has them; or 0.
  std::uint32_t go_through(const Pdo& pdo, std::uint8_t* image, Step step);
  /// The steps of received data.
  std::uint32_t unpack(const Pdo& pdo, PdoImage& image, Step step) {
    if constexpr (!Pdo::has_plans) return go_through(pdo, image.data(), step);
    switch (step) {
      case Step::check:
        return check_values(pdo, image);
      case Step::write:
        write_values(pdo, image);
        return 0;
      default:
        announce_values(pdo);
        return 0;
    }
  }
  // The same for hosts, by what was resolved.
  std::uint32_t check_values(const Pdo& pdo, const PdoImage& image) const;
  void write_values(const Pdo& pdo, const PdoImage& image);
  /// All of the steps.
  std::uint32_t take_values(const Pdo& pdo, const PdoImage& image);
  void announce_values(const Pdo& pdo) const {
    if (pdo.special_ && (pdo.plan_ & MappedValue::tell) != 0) tell_of_values(pdo);
  }
  /// Of an active PDO its values, in their order: what it maps may change in between, and then it
  /// goes on with the new ones. `act(value, start)` says whether it goes on.
  template <class Act>
  void for_values(const Pdo& pdo, Act act) const {
    const MappedValue* value = values_of(pdo);
    const MappedValue* const end = value + places_.value.share;
    for (unsigned start = 0; start < pdo.bits_ && value != end; ++value) {
      const unsigned bits = value->bits();
      if (bits == 0 || start + bits > pdo.bits_ || !act(*value, start)) return;
      start += bits;
    }
  }
  /// Where a host keeps what it knows of mapped values.
  struct Places {
    MappedValue* values = nullptr;
    std::uint32_t revision = 0;       ///< Dictionary::revision() when renew() looked last
    std::uint16_t share = 0;          ///< of the values that each PDO may have
    bool are_found = false;           ///< for TPDOs: by PlacesOfValues
    mutable std::uint32_t reads = 0;  ///< of mapping records
    PdoSet chosen;  ///< TPDOs that wait for SYNC; RPDOs that may hold values for it
  };

  // What is small comes first: a Cortex-M0+ reaches it with shorter instructions.
  bool operational_ = false;
  bool any_waits_ = false;  ///< for hosts: a TPDO, for room in the controller
  Node& node_;
  const PdoKind& kind_;
  Pdo* pdos_;
  Sync* sync_;
  [[no_unique_address]] HostOnly<Places> places_;
  std::uint16_t count_;  ///< of `pdos_`
  std::uint16_t first_;  ///< the number of the first one of `pdos_`
  /// The bits of Pdo::mode_ that follow from transmission type and number of entries. Set with what
  /// serves multiplexed PDOs, so that nothing of them is linked where there are none.
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
  /// Tells the acceptance filter where there are no routes, and no other PDO has the CAN-ID.
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
  std::uint32_t check_limits(const Pdo& pdo, const PdoImage& image) const;
  std::uint32_t ask_for_values(const Pdo& pdo, const PdoImage& image) const;
  bool is_refused(const MappedValue& value, std::uint64_t number) const;
  void write_numbers(const Pdo& pdo, const PdoImage& image);
  void write_special(const MappedValue& value, std::uint64_t number);
  void tell_of_values(const Pdo& pdo) const;
  void pack_values(const Pdo& pdo, PdoImage& image, bool asks);
  void pack_any(const Pdo& pdo, PdoImage& image, bool asks);
  void look_again(Pdo& pdo);
  void forget_plan(Pdo& pdo);
  void keep_place(Pdo& pdo, unsigned position, const Entry& entry, unsigned bits);
  bool is_there(std::uint32_t mapped, Entry& entry) const;
  void resolve(Pdo& pdo);
  unsigned resolve(MappedValue& value) const;
  std::uint8_t plan_copies(const Pdo& pdo) const;

  Timer timer_;
};

}  // namespace canvoy
