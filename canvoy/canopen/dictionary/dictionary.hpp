// The object dictionary (CiA 301, 7.4): constant tables that say what there is, and a block of
// bytes with the values.
//
// The tables are made at compile time from a profile's description (canvoy/profiles); the block
// belongs to the owner. Values are kept packed, as they travel. What has meaning beyond a value
// hangs on as a Hook.
//
//     Result<Entry> entry = dictionary.find(0x6010, 0);
//     AbortCode answer = dictionary.write(0x1017, 0, bytes, Source::sdo);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/machine.hpp"
#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/canopen/dictionary/data_type.hpp"
#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/canopen/service.hpp"

namespace canvoy {

/// What may be done with an entry: bits, of which the usual sums have names.
enum class Access : std::uint8_t {
  none = 0,
  sdo_read = 1,
  sdo_write = 2,
  tpdo = 4,       ///< may be mapped into a TPDO
  rpdo = 8,       ///< may be mapped into an RPDO
  constant = 16,  ///< does not change in operation
  ro = sdo_read,
  wo = sdo_write,
  rw = sdo_read | sdo_write,
  const_ = sdo_read | constant,
};
constexpr Access operator|(Access a, Access b) {
  return static_cast<Access>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool allows(Access access, Access what) {
  return (static_cast<unsigned>(access) & static_cast<unsigned>(what)) ==
         static_cast<unsigned>(what);
}

/// How limits and default of an entry are to be read: bits.
enum class EntryTraits : std::uint8_t {
  none = 0,
  limited = 1,       ///< `low` and `high` hold
  has_sentinel = 2,  ///< `sentinel` is allowed although it lies outside of the limits
  plus_node_id = 4,  ///< the default is `initial` plus the node-ID
  not_stored = 8,    ///< a value of the process, no parameter: it is not kept without power
  text = 16,         ///< a string: filled in by the layout
  has_sign = 32,     ///< a signed integer: filled in by the layout
};
constexpr EntryTraits operator|(EntryTraits a, EntryTraits b) {
  return static_cast<EntryTraits>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(EntryTraits traits, EntryTraits trait) {
  return (static_cast<unsigned>(traits) & static_cast<unsigned>(trait)) != 0;
}

/// Bytes from the start of a block of values: a small machine's whole memory is below 64 KiB.
using BlockOffset = std::conditional_t<is_small_machine, std::uint16_t, std::uint32_t>;

/// What the tables say of entries of one shape: sub-indices first to last of an object, all of one
/// type, access and range. Objects of one shape may share them, so that defaults stand apart.
struct EntryShape {
  std::uint8_t sub_first = 0;
  std::uint8_t sub_last = 0;
  DataType type = DataType::unsigned8;
  Access access = Access::ro;
  EntryTraits traits = EntryTraits::none;
  std::uint8_t bits = 0;       ///< of a number
  std::uint16_t capacity = 0;  ///< bytes that one value takes at most; a domain takes none
  /// Where it is limited: of low, high and sentinel in DictionaryTables::numbers.
  std::uint16_t limits = 0;
  BlockOffset offset = 0;  ///< of the first value, from the start of the object's values

  constexpr bool is_text() const { return has(traits, EntryTraits::text); }
  /// Bytes from one value to the next: a string keeps its present length in two bytes before it.
  constexpr std::uint16_t pitch() const {
    return static_cast<std::uint16_t>(capacity + (is_text() ? 2 : 0));
  }
  friend bool operator==(const EntryShape&, const EntryShape&) = default;
};

/// Objects of one shape: `count` objects with consecutive indices. Who writes one says how many
/// entries it has; what comes after that is filled in by the layout.
struct ObjectRow {
  std::uint16_t index = 0;  ///< of the first
  std::uint16_t count = 1;
  std::uint16_t entry_count = 0;
  std::uint16_t entry_first = 0;  ///< position in the table of entries
  /// Position of the first entry's default, and how many further that of the next object is: 0
  /// where all have the same ones.
  std::uint16_t default_first = 0;
  std::uint16_t default_pitch = 0;
  BlockOffset offset = 0;  ///< of the first object's values, from the start of the block
  BlockOffset pitch = 0;   ///< bytes from one object's values to the next object's
};

class Dictionary;
struct DictionaryTables;

/// Limits, and the bits of odd sizes that stay unused: of a value that has the length of its type.
AbortCode check_number(const DictionaryTables& tables, const EntryShape& row,
                       const std::uint8_t* value);

/// The run-time half of a description: constant, and shared by all nodes of a kind.
struct DictionaryTables {
  std::span<const ObjectRow> objects;   ///< sorted by index, without overlap
  std::span<const EntryShape> entries;  ///< of each object sorted by sub-index, without overlap
  /// One for each entry of an object: a number, or the bits of a real; of more than four bytes its
  /// place in `numbers`, of a string its place in `texts`.
  std::span<const std::uint32_t> defaults;
  std::span<const std::int64_t> numbers;
  std::span<const std::string_view> texts;
  std::uint32_t value_bytes = 0;  ///< size of the block
  /// For devices of which objects change their place: the index by which the tables have what the
  /// bus knows by `index`, 0 where the bus finds nothing there. Null: every object stays.
  std::uint16_t (*index_in_tables)(const Dictionary&, std::uint16_t index) = nullptr;
  /// Null where no entry has anything for it to check, so that a small machine does not link it.
  AbortCode (*check_number)(const DictionaryTables& tables, const EntryShape& row,
                            const std::uint8_t* value) = &canvoy::check_number;

  constexpr std::span<const EntryShape> entries_of(const ObjectRow& object) const {
    return entries.subspan(object.entry_first, object.entry_count);
  }
  /// Of the object `index` of such a row.
  constexpr const std::uint32_t* defaults_of(const ObjectRow& object, unsigned index) const {
    return defaults.data() + object.default_first + (index - object.index) * object.default_pitch;
  }
  /// A default of `defaults` as what it is: a number or the bits of a real, without the node-ID
  /// that may be added.
  constexpr std::uint64_t number_at(const EntryShape& row, std::uint32_t place) const {
    return row.capacity > sizeof place ? static_cast<std::uint64_t>(numbers[place]) : place;
  }
};

/// What changes at run time for an ObjectRow, beside the values. A small machine has none: each
/// change has all TPDOs look whether it concerns them, and each access asks all hooks.
struct ObjectState {
  /// Bit n: a TPDO of which the number modulo 32 is n maps an entry of this row.
  std::uint32_t watchers = 0;
  std::uint8_t hooks = 0;  ///< accesses of which somebody is asked or told: ServiceEvent::bit_of()
  bool several = false;    ///< services are, of which each covers an object of this row
  NodeService* hooked = nullptr;  ///< the one that is, where there are not several
};

/// One entry, found: lives as long as the dictionary.
struct Entry {
  const EntryShape* row = nullptr;
  [[no_unique_address]] HostOnly<ObjectState*> state = {};
  std::uint8_t* value = nullptr;  ///< of a string, its length; of a domain, meaningless
  std::uint16_t index = 0;
  std::uint8_t sub = 0;

  /// The first four bytes of a number.
  std::uint32_t word() const { return load_word(value, row->capacity); }
  /// There may be a hook of one of these accesses: ServiceEvent::bit_of().
  bool is_hooked(unsigned accesses) const {
    return is_small_machine || (state.value->hooks & accesses) != 0;
  }
  bool is_hooked(ServiceEvent::Kind access) const {
    return is_hooked(unsigned{ServiceEvent::bit_of(access)});
  }
  std::uint32_t watchers() const { return is_small_machine ? ~0U : state.value->watchers; }
  /// The bytes of the present value.
  std::span<std::uint8_t> bytes() const {
    if (!row->is_text()) return {value, row->capacity};
    return {value + 2, load<std::uint16_t>(value)};
  }
};

/// Where an entry stands, in few bytes: for hosts, who keep thousands of them.
struct EntryPlace {
  std::uint32_t offset = 0;  ///< of its value, in bytes from the start of the block
  std::uint16_t object = 0;  ///< position of its ObjectRow
  std::uint16_t row = 0;     ///< position of its EntryShape
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
};

/// The first few watched values that were changed, so that who maps them is found without a look at
/// all who might.
struct ChangedPlaces {
  static constexpr std::size_t places_max = 8;

  constexpr ChangedPlaces() = default;
  /// Copies no more than there are.
  ChangedPlaces(const ChangedPlaces& other) : count(other.count) {  // NOLINT: the rest says nothing
    places[0] = other.places[0];
    for (std::size_t i = 1; i < count && i < places_max; ++i) places[i] = other.places[i];
  }
  ChangedPlaces& operator=(const ChangedPlaces&) = delete;

  /// There were more, or it is not known where.
  bool are_too_many() const { return count > places_max; }
  void add(std::uint32_t place) {
    if (count < places_max) places[count] = place;
    if (count <= places_max) ++count;
  }
  void forget() { count = places_max + 1; }

  std::size_t count = 0;
  std::array<std::uint32_t, places_max> places{};  ///< of values, from the start of the block
};

class SdoEntry;
struct Domain;

/// How SDO servers stream domains: a table, so that nothing of it is linked where there is no
/// Domain.
struct DomainTransfer {
  AbortCode (*open_read)(SdoEntry&, const Domain&);
  Result<std::span<const std::uint8_t>> (*read)(SdoEntry&, std::span<std::uint8_t> memory);
  AbortCode (*open_write)(SdoEntry&, const Domain&);
  AbortCode (*write)(SdoEntry&, std::span<const std::uint8_t> bytes);
  AbortCode (*close)(SdoEntry&, bool complete);

  static const DomainTransfer calls;
};

/// The content of a domain, streamed (never whole in memory).
struct Domain {
  /// An answer of open_read: the end shows when it is reached.
  static constexpr std::uint32_t size_unknown = 0xFFFF'FFFF;

  /// Begins an upload, and says how many bytes there are, or size_unknown.
  Callback<Result<std::uint32_t>(const Entry&)> open_read;
  /// Fills `bytes` from `offset` on, and says how many there were: fewer than asked for, and they
  /// are the last. More than open_read told are not asked for. Offsets ascend; but where segments
  /// of a block upload were lost, it comes back by up to 889 bytes.
  Callback<Result<std::size_t>(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes)>
      read;
  /// Begins a download; `size` is what the client announced, 0 where it did not.
  Callback<AbortCode(const Entry&, std::uint32_t size)> open_write;
  Callback<AbortCode(const Entry&, std::span<const std::uint8_t> bytes)> write;
  /// Ends a download: with `complete` false all that was written is to be forgotten.
  Callback<AbortCode(const Entry&, bool complete)> close_write;
  const DomainTransfer* transfer = &DomainTransfer::calls;
};

/// What HookCalls says of a class, of one object and at run time: for applications. It is called
/// for all objects of a range that are in the dictionary, for accesses from the bus (SDO, PDO)
/// only. The owner keeps it alive as long as the dictionary.
struct Hook {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  /// May refresh the value (through Dictionary::set) before it is read, or refuse.
  Callback<AbortCode(const Entry&)> before_read = {};
  /// May refuse the new value. All entries of a PDO are asked before one is written. It may answer
  /// `deferred` where it does itself what the write is for, and that takes time: then nothing is
  /// written here, and whoever waits is told by Node::finish_deferred().
  Callback<AbortCode(const Entry&, std::span<const std::uint8_t> value)> before_write = {};
  Callback<void(const Entry&, Source)> after_write = {};
  const Domain* domain = nullptr;

  /// Its place among the services of the node.
  class Link : public NodeService {
   public:
    explicit Link(const Hook* hook)
        : NodeService({told}, Cares::for_nothing_frequent), hook_(hook) {}

   private:
    static void told(NodeService& link, ServiceEvent& event);

    const Hook* hook_;
  };
  Link link{this};
};

class Dictionary {
 public:
  /// `values` has tables.value_bytes bytes. `states` has one for each ObjectRow, or none on a small
  /// machine. Both must outlive the dictionary, and so must `tables` on a small machine.
  constexpr Dictionary(const DictionaryTables& tables, std::span<std::uint8_t> values,
                       std::span<ObjectState> states)
      : tables_(tables), values_(values.data()) {
    if constexpr (!is_small_machine) {
      states_.value = states.data();
      remembered_.value.fill(&no_row);
    }
    // What is constant-initialised is zero.
    if (std::is_constant_evaluated()) return;
    for (std::uint8_t& byte : values) byte = 0;
  }
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  /// Looks an entry up: in constant time where the object was found before and no other took its
  /// place, else logarithmic in the number of rows. Aborts: no_object, no_sub_index.
  Result<Entry> find(std::uint16_t index, std::uint8_t sub) const;
  /// The same for the index and sub-index that stand in `entry`, of which the rest is filled in.
  AbortCode locate(Entry& entry) const;
  /// The same for who names objects as the bus knows them: SDO, PDO mapping, MPDO. See
  /// DictionaryTables::index_in_tables; `entry` gets the index of the tables.
  AbortCode locate_for_bus(Entry& entry) const {
    if (tables_.index_in_tables != nullptr) {
      entry.index = tables_.index_in_tables(*this, entry.index);
    }
    return locate(entry);
  }
  Result<Entry> find_for_bus(std::uint16_t index, std::uint8_t sub) const;

  /// The value as a client may read it, hooks included. It is valid until the entry is written.
  /// Aborts: those of find, write_only, and the hooks'. A domain has no value here
  /// (unsupported_access): see domain().
  Result<std::span<const std::uint8_t>> read(const Entry& entry) {
    const AbortCode answer = open_read(entry);
    if (answer != AbortCode::none) return answer;
    return std::span<const std::uint8_t>(entry.bytes());
  }
  /// The same for who takes the value from the entry.
  AbortCode open_read(const Entry& entry) {
    if constexpr (is_small_machine) return refresh(entry);
    const AbortCode answer = check_read(entry);
    return answer == AbortCode::none && entry.is_hooked(ServiceEvent::before_read) ? refresh(entry)
                                                                                   : answer;
  }

  /// Checks what CiA 301 asks for (access, length, range, hooks) and writes, or answers why not and
  /// changes nothing.
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> value, Source source);
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value,
                  Source source);

  /// The checks of write() without access rights: length, range, hooks.
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value) const;
  /// Length and range alone.
  AbortCode check_value(const EntryShape& row, std::span<const std::uint8_t> value) const;
  /// Writes what was checked before, and calls after_write.
  void commit(const Entry& entry, std::span<const std::uint8_t> value, Source source);
  /// Calls after_write alone: for a PDO, of which all values are written before one is told of.
  void announce(const Entry& entry, Source source);

  /// For hosts: who is asked and told of accesses to an entry, for ask() and tell_of(), which then
  /// search for nobody. It holds until revision() changes. Linear in the number of services.
  EntryHooks find_hooks(const Entry& entry) const;
  AbortCode ask(const Entry& entry, std::span<const std::uint8_t> value,
                const EntryHooks& hooks) const;
  void tell_of(const Entry& entry, Source source, const EntryHooks& hooks) const {
    if (hooks.service == nullptr || hooks.after_row == EntryHooks::any_row) {
      return tell_any(entry, source, hooks);
    }
    static_cast<const ServiceLink&>(*hooks.service).tell_row(hooks.after_row, entry, source);
  }
  /// For hosts: a TPDO maps this very entry. It holds until revision() changes.
  bool is_watched(const Entry& entry) const;
  /// For hosts: where a located entry stands, and the entry there.
  EntryPlace place_of(const Entry& entry) const {
    return {.offset = static_cast<std::uint32_t>(entry.value - values_),
            .object = static_cast<std::uint16_t>(entry.state.value - states_.value),
            .row = static_cast<std::uint16_t>(entry.row - tables_.entries.data()),
            .index = entry.index,
            .sub = entry.sub};
  }
  Entry entry_at(const EntryPlace& place) const {
    Entry entry{.row = &tables_.entries[place.row],
                .value = values_ + place.offset,
                .index = place.index,
                .sub = place.sub};
    entry.state.value = states_.value + place.object;
    return entry;
  }
  /// For hosts: a watched value that stands there was changed past set().
  void note_change(const EntryPlace& place) {
    changes_ |= states_.value[place.object].watchers;
    changed_places_.value.add(place.offset);
  }

  /// Writes from inside the device: no access rights, ranges or hooks; TPDOs that map the entry
  /// learn of a change. Bytes beyond the capacity are dropped.
  void set(const Entry& entry, std::span<const std::uint8_t> value);
  /// The same for a number of any type; it is cut to the length of the entry. False where there is
  /// no such entry.
  bool set_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number);
  /// The same at sub-index 0, of four bytes at most.
  void set_word(std::uint16_t index, std::uint32_t number);
  /// The number in an entry, not sign-extended; 0 where there is none.
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) const;
  /// The same of up to four bytes (of a longer one the lower four), or `absent`.
  std::uint32_t word(std::uint16_t index, std::uint8_t sub, std::uint32_t absent = 0) const;
  /// The same at sub-index 0.
  std::uint32_t word(std::uint16_t index) const;

  /// The default of a number, without the node-ID that may be added.
  std::uint64_t default_number(const Entry& entry) const;

  /// The callbacks of a domain entry; null where nobody serves it.
  const Domain* domain(const Entry& entry) const;

  /// It is asked and told before all that are attached already. Linear in the number of rows.
  void attach(Hook& hook);
  /// It is asked and told no more. Not from within a callback of a hook. Linear in the number of
  /// services.
  void detach(Hook& hook);
  /// Services are asked and told in the order in which they were attached. See Node::attach().
  constexpr void attach(NodeService& service) {
    append(service);
    if constexpr (!is_small_machine) {
      if (service.frequent_.value.cares != 0) append_frequent(service);
    }
    if (!is_small_machine && service.covers(service.listener_.first)) {
      mark_hooked(service, service.listener_.first, service.listener_.last,
                  ServiceEvent::all_accesses);
    }
  }
  constexpr void attach(ServiceLink& service) {
    append(service);
    if (!is_small_machine && service.calls_->values_changed != nullptr) append_frequent(service);
    if (!is_small_machine && !service.calls_->hooks.empty()) mark_hooked(service);
  }
  NodeService* services() const { return services_; }
  /// All services, until one refuses: of an access those that cover the object. See ServiceEvent.
  std::uint32_t tell(ServiceEvent::Kind kind, std::uint32_t number,
                     const void* subject = nullptr) const;
  std::uint32_t tell(ServiceEvent& event) const;
  /// The same of what is frequent: on a host, those that care for it.
  void tell_frequent(ServiceEvent& event) const {
    if constexpr (is_small_machine) {
      tell(event);
    } else {
      NodeService* service = frequent_.value.first;
      for (; service != nullptr; service = service->frequent_.value.next) {
        if ((service->frequent_.value.cares >> event.kind & 1) != 0) service->tell(event);
      }
    }
  }

  /// Gives all entries of the objects from `first` to `last` their default values.
  void restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id);

  /// TPDOs (numbers modulo 32) that map something that was changed since clear_changes().
  std::uint32_t changes() const { return changes_; }
  void clear_changes() {
    changes_ = 0;
    if constexpr (!is_small_machine) changed_places_.value.count = 0;
  }
  /// For who writes past set(): what these watchers watch was changed.
  void mark_changed(std::uint32_t watchers) {
    changes_ |= watchers;
    if constexpr (!is_small_machine) changed_places_.value.forget();
  }
  /// For hosts: where those changes were.
  const ChangedPlaces& changed_places() const { return changed_places_.value; }

  /// Adds to the watchers of an entry's row: bits of TPDO numbers modulo 32. For TPDOs, which know
  /// which entries of the row are meant (ServiceEvent::watch_asked).
  void watch(const Entry& entry, std::uint32_t watchers);
  /// Takes these bits from all rows. Linear in the number of rows.
  void unwatch(std::uint32_t watchers);
  /// For hosts: counts attached hooks and changes of watchers: who keeps what hangs on a value
  /// compares this number, and looks again where it differs.
  std::uint32_t revision() const { return revision_.value; }

  const DictionaryTables& tables() const { return tables_; }
  /// The block of values, for who keeps places in it.
  std::uint8_t* values() const { return values_; }

 private:
  /// Rows that were found last, each in a place that its index gives: a client reads entry after
  /// entry of an object, and a master the same few objects again and again. A 32-bit processor
  /// searches its few rows, and spares the memory.
  static constexpr std::size_t remembered_max = 16;

  const ObjectRow* find_object(std::uint16_t index) const;
  const ObjectRow* search_object(std::uint16_t index) const;
  const EntryShape* find_row(const ObjectRow& object, std::uint8_t sub) const;
  AbortCode look_up(Entry& entry) const;
  bool has_value(Entry& entry) const;
  static AbortCode check_read(const Entry& entry) {
    if (!allows(entry.row->access, Access::sdo_read)) return AbortCode::write_only;
    return entry.row->type == DataType::domain ? AbortCode::unsupported_access : AbortCode::none;
  }
  AbortCode refresh(const Entry& entry);
  std::uint64_t default_of(const EntryShape& row, std::uint32_t place, std::uint8_t node_id) const;
  void restore_default(const Entry& entry, std::uint32_t place, std::uint8_t node_id);
  void restore_unwatched(std::span<const EntryShape> rows, Entry& entry, const std::uint32_t* place,
                         std::uint8_t node_id);
  void mark_hooked(NodeService& service, std::uint16_t first, std::uint16_t last,
                   std::uint8_t accesses);
  void mark_hooked(ServiceLink& service);
  void tell_of_access(ServiceEvent& event) const;
  void tell_any(const Entry& entry, Source source, const EntryHooks& hooks) const;
  constexpr void append(NodeService& service) {
    *last_ = &service;
    last_ = &service.next_;
  }
  void append_frequent(NodeService& service) {
    NodeService*& last = frequent_.value.last;
    (last == nullptr ? frequent_.value.first : last->frequent_.value.next) = &service;
    last = &service;
  }
  /// The services that are told what is frequent.
  struct Frequent {
    NodeService* first = nullptr;
    NodeService* last = nullptr;
  };
  static constexpr ObjectRow no_row = {.index = 0, .count = 0};

  std::conditional_t<is_small_machine, const DictionaryTables&, const DictionaryTables> tables_;
  std::uint8_t* values_;
  [[no_unique_address]] HostOnly<ObjectState*> states_;
  NodeService* services_ = nullptr;
  NodeService** last_ = &services_;  ///< where the next service is tied
  std::uint32_t changes_ = 0;
  [[no_unique_address]] HostOnly<std::uint32_t> revision_;
  [[no_unique_address]] HostOnly<Frequent> frequent_;
  [[no_unique_address]] HostOnly<ChangedPlaces> changed_places_;
  [[no_unique_address]] mutable HostOnly<std::array<const ObjectRow*, remembered_max>> remembered_;
};

}  // namespace canvoy
