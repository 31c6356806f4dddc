// The PDOs of the gateway itself: set up, read and written by a client (CiA 309-1, PDO access
// services).
//
//     PdoAccess pdo(device, 1);
//     Answer answer = pdo.set_rpdo(3, setup);
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "canvoy/gateway/gateway_device.hpp"
#include "canvoy/gateway/operation.hpp"

namespace canvoy::gateway {

/// Numbers of PDOs are 1 to 512. All of it works while the gateway has a node-ID, and data flows in
/// NMT state operational. A reset of the gateway's node forgets all PDOs.
class PdoAccess {
 public:
  using Received = std::function<void(std::uint16_t pdo, std::vector<std::uint64_t> values)>;

  PdoAccess(GatewayDevice& device, std::uint16_t net, Received received);
  PdoAccess(const PdoAccess&) = delete;
  PdoAccess& operator=(const PdoAccess&) = delete;
  ~PdoAccess();

  /// Sets a PDO up anew, or (with bit 31 of the COB-ID, or nothing mapped) switches it off.
  /// Errors: pdo_length above 64 bits, pdo_in_use where another PDO has the COB-ID, and what the
  /// dictionary answers.
  Answer set(PdoDirection direction, std::uint16_t number, const PdoSetup& setup);

  /// Answers with the values that came last, or asks for new ones where the PDO is one that comes
  /// on request only: then the answer comes later, or is time_out.
  void begin_read(Operation& operation, Duration time_out);
  bool cancel(Operation& operation);
  void fail_all(const Answer& answer);

  /// Writes all values of a TPDO and sends it, or leaves it to the next SYNC or request. Until it
  /// is written for the first time, the PDO is silent: nobody asked for zeros.
  Answer write(std::uint16_t number, std::span<const std::uint64_t> values);

 private:
  /// Where a mapped value is kept.
  struct Slot {
    std::uint8_t sub = 0;
    std::uint8_t bits = 0;
  };
  struct Pdo {
    std::uint32_t cob_id = CobId::bit31;
    bool on_request = false;
    std::vector<Slot> slots;
    bool used = false;  ///< received, or written, since it was set up
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
  Timer timer_{Callback<void(Time)>::to<&PdoAccess::expired>(*this)};
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy::gateway
