// The charging yard of `canvoy run charger`: `[yard]` and `[[vehicle]]` in a network file, and
// `--chargers` and others on the command line.
//
//     YardSettings yard;
//     yard.goal = "80@06:00";
//     check_yard(yard, network, "");            // throws UsageError
//     charger::ChargingYard made(yard_of(yard, network));
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/play/settings.hpp"
#include "canvoy/tools/player/run_options.hpp"
#include "canvoy/worlds/charger/yard_options.hpp"

namespace canvoy::tools {

/// A vehicle as in a file: times from the start on; 0: at the start, or never.
struct VehicleOfFile {
  unsigned bay = 1;
  double percent = 20;  ///< state of charge when it first comes
  Duration arrives{};
  Duration leaves{};
  Duration returns{};
  double used_percent = 40;
};

/// A bay of which a part is real, as in a file.
struct BayOfFile {
  unsigned bay = 1;
  bool plays_charger = true;
  bool plays_battery = true;
  std::string real{};  ///< the real bus of the bay, `can0`; empty: none

  bool is_played() const { return plays_charger && plays_battery; }
};

struct YardSettings {
  bool is_given = false;  ///< false: one charger and one battery
  unsigned chargers = 1;
  unsigned batteries = 0;  ///< 0: one for each charger, or each vehicle
  bool one_bus = false;
  std::vector<std::string> kinds{};  ///< names of BatteryKind
  std::string goal{};                ///< `80@06:00`; empty: none
  Duration change_time = 2min;
  double supply_kilowatt = 0;
  std::vector<VehicleOfFile> vehicles{};
  std::vector<BayOfFile> bays{};
};

/// Options of the command line. What differs from these values makes a yard.
struct YardChoice {
  unsigned chargers = 1;
  unsigned batteries = 0;
  bool one_bus = false;
  std::string battery{};
  std::string goal{};
  double supply = 0;
};
void add_yard_options(Verb& verb, YardChoice& choice);
YardSettings chosen_yard(const YardChoice& choice);

SettingTable<YardSettings> yard_table();
SettingTable<VehicleOfFile> yard_vehicle_table();
SettingTable<BayOfFile> yard_bay_table();

/// One line that says what is wrong, for a network with these options; empty: nothing.
/// `has_real_bus` is that of `[bus]`.
std::string wrong_of_yard(const YardSettings& yard, const charger::ChargerOptions& network,
                          bool has_real_bus = false);
/// The real buses of bays that have a bus of their own.
std::vector<RealBus> real_buses_of(const YardSettings& yard);
/// The yard, of settings that are right. The vehicles are drawn where there are none.
charger::YardOptions yard_of(const YardSettings& yard, const charger::ChargerOptions& network);

}  // namespace canvoy::tools
