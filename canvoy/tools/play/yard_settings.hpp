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

/// One line that says what is wrong, for a network with these options; empty: nothing.
std::string wrong_of_yard(const YardSettings& yard, const charger::ChargerOptions& network);
/// The yard, of settings that are right. The vehicles are drawn where there are none.
charger::YardOptions yard_of(const YardSettings& yard, const charger::ChargerOptions& network);

}  // namespace canvoy::tools
