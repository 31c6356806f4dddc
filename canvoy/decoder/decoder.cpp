#include "canvoy/decoder/decoder.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/active_field.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

constexpr unsigned mpdo_data_bits = 32;

Marks marks_of(const Reading& reading) {
  Marks marks;
  if (reading.kind == Reading::Kind::none) marks.add(Mark::wrong_length);
  if (reading.out_of_range) marks.add(Mark::out_of_range);
  if (reading.named != nullptr && reading.named->meaning == Meaning::reserved) {
    marks.add(Mark::reserved);
  }
  return marks;
}

Marks marks_of(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  const Reading whole = read_value(entry, bytes);
  if (entry.fields.empty() || whole.kind == Reading::Kind::none) return marks_of(whole);
  Marks marks;
  if (whole.out_of_range) marks.add(Mark::out_of_range);
  for (const FieldInfo& field : entry.fields) {
    if (is_active(entry, field, bytes)) marks.add(marks_of(read_field(entry, field, bytes)));
  }
  return marks;
}

bool may_write(const EntryInfo& entry) {
  return entry.access_by_device || allows(entry.access, Access::sdo_write) ||
         allows(entry.consumer_access, Access::sdo_write);
}

bool may_read(const EntryInfo& entry) {
  return entry.access_by_device || allows(entry.access, Access::sdo_read) ||
         allows(entry.consumer_access, Access::sdo_read);
}

constexpr std::uint64_t bit_mask(unsigned bits) {
  return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

void set_bytes(DecodedValue& value, std::uint64_t raw, unsigned bits) {
  store(value.mapped.data(), raw);
  value.size = static_cast<std::uint8_t>((bits + 7) / 8);
}

/// A received PDO writes its entries, and a sent one reads them; a sheet may allow only one of
/// these, or what SDO may not do.
bool may_map(const EntryInfo& entry, PdoInfo::Direction direction) {
  if (entry.mapping == Mapping::no) return false;
  const bool is_tpdo = direction == PdoInfo::Direction::transmit;
  if (allows(entry.access, is_tpdo ? Access::tpdo : Access::rpdo)) return true;
  if (allows(entry.access, is_tpdo ? Access::rpdo : Access::tpdo)) return false;
  return is_tpdo ? may_read(entry) : may_write(entry);
}

void set_value(DecodedValue& value, std::uint64_t raw, unsigned bits,
               PdoInfo::Direction direction) {
  set_bytes(value, raw, bits);
  value.marks = {};
  if (value.entry == nullptr) return;
  value.marks = marks_of(*value.entry, value.bytes());
  if (!may_map(*value.entry, direction)) value.marks.add(Mark::wrong_access);
}

/// Sender of a boot-up message; 0: another message (CiA 301, 7.2.8.3.3).
NodeId booting_node(const Frame& frame) {
  const std::uint32_t node = frame.id - can_id::error_control;
  const bool boots = frame.id > can_id::error_control && is_node_id(node) && frame.length == 1 &&
                     frame.data[0] == 0;
  return boots ? static_cast<NodeId>(node) : NodeId{0};
}

}  // namespace

const Decoded& Decoder::decode(const Frame& frame) {
  decoded_ = {};
  if (!frame.is_plain()) return decoded_;
  if (const std::optional<SdoRoute> route = network_.sdo(frame.id)) {
    decode_sdo(frame, *route);
  } else if (const PdoPlan* plan = network_.pdo(frame.id)) {
    decode_pdo(frame, *plan);
  } else if (frame.id == can_id::lss_request || frame.id == can_id::lss_response) {
    decode_lss(frame);
  } else if (const NodeId node = booting_node(frame); node != 0) {
    end_transfers_with(node);
  }
  return decoded_;
}

DecodedValue Decoder::described(const Profile& profile, sdo::Multiplexer place) {
  const Described& known = entries_.at(profile, place, [&] {
    const ObjectInfo* object = find_description(profile, place.index());
    return Described{object, object == nullptr ? nullptr : find_entry(*object, place.sub())};
  });
  return {.index = place.index(),
          .sub = place.sub(),
          .profile = &profile,
          .object = known.object,
          .entry = known.entry};
}

/// Value of an object of `node`; 0: the node is unknown.
DecodedValue Decoder::value_at(NodeId node, const Profile& profile, sdo::Multiplexer place) {
  DecodedValue value = described(profile, place);
  if (value.object == nullptr) return value;
  const EntryInfo* told = network_.as_told(node, profile, value.entry, place.index(), place.sub());
  value.is_told = told != value.entry;
  value.entry = told;
  return value;
}

void Decoder::add_value(DecodedValue value) {
  if (value.entry != nullptr) value.marks.add(marks_of(*value.entry, value.bytes()));
  decoded_.marks.add(value.marks);
  values_.assign(1, value);
  decoded_.values = values_;
}

void Decoder::decode_lss(const Frame& frame) {
  if (frame.length != lss::length) return decoded_.marks.add(Mark::wrong_length);
  network_.clear_news();
  decoded_.device = lss_.take(frame);
  if (decoded_.device == nullptr) return;
  network_.learn_identity(decoded_.device->node, decoded_.device->identity);
  decoded_.news = network_.news();
}

// SDO

/// A restarted client does not end its transfers: the server does not notice the restart.
void Decoder::end_transfers_with(NodeId server) {
  for (auto& [can_id, channel] : channels_) {
    const std::optional<SdoRoute> route = network_.sdo(can_id);
    if (route && route->server == server) channel.server_starts();
  }
}

void Decoder::decode_sdo(const Frame& frame, const SdoRoute& route) {
  decoded_.service =
      route.is_request ? Decoded::Service::sdo_request : Decoded::Service::sdo_response;
  decoded_.node = route.server;
  decoded_.client = route.client;
  decoded_.channel = route.channel;
  if (frame.length != Frame::length_max) return decoded_.marks.add(Mark::wrong_length);
  SdoFollower& channel = channels_[route.channel];
  const SdoStep step = route.is_request ? channel.request(frame) : channel.response(frame);
  decoded_.message = step.message;
  decoded_.behind = step.behind;
  decoded_.transfer = step.done;
  decoded_.marks.add(step.marks);
  if (step.entry) describe(*step.entry, step.behind, route.server);
  if (step.done != nullptr) decode_transfer(*step.done, route.server);
  if (step.message == SdoMessage::write && step.behind.node == 0) {
    check_length(sdo::Message(frame), route.server);
  }
}

/// A device behind the server is unknown.
void Decoder::describe(sdo::Multiplexer entry, const SdoBehind& behind, NodeId server) {
  const Profile& profile = behind.node == 0 ? network_.profile(server) : cia301::profile;
  about_ = described(profile, entry);
  decoded_.about = &about_;
}

/// A written value has the length of its type, whether the node accepts it or not; a message
/// without a size (s is 0) cannot be judged (CiA 301, 7.2.4.3).
void Decoder::check_length(const sdo::Message& message, NodeId server) {
  if (!message.is_expedited() || !message.has_size()) return;
  const DecodedValue value = value_at(server, network_.profile(server), message.multiplexer());
  const std::size_t length = value.entry == nullptr ? 0 : byte_length(value.entry->type);
  if (length != 0 && length != message.expedited_size()) decoded_.marks.add(Mark::wrong_length);
}

void Decoder::decode_transfer(const SdoTransfer& transfer, NodeId server) {
  network_.clear_news();
  network_.learn(server, transfer.index, transfer.sub, transfer.bytes);
  decoded_.news = network_.news();
  DecodedValue value = value_at(server, network_.profile(server), {transfer.index, transfer.sub});
  value.transferred = transfer.bytes;
  const bool may = value.entry == nullptr ||
                   (transfer.is_write ? may_write(*value.entry) : may_read(*value.entry));
  if (!may) value.marks.add(Mark::wrong_access);
  add_value(value);
}

// PDO

void Decoder::decode_pdo(const Frame& frame, const PdoPlan& plan) {
  decoded_.service = Decoded::Service::pdo;
  decoded_.node = plan.node;
  decoded_.pdo = &plan;
  if (plan.multiplexed == MpdoKind::no) {
    decode_mapped(frame, plan);
  } else {
    decode_multiplexed(frame, plan);
  }
}

void Decoder::make_image(Image& image, const PdoPlan& plan) {
  image.slots.clear();
  image.values.clear();
  image.bits = 0;
  image.is_heard = false;
  // The sender of a PDO gives the unit for its receivers.
  const NodeId teller = plan.direction == PdoInfo::Direction::transmit ? plan.node : NodeId{0};
  for (const std::uint32_t raw : plan.mapping) {
    const MappingValue mapped(raw);
    const bool is_value = !mapped.is_dummy() && mapped.bits != 0;
    image.slots.push_back({.first = image.bits,
                           .end = image.bits + mapped.bits,
                           .mask = bit_mask(mapped.bits),
                           .is_value = is_value});
    image.bits += mapped.bits;
    if (!is_value) continue;
    image.values.push_back(value_at(teller, *plan.profile, {mapped.index, mapped.sub}));
  }
}

void Decoder::decode_mapped(const Frame& frame, const PdoPlan& plan) {
  Image& image = images_.at(frame.id);
  if (image.generation != network_.generation()) {
    make_image(image, plan);
    image.generation = network_.generation();
  }
  const auto whole = load<std::uint64_t>(frame.data.data());
  if (image.is_heard && image.whole == whole && image.length == frame.length) {
    decoded_.is_same = true;
    decoded_.values = std::span(image.values).first(image.count);
    decoded_.marks = image.marks;
    return;
  }
  const unsigned bits = frame.length * 8U;
  std::size_t count = 0;
  for (Slot& slot : image.slots) {
    if (slot.end > bits) break;
    if (!slot.is_value) continue;
    DecodedValue& value = image.values[count++];
    const std::uint64_t raw = whole >> slot.first & slot.mask;
    if (raw != slot.raw || !slot.is_heard) {
      slot.raw = raw;
      slot.is_heard = true;
      set_value(value, raw, slot.end - slot.first, plan.direction);
      value.version = ++versions_;
    }
    decoded_.marks.add(value.marks);
  }
  decoded_.values = std::span(image.values).first(count);
  if (image.bits > bits || (image.bits + 7) / 8 < frame.length) {
    decoded_.marks.add(Mark::wrong_length);
  }
  image.is_heard = true;
  image.whole = whole;
  image.length = frame.length;
  image.count = count;
  image.marks = decoded_.marks;
}

/// In source addressing the node is the sender; in destination addressing it is the node that takes
/// the value, or all (CiA 301, 7.2.2.5).
void Decoder::decode_multiplexed(const Frame& frame, const PdoPlan& plan) {
  if (frame.length != Frame::length_max) return decoded_.marks.add(Mark::wrong_length);
  const auto address = static_cast<NodeId>(frame.data[0] & 0x7FU);
  const Profile& profile = address == 0 ? *plan.profile : network_.profile(address);
  DecodedValue value = value_at(address, profile, sdo::Message(frame).multiplexer());
  const unsigned length = value.entry == nullptr ? 0 : bit_length(value.entry->type);
  const bool is_known = length != 0 && length <= mpdo_data_bits;
  const unsigned bits = is_known ? length : mpdo_data_bits;
  const std::uint64_t raw = load<std::uint64_t>(frame.data.data()) >> mpdo_data_bits;
  set_bytes(value, raw & bit_mask(bits), bits);
  add_value(value);
}

}  // namespace canvoy::decoder
