// A device that has all that a profile describes for one of its virtual devices, made from the
// profile's data at run time, without behaviour. A change of its rows makes a broken one.
//
//     PaperDevice device(cia419::profile, nullptr, [](PaperRows& rows) { rows.erase(0x6001); });
//     Check check(device.line(), device.node(), {.moves = true, .profile = &cia419::profile});
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/canopen/device/heap_tables.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/active_field.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"
#include "canvoy/text/check/profile_rule.hpp"
#include "canvoy/text/check/testing/node_on_line.hpp"

namespace canvoy::conformance {

/// The entries of a device by index.
using PaperRows = std::map<std::uint16_t, std::vector<EntryRow>>;

/// The row with this sub-index, which must exist.
inline EntryRow& row_at(PaperRows& rows, std::uint16_t index, std::uint8_t sub) {
  return *std::ranges::find_if(rows.at(index), [sub](const EntryRow& each) {
    return sub >= each.sub_first && sub <= each.sub_last;
  });
}

/// The bytes of a number of this entry.
inline std::vector<std::uint8_t> bytes_of(const EntryInfo& entry, std::int64_t number) {
  std::uint8_t all[8];
  store(all, static_cast<std::uint64_t>(number));
  return {all, all + byte_length(entry.type)};
}

/// The first field of the entry that has a reserved value with this number; null: none.
inline const FieldInfo* reserved_field(const EntryInfo& entry, std::int64_t number) {
  const auto bytes = bytes_of(entry, number);
  for (const FieldInfo& field : entry.fields) {
    if (!decoder::is_active(entry, field, bytes)) continue;
    const Reading reading = read_field(entry, field, bytes);
    const bool is_named = reading.named != nullptr;
    if ((is_named && reading.named->meaning == Meaning::reserved) || reading.out_of_range) {
      return &field;
    }
  }
  return nullptr;
}

/// A number that the names and limits allow; reserved ones are left out.
inline std::int64_t allowed_number(const ValueInfo& value, std::int64_t number, unsigned bits,
                                   bool has_sign) {
  const NamedValue* const named = find_name(value, number, bits, has_sign);
  const bool is_named = named != nullptr && named->meaning != Meaning::reserved;
  const bool is_limited = value.limits.kind == Limits::Kind::absolute;
  const bool is_within = !is_limited || (number >= value.limits.low && number <= value.limits.high);
  if (is_named || (named == nullptr && is_within)) return number;
  for (const NamedValue& each : value.names) {
    if (each.meaning != Meaning::reserved) return each.first;
  }
  return is_limited ? value.limits.low : number;
}

/// The number of an entry with nothing reserved in it, as near to `number` as is simple.
inline std::int64_t with_nothing_reserved(const EntryInfo& entry, std::int64_t number) {
  const unsigned bits = bit_length(entry.type);
  if (!is_integer(entry.type) || bits == 0) return number;
  if (entry.fields.empty()) return allowed_number(entry.value, number, bits, is_signed(entry.type));
  for (std::size_t i = 0; i < 2 * entry.fields.size(); ++i) {
    const FieldInfo* const field = reserved_field(entry, number);
    if (field == nullptr) break;
    const std::int64_t is = read_field(entry, *field, bytes_of(entry, number)).raw;
    const std::int64_t other = allowed_number(field->value, is, field->bits, field->is_signed);
    number = static_cast<std::int64_t>(
        insert(static_cast<std::uint64_t>(number), bits_of(*field), other));
  }
  return number;
}

class PaperDevice : public NodeOnLine {
 public:
  using Change = std::function<void(PaperRows&)>;

  /// `device` is null for a profile without virtual devices.
  PaperDevice(const Profile& profile, const VirtualDeviceInfo* device, const Change& change = {})
      : profile_(profile), device_(device) {
    for (const ObjectInfo* object : profile.objects) add(*object);
    for (const PdoInfo& pdo : profile.pdos) add(pdo);
    add_basics();
    if (change) change(rows_);
    for (const auto& [index, rows] : rows_) add_object(tables_, {.index = index}, rows);
    node_ = std::make_unique<HeapNode>(tables_.tables(), port(), NodeId{5});
    start(node_->node());
  }

  /// Rows of the device, as changed.
  const PaperRows& rows() const { return rows_; }

 private:
  static constexpr std::uint16_t application_first = 0x2000;

  void add(const ObjectInfo& object) {
    const DeviceObject* as = nullptr;
    if (object.index >= application_first && !profile_.virtual_devices.empty()) {
      as = device_ == nullptr ? nullptr : detail::find_device_object(*device_, object.index);
      const bool is_of_any =
          std::ranges::none_of(profile_.virtual_devices, [&object](const VirtualDeviceInfo& each) {
            return detail::find_device_object(each, object.index) != nullptr;
          });
      if (as == nullptr && !is_of_any) return;
    }
    add(detail::part_of(object, object.index, as != nullptr ? *as : DeviceObject{}, {}));
  }
  void add(const Part& part) {
    std::vector<EntryRow>& rows = rows_[part.index()];
    rows.clear();
    for (const EntryInfo& entry : part.object().entries()) {
      detail::Reason reason;
      EntryRow row = detail::row_of(part, entry, reason);
      if (!printed_default(entry)) row.initial = with_nothing_reserved(entry, row.initial);
      if (is_string(row.type) && row.capacity == 0) row.capacity = 64;
      rows.push_back(row);
    }
  }
  /// Of several alternatives of one number, the first that maps what the device has.
  void add(const PdoInfo& pdo) {
    const bool is_tpdo = pdo.direction == PdoInfo::Direction::transmit;
    const auto parameter = static_cast<std::uint16_t>(
        (is_tpdo ? object_index::tpdo_parameter : object_index::rpdo_parameter) + pdo.number - 1);
    const bool has_all = std::ranges::all_of(pdo.mapping, [this](std::uint32_t mapped) {
      const MappingValue value(mapped);
      return value.is_dummy() || rows_.contains(value.index);
    });
    if (pdo.number == 0 || !has_all || rows_.contains(parameter)) return;
    EntryRow cob_id = pdo_row(1, DataType::unsigned32, pdo.cob_id);
    if (pdo.plus_node_id) cob_id.traits = EntryTraits::plus_node_id;
    rows_[parameter] = {pdo_row(0, DataType::unsigned8, 5), cob_id,
                        pdo_row(2, DataType::unsigned8, pdo.transmission_type),
                        pdo_row(3, DataType::unsigned16, pdo.inhibit_time),
                        pdo_row(5, DataType::unsigned16, pdo.event_timer)};
    std::vector<EntryRow>& mapping = rows_[static_cast<std::uint16_t>(parameter + 0x200)];
    constexpr std::size_t source = 0xFE;
    const std::size_t count = pdo.multiplexed == MpdoKind::no       ? pdo.mapping.size()
                              : pdo.multiplexed == MpdoKind::source ? source
                                                                    : source + 1;
    mapping.push_back(pdo_row(0, DataType::unsigned8, static_cast<std::int64_t>(count)));
    for (const std::uint32_t mapped : pdo.mapping) {
      mapping.push_back(
          pdo_row(static_cast<std::uint8_t>(mapping.size()), DataType::unsigned32, mapped));
    }
  }
  static EntryRow pdo_row(std::uint8_t sub, DataType type, std::int64_t initial) {
    return {.sub_first = sub,
            .sub_last = sub,
            .type = type,
            .access = sub == 0 && initial == 5 ? Access::ro : Access::rw,
            .initial = initial};
  }

  void add_basics() {
    const auto basic = [this](const ObjectInfo& object) {
      if (!rows_.contains(object.index)) add(Part(object));
    };
    basic(cia301::device_type_object);
    basic(cia301::error_register_object);
    basic(cia301::producer_heartbeat_object);
    basic(cia301::identity_object);
    const bool is_known = profile_.device_type_of != nullptr && device_ != nullptr;
    EntryRow& type = row_at(rows_, object_index::device_type, 0);
    if (is_known) type.initial = profile_.device_type_of(*device_);
    if (!is_known && type.initial == 0) type.initial = profile_.number;
  }

  const Profile& profile_;
  const VirtualDeviceInfo* device_;
  PaperRows rows_;
  HeapTables tables_;
  std::unique_ptr<HeapNode> node_;
};

}  // namespace canvoy::conformance
