// Receive PDOs: process data from the bus into the dictionary (CiA 301, 7.2.2, 7.5.2.35 and
// 7.5.2.36).
//
//     Rpdo pdos[4];
//     MappedValue values[4 * 8];
//     Rpdos rpdos(node, pdos, values, &sync);
//     rpdos.received = Callback<void(std::uint16_t)>::to<&Charger::pdo_received>(charger);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo.hpp"

namespace canvoy {

/// A receive PDO: memory for Rpdos.
using Rpdo = Pdo;

/// Outcome for a multiplexed PDO, and the object that it was for.
struct MpdoAnswer {
  /// What became of it: not listed, written, no such object, or refused by it.
  enum Outcome : std::uint8_t { ignored, taken, missing, refused };

  Outcome outcome = ignored;  ///< see Outcome
  std::uint16_t index = 0;    ///< object of this node, if missing or refused
  std::uint8_t sub = 0;       ///< sub-index
};
/// Takes the eight bytes of a multiplexed PDO, and passes the outcome to Rpdos::finish(): see
/// MpdoConsumer.
using MpdoReceiver = Callback<void(std::uint16_t number, MpdoMode, const std::uint8_t* data)>;

/// All RPDOs of a node. They receive in NMT state operational only.
///
/// Transmission types 0 to 240 take the values over at the next SYNC, 254 and 255 at once. A PDO is
/// taken completely or not at all: all ranges and before_write hooks are checked before the first
/// value is written. A fault is raised as an error with the number of the PDO as instance, and
/// cleared by the next valid PDO: 8210h too short, 8220h too long (the first bytes are used), 8200h
/// a value was refused, 8230h the destination of a multiplexed PDO is missing, 8250h it was late.
class Rpdos : public PdoService {
 public:
  /// Makes the RPDOs. PDO number n (from 1) has the objects 1400h + n - 1 and 1600h + n - 1; it is
  /// disabled if they are absent. `pdos` are those with the number `first` and up. Each can map an
  /// equal share of `values`, 64 at most. Without `sync` there is no SYNC, and types 0 to 240 never
  /// take values over. All arguments must outlive this object.
  constexpr Rpdos(Node& node, std::span<Rpdo> pdos, std::span<MappedValue> values,
                  Sync* sync = nullptr, std::uint16_t first = 1,
                  PdoRecords records = PdoRecords::writable)
      : PdoService(
            is_small_machine && records == PdoRecords::constant
                ? Listener{on_constant_event}
                : Listener{on_event, object_index::rpdo_parameter, object_index::rpdo_mapping_last},
            EventMask::actuate, node, kind, pdos, values, sync, first) {}

  /// Called after all values of a PDO were written. The application may set the callbacks at any
  /// time.
  Callback<void(std::uint16_t number)> received;
  /// Called when a PDO did not arrive within its deadline (sub-index 5).
  Callback<void(std::uint16_t number)> timed_out;

  /// Requests the PDO from its producer by a remote frame. False if its COB-ID forbids it (bit 30),
  /// there is no such active PDO, or the node is not operational.
  bool request(std::uint16_t number);

  /// Enables multiplexed RPDOs. MpdoConsumer calls it before the node is started. `receiver` must
  /// outlive this object.
  void use(const MpdoReceiver& receiver) {
    mpdo_receiver_ = &receiver;
    take_mpdo_ = take_mpdo;
    multiplexed_ = mode_bits;
  }
  /// Handles the outcome for the multiplexed PDO that the receiver was called with.
  void finish(std::uint16_t number, const MpdoAnswer& answer);

 private:
  /// Faults that are present: bits.
  enum Fault : std::uint8_t { too_short = 1, too_long = 2, refused = 4, missing = 8, late = 16 };

  static void receive_routed(void* pdo, const Frame& frame, Time now);
  static void on_event(NodeService& service, ServiceEvent& event);
  static void on_event(PdoService& service, Rpdo& pdo, ServiceEvent& event);
  void look_at_deadline(Rpdo& pdo);
  void parameter_written(const Entry& entry);

  static void take_mpdo(const Rpdos& self, const Rpdo& pdo, const std::uint8_t* data);
  static void rest(Rpdo& pdo);
  void take_any(Rpdo& pdo, const Frame& frame);
  bool is_long_enough(Rpdo& pdo, std::uint8_t length);
  void change_deadline(Rpdo& pdo);
  void take(Rpdo& pdo, PdoImage image);
  // For hosts: values with something to do beside copying.
  void take_at_once(Rpdo& pdo, const PdoImage& image);
  void check_and_take(Rpdo& pdo, const PdoImage& image);
  void ask_and_take(Rpdo& pdo, const PdoImage& image);
  void take_checked(const Rpdo& pdo, const PdoImage& image);
  void take_apart(const Rpdo& pdo, const PdoImage& image);
  void finish_taken(const Rpdo& pdo, unsigned deeds);
  void announce_taken(const Rpdo& pdo);
  void refuse(Rpdo& pdo, std::uint32_t object);
  /// Raises a fault. `object` has index and sub-index in its upper three bytes, like a mapping
  /// entry.
  void raise(Rpdo& pdo, Fault fault, std::uint32_t object = 0) {
    report(pdo, fault, object | present);
  }
  void settle(Rpdo& pdo, unsigned faults) { report(pdo, faults, 0); }
  /// Reports the faults that appear, with `object`, and those that disappear.
  void report(Rpdo& pdo, unsigned faults, std::uint32_t object);
  static constexpr std::uint32_t present = 1;

  static const PdoKind kind;
  const MpdoReceiver* mpdo_receiver_ = nullptr;
  /// Set together with it.
  void (*take_mpdo_)(const Rpdos&, const Rpdo&, const std::uint8_t*) = nullptr;
};

}  // namespace canvoy
