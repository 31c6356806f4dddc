#include "canvoy/decoder/decoder.hpp"

#include <algorithm>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/decoder/active_field.hpp"
#include "canvoy/profiles/mapping_value.hpp"
#include "canvoy/profiles/physical.hpp"
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
  for (const FieldInfo& field : entry.fields) {
    if (is_active(entry, field, bytes)) marks.add(marks_of(read_field(entry, field, bytes)));
  }
  return marks;
}

DecodedValue value_at(const Profile& profile, unsigned index, unsigned sub) {
  DecodedValue value = {.index = static_cast<std::uint16_t>(index),
                        .sub = static_cast<std::uint8_t>(sub),
                        .profile = &profile};
  value.object = find_description(profile, index);
  if (value.object != nullptr) value.entry = find_entry(*value.object, sub);
  return value;
}

bool may_write(Access access) {
  return (static_cast<unsigned>(access) & static_cast<unsigned>(Access::sdo_write)) != 0;
}
bool is_writable(const EntryInfo& entry) {
  return entry.access_by_device || may_write(entry.access) || may_write(entry.consumer_access);
}

/// `count` bits from `first` on, as the bytes that they fill.
void copy_bits(const Frame& frame, unsigned first, unsigned count, DecodedValue& value) {
  const auto whole = load<std::uint64_t>(frame.data.data()) >> first;
  const std::uint64_t mask = count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  store(value.mapped.data(), whole & mask);
  value.size = static_cast<std::uint8_t>((count + 7) / 8);
}

}  // namespace

std::string_view mark_name(Mark mark) {
  switch (mark) {
    case Mark::reserved:
      return "reserved";
    case Mark::out_of_range:
      return "out of range";
    case Mark::wrong_length:
      return "wrong length";
    case Mark::wrong_access:
      break;
  }
  return "wrong access";
}

const Decoded& Decoder::decode(const Frame& frame) {
  decoded_ = {};
  values_.clear();
  if (!frame.is_plain()) return decoded_;
  if (const std::optional<SdoRoute> route = network_.sdo(frame.id)) {
    decode_sdo(frame, *route);
  } else if (const PdoPlan* plan = network_.pdo(frame.id)) {
    decode_pdo(frame, *plan);
  }
  decoded_.values = values_;
  return decoded_;
}

void Decoder::add_value(DecodedValue value) {
  if (value.entry != nullptr) value.marks.add(marks_of(*value.entry, value.bytes()));
  decoded_.marks.add(value.marks);
  values_.push_back(value);
}

// SDO

void Decoder::decode_sdo(const Frame& frame, const SdoRoute& route) {
  decoded_.service =
      route.is_request ? Decoded::Service::sdo_request : Decoded::Service::sdo_response;
  decoded_.node = route.server;
  decoded_.client = route.client;
  decoded_.channel = route.channel;
  if (frame.length != Frame::length_max) return decoded_.marks.add(Mark::wrong_length);
  SdoFollower& channel = channels_[route.channel];
  const SdoTransfer* done = route.is_request ? channel.request(frame) : channel.response(frame);
  if (done == nullptr) return;
  decoded_.transfer = done;
  network_.learn(route.server, done->index, done->sub, done->bytes);
  DecodedValue value = value_at(network_.profile(route.server), done->index, done->sub);
  value.transferred = done->bytes;
  const bool is_known = value.entry != nullptr && done->is_write;
  if (is_known && !is_writable(*value.entry)) value.marks.add(Mark::wrong_access);
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

void Decoder::decode_mapped(const Frame& frame, const PdoPlan& plan) {
  unsigned position = 0;
  const unsigned bits = frame.length * 8U;
  for (const std::uint32_t raw : plan.mapping) {
    const MappingValue mapped(raw);
    const unsigned first = position;
    position += mapped.bits;
    if (position > bits) return decoded_.marks.add(Mark::wrong_length);
    if (mapped.is_dummy() || mapped.bits == 0) continue;
    DecodedValue value = value_at(*plan.profile, mapped.index, mapped.sub);
    copy_bits(frame, first, mapped.bits, value);
    if (value.entry != nullptr && value.entry->mapping == Mapping::no) {
      value.marks.add(Mark::wrong_access);
    }
    add_value(value);
  }
  if ((position + 7) / 8 < frame.length) decoded_.marks.add(Mark::wrong_length);
}

/// A source is the node that sends; a destination names the node that is to take the value, or all
/// (CiA 301, 7.2.2.5).
void Decoder::decode_multiplexed(const Frame& frame, const PdoPlan& plan) {
  if (frame.length != Frame::length_max) return decoded_.marks.add(Mark::wrong_length);
  const auto address = static_cast<NodeId>(frame.data[0] & 0x7FU);
  const Profile& profile = address == 0 ? *plan.profile : network_.profile(address);
  const unsigned index = frame.data[1] | unsigned{frame.data[2]} << 8;
  DecodedValue value = value_at(profile, index, frame.data[3]);
  const unsigned length = value.entry == nullptr ? 0 : bit_length(value.entry->type);
  const bool is_known = length != 0 && length <= mpdo_data_bits;
  copy_bits(frame, mpdo_data_bits, is_known ? length : mpdo_data_bits, value);
  add_value(value);
}

}  // namespace canvoy::decoder
