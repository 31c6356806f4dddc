// The object dictionary: constant tables that describe the entries, and a block of bytes with the
// values (CiA 301, 7.4).
//
// The tables are made at compile time from a profile's description (canvoy/profiles); the block
// belongs to the owner. Values are packed, as on the wire. A meaning beyond the value is attached
// as a Hook.
//
//     Result<Entry> entry = dictionary.find(0x6010, 0);
//     AbortCode answer = dictionary.write(0x1017, 0, bytes, Source::sdo);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/machine.hpp"
#include "canvoy/canopen/dictionary/dictionary_tables.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/service/service.hpp"

namespace canvoy {

/// Run-time state of an ObjectRow, beside the values. A small machine has none: on each change all
/// TPDOs check whether it concerns them, and each access asks all hooks.
struct ObjectState {
  static constexpr std::size_t services_max = 3;  ///< kept by their addresses

  /// Bit n: a TPDO of which the number modulo 32 is n maps an entry of this row.
  std::uint32_t watchers = 0;
  /// Of the index, not of this row: see Dictionary::search_object().
  std::uint16_t place = 0;
  std::uint8_t hooks = 0;  ///< accesses with a hook: ServiceEvent::bit_of()
  /// Services that are, of which each covers an object of this row: more than services_max where
  /// not all of them stand here.
  std::uint8_t service_count = 0;
  std::array<NodeService*, services_max> services{};  ///< in the order in which they are told

  /// True if all services of this row stand in `services`.
  bool has_all() const { return service_count <= services_max; }
  /// Counts a service, and keeps it while there is room.
  void add(NodeService& service, bool in_front);
  /// Forgets a service; if not all are kept, the count stays.
  void remove(const NodeService& service);
};

/// One entry, found in the dictionary; valid as long as the dictionary.
struct Entry {
  const EntryShape* row = nullptr;                          ///< null: not found
  [[no_unique_address]] HostOnly<ObjectState*> state = {};  ///< of its ObjectRow
  std::uint8_t* value = nullptr;  ///< for a string, its length; for a domain, meaningless
  std::uint16_t index = 0;        ///< as in the tables: see locate_for_bus()
  std::uint8_t sub = 0;           ///< sub-index

  /// First four bytes of a number.
  std::uint32_t word() const { return load_word(value, row->capacity); }
  /// True if there may be a hook for one of these accesses: ServiceEvent::bit_of().
  bool is_hooked(unsigned accesses) const {
    return is_small_machine || (state.value->hooks & accesses) != 0;
  }
  /// True if there may be a hook for this access.
  bool is_hooked(ServiceEvent::Kind access) const {
    return is_hooked(unsigned{ServiceEvent::bit_of(access)});
  }
  /// No more than one service has a hook there. On a small machine it is not known.
  bool is_hooked_by_one() const { return !is_small_machine && state.value->service_count <= 1; }
  /// Numbers of TPDOs, modulo 32, that map it: ObjectState::watchers. All on a small machine.
  std::uint32_t watchers() const { return is_small_machine ? ~0U : state.value->watchers; }
  /// Bytes of the present value.
  std::span<std::uint8_t> bytes() const {
    if (!row->is_text()) return {value, row->capacity};
    return {value + 2, load<std::uint16_t>(value)};
  }
};

/// The first few watched values that were changed, so that the TPDOs that map them are found
/// without a search through all.
struct ChangedPlaces {
  static constexpr std::size_t places_max = 8;  ///< changes kept

  constexpr ChangedPlaces() = default;
  /// Copies only the places in use.
  ChangedPlaces(const ChangedPlaces& other) : count(other.count) {  // NOLINT: the rest says nothing
    places[0] = other.places[0];
    for (std::size_t i = 1; i < count && i < places_max; ++i) places[i] = other.places[i];
  }
  ChangedPlaces& operator=(const ChangedPlaces&) = delete;

  /// True if there were more changes, or a position is unknown.
  bool are_too_many() const { return count > places_max; }
  /// Adds a change at an offset. Beyond places_max it is only counted.
  void add(std::uint32_t place) {
    if (count < places_max) places[count] = place;
    if (count <= places_max) ++count;
  }
  /// Notes that positions are unknown: all TPDOs check.
  void forget() { count = places_max + 1; }

  std::size_t count = 0;  ///< changes, up to places_max + 1
  /// Offsets of values from the start of the block.
  std::array<std::uint32_t, places_max> places{};
};

class SdoEntry;
struct Domain;

/// Streaming of domains by SDO servers: a table of functions, so that a program without a Domain
/// links none of it.
struct DomainTransfer {
  AbortCode (*open_read)(SdoEntry&, const Domain&);  ///< begins an upload
  /// Next bytes of an upload, in `memory` or elsewhere; none at the end.
  Result<std::span<const std::uint8_t>> (*read)(SdoEntry&, std::span<std::uint8_t> memory);
  AbortCode (*open_write)(SdoEntry&, const Domain&);                   ///< begins a download
  AbortCode (*write)(SdoEntry&, std::span<const std::uint8_t> bytes);  ///< takes bytes, in order
  AbortCode (*close)(SdoEntry&, bool complete);                        ///< ends either

  /// Those that use the functions of the Domain.
  static const DomainTransfer calls;
};

/// Content of a domain, streamed (never whole in memory).
struct Domain {
  /// Result of open_read for an unknown size: the end shows when it is reached.
  static constexpr std::uint32_t size_unknown = 0xFFFF'FFFF;

  /// Begins an upload, and returns the number of bytes, or size_unknown.
  Callback<Result<std::uint32_t>(const Entry&)> open_read;
  /// Fills `bytes` from `offset` on, and returns the number filled: fewer than requested mark the
  /// end. No more than the size from open_read are requested: the bytes of a segment, on a host as
  /// many segments as the server's buffer has room for, and if that is refused, one. Offsets
  /// ascend, except after lost segments of a block upload, which go back by up to 889 bytes.
  Callback<Result<std::size_t>(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes)>
      read;
  /// Begins a download; `size` is the size that the client announced, 0 if none.
  Callback<AbortCode(const Entry&, std::uint32_t size)> open_write;
  /// Takes the next bytes: of a segment, on a host of a block that fits into the server's buffer.
  Callback<AbortCode(const Entry&, std::span<const std::uint8_t> bytes)> write;
  /// Ends a download; with `complete` false, all data written must be discarded.
  Callback<AbortCode(const Entry&, bool complete)> close_write;

  /// For hosts, in place of open_read and read: the content, sent without a copy until the end.
  Callback<Result<std::span<const std::uint8_t>>(const Entry&)> view = {};
  /// For hosts, in place of open_write: where the bytes of a download are put as they come, without
  /// a copy; `size` as open_write has it. No more come than there is room (0504 0005h, 0607 0012h).
  /// When the last of them has come, `write` is called once, with all of them.
  Callback<Result<std::span<std::uint8_t>>(const Entry&, std::uint32_t size)> room = {};
  const DomainTransfer* transfer = &DomainTransfer::calls;  ///< streams by the functions above
};

/// Like AccessHandlers, but set at run time for one instance, for applications. It is called for
/// objects of a range, and only for accesses from the bus (SDO, PDO). It must outlive the
/// dictionary. After it is attached, a callback may be replaced, not added.
struct Hook {
  std::uint16_t first = 0;  ///< lowest index
  std::uint16_t last = 0;   ///< highest index, included
  /// May refresh the value (with Dictionary::set) before it is read, or refuse.
  Callback<AbortCode(const Entry&)> before_read = {};
  /// May refuse the new value. For a PDO it is called for all entries before one is written. It may
  /// answer `deferred` if it carries out the purpose of the write itself, and needs time for it:
  /// then nothing is written here, and the waiting service gets the answer from
  /// Node::finish_deferred().
  Callback<AbortCode(const Entry&, std::span<const std::uint8_t> value)> before_write = {};
  /// Notifies of a value that was written by an SDO client or an RPDO.
  Callback<void(const Entry&, Source)> after_write = {};
  const Domain* domain = nullptr;  ///< for entries of type domain in this range

  /// What is set: ServiceEvent::bit_of().
  std::uint8_t accesses() const {
    using Event = ServiceEvent;
    return static_cast<std::uint8_t>(
        Event::bit_if(static_cast<bool>(before_read), Event::before_read) |
        Event::bit_if(static_cast<bool>(before_write), Event::before_write) |
        Event::bit_if(static_cast<bool>(after_write), Event::after_write) |
        Event::bit_if(domain != nullptr, Event::domain_wanted));
  }

  /// Link in the list of the node's services.
  class Link : public NodeService {
   public:
    /// Links `hook`, which must outlive it.
    explicit Link(const Hook* hook) : NodeService({on_event}, EventMask::none), hook_(hook) {}

   private:
    static void on_event(NodeService& link, ServiceEvent& event);

    const Hook* hook_;
  };
  Link link{this};  ///< owned by the hook
};

/// The values of one node, and the services and hooks that give them a meaning.
class Dictionary {
 public:
  /// Makes a dictionary. `values` has tables.value_bytes bytes. `states` has one item for each
  /// ObjectRow, or none on a small machine. Both must outlive the dictionary, and so must `tables`
  /// on a small machine.
  constexpr Dictionary(const DictionaryTables& tables, std::span<std::uint8_t> values,
                       std::span<ObjectState> states)
      : tables_(tables), values_(values.data()) {
    if constexpr (!is_small_machine) {
      states_.value = states.data();
      remembered_.value.fill(&no_row);
    }
    // Constant-initialised memory is zero.
    if (std::is_constant_evaluated()) return;
    for (std::uint8_t& byte : values) byte = 0;
    if constexpr (!is_small_machine) make_index();
  }
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  /// Looks an entry up: in constant time where the object was found before and no other took its
  /// place, or where its index is not in a crowd of others; else logarithmic in the number of rows.
  /// Aborts: no_object, no_sub_index.
  Result<Entry> find(std::uint16_t index, std::uint8_t sub) const;
  /// Like find(), but for the index and sub-index in `entry`; fills in the rest of it.
  AbortCode locate(Entry& entry) const;
  /// Like locate(), but for an index as the bus uses it: SDO, PDO mapping, MPDO. See
  /// DictionaryTables::index_in_tables; `entry` gets the index of the tables.
  AbortCode locate_for_bus(Entry& entry) const {
    if (tables_.index_in_tables != nullptr) {
      entry.index = tables_.index_in_tables(*this, entry.index);
    }
    return locate(entry);
  }
  /// Like find(), but for an index as the bus uses it: see locate_for_bus().
  Result<Entry> find_for_bus(std::uint16_t index, std::uint8_t sub) const;

  /// Value as a client may read it, hooks included. It is valid until the entry is written. Aborts:
  /// those of find(), write_only, and those of hooks. A domain has no value here
  /// (unsupported_access): see domain().
  Result<std::span<const std::uint8_t>> read(const Entry& entry) {
    const AbortCode answer = open_read(entry);
    if (answer != AbortCode::none) return answer;
    return std::span<const std::uint8_t>(entry.bytes());
  }
  /// Like read(), but without the value, which the caller takes from the entry.
  AbortCode open_read(const Entry& entry) {
    if constexpr (is_small_machine) return refresh(entry);
    const AbortCode answer = check_read(entry);
    return answer == AbortCode::none && entry.is_hooked(ServiceEvent::before_read) ? refresh(entry)
                                                                                   : answer;
  }

  /// Checks access, length, range and hooks as CiA 301 requires, and writes; on an abort changes
  /// nothing.
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> value, Source source);
  /// Like write(), but looks the entry up first, as the bus addresses it. Aborts also: those of
  /// find().
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value,
                  Source source);

  /// Checks like write(), but without access rights: length, range, hooks.
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value) const;
  /// Checks length and range only.
  AbortCode check_value(const EntryShape& row, std::span<const std::uint8_t> value) const;
  /// Writes a value that was checked before, and calls after_write.
  void commit(const Entry& entry, std::span<const std::uint8_t> value, Source source);
  /// Calls after_write only: for a PDO, which writes all values before the first notification.
  void announce(const Entry& entry, Source source);

  /// For hosts: functions to ask and to notify of writes of an entry. Valid until revision()
  /// changes. Linear in the number of services.
  EntryHooks find_hooks(const Entry& entry);
  /// For hosts: which TPDOs map this entry. Valid until revision() changes.
  EntryWatchers find_watchers(const Entry& entry) const;
  /// For hosts: bytes from the start of all values to that of a located entry.
  std::uint32_t offset_of(const Entry& entry) const {
    return static_cast<std::uint32_t>(entry.value - values_);
  }
  /// For hosts: notes that the value of a watched entry was changed without set().
  void note_change(const Entry& entry) {
    changes_ |= entry.watchers();
    changed_places_.value.add(offset_of(entry));
  }

  /// Writes from inside the device: no access rights, ranges or hooks; TPDOs that map the entry are
  /// notified of a change. Bytes beyond the capacity are dropped.
  void set(const Entry& entry, std::span<const std::uint8_t> value);
  /// Like set(), but for a number with a change that is an event by rules of the application, such
  /// as interrupt masks: TPDOs that map it are sent even if they carried the same bytes last. On a
  /// small machine it equals set(): a TPDO that carried the same bytes last is not sent.
  void set_with_event(const Entry& entry, std::span<const std::uint8_t> value);
  /// Like set(), but the change is no event: no TPDO is sent for it, and the next one includes it.
  void set_without_event(const Entry& entry, std::span<const std::uint8_t> value);
  /// Like set(), but for a number of any type, cut to the length of the entry. False if there is no
  /// such entry.
  bool set_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number);
  /// Like set_number(), but at sub-index 0, and for four bytes at most.
  void set_word(std::uint16_t index, std::uint32_t number);
  /// Number in an entry, not sign-extended; 0 if there is no such entry.
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) const;
  /// Like number(), but for up to four bytes (the lower four of a longer number); `absent` if there
  /// is no such entry.
  std::uint32_t word(std::uint16_t index, std::uint8_t sub, std::uint32_t absent = 0) const;
  /// Like word(), but at sub-index 0.
  std::uint32_t word(std::uint16_t index) const;

  /// Default of a number, without the node-ID that may be added.
  std::uint64_t default_number(const Entry& entry) const;

  /// Callbacks of a domain entry; null if no service provides them.
  const Domain* domain(const Entry& entry) const;

  /// Attaches a hook before all attached ones, which it then precedes. Linear in the number of
  /// rows.
  void attach(Hook& hook);
  /// Detaches a hook. Must not be called from a callback of a hook. Linear in the number of
  /// services.
  void detach(Hook& hook);
  /// Attaches a service. Services are asked and notified in the order of attachment. See
  /// Node::attach().
  constexpr void attach(NodeService& service) {
    append(service);
    if constexpr (!is_small_machine) {
      if (service.frequent_.value.events != 0) append_frequent(service);
    }
    if (!is_small_machine && service.covers(service.listener_.first)) {
      mark_hooked(service, service.listener_.first, service.listener_.last,
                  ServiceEvent::all_accesses);
    }
  }
  /// Like attach(NodeService&), for a service with a table of handlers.
  constexpr void attach(HandlerBinding& service) {
    append(service);
    if (!is_small_machine && service.calls_->values_changed != nullptr) append_frequent(service);
    if (!is_small_machine && !service.calls_->hooks.empty()) mark_hooked(service);
  }
  /// First of the attached services, in order of attachment; null if there is none.
  NodeService* services() const { return services_; }
  /// Notifies all services until one refuses; of an access, those that cover the object. See
  /// ServiceEvent.
  std::uint32_t notify(ServiceEvent::Kind kind, std::uint32_t number,
                       const void* subject = nullptr) const;
  /// Like notify(), for an event that exists already. Returns its answer.
  std::uint32_t notify(ServiceEvent& event) const;
  /// Like notify(), but for frequent events: on a host, only the services with the event in their
  /// mask.
  void notify_frequent(ServiceEvent& event) const {
    if constexpr (is_small_machine) {
      notify(event);
    } else {
      NodeService* service = frequent_.value.first;
      for (; service != nullptr; service = service->frequent_.value.next) {
        if ((service->frequent_.value.events >> event.kind & 1) != 0) service->notify(event);
      }
    }
  }

  /// Resets all entries of the objects from `first` to `last` to their default values.
  void restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id);

  /// TPDOs (numbers modulo 32) that map a value changed since clear_changes().
  std::uint32_t changes() const { return changes_; }
  /// Forgets all changes: the node has announced them.
  void clear_changes() {
    changes_ = 0;
    if constexpr (!is_small_machine) changed_places_.value.count = 0;
  }
  /// Notes a change of values that these watchers map, made without set().
  void mark_changed(std::uint32_t watchers) {
    changes_ |= watchers;
    if constexpr (!is_small_machine) changed_places_.value.forget();
  }
  /// For hosts: places of those changes.
  const ChangedPlaces& changed_places() const { return changed_places_.value; }

  /// Adds watchers to the row of an entry: bits of TPDO numbers modulo 32. Called by TPDOs, which
  /// identify the entries of the row (ServiceEvent::watch_asked).
  void watch(const Entry& entry, std::uint32_t watchers);
  /// Removes these watchers from all rows. Linear in the number of rows.
  void unwatch(std::uint32_t watchers);
  /// For hosts: counts attached hooks and listeners, and changes of watchers. Data that depends on
  /// them is valid while the number is the same.
  std::uint32_t revision() const { return revision_.value; }

  /// Tables with which it was made.
  const DictionaryTables& tables() const { return tables_; }
  /// Block of values, for code that keeps places in it.
  std::uint8_t* values() const { return values_; }

 private:
  /// Rows that were found last, each at a position derived from its index: a client reads entry
  /// after entry of an object, and a master the same few objects again and again. A 32-bit
  /// processor searches its few rows, and saves the memory.
  static constexpr std::size_t remembered_max = 64;

  /// For hosts: the range of indices in as many equal parts as there are rows, of which each knows
  /// in ObjectState::place where its rows begin.
  struct Index {
    std::uint32_t first = 0x1'0000;  ///< the lowest index; here above all of them
    std::uint32_t reach = 0;         ///< the highest one, counted from the lowest
    std::uint64_t scale = 0;         ///< parts for each index, times 2^32
  };

  void make_index();
  const ObjectRow* search_object(std::uint16_t index) const;
  const ObjectRow* search_part(std::size_t part, std::uint16_t index) const;
  const ObjectRow* search_here(std::size_t part, std::uint16_t index) const;
  const EntryShape* find_row(const ObjectRow& object, std::uint8_t sub) const;
  AbortCode look_up(Entry& entry) const;
  AbortCode look_up_in(const ObjectRow& object, Entry& entry) const;
  AbortCode look_up_anew(Entry& entry) const;
  AbortCode look_up_in_part(std::size_t part, Entry& entry) const;
  AbortCode remember(const ObjectRow& object, Entry& entry) const;
  bool has_value(Entry& entry) const;
  static AbortCode check_read(const Entry& entry) {
    if (!allows(entry.row->access, Access::sdo_read)) return AbortCode::write_only;
    return entry.row->type == DataType::domain ? AbortCode::unsupported_access : AbortCode::none;
  }
  AbortCode refresh(const Entry& entry);
  AbortCode ask(const Entry& entry, std::span<const std::uint8_t> value) const;
  void restore_rows(std::span<const ObjectRow> objects, std::uint16_t first, std::uint16_t last,
                    std::uint8_t node_id);
  void restore_default(const Entry& entry, std::uint32_t place, std::uint8_t node_id);
  bool is_as_initially(const ObjectRow& object) const;
  void copy_rows(std::size_t first, std::size_t last, std::uint8_t node_id);
  void copy_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id);
  void mark_hooked(NodeService& service, std::uint16_t first, std::uint16_t last,
                   std::uint8_t accesses, bool in_front = false);
  void mark_hooked(HandlerBinding& service);
  void notify_access(ServiceEvent& event) const;
  [[gnu::noinline]] void tell_several_of_access(ServiceEvent& event) const;
  void tell_of_access_by_list(ServiceEvent& event) const;
  void add_hooks(EntryHooks& found, const EntryHooks& more);
  static AbortCode ask_all(void* dictionary, const Entry& entry,
                           std::span<const std::uint8_t> value);
  static void notify_all(void* dictionary, const Entry& entry, Source source);
  constexpr void append(NodeService& service) {
    *last_ = &service;
    last_ = &service.next_;
  }
  void append_frequent(NodeService& service) {
    ++revision_.value;
    NodeService*& last = frequent_.value.last;
    (last == nullptr ? frequent_.value.first : last->frequent_.value.next) = &service;
    last = &service;
  }
  /// Services that are notified of frequent events.
  struct Frequent {
    NodeService* first = nullptr;
    NodeService* last = nullptr;
  };
  static constexpr ObjectRow no_row = {.index = 0, .count = 0};

  std::conditional_t<is_small_machine, const DictionaryTables&, const DictionaryTables> tables_;
  std::uint8_t* values_;
  [[no_unique_address]] HostOnly<ObjectState*> states_;
  NodeService* services_ = nullptr;
  NodeService** last_ = &services_;  ///< where the next service is linked
  std::uint32_t changes_ = 0;
  [[no_unique_address]] HostOnly<std::uint32_t> revision_;
  [[no_unique_address]] HostOnly<Frequent> frequent_;
  [[no_unique_address]] HostOnly<Index> index_;
  [[no_unique_address]] HostOnly<ChangedPlaces> changed_places_;
  [[no_unique_address]] mutable HostOnly<std::array<const ObjectRow*, remembered_max>> remembered_;
};

}  // namespace canvoy
