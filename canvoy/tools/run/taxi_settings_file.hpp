// Parts of the file of a taxi: its shift, its tariff, and what we assume of the network of a car
// where parts 1 and 4 of CiA 447 are not at hand.
//
//     take_shift(table, run.network.shift);
//     run.tariff = take_tariff(table);
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// What a cia447::Tariff refers to.
struct TariffParts {
  std::vector<cia447::TariffLevel> levels;
  std::vector<cia447::TariffHours> hours;

  cia447::Tariff tariff() const { return {.id = 1, .levels = levels, .hours = hours}; }
};

/// Each throws Failure with file and line.

/// `[shift]`
void take_shift(TomlTable& file, taxi::ShiftOptions& shift);
/// `[car_network]`
void take_car_network(TomlTable& file, taxi::CarNetworkOptions& network);
/// `[[tariff]]` and `[[tariff_hours]]`; null: there are none.
std::shared_ptr<const TariffParts> take_tariff(TomlTable& file);

std::string shift_text(const taxi::ShiftOptions& shift);
std::string car_network_text(const taxi::CarNetworkOptions& network);
std::string tariff_text(const cia447::Tariff& tariff);

}  // namespace canvoy::tools
