#include "canvoy/text/signal_table_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/entry_signals.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

namespace {

using decoder::PdoPlan;
using formats::Signal;
using formats::SignalMessage;
using formats::SignalState;
using Direction = PdoInfo::Direction;

constexpr std::uint32_t can_id_last = 0x7FF;
/// After the first four bytes of an SDO message, or of a multiplexed PDO.
constexpr unsigned data_first_bit = 32;

/// The part of some signals that lies within this number of bits, moved up to where these begin.
std::vector<Signal> placed(std::vector<Signal> signals, unsigned first_bit, unsigned bits) {
  std::erase_if(signals, [bits](const Signal& signal) { return signal.first_bit >= bits; });
  for (Signal& signal : signals) {
    signal.bits = std::min(signal.bits, bits - signal.first_bit);
    signal.first_bit += first_bit;
  }
  return signals;
}

std::string entry_comment(unsigned index, unsigned sub, const ObjectInfo* object) {
  std::string text = object_text(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
  if (object != nullptr && !object->clause.empty())
    text += fmt::format(", clause {}", object->clause);
  return text;
}

void add_unique(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
}

std::string pdo_name(const PdoPlan& plan, std::uint32_t can_id) {
  if (!plan.name.empty()) return std::string(plan.name);
  if (plan.number == 0) return fmt::format("PDO {:03X}", can_id);
  return fmt::format("{}PDO{}", plan.direction == Direction::transmit ? 'T' : 'R', plan.number);
}

std::vector<SignalState> error_states(const Profile& profile) {
  std::vector<SignalState> states;
  std::set<std::uint16_t> known;
  const auto add = [&](const ErrorCodeInfo& error) {
    if (known.insert(error.code).second) states.push_back({error.code, std::string(error.text)});
  };
  for (const Profile* each = &profile; each != nullptr; each = each->base) {
    for (const ErrorCodeInfo& error : each->error_codes) add(error);
  }
  for (const ErrorCodeInfo& error : cia301::error_codes) add(error);
  std::ranges::sort(states, {}, &SignalState::number);
  return states;
}

/// The first bytes of an expedited SDO message with a value of this length, and its index and
/// sub-index (CiA 301, 7.2.4.3.3 and 7.2.4.3.5).
std::uint32_t transfer_selector(bool is_request, unsigned bytes, unsigned index, unsigned sub) {
  const unsigned command = (is_request ? 0x23U : 0x43U) | (4 - bytes) << 2;
  return command | index << 8 | sub << 24;
}

}  // namespace

/// A device to be described, from its profile and its sheet.
struct SignalTableMaker::Device {
  std::string name = {};
  NodeId node = 0;
  const formats::DataSheet* sheet = nullptr;
  const Profile* profile = nullptr;
  decoder::Network network = {};

  bool has(unsigned index) const {
    return sheet == nullptr || sheet->objects.contains(static_cast<std::uint16_t>(index));
  }
};

SignalMessage& SignalTableMaker::message_at(std::uint32_t can_id) {
  SignalMessage& message = messages_[can_id];
  message.can_id = can_id;
  return message;
}

std::vector<Signal> SignalTableMaker::signals_at(Device& device, unsigned index, unsigned sub) {
  const ObjectInfo* object = find_description(*device.profile, index);
  const EntryInfo* plain = object == nullptr ? nullptr : find_entry(*object, sub);
  if (plain == nullptr) return {};
  const EntryInfo* entry = device.network.as_told(device.node, *device.profile, plain, index, sub);
  const decoder::DecodedValue named = {.index = static_cast<std::uint16_t>(index),
                                       .sub = static_cast<std::uint8_t>(sub),
                                       .profile = device.profile,
                                       .object = object,
                                       .entry = plain};
  std::vector<Signal> signals = entry_signals(object_name_text(named), *entry);
  for (Signal& signal : signals) {
    signal.index = named.index;
    signal.sub = named.sub;
    const std::string of_entry = entry_comment(index, sub, object);
    signal.comment = signal.comment.empty() ? of_entry : of_entry + "; " + signal.comment;
  }
  return signals;
}

// PDOs

std::vector<Signal> SignalTableMaker::mapped_signals(Device& device, const PdoPlan& plan) {
  std::vector<Signal> signals;
  unsigned first_bit = 0;
  for (const std::uint32_t raw : plan.mapping) {
    const MappingValue mapped(raw);
    const unsigned at = first_bit;
    first_bit += mapped.bits;
    if (mapped.is_dummy() || mapped.bits == 0 || first_bit > pdo_bits_max) continue;
    std::vector<Signal> found =
        placed(signals_at(device, mapped.index, mapped.sub), at, mapped.bits);
    if (found.empty()) {
      const std::string name = object_text(mapped.index, mapped.sub);
      found.push_back({.index = mapped.index,
                       .sub = mapped.sub,
                       .name = name,
                       .first_bit = at,
                       .bits = mapped.bits});
    }
    std::ranges::move(found, std::back_inserter(signals));
  }
  return signals;
}

/// The node that sends or receives it, and one of the entries that PDOs may carry (CiA 301,
/// 7.2.2.5).
std::vector<Signal> SignalTableMaker::multiplexed_signals(Device& device, const PdoPlan& plan) {
  constexpr unsigned selector_first_bit = 8;
  constexpr unsigned selector_bits = 24;
  const bool is_source = plan.multiplexed == MpdoKind::source;
  std::vector<Signal> signals = {
      {.name = is_source ? "source node" : "destination node", .bits = 7},
      {.name = "object",
       .first_bit = selector_first_bit,
       .bits = selector_bits,
       .is_selector = device.sheet != nullptr}};
  if (device.sheet == nullptr) {
    signals.push_back({.name = "data", .first_bit = data_first_bit, .bits = 32});
    return signals;
  }
  for (const formats::DictionaryLine& line : dictionary_of(device)) {
    const bool fits =
        !line.fields.empty() && line.fields.back().first_bit + line.fields.back().bits <= 32;
    if (!line.may_be_mapped || !fits) continue;
    const std::uint32_t selector = line.index | std::uint32_t{line.sub} << 16;
    signals[1].states.push_back({selector, line.name});
    for (Signal& signal : placed(line.fields, data_first_bit, 32)) {
      signal.selected_by = selector;
      signals.push_back(std::move(signal));
    }
  }
  return signals;
}

void SignalTableMaker::add_pdo(Device& device, std::uint32_t can_id, const PdoPlan& plan) {
  const bool is_sent = plan.direction == Direction::transmit;
  const bool is_known = messages_.contains(can_id);
  SignalMessage& message = message_at(can_id);
  if (!is_known || (is_sent && message.senders.empty())) {
    unsigned bits = 0;
    for (const std::uint32_t mapped : plan.mapping) bits += MappingValue(mapped).bits;
    const bool is_multiplexed = plan.multiplexed != MpdoKind::no;
    message.length = is_multiplexed ? 8 : std::min(bits + 7, pdo_bits_max) / 8;
    message.name =
        device.name.empty() ? pdo_name(plan, can_id) : device.name + ' ' + pdo_name(plan, can_id);
    message.signals =
        is_multiplexed ? multiplexed_signals(device, plan) : mapped_signals(device, plan);
  }
  add_unique(is_sent ? message.senders : message.receivers, device.name);
}

/// Of the PDOs of a profile, a device has those with one of its objects.
void SignalTableMaker::add_pdos(Device& device) {
  for (std::uint32_t can_id = 1; can_id <= can_id_last; ++can_id) {
    const PdoPlan* plan = device.network.pdo(can_id);
    if (plan == nullptr || (plan->node != 0 && plan->node != device.node)) continue;
    const bool is_of_device = plan->multiplexed != MpdoKind::no ||
                              std::ranges::any_of(plan->mapping, [&](std::uint32_t mapped) {
                                return device.has(MappingValue(mapped).index);
                              });
    if (is_of_device) add_pdo(device, can_id, PdoPlan(*plan));
  }
}

// The dictionary

std::vector<formats::DictionaryLine> SignalTableMaker::dictionary_of(Device& device) {
  std::vector<formats::DictionaryLine> lines;
  const auto add = [&](std::uint16_t index, std::uint8_t sub, const formats::SheetEntry& entry) {
    const ObjectInfo* object = find_description(*device.profile, index);
    const std::optional<DataType> type = formats::sheet_type(entry.data_type);
    formats::DictionaryLine line = {.index = index,
                                    .sub = sub,
                                    .type = std::string(type ? formats::data_type_name(*type) : ""),
                                    .access = entry.access,
                                    .may_be_mapped = entry.pdo_mapping,
                                    .initial = formats::plain_text(entry.default_value),
                                    .value = formats::plain_text(entry.value)};
    const EntryInfo* plain = object == nullptr ? nullptr : find_entry(*object, sub);
    line.name = object_name_text(
        {.index = index, .sub = sub, .profile = device.profile, .object = object, .entry = plain});
    if (object != nullptr)
      line.clause = plain != nullptr && !plain->clause.empty() ? plain->clause : object->clause;
    line.fields = signals_at(device, index, sub);
    lines.push_back(std::move(line));
  };
  for (const auto& [index, object] : device.sheet->objects) {
    if (object.is_variable()) add(index, 0, object.own);
    for (const auto& [sub, entry] : object.subs) add(index, sub, entry);
  }
  return lines;
}

// Error control, emergencies, SDO

void SignalTableMaker::add_emergency(Device& device) {
  const formats::SheetEntry* entry = device.sheet->find(object_index::cob_id_emergency, 0);
  if (entry == nullptr) return;
  const auto said =
      formats::sheet_number(entry->value.empty() ? entry->default_value : entry->value);
  const CobId cob_id{said ? static_cast<std::uint32_t>(said->at(device.node))
                          : can_id::emergency + device.node};
  if (!cob_id.valid() || !cob_id.is_base_frame()) return;
  SignalMessage& message = message_at(cob_id.can_id());
  message.name = device.name + " EMCY";
  add_unique(message.senders, device.name);
  message.signals = {{.name = "error code", .bits = 16, .states = error_states(*device.profile)},
                     {.name = "error register", .first_bit = 16, .bits = 8},
                     {.name = "manufacturer", .first_bit = 24, .bits = 40}};
}

void SignalTableMaker::add_heartbeat(const Device& device) {
  SignalMessage& message = message_at(can_id::error_control + device.node);
  message.name = device.name + " heartbeat";
  message.length = 1;
  add_unique(message.senders, device.name);
  message.signals = {
      {.name = "NMT state",
       .bits = 7,
       .states = {{0, "boot-up"}, {4, "stopped"}, {5, "operational"}, {127, "pre-operational"}}},
      {.name = "toggle bit", .first_bit = 7, .comment = "of node guarding"}};
}

void SignalTableMaker::add_transfers(Device& device, bool is_request) {
  SignalMessage& message = message_at((is_request ? can_id::sdo_request : can_id::sdo_response) +
                                      std::uint32_t{device.node});
  message.name = device.name + (is_request ? " SDO request" : " SDO response");
  message.comment =
      is_request ? "values that are written, expedited" : "values that are read, expedited";
  add_unique(is_request ? message.receivers : message.senders, device.name);
  message.signals = {{.name = "SDO transfer",
                      .bits = data_first_bit,
                      .is_selector = true,
                      .comment = "command, index and sub-index"}};
  for (const formats::DictionaryLine& line : dictionary_of(device)) {
    const std::optional<DataType> type = formats::data_type_named(line.type);
    const unsigned bytes = type ? byte_length(*type) : 0;
    const bool is_possible =
        is_request ? line.access != "ro" && line.access != "const" : line.access != "wo";
    if (bytes == 0 || bytes > 4 || !is_possible) continue;
    const std::uint32_t selector = transfer_selector(is_request, bytes, line.index, line.sub);
    message.signals.front().states.push_back({selector, line.name});
    for (Signal& signal : placed(line.fields, data_first_bit, 32)) {
      signal.selected_by = selector;
      message.signals.push_back(std::move(signal));
    }
  }
}

void SignalTableMaker::add_sdo(Device& device) {
  for (const bool is_request : {true, false}) add_transfers(device, is_request);
}

/// Messages between a client and a server are like those on the default channel.
void SignalTableMaker::add_channel(const CarNode& client, const CarNode& server) {
  const auto add = [&](std::uint32_t can_id, std::uint32_t as, const char* what,
                       const CarNode& sender, const CarNode& receiver) {
    SignalMessage message = messages_.at(as);
    message.can_id = can_id;
    message.name = fmt::format("{} SDO {} {}", sender.name, what, receiver.id);
    message.senders = {sender.name};
    message.receivers = {receiver.name};
    messages_.try_emplace(can_id, std::move(message));
  };
  add(cia447::sdo_request(client.id, server.id), can_id::sdo_request + server.id, "asks", client,
      server);
  add(cia447::sdo_response(client.id, server.id), can_id::sdo_response + server.id, "tells", server,
      client);
}

/// Each pair of nodes of a car has its own CAN-IDs (CiA 447-4).
void SignalTableMaker::add_mesh() {
  for (const CarNode& client : car_nodes_) {
    for (const CarNode& server : car_nodes_) {
      if (client.id != server.id) add_channel(client, server);
    }
  }
  car_nodes_.clear();
}

void SignalTableMaker::add_device(const std::string& name, NodeId node,
                                  const formats::DataSheet& sheet) {
  const decoder::SheetProfile made(sheet);
  Device device = {.name = name, .node = node, .sheet = &sheet, .profile = &made.profile()};
  device.network.set_sheet(node, made.sheet());
  table_.nodes.push_back({.name = name,
                          .id = node,
                          .product = formats::plain_text(sheet.text("DeviceInfo", "ProductName")),
                          .profile = std::string(made.profile().name),
                          .dictionary = dictionary_of(device)});
  add_pdos(device);
  add_emergency(device);
  add_heartbeat(device);
  if (!with_sdo_) return;
  add_sdo(device);
  if (device.network.has_car() && node <= cia447::node_id_max) car_nodes_.push_back({name, node});
}

void SignalTableMaker::add_profile(const Profile& profile) {
  constexpr NodeId any_node = 1;
  Device device = {.node = any_node, .profile = &profile};
  device.network.set_profile(any_node, profile);
  for (std::uint32_t can_id = 1; can_id <= can_id_last; ++can_id) {
    const PdoPlan* plan = device.network.pdo(can_id);
    if (plan != nullptr && plan->node == 0) add_pdo(device, can_id, PdoPlan(*plan));
  }
}

formats::SignalTable SignalTableMaker::take() {
  add_mesh();
  for (auto& [can_id, message] : messages_) table_.messages.push_back(std::move(message));
  messages_.clear();
  return std::move(table_);
}

}  // namespace canvoy::text
