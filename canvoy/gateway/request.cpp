#include "canvoy/gateway/request.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "canvoy/gateway/number.hpp"
#include "canvoy/gateway/token.hpp"

namespace canvoy::gateway {

namespace {

struct Range {
  std::uint64_t low = 0;
  std::uint64_t high = 0;  ///< 0: no such argument
};
constexpr Range any_u8{0, UINT8_MAX};
constexpr Range any_u16{0, UINT16_MAX};
constexpr Range any_u32{0, UINT32_MAX};
constexpr Range any_milliseconds{1, UINT32_MAX};
constexpr Range pdo_number{1, 512};

/// Parses what follows the name of a command; false if it is wrong.
using Reader = bool (*)(Tokens words, Request& request);

bool read_object(Tokens words, Request& request);
bool read_value(Tokens words, Request& request);
bool read_rpdo(Tokens words, Request& request);
bool read_tpdo(Tokens words, Request& request);
bool read_extended_tpdo(Tokens words, Request& request);
bool read_pdo_values(Tokens words, Request& request);
bool read_switch(Tokens words, Request& request);
bool read_address_part(Tokens words, Request& request);
bool read_scan(Tokens words, Request& request);

/// A command: its words, and the arguments, which are either numbers or parsed by `reader`.
struct CommandRow {
  std::string_view first;
  std::string_view second;
  Command command = Command::none;
  Scope scope = Scope::network;
  std::array<Range, 6> numbers = {};
  Reader reader = nullptr;
};

// A command of two words precedes the one that is its first word.
constexpr auto commands = std::to_array<CommandRow>({
    {"r[ead]", "p[do]", Command::read_pdo, Scope::network, {pdo_number}},
    {"r[ead]", "", Command::read, Scope::node, {}, read_object},
    {"w[rite]", "p[do]", Command::write_pdo, Scope::network, {}, read_pdo_values},
    {"w[rite]", "", Command::write, Scope::node, {}, read_value},
    {"set", "sdo_timeout", Command::set_sdo_timeout, Scope::network, {any_milliseconds}},
    {"set", "sdo_block", Command::set_sdo_block, Scope::network, {Range{0, 1}}},
    {"set", "rpdo", Command::set_rpdo, Scope::network, {}, read_rpdo},
    {"set", "tpdo", Command::set_tpdo, Scope::network, {}, read_tpdo},
    {"set", "tpdox", Command::set_tpdo, Scope::network, {}, read_extended_tpdo},
    {"start", "", Command::start, Scope::node},
    {"stop", "", Command::stop, Scope::node},
    {"preop[erational]", "", Command::preoperational, Scope::node},
    {"reset", "node", Command::reset_node, Scope::node},
    {"reset", "comm[unication]", Command::reset_communication, Scope::node},
    {"enable", "guarding", Command::enable_guarding, Scope::node, {any_u16, any_u8}},
    {"disable", "guarding", Command::disable_guarding, Scope::node},
    {"enable", "heartbeat", Command::enable_heartbeat, Scope::node, {any_u16}},
    {"disable", "heartbeat", Command::disable_heartbeat, Scope::node},
    {"init", "", Command::init, Scope::network, {Range{0, 9}}},
    {"set", "heartbeat", Command::set_heartbeat, Scope::network, {any_u16}},
    {"set", "id", Command::set_id, Scope::network, {Range{1, UINT8_MAX}}},
    {"set", "command_timeout", Command::set_command_timeout, Scope::gateway, {any_milliseconds}},
    {"set", "command_size", Command::set_command_size, Scope::gateway, {any_u32}},
    {"boot_up_indication", "", Command::boot_up_indication, Scope::network, {}, read_switch},
    {"set", "network", Command::set_network, Scope::gateway, {any_u16}},
    {"set", "node", Command::set_node, Scope::network, {any_u8}},
    {"info", "version", Command::info_version, Scope::network},
    {"lss_switch_glob", "", Command::lss_switch_global, Scope::network, {Range{0, 1}}},
    {"lss_switch_sel",
     "",
     Command::lss_switch_selective,
     Scope::network,
     {any_u32, any_u32, any_u32, any_u32}},
    {"lss_set_node", "", Command::lss_set_node, Scope::network, {Range{1, UINT8_MAX}}},
    {"lss_conf_bitrate", "", Command::lss_configure_bit_rate, Scope::network, {any_u8, any_u8}},
    {"lss_activate_bitrate", "", Command::lss_activate_bit_rate, Scope::network, {any_u16}},
    {"lss_store", "", Command::lss_store, Scope::network},
    {"lss_inquire_addr", "", Command::lss_inquire_address, Scope::network, {}, read_address_part},
    {"lss_get_node", "", Command::lss_get_node, Scope::network},
    {"lss_identity",
     "",
     Command::lss_identity,
     Scope::network,
     {any_u32, any_u32, any_u32, any_u32, any_u32, any_u32}},
    {"lss_ident_nonconf", "", Command::lss_identify_unconfigured, Scope::network},
    {"_lss_fastscan", "", Command::lss_fastscan, Scope::network, {}, read_scan},
});

std::optional<std::uint64_t> parse_in(Token word, const Range& range) {
  const auto number = parse_unsigned(word, range.high);
  return number && *number >= range.low ? number : std::nullopt;
}

bool read_numbers(Tokens words, std::span<const Range> ranges, Request& request) {
  for (const Range& range : ranges) {
    if (range.high == 0) break;
    const auto number = words.empty() ? std::nullopt : parse_in(words.front(), range);
    if (!number) return false;
    request.numbers.push_back(*number);
    words = words.subspan(1);
  }
  return words.empty();
}

bool read_multiplexer(Tokens words, Request& request) {
  if (words.size() < 2) return false;
  const auto index = parse_unsigned(words[0], UINT16_MAX);
  const auto sub = parse_unsigned(words[1], UINT8_MAX);
  if (!index || !sub) return false;
  request.index = static_cast<std::uint16_t>(*index);
  request.sub = static_cast<std::uint8_t>(*sub);
  return true;
}

bool read_type(Token word, Request& request) {
  const std::optional<ValueType> type = parse_type(word);
  if (type) request.type = *type;
  return type.has_value();
}

bool read_object(Tokens words, Request& request) {
  if (!read_multiplexer(words, request) || words.size() > 3) return false;
  return words.size() == 2 || read_type(words[2], request);
}

bool read_value(Tokens words, Request& request) {
  if (!read_multiplexer(words, request) || words.size() < 4) return false;
  if (!read_type(words[2], request)) return false;
  std::optional<Bytes> value = parse_value(request.type, words.subspan(3));
  if (!value) return false;
  request.value = *std::move(value);
  return true;
}

/// Takes a number directly after a name, or as the next word: `sync1`, `event 100`.
std::optional<std::uint64_t> take_number(Token& rest, Tokens& words, const Range& range) {
  if (rest.empty() && !words.empty()) {
    rest = words.front();
    words = words.subspan(1);
  }
  return parse_in(std::exchange(rest, {}), range);
}

/// `rtr`, `event`, `sync<n>`; extended: `event<inhibit> <event timer>`, `sync<n> <start value>`.
bool take_transmission_type(Tokens& words, bool extended, PdoSetup& pdo) {
  if (words.empty()) return false;
  Token word = words.front();
  words = words.subspan(1);
  if (matches("rtr", word)) {
    pdo.transmission_type = 253;
    return true;
  }
  constexpr std::size_t sync_length = 4;
  if (matches("sync", word.substr(0, sync_length))) {
    word.remove_prefix(sync_length);
    const auto type = take_number(word, words, {0, 240});
    const auto start = extended ? take_number(word, words, any_u8) : 0;
    pdo.transmission_type = static_cast<std::uint8_t>(type.value_or(0));
    pdo.sync_start = static_cast<std::uint8_t>(start.value_or(0));
    return type && start;
  }
  constexpr std::size_t event_length = 5;
  if (!matches("event", word.substr(0, event_length))) return false;
  word.remove_prefix(event_length);
  pdo.transmission_type = 255;
  if (!extended) return word.empty();
  // The object has the inhibit time in tenths of a millisecond, in 16 bits.
  const auto inhibit = take_number(word, words, {0, UINT16_MAX / 10});
  const auto event = take_number(word, words, any_u16);
  pdo.inhibit_ms = static_cast<std::uint16_t>(inhibit.value_or(0));
  pdo.event_ms = static_cast<std::uint16_t>(event.value_or(0));
  return inhibit && event;
}

/// Takes a type, with or without its object: the gateway has no objects of its own, and keeps the
/// values under the number of the PDO.
bool take_mapped(Tokens& words, PdoSetup& pdo) {
  Request object;
  if (read_multiplexer(words, object)) words = words.subspan(2);
  if (words.empty()) return false;
  const std::optional<ValueType> type = parse_type(words.front());
  words = words.subspan(1);
  if (!type || bit_length(type->type) == 0) return false;
  pdo.mapped.push_back(type->type);
  return true;
}

bool read_pdo(Tokens words, bool extended, Request& request) {
  if (words.size() < 2) return false;
  const auto number = parse_in(words[0], pdo_number);
  const auto cob_id = parse_unsigned(words[1], UINT32_MAX);
  if (!number || !cob_id) return false;
  request.numbers.push_back(*number);
  request.pdo.cob_id = static_cast<std::uint32_t>(*cob_id);
  words = words.subspan(2);
  if (!take_transmission_type(words, extended, request.pdo) || words.empty()) return false;
  const auto count = parse_unsigned(words.front(), 64);
  words = words.subspan(1);
  for (std::uint64_t i = 0; i < count.value_or(0); ++i) {
    if (!take_mapped(words, request.pdo)) return false;
  }
  return count && words.empty();
}

bool read_rpdo(Tokens words, Request& request) {
  return read_pdo(words, false, request);
}
bool read_tpdo(Tokens words, Request& request) {
  return read_pdo(words, false, request);
}
bool read_extended_tpdo(Tokens words, Request& request) {
  return read_pdo(words, true, request);
}

/// Reads the number of the PDO, the number of values, and the values.
bool read_pdo_values(Tokens words, Request& request) {
  if (words.size() < 2) return false;
  const auto number = parse_in(words[0], pdo_number);
  const auto count = parse_unsigned(words[1], 64);
  if (!number || !count || words.size() != 2 + *count) return false;
  request.numbers.push_back(*number);
  for (const Token word : words.subspan(2)) {
    const auto value = parse_unsigned(word);
    if (!value) return false;
    request.numbers.push_back(*value);
  }
  return true;
}

bool read_switch(Tokens words, Request& request) {
  if (words.size() != 1) return false;
  const bool enable = matches("enable", words[0]);
  request.numbers.push_back(enable ? 1 : 0);
  return enable || matches("disable", words[0]);
}

/// Reads the command specifier of CiA 305, or 0 to 3 as in CANopenNode, or nothing: all of them.
bool read_address_part(Tokens words, Request& request) {
  constexpr std::uint64_t inquire_vendor = 0x5A;
  if (words.empty()) return true;
  if (words.size() > 1) return false;
  auto part = parse_in(words[0], {inquire_vendor, inquire_vendor + 3});
  if (part) part = *part - inquire_vendor;
  if (!part) part = parse_in(words[0], {0, 3});
  request.numbers.push_back(part.value_or(0));
  return part.has_value();
}

/// Reads nothing, or a time-out in milliseconds, or (as in Lely) four pairs of number and mask.
bool read_scan(Tokens words, Request& request) {
  if (words.size() > 1 && words.size() != 8) return false;
  for (const Token word : words) {
    const auto number = parse_unsigned(word, UINT32_MAX);
    if (!number) return false;
    request.numbers.push_back(*number);
  }
  return words.size() != 1 || (request.numbers[0] > 0 && request.numbers[0] <= UINT16_MAX);
}

/// Takes `[7]` from the start of the line.
std::optional<std::uint32_t> take_sequence(std::string_view& line) {
  const std::size_t end = line.find(']');
  if (!line.starts_with('[') || end == std::string_view::npos) return std::nullopt;
  std::string_view digits = line.substr(1, end - 1);
  while (digits.starts_with(' ')) digits.remove_prefix(1);
  while (digits.ends_with(' ')) digits.remove_suffix(1);
  const auto number = parse_unsigned(digits, UINT32_MAX);
  if (!number) return std::nullopt;
  line.remove_prefix(end + 1);
  return static_cast<std::uint32_t>(*number);
}

/// Takes up to two numbers in front of the command from `words`.
std::optional<std::vector<std::uint32_t>> take_prefix(Tokens& words) {
  std::vector<std::uint32_t> numbers;
  while (!words.empty() && words.front().front() >= '0' && words.front().front() <= '9') {
    const auto number = parse_unsigned(words.front(), UINT32_MAX);
    if (!number || numbers.size() == 2) return std::nullopt;
    numbers.push_back(static_cast<std::uint32_t>(*number));
    words = words.subspan(1);
  }
  return numbers;
}

/// One number alone is the node of a command for nodes, and the network of a command for networks.
ErrorCode address(std::span<const std::uint32_t> numbers, Scope scope, Request& request) {
  const std::size_t most = static_cast<std::size_t>(scope);
  if (numbers.size() > most) return ErrorCode::syntax;
  if (numbers.empty()) return ErrorCode::none;
  if (scope == Scope::node) {
    request.node = numbers.back();
    numbers = numbers.first(numbers.size() - 1);
  }
  if (!numbers.empty()) request.net = numbers.front();
  if (request.net && (*request.net == 0 || *request.net > UINT16_MAX)) {
    return ErrorCode::unknown_net;
  }
  return request.node.value_or(0) > node_id_max ? ErrorCode::unknown_node : ErrorCode::none;
}

const CommandRow* find_command(Tokens words) {
  const auto* const found = std::ranges::find_if(commands, [words](const CommandRow& row) {
    if (words.empty() || !matches(row.first, words[0])) return false;
    return row.second.empty() || (words.size() > 1 && matches(row.second, words[1]));
  });
  return found == commands.end() ? nullptr : found;
}

ErrorCode read_command(Tokens words, Request& request) {
  const auto numbers = take_prefix(words);
  if (!numbers || words.empty()) return ErrorCode::syntax;
  const CommandRow* row = find_command(words);
  if (row == nullptr) return ErrorCode::not_supported;
  request.command = row->command;
  const ErrorCode wrong = address(*numbers, row->scope, request);
  if (wrong != ErrorCode::none) return wrong;
  words = words.subspan(row->second.empty() ? 1 : 2);
  const bool good = row->reader != nullptr ? row->reader(words, request)
                                           : read_numbers(words, row->numbers, request);
  return good ? ErrorCode::none : ErrorCode::syntax;
}

}  // namespace

Scope scope_of(Command command) {
  const auto* const found = std::ranges::find(commands, command, &CommandRow::command);
  return found == commands.end() ? Scope::gateway : found->scope;
}

Parsed parse_request(std::string_view line) {
  Parsed parsed;
  while (line.starts_with(' ') || line.starts_with('\t')) line.remove_prefix(1);
  if (line.empty() || line.front() == '#') return parsed;
  const std::optional<std::uint32_t> sequence = take_sequence(line);
  parsed.sequence = sequence.value_or(0);
  const auto words = sequence ? split(line) : std::nullopt;
  parsed.error = words ? read_command(*words, parsed.request) : ErrorCode::syntax;
  return parsed;
}

}  // namespace canvoy::gateway
