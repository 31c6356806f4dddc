// How the parts of a node (SDO, PDO, heartbeat ...) follow its life and the objects of its
// dictionary. A service of every small node handles all events in one function; where code size
// matters less, a constant table of functions does so, and applications use callbacks (Service).
//
//     struct Beat : NodeService {
//       explicit Beat(Node& node) : NodeService({told, 0x1005, 0x1019}) { node.attach(*this); }
//       static void told(NodeService& beat, ServiceEvent& event);
//     };
//
//     struct Counter {
//       void reset(ResetScope scope);
//     };
//     constexpr ServiceHandlers calls = {.reset = method<&Counter::reset>};
//
//     HandlerBinding binding(&calls, &counter);
//     node.attach(binding);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/machine.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"

namespace canvoy {

struct ChangedPlaces;
struct Domain;
struct Entry;
struct Error;
struct Frame;

/// Source of a write.
enum class Source : std::uint8_t { sdo, pdo, application };

/// An event in the life of a node, for its services.
struct ServiceEvent {
  /// Kind of event. Services depend on the order: see bit_of().
  enum Kind : std::uint32_t {
    /// Parameters have their power-on values again: the service reads them, and returns to its
    /// state after power-on.
    reset,
    state_entered,
    bus_state_changed,  ///< of the CAN controller
    /// Like bus_state_changed, but from bus-off: frames that waited for the controller were lost.
    bus_recovered,
    error_came,
    error_went,
    /// TPDOs with these numbers modulo 32 map a changed value. On a host, `subject` is the
    /// ChangedPlaces.
    values_changed,
    tx_ready,  ///< waiting frames have gone to the controller, which has room for more
    // At a SYNC, in this order; the application (SyncListener) comes between them.
    actuate,        ///< RPDO values received since the last SYNC become valid
    sample,         ///< TPDO values are sampled and sent
    timer_expired,  ///< a timer of the service
    /// A frame with NodeService::can_id_ arrived. On small machines only, for services that have
    /// routes in the Router on a host.
    frame_came,
    /// Question whether a TPDO maps the value `number` bytes from the start of all; a service that
    /// maps it sets `answer`, and `subject` to the Pdo, if it is only one. On hosts only, for
    /// services with the event in their mask; it thus shares the number of frame_came.
    watch_asked = frame_came,
    // Accesses from the bus to an object of the service's range.
    before_read,   ///< it may refresh the value, or refuse
    before_write,  ///< it may refuse the new value
    after_write,
    domain_wanted,  ///< the service that has the content of a domain calls serve()
    /// The value of an entry (`subject`) was set, with an explicit statement whether it is an
    /// event: `number` 1 or 0. On hosts only: Dictionary::set_with_event().
    value_set,
  };

  Kind kind;                           ///< which event it is
  std::uint32_t number = 0;            ///< depends on the kind: see the functions below
  const void* subject = nullptr;       ///< depends on the kind: error, frame, entry, places
  const std::uint8_t* data = nullptr;  ///< value to be written
  /// For an access, the refusal, which ends the notification. For a frame, whether a service takes
  /// it.
  std::uint32_t answer = 0;

  /// Scope of a reset.
  ResetScope scope() const { return static_cast<ResetScope>(number); }
  /// The new NMT state, for state_entered.
  NmtState state() const { return static_cast<NmtState>(number); }
  /// The new state of the controller, for bus_state_changed and bus_recovered.
  BusState bus_state() const { return static_cast<BusState>(number); }
  /// TPDO numbers modulo 32 as bits, for values_changed.
  std::uint32_t watchers() const { return number; }
  /// Counter of the SYNC; 0 if it carries none.
  std::uint8_t counter() const { return static_cast<std::uint8_t>(number); }
  /// Source of the write, for after_write.
  Source source() const { return static_cast<Source>(number); }
  /// The error, for error_came and error_went.
  const Error& error() const { return *static_cast<const Error*>(subject); }
  /// The frame, for frame_came.
  const Frame& frame() const { return *static_cast<const Frame*>(subject); }
  /// Places of the changes, for values_changed on a host.
  const ChangedPlaces& places() const { return *static_cast<const ChangedPlaces*>(subject); }
  /// The entry that is accessed, for accesses and value_set.
  const Entry& entry() const { return *static_cast<const Entry*>(subject); }
  /// The new value, for before_write.
  std::span<const std::uint8_t> value() const { return {data, number}; }
  /// True for accesses from the bus: before_read to domain_wanted.
  bool is_access() const { return kind >= before_read && (is_small_machine || kind != value_set); }
  /// Bits of ObjectState::hooks for a kind of access, and for all kinds.
  static constexpr std::uint8_t bit_of(Kind kind) {
    return static_cast<std::uint8_t>(1U << (kind - before_read));
  }
  /// bit_of() if it is set; otherwise 0.
  static constexpr std::uint8_t bit_if(bool is_set, Kind kind) {
    return is_set ? bit_of(kind) : std::uint8_t{0};
  }
  static constexpr std::uint8_t all_accesses = 0x0F;  ///< of ObjectState::hooks

  /// Answers domain_wanted with the domain, in place of the entry.
  void serve(const Domain& domain) {
    subject = &domain;
    answer = 1;
  }
  /// Answers an access with a refusal, which ends the notification.
  void refuse(AbortCode code) { answer = static_cast<std::uint32_t>(code); }
  /// Takes the frame of frame_came, or says yes to watch_asked: no other service needs to.
  void want() { answer = 1; }
};

/// A part of a node that follows its life. It must outlive the node.
class NodeService {
 public:
  /// Receiver of events. `on_event` is called for accesses to objects from index `first` to `last`;
  /// by default for none.
  struct Listener {
    void (*on_event)(NodeService&, ServiceEvent&);  ///< one function for all events
    std::uint16_t first = 0xFFFF;                   ///< the lowest index
    std::uint16_t last = 0;                         ///< the highest index, included
  };

  /// Frequent events that a host sends only to services that need them: bits of ServiceEvent::Kind.
  struct EventMask {
    static constexpr std::uint32_t values = 1U << ServiceEvent::values_changed;  ///< values_changed
    static constexpr std::uint32_t actuate = 1U << ServiceEvent::actuate;  ///< actuate, at a SYNC
    static constexpr std::uint32_t sample = 1U << ServiceEvent::sample;    ///< sample, at a SYNC
    /// Questions of changes, for TPDOs on a host.
    static constexpr std::uint32_t watch =
        1U << ServiceEvent::watch_asked | 1U << ServiceEvent::value_set;
    static constexpr std::uint32_t all = values | actuate | sample;  ///< all but watch
    static constexpr std::uint32_t none = 0;  ///< for a service that needs none of them
  };

  /// Makes a service; it follows a node once attached. `events` has no effect on a small machine,
  /// which sends all.
  constexpr explicit NodeService(const Listener& listener, std::uint32_t events = EventMask::all)
      : listener_(listener) {
    if constexpr (!is_small_machine) frequent_.value.events = events;
  }
  NodeService(const NodeService&) = delete;
  NodeService& operator=(const NodeService&) = delete;

  /// Calls the service with an event.
  void notify(ServiceEvent& event) { listener_.on_event(*this, event); }
  /// True if accesses to the object at `index` concern the service.
  constexpr bool covers(std::uint16_t index) const {
    return index >= listener_.first && index <= listener_.last;
  }

 private:
  friend class Dictionary;
  friend class Node;

  bool hears(ServiceEvent& event) const;

  /// Link to the next service for frequent events.
  struct Frequent {
    NodeService* next = nullptr;
    std::uint32_t events = EventMask::all;
    /// Accesses that a service without a table may handle: ServiceEvent::bit_of().
    std::uint8_t accesses = ServiceEvent::all_accesses;
  };

  NodeService* next_ = nullptr;
  Listener listener_;
  [[no_unique_address]] HostOnly<Frequent> frequent_;

 protected:
  static constexpr std::uint16_t every_id = 0xFFFF;

  /// CAN-ID of the data frames that the service receives; 0: none. With every_id it checks each
  /// 11-bit frame, data or remote, by itself.
  std::uint16_t can_id_ = 0;
};

/// Handlers of a class of services for accesses from the bus to objects from `first` to `last`, by
/// default at any sub-index. Each function takes the service first, and is like that of Hook; null:
/// no action.
struct AccessHandlers {
  std::uint16_t first = 0;                                  ///< lowest index
  std::uint16_t last = 0;                                   ///< highest index, included
  std::uint8_t sub_first = 0;                               ///< lowest sub-index
  std::uint8_t sub_last = 0xFF;                             ///< highest sub-index, included
  AbortCode (*before_read)(void*, const Entry&) = nullptr;  ///< may refuse
  /// May refuse the value, or defer the answer.
  AbortCode (*before_write)(void*, const Entry&, std::span<const std::uint8_t> value) = nullptr;
  void (*after_write)(void*, const Entry&, Source) = nullptr;  ///< the value is written

  /// True if an object at `index` is in the range.
  constexpr bool covers(std::uint16_t index) const { return index >= first && index <= last; }
  /// True if an entry is in the range.
  constexpr bool covers(std::uint16_t index, std::uint8_t sub) const {
    return covers(index) && sub >= sub_first && sub <= sub_last;
  }
  /// Accesses with a handler: see ServiceEvent::bit_of().
  constexpr std::uint8_t accesses() const {
    using Event = ServiceEvent;
    return static_cast<std::uint8_t>(Event::bit_if(before_read != nullptr, Event::before_read) |
                                     Event::bit_if(before_write != nullptr, Event::before_write) |
                                     Event::bit_if(after_write != nullptr, Event::after_write));
  }
};

/// Handlers of a class of services for the events of ServiceEvent: constant, one table for all
/// objects of the class. Each takes the service first; null: no action.
struct ServiceHandlers {
  void (*reset)(void*, ResetScope) = nullptr;            ///< parameters were reset
  void (*state_entered)(void*, NmtState) = nullptr;      ///< new NMT state
  void (*bus_state_changed)(void*, BusState) = nullptr;  ///< new state of the controller
  void (*error_changed)(void*, const Error&, bool present) = nullptr;  ///< came or went
  void (*values_changed)(void*, std::uint32_t) = nullptr;  ///< for TPDOs that are these bits
  void (*tx_ready)(void*) = nullptr;                       ///< the controller has room
  /// Objects with a meaning beyond their values.
  std::span<const AccessHandlers> hooks = {};
};

/// Whom to ask and to notify of writes of an entry, found once for code that writes it again and
/// again: see Dictionary::find_hooks(). The functions are those of AccessHandlers; the dictionary's
/// own where several are to be called.
struct EntryHooks {
  void* context = nullptr;  ///< first argument of the functions
  /// Returns the first refusal of a new value, in the format of SDO; null: none refuses.
  AbortCode (*ask)(void*, const Entry&, std::span<const std::uint8_t> value) = nullptr;
  /// Called after a write, with the service that wrote; null: none is notified.
  void (*notify)(void*, const Entry&, Source) = nullptr;
  bool reads = false;  ///< a service may refresh the entry before it is read
};

/// TPDOs that map an entry: see Dictionary::find_watchers().
struct EntryWatchers {
  bool are_there = false;  ///< one or more
  /// The Pdo, if it is only one, and no other service is notified of changed values; or null.
  const void* only = nullptr;
};

/// Connects such a table to the service that owns the binding.
class HandlerBinding : public NodeService {
 public:
  /// Makes a binding. `shift` is added to the indices of the table, for objects that a device may
  /// have in one of several blocks.
  constexpr HandlerBinding(const ServiceHandlers* calls, void* service, std::uint16_t shift = 0)
      : NodeService({on_event, 0, 0xFFFF}, EventMask::values),
        shift_(shift),
        calls_(calls),
        service_(service) {}

 private:
  friend class Dictionary;

  static void on_event(NodeService& link, ServiceEvent& event);
  bool covers_object(std::uint16_t index) const;
  AbortCode answer(const ServiceEvent& access) const;

  std::uint16_t shift_;
  const ServiceHandlers* calls_;
  void* service_;
};

}  // namespace canvoy
