// Configuration of a device before the test: a reset, which some cases need, discards what is not
// stored.
//
//     KeptSettings kept;
//     kept.read(bench);
//     ... cases ...
//     kept.put_back(bench);   // Answers what could not be
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/text/check/bench/bench.hpp"

namespace canvoy::conformance {

/// Parameters of SYNC, emergencies and error control, and of the first 32 PDOs of each direction.
class KeptSettings {
 public:
  /// Reads all of them from the device.
  void read(Bench& bench);
  /// Writes only what has changed, PDO parameters while the PDO is invalid (CiA 301, 7.5.2.36).
  std::vector<std::string> put_back(Bench& bench);

 private:
  struct Setting {
    /// Index of the entry.
    std::uint16_t index;
    /// Sub-index of the entry.
    std::uint8_t sub;
    /// Value before the test.
    Bytes value;
  };
  struct Pdo {
    /// Sub-index 01h.
    Setting cob_id;
    std::vector<Setting> parameters;  ///< from sub-index 02h on
    std::vector<Setting> mapping;     ///< from sub-index 00h on
  };

  static void keep(Bench& bench, std::vector<Setting>& settings, std::uint16_t index,
                   std::uint8_t sub);
  void read_pdo(Bench& bench, std::uint16_t parameter, std::uint16_t mapping);
  static bool is_as_it_was(Bench& bench, const Setting& setting);
  static bool put_back(Bench& bench, const Pdo& pdo);
  static bool map_again(Bench& bench, const std::vector<Setting>& mapping);

  std::vector<Setting> plain_;
  std::vector<Pdo> pdos_;
};

}  // namespace canvoy::conformance
