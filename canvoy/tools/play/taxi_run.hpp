// Content of the file of a taxi.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/tools/play/world_file.hpp"
#include "canvoy/tools/play/world_hands.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::tools {

/// `[[supplement]]`
struct TariffSupplement {
  std::string name;
  std::uint32_t price = 0;  ///< in 0,001 of the currency unit
  double share = 0;         ///< part of the trips
};

/// Data that a cia447::Tariff and a cia447::Currency refer to.
struct TariffParts {
  std::vector<cia447::TariffLevel> levels;
  std::vector<cia447::TariffHours> hours;
  std::optional<std::vector<cia447::Holiday>> holidays;  ///< nothing: those of the example
  std::vector<TariffSupplement> supplements;
  std::vector<cia447::SupplementKind> kinds;   ///< of the supplements
  std::string code;                            ///< code of the currency
  std::string symbol;                          ///< symbol of the currency
  std::optional<std::string> taxi_identifier;  ///< of the meter; nothing: as the licence

  /// The tariff; missing parts are those of the example. Hours and supplements belong to the
  /// levels.
  cia447::Tariff tariff() const;
};

struct TaxiRun : WorldRun {
  taxi::TaxiOptions network{};
  std::shared_ptr<TariffParts> tariff =
      std::make_shared<TariffParts>();  ///< as read; empty: those of the example
  std::string nmea{};                   ///< file of the drive, as given
  std::vector<HandOfFile> hands{};
};

}  // namespace canvoy::tools
