// What the gateway does for the network of a car (CiA 447-1, which is not at hand: this is how
// public implementations do it): as LSS master it finds add-on devices without a node-ID by
// Fastscan and names them, as NMT master it starts them and asks what they are, and it sends the
// network to sleep and wakes it up.
//
//     CarMaster master(network, sleep, {});
//     master.on_event(Callback<void(const CarEvent&)>::to<&App::happened>(app));
//     master.send_to_sleep();
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/car_sleep.hpp"

namespace canvoy::cia447 {

inline constexpr std::size_t add_on_devices_max = node_id_max - 1;

/// The node-IDs that were given, by the identity of who got them: 2 is the first.
struct KnownDevices {
  std::array<LssAddress, add_on_devices_max> addresses{};
  std::array<bool, add_on_devices_max> is_known{};

  std::optional<NodeId> find(const LssAddress& address) const;
};

/// Keeps them over restarts of the gateway. Both are optional.
struct CarMemory {
  Callback<KnownDevices()> load = {};
  Callback<void(const KnownDevices&)> store = {};
};

struct CarMasterSettings {
  Duration scan_period = 1s;  ///< from one look for devices without a node-ID to the next
  /// The same while a device answers Fastscan although it has a node-ID (devices of others do, and
  /// a look then is some hundred messages). Who is known and was lost is looked for by its identity
  /// in between.
  Duration answered_scan_period = 30s;
  Duration objection_time = 1s;  ///< how long objections to sleep are waited for
  bool starts_nodes = true;      ///< into NMT state operational
  /// Whom it knows and does not hear so long after it has booted may be asleep: it wakes all up.
  Duration wake_up_after = 10s;
  /// While it sleeps, one that is awake is asked so often whether it may sleep as well.
  Duration order_period = 10s;
};

struct CarEvent {
  enum class Kind : std::uint8_t {
    named,      ///< a device was given `node`
    refused,    ///< there are 15 already
    started,    ///< `node` was told to enter operational
    lost,       ///< `node` is not heard any more
    stranger,   ///< `node` is no device of CiA 447 (1000h), or does not say what it is
    objection,  ///< `node` objects to sleep, with `reason`
    asleep,
    awake,
  };
  Kind kind;
  NodeId node = 0;
  std::uint8_t reason = 0;
};

class CarMaster {
 public:
  static constexpr std::size_t routes = LssMaster::routes + node_id_max + 2;

  /// `sleep` is that of the same device. All must outlive this. It takes on_heard(), on_lost() and
  /// on_change() of them, and calls who was called before for the first two.
  CarMaster(CarNetwork& network, CarSleep& sleep, const CarMemory& memory,
            const CarMasterSettings& settings = {});
  CarMaster(const CarMaster&) = delete;
  CarMaster& operator=(const CarMaster&) = delete;

  void on_event(Callback<void(const CarEvent&)> told) { told_ = told; }

  /// Asks whether anybody objects; where nobody does in time, the network is sent to sleep. Nothing
  /// happens while it asks already, or sleeps.
  void send_to_sleep();
  void wake_up();

  const KnownDevices& known() const { return known_; }
  /// It is heard.
  bool is_present(NodeId node) const { return present_[node]; }

 private:
  void reset(ResetScope scope);
  void look(Time now);
  void look_for_lost();
  NodeId choose(const LssAddress& address);
  NodeId find_free() const;
  void found(const LssScan::Found& found);
  void scanned(LssScan::Outcome outcome);
  void looked(LssScan::Outcome outcome);
  void commanded(const Frame& frame, Time now);
  void heard(NodeId node, std::uint8_t state);
  void lost(NodeId node);
  void start(NodeId node);
  void wake_up_unheard(Time now);
  void repeat_order();
  void ask_next();
  void device_type_came(SdoClient::Outcome outcome);
  void sleep_message(const Frame& frame, Time now);
  void nobody_objected(Time now);
  void sleep_changed(SleepState state);
  void tell(const CarEvent& event);

  CarNetwork& network_;
  CarSleep& sleep_;
  CarMemory memory_;
  CarMasterSettings settings_;
  KnownDevices known_;
  Callback<void(const CarEvent&)> told_;
  Callback<void(NodeId, std::uint8_t)> next_heard_;
  Callback<void(NodeId)> next_lost_;
  LssMaster lss_;
  std::array<LssAddress, add_on_devices_max + 1> scanned_{};
  LssScan scan_;
  Timer scan_timer_;
  Time look_around_at_{};  ///< before it, only those who were lost are looked for
  NodeId looked_for_ = node_id_max;
  Timer objection_timer_;
  Timer wake_up_timer_;
  Time order_again_at_{};  ///< while it sleeps
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  std::bitset<node_id_max + 1> present_;
  std::bitset<node_id_max + 1> started_;  ///< and not yet heard to be operational
  std::bitset<node_id_max + 1> halted_;   ///< by somebody's command
  SdoClient client_;                      ///< on the default channels, as CiA 301 has them
  std::bitset<node_id_max + 1> to_be_asked_;
  NodeId asked_ = 0;
  std::uint32_t bus_offs_before_ = 0;  ///< of this node, before it asked
  std::array<std::uint8_t, 4> device_type_{};
};

}  // namespace canvoy::cia447
