// The configuration of a node in a DCF, as SDO writes in an order that a node accepts: a PDO is
// changed while it is invalid (CiA 301, 7.5.2.36).
//
//     Configuration configuration = configuration_of(sheet, 5);
//     for (const ConfigurationEntry& entry : configuration.entries) ...
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"

namespace canvoy::formats {

/// One SDO write.
struct ConfigurationEntry {
  std::uint16_t index = 0;               ///< of the object
  std::uint8_t sub = 0;                  ///< sub-index
  std::vector<std::uint8_t> value = {};  ///< little-endian

  friend bool operator==(const ConfigurationEntry&, const ConfigurationEntry&) = default;
};

/// Writes of a whole configuration, and what became of the others.
struct Configuration {
  std::vector<ConfigurationEntry> entries = {};  ///< in the order to write them
  NodeId sheet_node = 0;                         ///< of the DCF; 0: not given
  std::size_t moved = 0;  ///< number of values that depend on the node-ID and were for another one
  std::size_t process_data = 0;  ///< number of values omitted since they are not configuration
  Findings bad = {};             ///< values omitted since they do not fit their type
};

/// The parameters of a DCF or XDC for the node `node_id`: entries with a value that a client may
/// write. Omits what is not a parameter: process data (what an RPDO may carry), actions and states,
/// domains, and 1020h, which belongs to the configuration manager. A value that equals the default
/// for the node-ID of the sheet becomes the default for `node_id` (0: that of the sheet).
Configuration configuration_of(const DataSheet& sheet, NodeId node_id);

/// Makes a concise DCF of the entries (CiA 302-3, 1F22h).
std::vector<std::uint8_t> concise_dcf_of(const std::vector<ConfigurationEntry>& entries);

}  // namespace canvoy::formats
