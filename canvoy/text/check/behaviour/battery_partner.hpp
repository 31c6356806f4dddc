// A battery module (CiA 418) that the test plays for a charger: it is on the same line, answers by
// SDO, sends its PDOs and its heartbeat, and reports what a case needs.
//
//     BatteryPartner battery(bench);
//     battery.says.ready = true;
//     if (const auto cannot = battery.wait_until_linked()) return *cannot;
#pragma once

#include <optional>
#include <vector>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia418/battery_hardware.hpp"
#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

class BatteryPartner {
 public:
  /// Starts the battery: not ready to be charged, no request.
  explicit BatteryPartner(Bench& bench);
  /// Resets the charger, so that the next case has another battery.
  ~BatteryPartner();

  /// Measurements and requests of the battery; may be changed at any time.
  cia418::BatteryReadings says = {.temperature_celsius = 25,
                                  .voltage_volt = 50,
                                  .requested_current_ampere = 0,
                                  .state_of_charge_percent = 30};

  /// Waits until the pilot contact is closed, if a person can close it, both devices are
  /// operational, and an RPDO of the charger has the CAN-ID of the battery. Returns the reason if
  /// this fails.
  std::optional<Verdict> wait_until_linked();
  /// Value of an entry of the battery, at most four bytes.
  std::uint32_t own(std::uint16_t index, std::uint8_t sub);
  /// Stops sending and receiving.
  void fall_silent() { is_silent_ = true; }
  /// True if this entry of the battery was read by SDO.
  bool was_read(std::uint16_t index, std::uint8_t sub) const {
    return was_asked({.is_write = false, .index = index, .sub = sub});
  }
  /// True if this entry of the battery was written by SDO.
  bool was_written(std::uint16_t index, std::uint8_t sub) const {
    return was_asked({.is_write = true, .index = index, .sub = sub});
  }
  /// Sends a frame as the battery.
  void send(const Frame& frame) { bench_.send(frame); }

 private:
  struct Request {
    bool is_write;  ///< a download
    /// Index of the requested entry.
    std::uint16_t index;
    /// Sub-index of the requested entry.
    std::uint8_t sub;

    /// True for the same entry and the same direction.
    friend bool operator==(const Request&, const Request&) = default;
  };

  bool was_asked(const Request& request) const;
  static bool send_from(void* context, const Frame& frame);
  cia418::BatteryReadings sense() { return says; }
  cia418::BatteryHardware hardware();
  void hear(const Heard& heard);
  bool has_rpdo_of_battery();

  Bench& bench_;
  Environment environment_;
  std::optional<CatalogueDevice> device_;
  Player player_;
  std::vector<Request> requests_;
  bool is_silent_ = false;
};

}  // namespace canvoy::conformance
