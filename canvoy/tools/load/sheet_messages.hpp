// What nodes send by their data sheets: SYNC (1005h, 1006h), TPDOs (1800h and 1A00h on), heartbeats
// (1017h) and emergencies (1014h, 1015h); CiA 301, 7.5.2.
//
//     add_sheet_messages(bus, describe_nodes("network.toml"));
#pragma once

#include <vector>

#include "canvoy/tools/load/loaded_bus.hpp"
#include "canvoy/tools/sheet/described_nodes.hpp"

namespace canvoy::tools {

/// A TPDO behind SYNC has its period times its transmission type, and its place: it may be queued
/// as late as SYNC itself can be; but for those of higher priority than SYNC, which come as they
/// like. A TPDO by events comes each inhibit time, or else each event time. What has no period is
/// `left_out`, as are requests: SDO, NMT, LSS. The bit rate of the bus has to be known where
/// anything is behind SYNC. Throws Failure where two send the same identifier, UsageError without
/// that bit rate.
void add_sheet_messages(LoadedBus& bus, const std::vector<DescribedNode>& nodes);

}  // namespace canvoy::tools
