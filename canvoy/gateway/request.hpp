// A command, parsed from its line (CiA 309-3).
//
//     Parsed parsed = parse_request("[1] 2 5 r 0x1018 1 u32");
//     if (parsed.error != ErrorCode::none) answer(parsed.sequence, parsed.error);
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/gateway/error_code.hpp"
#include "canvoy/gateway/value.hpp"

namespace canvoy::gateway {

/// Commands of CiA 309-3, by what they do.
enum class Command : std::uint8_t {
  none,  ///< an empty line, or a comment alone
  read,
  write,
  set_sdo_timeout,
  set_sdo_block,
  set_rpdo,
  set_tpdo,
  read_pdo,
  write_pdo,
  start,
  stop,
  preoperational,
  reset_node,
  reset_communication,
  enable_guarding,
  disable_guarding,
  enable_heartbeat,
  disable_heartbeat,
  init,
  set_heartbeat,
  set_id,
  set_command_timeout,
  set_command_size,
  boot_up_indication,
  set_network,
  set_node,
  info_version,
  lss_switch_global,
  lss_switch_selective,
  lss_set_node,
  lss_configure_bit_rate,
  lss_activate_bit_rate,
  lss_store,
  lss_inquire_address,
  lss_get_node,
  lss_identity,
  lss_identify_unconfigured,
  lss_fastscan,
};

/// Target of a command, which determines the numbers that may precede it.
enum class Scope : std::uint8_t { gateway, network, node };
/// Scope of a command.
Scope scope_of(Command command);

/// A PDO of the gateway, as `set rpdo`, `set tpdo` and `set tpdox` describe it.
struct PdoSetup {
  std::uint32_t cob_id = CobId::bit31;   ///< as in 1400h or 1800h
  std::uint8_t transmission_type = 255;  ///< 0 to 255
  std::uint16_t inhibit_ms = 0;          ///< at least, between two frames
  std::uint16_t event_ms = 0;            ///< event timer
  std::uint8_t sync_start = 0;           ///< counter of the SYNC to begin with; 0: any
  std::vector<DataType> mapped;          ///< types of the values, in order

  friend bool operator==(const PdoSetup&, const PdoSetup&) = default;
};

struct Request {
  Command command = Command::none;     ///< which arguments it has depends on it
  std::optional<std::uint32_t> net;    ///< nothing: the default network
  std::optional<std::uint32_t> node;   ///< nothing: the default node; 0: all nodes
  std::uint16_t index = 0;             ///< index of an object
  std::uint8_t sub = 0;                ///< sub-index of an object
  ValueType type;                      ///< of a value to read or write
  Bytes value;                         ///< value to write
  std::vector<std::uint64_t> numbers;  ///< the arguments of all other commands, in their order
  PdoSetup pdo;                        ///< of `set rpdo` and `set tpdo`

  friend bool operator==(const Request&, const Request&) = default;
};

/// What a line says.
struct Parsed {
  std::uint32_t sequence = 0;         ///< 0 if the line has none
  ErrorCode error = ErrorCode::none;  ///< none: the request is complete
  Request request;                    ///< meaningless if there is an error
};

/// Parses a line. Errors: syntax; not_supported if the command is unknown; unknown_net and
/// unknown_node if a number in front of it is out of range.
Parsed parse_request(std::string_view line);

}  // namespace canvoy::gateway
