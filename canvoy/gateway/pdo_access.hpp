// The PDOs of the gateway: set up, read and written by a client (CiA 309-1, PDO access services).
//
//     PdoAccess pdo(device, 1, received);
//     Answer answer = pdo.set(PdoDirection::receive, 3, setup);
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "canvoy/gateway/gateway_device.hpp"
#include "canvoy/gateway/operation.hpp"

namespace canvoy::gateway {

/// PDOs 1 to 512 of the gateway. Needs a node-ID of the gateway; data flows in NMT state
/// operational. A reset of the gateway's node deletes all PDOs.
class PdoAccess {
 public:
  /// Called with the values of an RPDO, in the order of its mapping.
  using Received = std::function<void(std::uint16_t pdo, std::vector<std::uint64_t> values)>;

  /// Makes the service for network `net`; `device` must outlive it.
  PdoAccess(GatewayDevice& device, std::uint16_t net, Received received);
  ~PdoAccess();

  /// Sets up a PDO, or switches it off (bit 31 of the COB-ID set, or nothing mapped). Errors:
  /// pdo_length above 64 bits, pdo_in_use if another PDO has the COB-ID, and errors of the
  /// dictionary.
  Answer set(PdoDirection direction, std::uint16_t number, const PdoSetup& setup);

  /// Answers with the last received values. Requests new values if the PDO is transmitted on
  /// request only: then the answer comes later, or is time_out.
  void begin_read(Operation& operation, Duration time_out);
  /// Cancels an operation. False if it is not under way.
  bool cancel(Operation& operation);
  /// Answers all operations that are under way.
  void fail_all(const Answer& answer);

  /// Writes all values of a TPDO and sends it, or leaves it to the next SYNC or request. Until the
  /// first write the PDO is silent, so that it never sends zeros by default.
  Answer write(std::uint16_t number, std::span<const std::uint64_t> values);

 private:
  /// Location of a mapped value.
  struct Slot {
    std::uint8_t sub = 0;
    std::uint8_t bits = 0;
  };
  struct Pdo {
    std::uint32_t cob_id = CobId::bit31;
    bool on_request = false;
    std::vector<Slot> slots;
    bool used = false;  ///< received or written since the setup
  };
  using Pdos = std::map<std::uint16_t, Pdo>;
  struct Reading {
    Operation* operation;
    Time until;
  };

  static std::vector<Slot> slots_for(const std::vector<DataType>& mapped);
  bool is_in_use(const Pdos& pdos, std::uint16_t number, std::uint32_t can_id) const;
  AbortCode write_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number);
  AbortCode apply(PdoDirection direction, std::uint16_t number, const PdoSetup& setup,
                  std::span<const Slot> slots);
  AbortCode check_cob_id(std::uint16_t parameter, std::uint32_t cob_id);
  AbortCode map(PdoDirection direction, std::uint16_t number, std::span<const Slot> slots);
  std::vector<std::uint64_t> values_of(std::uint16_t number, const Pdo& pdo) const;
  Answer values_answer(std::uint16_t number, const Pdo& pdo) const;
  void received(std::uint16_t number);
  void reset(ResetScope scope);
  void arm();
  void expired(Time now);

  GatewayDevice& device_;
  std::uint16_t net_;
  Received received_;
  Pdos rpdos_;
  Pdos tpdos_;
  std::vector<Reading> readings_;
  Timer timer_{callback<&PdoAccess::expired>(*this)};
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::gateway
