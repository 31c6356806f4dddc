// A plain list of the messages on a bus, in TOML:
//
//     bit_rate = 125000
//     [errors]
//     at_once = 1
//     each = "100ms"
//     [[message]]
//     id = 0x185
//     bytes = 8
//     period = "10ms"
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/load/loaded_bus.hpp"
#include "canvoy/tools/sheet/described_nodes.hpp"

namespace canvoy::tools {

// Messages that nodes send according to their data sheets: SYNC (1005h, 1006h), TPDOs (from 1800h
// and 1A00h), heartbeats (1017h) and emergencies (1014h, 1015h) (CiA 301, 7.5.2).
//
//     add_sheet_messages(bus, describe_nodes("network.toml"));

/// The period of a synchronous TPDO is that of SYNC times its transmission type, its offset is that
/// of SYNC, and its jitter the worst-case delay of SYNC. A synchronous TPDO with a higher priority
/// than SYNC may come at any time. The period of an event-driven TPDO is its inhibit time, or else
/// its event time. Messages without a period become `left_out`, as do requests: SDO, NMT, LSS. The
/// bit rate of the bus must be known if a message is synchronous. Throws Failure if two messages
/// have the same identifier, UsageError without that bit rate.
void add_sheet_messages(LoadedBus& bus, const std::vector<DescribedNode>& nodes);

/// True if a file is such a list, not a network of nodes.
bool is_message_list(const TomlTable& file);

/// Throws Failure with file and line.
LoadedBus read_message_list(TomlTable& file, const std::string& name);

/// Reads deadlines from a file with `[[deadline]]`, each with `id`, `extended` and `deadline`, and
/// `bus` if it applies to one bus only. Throws Failure with file and line, also for an identifier
/// without a message.
void read_deadlines(TomlTable& file, std::vector<LoadedBus>& buses);

}  // namespace canvoy::tools
