#include "canvoy/formats/sheet/sheet_configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "canvoy/canopen/dictionary/action_objects.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/cia417/physical.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::formats {

namespace {

constexpr std::uint16_t mapping_distance = 0x200;
constexpr unsigned mapped_max = 64;

bool is_between(std::uint16_t index, unsigned first, unsigned last) {
  return index >= first && index <= last;
}
bool is_pdo_parameter(std::uint16_t index) {
  return is_between(index, object_index::rpdo_parameter, object_index::rpdo_parameter_last) ||
         is_between(index, object_index::tpdo_parameter, object_index::tpdo_parameter_last);
}
bool is_sdo_channel(std::uint16_t index) {
  return is_between(index, object_index::sdo_server + 1, object_index::sdo_client_last);
}

/// True for what an RPDO may carry; an entry for TPDOs that SDO may write is `rwr`.
bool is_process_data(const SheetEntry& entry) {
  return entry.pdo_mapping && !same_letters(entry.access, "rwr");
}

using Bytes = std::vector<std::uint8_t>;
using Values = std::map<std::uint8_t, Bytes>;

std::uint64_t number_in(const Bytes& value) {
  return value.empty() ? 0 : load_unsigned(value);
}

class Maker {
 public:
  Maker(const DataSheet& sheet, NodeId node_id) : sheet_(sheet), node_id_(node_id) {
    made_.sheet_node = sheet.node_id();
    if (node_id_ == 0) node_id_ = made_.sheet_node;
  }

  Configuration make() {
    for (const auto& [index, object] : sheet_.objects) collect(index, object);
    const auto number =
        is_of_lift() ? values_.find(cia417::lift_number_object.index) : values_.end();
    if (number != values_.end()) write_object(number->first, number->second);
    for (const auto& [index, values] : values_) {
      if (number == values_.end() || index != number->first) write_object(index, values);
    }
    return std::move(made_);
  }

 private:
  /// Objects and PDOs of devices of CiA 417 depend on their lift: those of lift 3 do not exist
  /// before 6001h selects it.
  bool is_of_lift() const {
    const SheetEntry* type = sheet_.find(object_index::device_type, 0);
    if (type == nullptr) return false;
    const auto number = sheet_number(type->value.empty() ? type->default_value : type->value);
    return number && (number->number & 0xFFFF) == cia417::profile_number;
  }

  void collect(std::uint16_t index, const SheetObject& object) {
    if (is_action_or_state(index) || index == object_index::verify_configuration) return;
    if (object.is_variable()) return collect_entry(index, 0, object.own);
    for (const auto& [sub, entry] : object.subs) collect_entry(index, sub, entry);
  }

  void collect_entry(std::uint16_t index, std::uint8_t sub, const SheetEntry& entry) {
    if (entry.value.empty() || !is_writable(entry)) return;
    if (is_process_data(entry)) {
      ++made_.process_data;
      return;
    }
    const auto type = sheet_type(entry.data_type);
    if (type == DataType::domain) return;
    const auto bytes = type ? value_of(entry, *type) : std::nullopt;
    if (bytes) {
      values_[index][sub] = *bytes;
    } else {
      made_.bad.push_back({entry.line, place_text(index, sub),
                           fmt::format("ParameterValue is '{}'", entry.value),
                           type ? fmt::format("a value of {}", data_type_name(*type)) : "",
                           Finding::Weight::error});
    }
  }

  std::optional<Bytes> value_of(const SheetEntry& entry, DataType type) {
    const NodeId from = made_.sheet_node;
    const auto initial = sheet_number(entry.default_value);
    const bool goes_with_node = initial && initial->plus_node_id;
    if (goes_with_node && from != 0 && from != node_id_ &&
        sheet_bytes(type, entry.value, from) == sheet_bytes(type, entry.default_value, from)) {
      ++made_.moved;
      return sheet_bytes(type, entry.default_value, node_id_);
    }
    return sheet_bytes(type, entry.value, node_id_);
  }

  void write(std::uint16_t index, std::uint8_t sub, Bytes value) {
    made_.entries.push_back({index, sub, std::move(value)});
  }
  void write_all(std::uint16_t index, const Values& values,
                 const std::function<bool(std::uint8_t)>& is_wanted) {
    for (const auto& [sub, value] : values) {
      if (is_wanted(sub)) write(index, sub, value);
    }
  }
  /// Writes a COB-ID, with or without other bits.
  void write_cob_id(std::uint16_t index, std::uint8_t sub, const Bytes& value, std::uint32_t set,
                    std::uint32_t clear = 0) {
    const auto id = static_cast<std::uint32_t>(number_in(value));
    Bytes changed(sizeof id);
    store(changed.data(), (id | set) & ~clear);
    write(index, sub, std::move(changed));
  }

  void write_object(std::uint16_t index, const Values& values) {
    if (is_pdo_parameter(index)) return write_pdo(index, values);
    if (is_pdo_mapping(index)) {
      // Together with its communication parameters, which precede it.
      const bool is_alone = !values_.contains(static_cast<std::uint16_t>(index - mapping_distance));
      return is_alone ? write_mapping(index, values) : void();
    }
    if (is_sdo_channel(index)) return write_channel(index, values);
    switch (index) {
      case object_index::cob_id_sync:
        return write_sync(values);
      case object_index::sync_period:
      case object_index::sync_counter_overflow:
        if (values_.contains(object_index::cob_id_sync)) return;
        break;
      case object_index::cob_id_emergency:
        return write_while_invalid(index, values, 0);
      case object_index::heartbeat_consumers:
        return write_heartbeat_consumers(values);
      default:
        break;
    }
    write_all(index, values, [](std::uint8_t) { return true; });
  }

  /// Makes the COB-ID at `sub` invalid while it gets its value; a value that is itself invalid
  /// needs one write.
  void write_while_invalid(std::uint16_t index, const Values& values, std::uint8_t sub) {
    const auto found = values.find(sub);
    if (found == values.end()) return;
    write_cob_id(index, sub, found->second, CobId::bit31);
    const auto id = static_cast<std::uint32_t>(number_in(found->second));
    if ((id & CobId::bit31) == 0) write(index, sub, found->second);
  }

  /// Order: invalid, mapping, the other parameters, valid.
  void write_pdo(std::uint16_t index, const Values& values) {
    constexpr std::uint8_t cob_id_sub = 1;
    const auto cob_id = values.find(cob_id_sub);
    const bool has_cob_id = cob_id != values.end();
    if (has_cob_id) write_cob_id(index, cob_id_sub, cob_id->second, CobId::bit31);
    const auto mapping = values_.find(static_cast<std::uint16_t>(index + mapping_distance));
    if (mapping != values_.end()) write_mapping(mapping->first, mapping->second);
    write_all(index, values, [=](std::uint8_t sub) { return sub != cob_id_sub; });
    const bool is_valid =
        has_cob_id && (number_in(cob_id->second) & std::uint64_t{CobId::bit31}) == 0;
    if (is_valid) write(index, cob_id_sub, cob_id->second);
  }

  /// Order: no mapping, the mapped entries, their number.
  void write_mapping(std::uint16_t index, const Values& values) {
    const auto number = values.find(0);
    if (number == values.end()) return write_all(index, values, [](std::uint8_t) { return true; });
    const auto count = static_cast<unsigned>(number_in(number->second));
    // If no entry is writable, neither is their number, whatever the sheet says.
    if (count != 0 && values.size() == 1) return;
    write(index, 0, Bytes(number->second.size()));
    for (const auto& [sub, value] : values) {
      // A multiplexed PDO has its kind in place of a number.
      const bool counts = count > mapped_max ? number_in(value) != 0 : sub <= count;
      if (sub != 0 && counts) write(index, sub, value);
    }
    if (count != 0) write(index, 0, number->second);
  }

  void write_channel(std::uint16_t index, const Values& values) {
    constexpr std::uint8_t cob_ids[] = {1, 2};
    const auto write_cob_ids = [&](std::uint32_t set) {
      for (const std::uint8_t sub : cob_ids) {
        const auto found = values.find(sub);
        if (found != values.end()) write_cob_id(index, sub, found->second, set);
      }
    };
    write_cob_ids(CobId::bit31);
    write_all(index, values, [](std::uint8_t sub) { return sub > 2; });
    write_cob_ids(0);
  }

  /// SYNC is produced after all of it is set: 1019h changes while 1006h is zero.
  void write_sync(const Values& values) {
    const Bytes& cob_id = values.begin()->second;
    write_cob_id(object_index::cob_id_sync, 0, cob_id, 0, CobId::bit30);
    const auto counter = values_.find(object_index::sync_counter_overflow);
    const auto period = values_.find(object_index::sync_period);
    if (counter != values_.end() && period != values_.end())
      write(object_index::sync_period, 0, Bytes(4));
    if (counter != values_.end())
      write(object_index::sync_counter_overflow, 0, counter->second.begin()->second);
    if (period != values_.end())
      write(object_index::sync_period, 0, period->second.begin()->second);
    if ((number_in(cob_id) & std::uint64_t{CobId::bit30}) != 0)
      write(object_index::cob_id_sync, 0, cob_id);
  }

  /// Switches all off first: a node must not appear twice, not even temporarily.
  void write_heartbeat_consumers(const Values& values) {
    for (const auto& [sub, value] : values) {
      if (sub != 0) write(object_index::heartbeat_consumers, sub, Bytes(value.size()));
    }
    write_all(object_index::heartbeat_consumers, values,
              [&values](std::uint8_t sub) { return sub != 0 && number_in(values.at(sub)) != 0; });
  }

  const DataSheet& sheet_;
  NodeId node_id_;
  std::map<std::uint16_t, Values> values_;
  Configuration made_;
};

}  // namespace

Configuration configuration_of(const DataSheet& sheet, NodeId node_id) {
  return Maker(sheet, node_id).make();
}

std::vector<std::uint8_t> concise_dcf_of(const std::vector<ConfigurationEntry>& entries) {
  std::vector<std::uint8_t> bytes;
  const auto append = [&bytes](std::size_t number, unsigned length) {
    for (unsigned i = 0; i < length; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
    }
  };
  append(entries.size(), 4);
  for (const ConfigurationEntry& entry : entries) {
    append(entry.index, 2);
    append(entry.sub, 1);
    append(entry.value.size(), 4);
    bytes.insert(bytes.end(), entry.value.begin(), entry.value.end());
  }
  return bytes;
}

}  // namespace canvoy::formats
