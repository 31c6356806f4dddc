// How the parts of a node (SDO, PDO, heartbeat ...) follow its life and the objects of its
// dictionary. What is in every small node is told all in one function; where code size matters less
// a constant table of functions says the same, and callbacks (Service) what applications care for.
//
//     class Sync : private NodeService { ... };      // node.attach(*this)
//     Sync::Sync(Node& node) : NodeService({told, 0x1005, 0x1019}) ...
//
//     constexpr ServiceCalls TimeStamp::service_calls = {.reset = method<&TimeStamp::reset>};
//     ServiceLink service_{&service_calls, this};    // node.attach(service_)
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/machine.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"

namespace canvoy {

struct ChangedPlaces;
struct Domain;
struct Entry;
struct Error;
struct Frame;

/// Who writes.
enum class Source : std::uint8_t { sdo, pdo, application };

/// What happens in the life of a node, as its services are told.
struct ServiceEvent {
  enum Kind : std::uint32_t {
    /// Parameters have their power-on values again: read them, and be as after power-on.
    reset,
    state_entered,
    bus_state_changed,  ///< of the CAN controller
    bus_recovered,      ///< the same, from bus-off: what waited for the controller was lost
    error_came,
    error_went,
    /// TPDOs with these numbers modulo 32 map something that changed. On a host, `subject` are the
    /// ChangedPlaces.
    values_changed,
    tx_ready,  ///< frames that waited have gone to the controller, and there is room for others
    // At a SYNC, in this order, and the application (SyncListener) between them.
    actuate,        ///< RPDO values received since the last one become valid
    sample,         ///< TPDO values are sampled and sent
    timer_expired,  ///< its own
    /// A frame with NodeService::can_id_ came. Told on small machines only, to services for which a
    /// host has routes in the Router.
    frame_came,
    /// Whether a TPDO maps the value that stands `number` bytes from the start of all: who does
    /// wants it. Asked on hosts only, those that care for it, and so in the place of frame_came.
    watch_asked = frame_came,
    // Accesses from the bus to an object of the service's range.
    before_read,   ///< it may refresh the value, or refuse
    before_write,  ///< it may refuse the new value
    after_write,
    domain_wanted,  ///< who has the content of a domain says so by serve()
  };

  Kind kind;
  std::uint32_t number = 0;
  const void* subject = nullptr;
  const std::uint8_t* data = nullptr;
  /// Of an access the refusal: nobody else is told then. Of a frame, whether somebody wants it.
  std::uint32_t answer = 0;

  ResetScope scope() const { return static_cast<ResetScope>(number); }
  NmtState state() const { return static_cast<NmtState>(number); }
  BusState bus_state() const { return static_cast<BusState>(number); }
  std::uint32_t watchers() const { return number; }
  /// Of the SYNC; 0 where it carries none.
  std::uint8_t counter() const { return static_cast<std::uint8_t>(number); }
  Source source() const { return static_cast<Source>(number); }
  const Error& error() const { return *static_cast<const Error*>(subject); }
  const Frame& frame() const { return *static_cast<const Frame*>(subject); }
  const ChangedPlaces& places() const { return *static_cast<const ChangedPlaces*>(subject); }
  const Entry& entry() const { return *static_cast<const Entry*>(subject); }
  std::span<const std::uint8_t> value() const { return {data, number}; }
  bool is_access() const { return kind >= before_read; }
  /// Of a kind of access, and of all: bits of ObjectState::hooks.
  static constexpr std::uint8_t bit_of(Kind kind) {
    return static_cast<std::uint8_t>(1U << (kind - before_read));
  }
  static constexpr std::uint8_t all_accesses = 0x0F;

  /// With the domain in place of the entry that was asked for.
  void serve(const Domain& domain) {
    subject = &domain;
    answer = 1;
  }
  void refuse(AbortCode code) { answer = static_cast<std::uint32_t>(code); }
  void want() { answer = 1; }
};

/// A part of a node that follows its life. It must outlive the node.
class NodeService {
 public:
  /// `told` learns of accesses to objects from index `first` to `last`; by default to none.
  struct Listener {
    void (*told)(NodeService&, ServiceEvent&);
    std::uint16_t first = 0xFFFF;
    std::uint16_t last = 0;
  };

  /// What is frequent a host tells only those that care for it: bits of ServiceEvent::Kind.
  struct Cares {
    static constexpr std::uint32_t for_values = 1U << ServiceEvent::values_changed;
    static constexpr std::uint32_t for_actuate = 1U << ServiceEvent::actuate;
    static constexpr std::uint32_t for_sample = 1U << ServiceEvent::sample;
    static constexpr std::uint32_t for_watch = 1U << ServiceEvent::watch_asked;
    static constexpr std::uint32_t for_all = for_values | for_actuate | for_sample;
    static constexpr std::uint32_t for_nothing_frequent = 0;
  };

  constexpr explicit NodeService(const Listener& listener, std::uint32_t cares = Cares::for_all)
      : listener_(listener) {
    if constexpr (!is_small_machine) frequent_.value.cares = cares;
  }
  NodeService(const NodeService&) = delete;
  NodeService& operator=(const NodeService&) = delete;

  void tell(ServiceEvent& event) { listener_.told(*this, event); }
  constexpr bool covers(std::uint16_t index) const {
    return index >= listener_.first && index <= listener_.last;
  }

 private:
  friend class Dictionary;
  friend class Node;

  bool hears(ServiceEvent& event) const;

  /// The next one of those that are told what is frequent.
  struct Frequent {
    NodeService* next = nullptr;
    std::uint32_t cares = Cares::for_all;
  };

  NodeService* next_ = nullptr;
  Listener listener_;
  [[no_unique_address]] HostOnly<Frequent> frequent_;

 protected:
  static constexpr std::uint16_t every_id = 0xFFFF;

  /// Of the data frames that it is told of; 0: none. With every_id it looks at each 11-bit frame,
  /// data or remote, by itself.
  std::uint16_t can_id_ = 0;
};

/// What a class of services does when objects from `first` to `last` are accessed from the bus, by
/// default at any sub-index. Each function takes the service first, and is as Hook has it; null:
/// nothing.
struct HookCalls {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  std::uint8_t sub_first = 0;
  std::uint8_t sub_last = 0xFF;
  AbortCode (*before_read)(void*, const Entry&) = nullptr;
  AbortCode (*before_write)(void*, const Entry&, std::span<const std::uint8_t> value) = nullptr;
  void (*after_write)(void*, const Entry&, Source) = nullptr;

  constexpr bool covers(std::uint16_t index) const { return index >= first && index <= last; }
  constexpr bool covers(std::uint16_t index, std::uint8_t sub) const {
    return covers(index) && sub >= sub_first && sub <= sub_last;
  }
  /// What it is asked or told of: see ServiceEvent::bit_of().
  constexpr std::uint8_t accesses() const {
    const auto bit_if = [](bool has_function, ServiceEvent::Kind kind) {
      return has_function ? ServiceEvent::bit_of(kind) : 0;
    };
    return static_cast<std::uint8_t>(bit_if(before_read != nullptr, ServiceEvent::before_read) |
                                     bit_if(before_write != nullptr, ServiceEvent::before_write) |
                                     bit_if(after_write != nullptr, ServiceEvent::after_write));
  }
};

/// What a class of services does as the life of its node goes on, as ServiceEvent has it: constant,
/// one for all objects of the class. Each takes the service first; null: nothing.
struct ServiceCalls {
  void (*reset)(void*, ResetScope) = nullptr;
  void (*state_entered)(void*, NmtState) = nullptr;
  void (*bus_state_changed)(void*, BusState) = nullptr;
  void (*error_changed)(void*, const Error&, bool present) = nullptr;
  void (*values_changed)(void*, std::uint32_t) = nullptr;
  void (*tx_ready)(void*) = nullptr;
  /// Objects that mean more to it than their values.
  std::span<const HookCalls> hooks = {};
};

/// Who is asked and told of accesses to an entry, found once for who writes it again and again: see
/// Dictionary::find_hooks().
struct EntryHooks {
  static constexpr std::uint16_t any_row = 0xFFFF;  ///< of a service that has no table

  NodeService* service = nullptr;      ///< the only one; null: nobody, or several
  std::uint16_t before_row = any_row;  ///< the only row of its table that asks
  std::uint16_t after_row = any_row;   ///< and the only one that tells
  bool reads = false;                  ///< somebody may refresh it before it is read
  bool asks = false;                   ///< somebody may refuse what is to be written
  bool tells = false;                  ///< somebody is told that it was written
  bool several = false;                ///< services, or rows of one table
};

/// Ties such a table to its service, which owns it.
class ServiceLink : public NodeService {
 public:
  /// `shift` is added to the indices of the table: of objects that a device may have in one of
  /// several blocks.
  constexpr ServiceLink(const ServiceCalls* calls, void* service, std::uint16_t shift = 0)
      : NodeService({told, 0, 0xFFFF}, Cares::for_values),
        shift_(shift),
        calls_(calls),
        service_(service) {}

  /// Calls what one row of its table has.
  AbortCode ask_row(unsigned row, const Entry& entry, std::span<const std::uint8_t> value) const {
    return calls_->hooks[row].before_write(service_, entry, value);
  }
  void tell_row(unsigned row, const Entry& entry, Source source) const {
    calls_->hooks[row].after_write(service_, entry, source);
  }

 private:
  friend class Dictionary;

  static void told(NodeService& link, ServiceEvent& event);
  bool covers_object(std::uint16_t index) const;
  bool find_hooks(const Entry& entry, EntryHooks& hooks) const;
  AbortCode answer(const ServiceEvent& access) const;

  std::uint16_t shift_;
  const ServiceCalls* calls_;
  void* service_;
};

}  // namespace canvoy
