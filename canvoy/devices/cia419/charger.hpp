// A CiA 419 battery charger: finds a CiA 418 battery, links its PDOs to it, and charges it (clauses
// 4 to 7).
//
//     Charger charger(node, services, hardware, {.limits = {.current_max_ampere = 40}});
//     node.start(now);  // from here on frames and time do the rest
#pragma once

#include <bitset>
#include <cstdint>

#include "canvoy/canopen/manager/sdo_requester.hpp"
#include "canvoy/canopen/nmt/error_behaviour.hpp"
#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/nmt/network_states.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/remote/device_scan.hpp"
#include "canvoy/canopen/sync/time_stamp.hpp"
#include "canvoy/devices/cia419/battery_link.hpp"
#include "canvoy/devices/cia419/charge_control.hpp"
#include "canvoy/devices/cia419/charge_curve.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"
#include "canvoy/devices/cia419/rival_watch.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/cia419.hpp"

namespace canvoy::cia419 {

/// Settings of a charger that no object of its dictionary has.
struct ChargerSettings {
  ChargeLimits limits;              ///< of current, voltage and temperature
  Duration control_period = 100ms;  ///< of measuring, deciding and counting
  /// Starts the battery and its own node: alone with a battery, there is no other NMT master.
  bool manage_network = true;
  Duration battery_heartbeat = 1s;     ///< written to a battery that sends none
  unsigned heartbeat_periods_max = 2;  ///< periods without a heartbeat after which it is lost
  unsigned pdo_periods_max = 3;        ///< for an RPDO: event times of the battery's TPDO
  /// Time for an SDO manager to answer, twice, before the battery is accessed on its default SDO
  /// channel (6.1).
  Duration sdo_manager_time_out = 250ms;
  Duration time_period = 1min;  ///< of TIME (4.1), if the hardware has the time of day
  /// For a battery that offers no TPDO with a requested current.
  ChargeCurveSettings curve = {};
  /// Node-ID of the battery in its bay, on a bus with several bays; 0: the first that is found.
  NodeId bay_battery = 0;
};

/// Services of a node that a charger uses.
struct ChargerServices {
  Rpdos& rpdos;                           ///< at least as many as are linked
  Tpdos& tpdos;                           ///< at least as many as are linked
  HeartbeatConsumer& heartbeats;          ///< of the battery
  ErrorBehaviour& error_behaviour;        ///< for 1029h
  NetworkStates* network = nullptr;       ///< needed to manage the network
  SdoRequester* sdo_requester = nullptr;  ///< needed for an SDO connection to the battery (6.1)
  SdoClient* battery_client = nullptr;    ///< of that connection: 1280h + battery_connection
  TimeStamp* time_stamp = nullptr;        ///< needed to be a TIME producer (4.1)
};

/// Numbers of the SDO clients to the SDO manager and to the battery.
inline constexpr std::uint8_t manager_connection = 0;
inline constexpr std::uint8_t battery_connection = 1;  ///< 1281h

/// Progress from an empty socket to a charge.
enum class ChargerPhase : std::uint8_t {
  unplugged,  ///< no pilot signal
  searching,  ///< scans for a battery
  linking,    ///< reads the battery's PDOs
  linked,
};

class Charger {
 public:
  /// The last change; the charger has the details.
  enum class Event : std::uint8_t {
    phase_changed,
    reason_changed,  ///< why no current flows, or that it flows again
    charge_began,
    charge_ended,  ///< and the ampere-hours were written back to the battery
  };

  /// All arguments must outlive the charger. `hardware` is read and driven every control_period.
  Charger(Node& node, const ChargerServices& services, const ChargerHardware& hardware,
          const ChargerSettings& settings);

  /// Sets the callback for each event; it is called in a call of the node.
  void on_event(Callback<void(Event)> event) { event_ = event; }

  /// Progress at present.
  ChargerPhase phase() const { return phase_; }
  /// none while current flows
  StopReason reason() const { return reason_; }
  /// The linked battery; 0 if there is none.
  NodeId battery() const { return phase_ == ChargerPhase::linked ? offer_.id : NodeId{0}; }
  /// What the battery has answered: meaningful from ChargerPhase::linking on.
  const BatteryOffer& provide() const { return offer_; }
  /// The current set at the power stage.
  double set_point_ampere() const { return set_point_; }
  /// Counted since construction from the current measured by the hardware, and the battery's
  /// voltage.
  double ampere_hours_total() const { return ampere_hours_total_; }
  /// Counted like ampere_hours_total(), in watt-hours.
  double energy_total_watt_hours() const { return energy_total_; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void bus_state_changed(BusState state);
  void error_changed(const Error& error, bool present);
  void battery_changed(NodeId id, RemoteState state);
  void network_changed(NodeId id, RemoteState state);
  void pdo_received(std::uint16_t number);
  void pdo_timed_out(std::uint16_t number);
  void note_pdo(std::uint16_t number, bool is_fresh);
  void refresh(std::uint16_t number);
  bool has_told_ready() const;
  void battery_found(NodeId id);
  void connection_answered(SdoEnd end);
  void battery_answered(const BatteryOffer& offer);
  void battery_silent();

  void control(Time now);
  void watch_pilot_signal();
  void manage(Time now);
  void report_time();
  void count(Time now);
  void act();
  void follow_curve();
  bool is_battery_heard() const;
  ChargeInputs inputs() const;
  RemoteState battery_state() const { return services_.heartbeats.state(offer_.id); }
  void report(StopReason reason);
  void begin_charge();
  void end_charge();

  void search(Duration later = {});
  void link();
  void report_misfits(bool present);
  void unlink();
  void watch_rivals(Time now);
  void forget_values();
  void link_rpdo(std::size_t position, bool use);
  bool link_tpdo(std::size_t position);
  unsigned battery_period() const;
  void supervise_battery();
  void check_link(const BatteryOffer& offer);
  void remind_battery(Time now);
  void ask_for_heartbeat();
  std::uint16_t asked_heartbeat_ms() const;
  void request_values(const std::bitset<BatteryOffer::pdos>& wanted);
  void request_first_values() { request_values(~fresh_rpdos_); }
  void ask_anew(NodeId battery);
  void enter(ChargerPhase phase);
  bool configure(std::uint16_t index, std::uint8_t sub, std::uint32_t value);

  Node& node_;
  ChargerServices services_;
  ChargerHardware hardware_;
  ChargerSettings settings_;
  Bound<battery_status> battery_status_;
  Bound<charger_status> charger_status_;
  Bound<battery_temperature> temperature_;
  Bound<battery_voltage> voltage_;
  Bound<charge_current_requested> requested_;
  Bound<battery_state_of_charge> state_of_charge_;
  Bound<charger_state_of_charge> estimate_;
  Bound<ah_returned_during_last_charge> returned_;
  ChargeControl charge_control_;
  ChargeCurve curve_;
  DeviceScan scan_;
  BatteryLink link_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Callback<void(Event)> event_;

  ChargerPhase phase_ = ChargerPhase::unplugged;
  StopReason reason_ = StopReason::no_pilot_signal;
  BatteryOffer offer_;

  std::bitset<BatteryOffer::pdos> linked_rpdos_;
  std::bitset<BatteryOffer::pdos> fresh_rpdos_;
  GapWatch gaps_;
  RivalWatch rivals_;
  NodeId found_ = 0;            ///< the battery to which a connection is requested; 0: none
  bool is_connected_ = false;   ///< by a separate SDO connection
  bool is_lost_ = false;        ///< the battery, by its heartbeat
  bool tells_status_ = false;   ///< a TPDO is linked, and each of them starts with the status
  Time ready_told_at_ = never;  ///< when a TPDO with "ready" was first passed to the controller
  bool pilot_signal_ = false;
  bool charging_ = false;  ///< a charge has started and not ended
  Time commanded_at_{};
  Time asked_at_{};  ///< for a heartbeat, or for the changes of a lost battery
  Time counted_at_{};
  double set_point_ = 0;
  double ampere_hours_ = 0;  ///< of this charge
  double ampere_hours_total_ = 0;
  double energy_total_ = 0;
  double state_of_charge_begin_ = 0;
};

}  // namespace canvoy::cia419
