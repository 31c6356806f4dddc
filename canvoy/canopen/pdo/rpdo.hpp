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

using Rpdo = Pdo;

/// What became of a multiplexed PDO, and for which object it was.
struct MpdoAnswer {
  enum Outcome : std::uint8_t { ignored, taken, missing, refused };

  Outcome outcome = ignored;
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
};
/// Takes the eight bytes of a multiplexed PDO, and hands the answer to Rpdos::finish(): see
/// MpdoConsumer.
using MpdoReceiver = Callback<void(std::uint16_t number, MpdoMode, const std::uint8_t* data)>;

/// All RPDOs of a node. They receive in NMT state operational only.
///
/// Transmission types 0 to 240 take the values over at the next SYNC, 254 and 255 at once. A PDO is
/// taken whole or not at all: all ranges and before_write hooks are asked before the first value is
/// written. What is wrong is raised as an error of which the instance is the number of the PDO, and
/// cleared by the next good one: 8210h too short, 8220h too long (the first bytes are used), 8200h
/// a value was refused, 8230h the destination of a multiplexed PDO is missing, 8250h it did not
/// come in time.
class Rpdos : public PdoService {
 public:
  /// PDO number n (from 1) has the objects 1400h + n - 1 and 1600h + n - 1; it is off where they
  /// are absent. `pdos` are those with the number `first` and up. Each one can map an equal share
  /// of `values`, 64 at most. Without `sync` there is no SYNC, and types 0 to 240 never take
  /// anything over. All must outlive this.
  constexpr Rpdos(Node& node, std::span<Rpdo> pdos, std::span<MappedValue> values,
                  Sync* sync = nullptr, std::uint16_t first = 1,
                  PdoRecords records = PdoRecords::writable)
      : PdoService(
            is_small_machine && records == PdoRecords::constant
                ? Listener{told_of_constant}
                : Listener{told, object_index::rpdo_parameter, object_index::rpdo_mapping_last},
            Cares::for_actuate, node, kind, pdos, values, sync, first) {}

  /// All values of a PDO were written. The application may set the callbacks at any time.
  Callback<void(std::uint16_t number)> received;
  /// A PDO did not come within its deadline (sub-index 5).
  Callback<void(std::uint16_t number)> timed_out;

  /// Asks the sender for the PDO by a remote frame. False where its COB-ID forbids it (bit 30), or
  /// there is no such active PDO, or the node is not operational.
  bool request(std::uint16_t number);

  /// From here on RPDOs can be multiplexed. MpdoConsumer calls it, before the node is started.
  /// `receiver` must outlive this.
  void use(const MpdoReceiver& receiver) {
    mpdo_receiver_ = &receiver;
    take_mpdo_ = take_mpdo;
    multiplexed_ = mode_bits;
  }
  /// What became of the multiplexed PDO that the receiver was told of.
  void finish(std::uint16_t number, const MpdoAnswer& answer);

 private:
  /// Errors that are present: bits.
  enum Fault : std::uint8_t { too_short = 1, too_long = 2, refused = 4, missing = 8, late = 16 };

  static void receive_routed(void* pdo, const Frame& frame, Time now);
  static void told(NodeService& service, ServiceEvent& event);
  static void told(PdoService& service, Rpdo& pdo, ServiceEvent& event);
  void look_at_deadline(Rpdo& pdo);
  void parameter_written(const Entry& entry);

  static void take_mpdo(const Rpdos& self, const Rpdo& pdo, const std::uint8_t* data);
  static void rest(Rpdo& pdo);
  void take_any(Rpdo& pdo, const Frame& frame);
  void copy(const Rpdo& pdo, const std::uint8_t* data) const;
  bool is_long_enough(Rpdo& pdo, std::uint8_t length);
  void change_deadline(Rpdo& pdo);
  void take(Rpdo& pdo, PdoImage image);
  /// `object` has index and sub-index in its upper three bytes, as a mapping entry has them.
  void raise(Rpdo& pdo, Fault fault, std::uint32_t object = 0) {
    report(pdo, fault, object | present);
  }
  void settle(Rpdo& pdo, unsigned faults) { report(pdo, faults, 0); }
  /// `object` with `present` where they come.
  void report(Rpdo& pdo, unsigned faults, std::uint32_t object);
  static constexpr std::uint32_t present = 1;

  static const PdoKind kind;
  const MpdoReceiver* mpdo_receiver_ = nullptr;
  void (*take_mpdo_)(const Rpdos&, const Rpdo&, const std::uint8_t*) = nullptr;  ///< set with it
};

}  // namespace canvoy
