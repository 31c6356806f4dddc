// What a DCF asks a node to be, as writes by SDO in an order that a node accepts (CiA
// 301, 7.5.2.36: a PDO changes while it is invalid).
//
//     Configuration configuration = configuration_of(sheet, 5);
//     for (const ConfigurationEntry& entry : configuration.entries) ...
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/formats/eds/eds_reader.hpp"
#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

struct ConfigurationEntry {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::vector<std::uint8_t> value = {};

  friend bool operator==(const ConfigurationEntry&, const ConfigurationEntry&) = default;
};

struct Configuration {
  std::vector<ConfigurationEntry> entries = {};
  NodeId sheet_node = 0;         ///< that the DCF is of; 0: it does not say
  std::size_t moved = 0;         ///< values that go with the node-ID, and were of another one
  std::size_t process_data = 0;  ///< values that are none of a configuration, and left out
  Findings bad = {};             ///< values that are none of their type, and left out
};

/// The parameters of a DCF or XDC for the node `node_id`: entries that have a value and that a
/// client may write. Left out is what is no parameter: process data (what an RPDO may carry),
/// actions and states, domains, and 1020h, which is the configuration manager's. A value that is
/// the default which goes with the sheet's node-ID becomes that of `node_id` (0: of the sheet's
/// own).
Configuration configuration_of(const DataSheet& sheet, NodeId node_id);

/// The same as a concise DCF (CiA 302-3, 1F22h).
std::vector<std::uint8_t> concise_dcf_of(const std::vector<ConfigurationEntry>& entries);

}  // namespace canvoy::formats
