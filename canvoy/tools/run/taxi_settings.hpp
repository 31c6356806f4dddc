// Parts of the file of a taxi: its shift, what we assume of the network of a car where parts 1 and
// 4 of CiA 447 are not at hand, and its tariff.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/tools/run/world_file.hpp"

namespace canvoy::tools {

/// What a cia447::Tariff refers to.
struct TariffParts {
  std::vector<cia447::TariffLevel> levels;
  std::vector<cia447::TariffHours> hours;

  cia447::Tariff tariff() const { return {.id = 1, .levels = levels, .hours = hours}; }
};

struct TaxiRun : WorldRun {
  taxi::TaxiOptions network{};
  std::shared_ptr<TariffParts> tariff =
      std::make_shared<TariffParts>();  ///< as read; empty: the example's
  std::string nmea{};                   ///< the file of the drive, as it was written
};

/// `[shift]`, `[car_network]`, `[[tariff]]` and `[[tariff_hours]]`.
void add_taxi_settings(std::vector<FilePart<TaxiRun>>& parts);

}  // namespace canvoy::tools
