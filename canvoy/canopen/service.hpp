// How the parts of a node (SDO, PDO, heartbeat ...) follow its life and the objects of its
// dictionary: a constant table of functions for each class of services, and a link for each
// service.
//
//     constexpr ServiceCalls Sync::service_calls = {.reset = method<&Sync::reset>,
//                                                   .hooks = hook_calls};
//     ServiceLink service_{&service_calls, this};   // node.attach(service_)
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/can/port.hpp"
#include "canvoy/canopen/abort_code.hpp"
#include "canvoy/canopen/nmt.hpp"

namespace canvoy {

struct Entry;
struct Error;
struct Frame;

/// Who writes.
enum class Source : std::uint8_t { sdo, pdo, application };

/// What happens at a SYNC, in this order: RPDO values received since the last one become valid, the
/// application computes and senses, TPDO values are sampled and sent.
enum class SyncPhase : std::uint8_t { actuate, application, sample };

/// What a class of services does when objects from `first` to `last` are accessed from the bus.
/// Each function takes the service first, and is as Hook has it; null: nothing.
struct HookCalls {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  AbortCode (*before_read)(void*, const Entry&) = nullptr;
  AbortCode (*before_write)(void*, const Entry&, std::span<const std::uint8_t> value) = nullptr;
  void (*after_write)(void*, const Entry&, Source) = nullptr;
};

/// What a class of services does as the life of its node goes on: constant, one for all objects of
/// the class. Each takes the service first; null: nothing.
struct ServiceCalls {
  /// Parameters have their power-on values again: read them, and be as after power-on.
  void (*reset)(void*, ResetScope) = nullptr;
  /// A state was entered.
  void (*state_entered)(void*, NmtState) = nullptr;
  /// The state of the CAN controller changed.
  void (*bus_state_changed)(void*, BusState) = nullptr;
  /// An error came (`present`) or went.
  void (*error_changed)(void*, const Error&, bool present) = nullptr;
  /// TPDOs with these numbers modulo 32 map something that changed.
  void (*values_changed)(void*, std::uint32_t) = nullptr;
  /// Frames that waited have gone to the controller, and there is room for others.
  void (*tx_ready)(void*) = nullptr;
  /// A SYNC came, or was produced: told for `actuate` and for `sample`. The counter is 0 where
  /// SYNC carries none.
  void (*sync)(void*, SyncPhase, std::uint8_t counter) = nullptr;
  /// An 11-bit frame came, data or remote: whether the service wanted it. Told on small machines
  /// only, to services for which a host has routes in the Router.
  bool (*receive)(void*, const Frame&) = nullptr;
  /// Objects that mean more to it than their values.
  std::span<const HookCalls> hooks = {};
};

/// A part of a node that follows its life. Owned by the service.
struct ServiceLink {
  const ServiceCalls* calls = nullptr;
  void* service = nullptr;
  ServiceLink* next = nullptr;
};

}  // namespace canvoy
