// Services of the gateway for the network of a car (CiA 447-1, which is not at hand: these follow
// public implementations). As LSS master it finds add-on devices without a node-ID by Fastscan and
// assigns node-IDs. As NMT master it starts them and reads their identity. It also puts the network
// to sleep and wakes it up.
//
//     CarMaster master(network, sleep, {});
//     master.on_event(Callback<void(const CarEvent&)>::to<&App::happened>(app));
//     master.send_to_sleep();
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/kit/car_places.hpp"
#include "canvoy/devices/cia447/kit/car_sleep.hpp"

namespace canvoy::cia447 {

/// All node-IDs but the gateway's.
inline constexpr std::size_t add_on_devices_max = node_id_max - 1;

/// The assigned node-IDs, by the identity of the devices: 2 is the first.
struct KnownDevices {
  std::array<LssAddress, add_on_devices_max> addresses{};  ///< node-ID 2 is at index 0
  std::array<bool, add_on_devices_max> is_known{};         ///< by index of `addresses`

  /// Node-ID of a known device; nothing for another one.
  std::optional<NodeId> find(const LssAddress& address) const;
};

/// Keeps them over restarts of the gateway. Both callbacks are optional.
struct CarMemory {
  Callback<KnownDevices()> load = {};              ///< called once, at the start
  Callback<void(const KnownDevices&)> store = {};  ///< called after each change
};

/// Periods and times of the master.
struct CarMasterSettings {
  Duration scan_period = 1s;  ///< period of scans for devices without a node-ID
  /// Period of scans while a device answers Fastscan although it has a node-ID (some devices of
  /// others do, and a scan then takes some hundred messages). In between, only known devices that
  /// were lost are searched for, by their identity.
  Duration answered_scan_period = 30s;
  Duration objection_time = 1s;  ///< time to wait for objections to sleep
  bool starts_nodes = true;      ///< into NMT state operational
  /// A known device that is not received for this time after its boot-up may be asleep: the master
  /// wakes up all.
  Duration wake_up_after = 10s;
  /// During sleep, period of requests to a device that is awake, whether it may sleep as well.
  Duration order_period = 10s;
  /// Devices for which node-IDs are reserved, beside the known ones; must outlive the master. A
  /// device that got another node-ID before its identity was known gets its reserved one: LSS
  /// assigns it, and communication of the device is reset.
  std::span<const CarPlace> places{};
};

/// Something that the master reports.
struct CarEvent {
  /// What has happened.
  enum class Kind : std::uint8_t {
    named,      ///< `node` was assigned to a device
    refused,    ///< there are already 15
    started,    ///< `node` was commanded to enter operational
    lost,       ///< `node` is not received any more
    stranger,   ///< `node` is no device of CiA 447 (1000h), or does not answer
    objection,  ///< `node` objects to sleep, with `reason`
    asleep,
    awake,
  };
  Kind kind;                ///< see Kind
  NodeId node = 0;          ///< 0: about no single node
  std::uint8_t reason = 0;  ///< of a refusal to sleep
};

class CarMaster {
 public:
  /// CAN-IDs that it receives.
  static constexpr std::size_t routes = LssMaster::routes + node_id_max + 2;

  /// `sleep` belongs to the same device. All arguments must outlive this. The master sets
  /// on_heard(), on_lost() and on_change() of them, and calls the former callbacks of the first
  /// two.
  CarMaster(CarNetwork& network, CarSleep& sleep, const CarMemory& memory,
            const CarMasterSettings& settings = {});

  /// Sets the callback for each event.
  void on_event(Callback<void(const CarEvent&)> told) { told_ = told; }

  /// Asks for objections; if none comes in time, the network is put to sleep. No effect while a
  /// request is under way, or during sleep.
  void send_to_sleep();
  /// Wakes the network up.
  void wake_up();

  /// The devices that have node-IDs.
  const KnownDevices& known() const { return known_; }
  /// True if it is received.
  bool is_present(NodeId node) const { return present_[node]; }

 private:
  void reset(ResetScope scope);
  void look(Time now);
  void look_for_lost();
  NodeId choose(const LssAddress& address);
  NodeId find_free() const;
  bool is_place(NodeId node) const;
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
  void ask_place(std::size_t first);
  void place_answered(SdoClient::Outcome outcome);
  void belongs(NodeId place);
  bool move_next();
  void stop_looking();
  void selected(const LssMaster::Reply& reply);
  void moved(const LssMaster::Reply& reply);
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
  Time look_around_at_{};  ///< before that, only lost devices are searched for
  NodeId looked_for_ = node_id_max;
  Timer objection_timer_;
  Timer wake_up_timer_;
  Time order_again_at_{};  ///< during sleep
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  NodeSet present_;
  NodeSet started_;   ///< and not yet received in operational
  NodeSet halted_;    ///< by a command of another node
  SdoClient client_;  ///< on the default channels of CiA 301
  NodeSet to_be_asked_;
  NodeSet guests_;  ///< got a node-ID without being known
  NodeId asked_ = 0;
  std::size_t asked_place_ = 0;
  std::array<NodeId, node_id_max + 1> moves_to_{};  ///< 0: stays
  NodeId moving_ = 0;                               ///< 0: none
  std::uint32_t bus_offs_before_ = 0;               ///< of this node, before the request
  std::array<std::uint8_t, 4> device_type_{};
};

}  // namespace canvoy::cia447
