// Receive PDOs: process data from the bus into the dictionary (CiA 301, 7.2.2, 7.5.2.35 and
// 7.5.2.36).
//
//     Rpdo pdos[4];
//     MappedValue values[4 * 8];
//     Rpdos rpdos(node, pdos, values, &sync);
//     rpdos[1].received = Callback<void(std::uint16_t)>::to<&Charger::battery_spoke>(charger);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/mpdo.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/pdo_mapping.hpp"
#include "canvoy/canopen/pdo_parameter.hpp"
#include "canvoy/canopen/sync.hpp"

namespace canvoy {

class Rpdos;

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

/// One RPDO. The application may set the callbacks at any time; they are told the number of the
/// PDO.
class Rpdo {
 public:
  Rpdo() = default;
  Rpdo(const Rpdo&) = delete;
  Rpdo& operator=(const Rpdo&) = delete;

  /// All values were written.
  Callback<void(std::uint16_t number)> received;
  /// The PDO did not come within its deadline (sub-index 5).
  Callback<void(std::uint16_t number)> timed_out;

  /// Valid, and something is mapped.
  bool is_active() const { return length_ != 0; }
  /// It came since it became active in NMT state operational, and not too long ago.
  bool is_supervised() const { return deadline_.armed(); }

 private:
  friend class Rpdos;
  /// Errors that are present.
  enum Fault : std::uint8_t { too_short = 1, too_long = 2, refused = 4, late = 8, missing = 16 };

  void receive(const Frame& frame, Time now);
  void expire(Time now);

  Rpdos* owner_ = nullptr;
  PdoMapping mapping_;
  Timer deadline_{Callback<void(Time)>::to<&Rpdo::expire>(*this)};
  PdoImage held_{};  ///< until the next SYNC
  Time received_at_{};
  Duration period_{};  ///< of the deadline; 0: none
  CobId cob_id_;
  std::uint16_t number_ = 0;
  std::uint16_t route_ = 0;  ///< CAN-ID that is listened to; 0: none
  std::uint8_t type_ = 0;
  std::uint8_t length_ = 0;  ///< in bytes; 0 while it is not active
  std::uint8_t faults_ = 0;
  MpdoMode mode_ = MpdoMode::none;
  bool holds_ = false;
  bool simple_ = false;  ///< nothing to do but to copy: see Rpdos::take_any()
};

/// All RPDOs of a node. They receive in NMT state operational only.
///
/// Transmission types 0 to 240 take the values over at the next SYNC, 254 and 255 at once. A PDO is
/// taken whole or not at all: all ranges and before_write hooks are asked before the first value is
/// written. What is wrong is raised as an error of which the instance is the number of the PDO, and
/// cleared by the next good one: 8210h too short, 8220h too long (the first bytes are used), 8200h
/// a value was refused, 8230h the destination of a multiplexed PDO is missing, 8250h it did not
/// come in time.
class Rpdos {
 public:
  /// PDO number n (from 1) has the objects 1400h + n - 1 and 1600h + n - 1; it is off where they
  /// are absent. Each one can map an equal share of `values`, 64 at most. Without `sync` there is
  /// no SYNC, and types 0 to 240 never take anything over. All must outlive this.
  Rpdos(Node& node, std::span<Rpdo> pdos, std::span<MappedValue> values, Sync* sync = nullptr);
  Rpdos(const Rpdos&) = delete;
  Rpdos& operator=(const Rpdos&) = delete;

  std::size_t size() const { return pdos_.size(); }
  /// `number` is 1 to size().
  Rpdo& operator[](std::uint16_t number) { return pdos_[number - 1U]; }

  /// Asks the sender for the PDO by a remote frame. False where its COB-ID forbids it (bit 30), or
  /// there is no such active PDO, or the node is not operational.
  bool request(std::uint16_t number);

  /// From here on RPDOs can be multiplexed. MpdoConsumer calls it, before the node is started.
  void use(MpdoReceiver receiver) { mpdo_receiver_ = receiver; }
  /// What became of the multiplexed PDO that the receiver was told of.
  void finish(std::uint16_t number, const MpdoAnswer& answer);

 private:
  friend class Rpdo;

  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void at_sync(std::uint8_t counter);
  AbortCode before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value);
  void parameter_written(const Entry& entry, Source source);
  AbortCode before_mapping_write(const Entry& entry, std::span<const std::uint8_t> value);

  void load(Rpdo& pdo);
  void resolve(Rpdo& pdo);
  void listen(Rpdo& pdo, std::uint16_t can_id);
  void rest(Rpdo& pdo);
  void take_any(Rpdo& pdo, const Frame& frame);
  bool is_long_enough(Rpdo& pdo, std::uint8_t length);
  void change_deadline(Rpdo& pdo, Duration period);
  void take(Rpdo& pdo, const std::uint8_t* data);
  void raise_about(Rpdo& pdo, Rpdo::Fault fault, std::uint16_t index, std::uint8_t sub);
  static std::uint16_t code_of(unsigned fault);
  void raise(Rpdo& pdo, Rpdo::Fault fault, const std::array<std::uint8_t, 5>& info = {});
  void settle(Rpdo& pdo, unsigned faults);
  bool owns(const Entry& entry) const { return (entry.index & 0x1FFU) < pdos_.size(); }
  Rpdo& at(const Entry& entry) { return pdos_[entry.index & 0x1FFU]; }

  Node& node_;
  std::span<Rpdo> pdos_;
  Sync* sync_;
  MpdoReceiver mpdo_receiver_;
  bool operational_ = false;
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls[2];
  ServiceLink service_{&service_calls, this};
  HookLink hooks_{hook_calls, this};
  SyncListener listener_;
};

}  // namespace canvoy
