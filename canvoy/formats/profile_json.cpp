#include "canvoy/formats/profile_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/provisions_json.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats {

namespace {

// The order of the keys is for human readers.
using Json = nlohmann::ordered_json;

std::string range_text(const NamedValue& named, const BitRange& bits) {
  const std::string first = pattern_text(named.first, bits.bits);
  return named.first == named.last ? first : first + "-" + pattern_text(named.last, bits.bits);
}

void add_text(Json& line, const char* key, std::string_view text) {
  if (!text.empty()) line[key] = text;
}

Json default_json(const Default& initial, DataType type) {
  switch (initial.kind) {
    case Default::Kind::none:
      return nullptr;
    case Default::Kind::text:
      return initial.text;
    case Default::Kind::plus_node_id:
      return fmt::format("$NODEID+0x{:X}", initial.number);
    case Default::Kind::highest_sub:
      return initial.number == 0 ? Json(nullptr) : Json(initial.number);
    case Default::Kind::number:
      break;
  }
  if (is_real(type)) return real_value(initial.number, type);
  return number_of(static_cast<std::uint64_t>(initial.number), bit_length(type), is_signed(type));
}

Json range_json(const ValueInfo& value) {
  if (value.limits.kind == Limits::Kind::none) return nullptr;
  return {value.limits.low, value.limits.high};
}

/// True if some number within the limits has no name, so that the value is a number.
bool has_unnamed(const ValueInfo& value, const BitRange& bits) {
  std::int64_t unnamed = value.limits.high - value.limits.low + 1;
  for (const NamedValue& named : value.names) {
    const NumberRange range = range_of(named, bits);
    const std::int64_t low = std::max(range.low, value.limits.low);
    const std::int64_t high = std::min(range.high, value.limits.high);
    if (low <= high) unnamed -= high - low + 1;
  }
  return unnamed > 0;
}

bool is_code(const ValueInfo& value) {
  return value.counting == Counting::identifies || value.notation == Notation::hexadecimal ||
         value.notation == Notation::characters || value.notation == Notation::bit_mask;
}

/// True if a value is a count or a measurement, not a code nor a list of states alone.
bool is_quantity(const ValueInfo& value, const BitRange& bits) {
  if (value.unit != Unit::none || value.scale != Scale{} || !value.pieces.empty()) return true;
  if (is_code(value)) return false;
  if (value.counting == Counting::counts) return true;
  if (value.limits.kind != Limits::Kind::none) return has_unnamed(value, bits);
  const bool has_sentinel = std::ranges::any_of(value.names, [](const NamedValue& named) {
    return named.meaning == Meaning::invalid || named.meaning == Meaning::failure ||
           named.meaning == Meaning::not_implemented || named.meaning == Meaning::do_not_care;
  });
  const bool has_state = std::ranges::any_of(
      value.names, [](const NamedValue& named) { return named.meaning == Meaning::state; });
  return has_sentinel && !has_state;
}

/// A state that also has a number by a scale: it stands for that number.
bool is_in_piece(const NamedValue& named, const ValueInfo& value) {
  return named.meaning == Meaning::state &&
         std::ranges::any_of(value.pieces, [&named](const Piece& piece) {
           return named.first >= piece.first && named.last <= piece.last;
         });
}

std::string entry_place(unsigned index, unsigned sub) {
  return fmt::format("{:04X}:{:02X}", index, sub);
}

/// Widest SDO access of an object, without the number of its entries.
Access widest_access(const ObjectInfo& object, bool consumed) {
  Access all = Access::none;
  for (const EntryInfo& entry : object.entries()) {
    const bool is_count = entry.sub_first == 0 && !object.subs.empty();
    if (is_count) continue;
    const bool is_mirrored = consumed && entry.consumer_access != Access::none;
    all = all | (is_mirrored ? entry.consumer_access : entry.access);
  }
  return all;
}

class Writer {
 public:
  Writer(const Profile& profile, const std::function<void(const std::string&)>& write)
      : profile_(profile), write_(write) {}

  void write_all() const {
    write_profile();
    for (const ObjectInfo* object : profile_.objects) write_object(*object);
    for (const RecordTypeInfo& type : profile_.record_types) write_record_type(type);
    for (const VirtualDeviceInfo& device : profile_.virtual_devices) write_device(device);
    for_each_pdo(profile_, [this](const PdoInfo& pdo) { write_pdo(pdo); });
    for (const ErrorCodeInfo& error : profile_.error_codes) write_error(error);
    for (const ReadingInfo& reading : profile_.readings) write_reading(reading);
    write_provisions_json(profile_, write_);
  }

 private:
  Json line_of(const char* kind) const {
    return {{"kind", kind}, {"profile", short_name(profile_)}};
  }
  void end(const Json& line) const { write_(line.dump()); }

  /// The keys with the address of an entry.
  static void add_place(Json& line, const ObjectInfo& object, const EntryInfo& entry) {
    line["index"] = hex(object.index, 4);
    line["index_last"] = hex(object.index + object.count - 1U, 4);
    line["sub"] = hex(entry.sub_first, 2);
    line["sub_last"] = hex(entry.last_sub(), 2);
  }

  void write_profile() const {
    Json line = line_of("profile");
    line["number"] = profile_.number;
    line["title"] = profile_.title;
    if (profile_.base != nullptr) line["base"] = short_name(*profile_.base);
    line["blocks"] = profile_.block_count;
    line["block_pitch"] = hex(profile_.block_pitch, 4);
    end(line);
    for (const FieldInfo& field : profile_.device_type) {
      Json bits = line_of("device_type");
      add_field(bits, field_name(field), bits_of(field), field.value);
      add_text(bits, "when", condition_text(field));
      end(bits);
    }
  }

  void write_object(const ObjectInfo& object) const {
    for (const EntryInfo& entry : object.entries()) {
      write_entry(object, entry);
      write_values(object, entry);
    }
  }

  void write_entry(const ObjectInfo& object, const EntryInfo& entry) const {
    Json line = line_of("entry");
    add_place(line, object, entry);
    line["object"] = object_name(object);
    line["entry"] = entry_name(object, entry);
    line["code"] = object_code_name(object.code);
    line["type"] = data_type_name(entry.type);
    line["access"] = access_name(entry);
    if (entry.consumer_access != Access::none) {
      line["consumer_access"] = access_name(entry.consumer_access);
    }
    line["pdo"] = mapping_name(entry.mapping);
    line["default"] = default_json(entry.initial, entry.type);
    if (entry.consumer_initial) {
      line["consumer_default"] = default_json(entry.consumer_initial, entry.type);
    }
    line["range"] = range_json(entry.value);
    if (entry.value.limits.kind == Limits::Kind::minimum) line["range_is_minimum"] = true;
    if (object.once) line["once"] = true;
    if (entry.capacity != 0) line["capacity"] = entry.capacity;
    if (entry.capacity_is_printed) line["capacity_is_printed"] = true;
    line["category"] = category_name(object.category);
    add_text(line, "condition", object.condition);
    line["entry_category"] = category_name(entry.category);
    add_text(line, "entry_condition", entry.condition);
    line["clause"] = entry.clause.empty() ? object.clause : entry.clause;
    add_text(line, "errata", entry.errata.empty() ? object.errata : entry.errata);
    add_text(line, "description",
             entry.description.empty() ? object.description : entry.description);
    end(line);
  }

  void write_values(const ObjectInfo& object, const EntryInfo& entry) const {
    if (!entry.value.names.empty() && bit_length(entry.type) != 0) {
      Json line = line_of("field");
      add_place(line, object, entry);
      add_field(line, entry_name(object, entry), bits_of(entry), entry.value);
      end(line);
    }
    // If bits have meanings of their own, the whole is no number.
    const bool is_whole = entry.fields.empty() || entry.value.unit != Unit::none;
    if (is_whole) write_quantities(object, entry, "", entry.value, bits_of(entry));
    for (const FieldInfo& field : entry.fields) {
      Json line = line_of("field");
      add_place(line, object, entry);
      add_field(line, field_name(field), bits_of(field), field.value);
      add_text(line, "when", condition_text(field));
      add_text(line, "description", field.description);
      end(line);
      write_quantities(object, entry, field_name(field), field.value, bits_of(field));
    }
  }

  static void add_field(Json& line, std::string_view name, const BitRange& bits,
                        const ValueInfo& value) {
    line["field"] = name;
    line["lsb"] = bits.first;
    line["width"] = bits.bits;
    if (bits.is_signed) line["signed"] = true;
    line["values"] = Json::object();
    for (const NamedValue& named : value.names) {
      line["values"][range_text(named, bits)] = named.name;
    }
  }

  /// One line for each scale of a value.
  void write_quantities(const ObjectInfo& object, const EntryInfo& entry, std::string_view field,
                        const ValueInfo& value, const BitRange& bits) const {
    if (!is_quantity(value, bits)) return;
    if (value.pieces.empty()) {
      const NumberRange range = value.limits.kind == Limits::Kind::none
                                    ? NumberRules(value, bits).range()
                                    : NumberRange{value.limits.low, value.limits.high};
      return write_quantity(object, entry, field, value, bits,
                            {range.low, range.high, value.scale});
    }
    for (const Piece& piece : value.pieces) {
      write_quantity(object, entry, field, value, bits, piece);
    }
  }

  /// The entry that gives the unit, for the first and the last address of a line.
  static void add_unit_entry(Json& line, const ObjectInfo& object, const EntryInfo& entry,
                             const UnitEntry& teller) {
    if (teller.index == 0) return;
    const bool moves = teller.sub == 0;
    line["unit_entry"] = entry_place(teller.index, moves ? entry.sub_first : teller.sub);
    line["unit_entry_last"] =
        entry_place(teller.index + object.count - 1U, moves ? entry.last_sub() : teller.sub);
  }

  void write_quantity(const ObjectInfo& object, const EntryInfo& entry, std::string_view field,
                      const ValueInfo& value, const BitRange& bits, const Piece& piece) const {
    Json line = line_of("quantity");
    add_place(line, object, entry);
    line["field"] = field;
    add_text(line, "piece", piece.name);
    const auto denominator = static_cast<double>(piece.scale.denominator);
    line["factor"] = static_cast<double>(piece.scale.numerator) / denominator;
    line["offset"] = static_cast<double>(piece.scale.offset) / denominator;
    line["unit"] = symbol(value.unit);
    if (value.step.index != 0) line["step"] = entry_place(value.step.index, value.step.sub);
    add_unit_entry(line, object, entry, value.unit_entry);
    line["min_raw"] = piece.first;
    line["max_raw"] = piece.last;
    line["sentinels"] = Json::object();
    for (const NamedValue& named : value.names) {
      if (is_in_piece(named, value)) continue;
      line["sentinels"][range_text(named, bits)] =
          named.meaning == Meaning::state ? named.name : meaning_name(named.meaning);
    }
    end(line);
  }

  void write_record_type(const RecordTypeInfo& type) const {
    for (const EntryInfo& member : type.members) {
      Json line = line_of("type");
      line["index"] = hex(type.index, 4);
      line["name"] = type.name;
      line["sub"] = hex(member.sub_first, 2);
      line["entry"] = member.name;
      line["type"] = data_type_name(member.type);
      line["clause"] = type.clause;
      end(line);
    }
  }

  static std::string_view device_access(const DeviceObject& object, const ObjectInfo* described) {
    if (object.printed_access != Access::none) return access_name(object.printed_access);
    if (object.access != Access::none || described == nullptr) return access_name(object.access);
    if (described->entries().back().access_by_device) return "vd";
    return access_name(widest_access(*described, object.consumed));
  }

  void write_device(const VirtualDeviceInfo& device) const {
    for (const DeviceObject& object : device.objects) {
      Json line = line_of("device");
      line["code"] = hex(device.code, 2);
      line["device"] = device.name;
      line["class"] = device.device_class;
      line["subclass"] = device.subclass;
      line["index"] = hex(object.index, 4);
      line["index_last"] = hex(object.last == 0 ? object.index : object.last, 4);
      line["category"] = category_name(object.category);
      add_text(line, "condition", object.condition);
      const ObjectInfo* described = find_object(profile_, object.index);
      line["access"] = device_access(object, described);
      line["consumed"] = object.consumed;
      line["clause"] = device.clause;
      add_text(line, "errata", object.errata);
      end(line);
    }
    if (!device.objects.empty()) return;
    Json line = line_of("device");
    line["code"] = hex(device.code, 2);
    line["device"] = device.name;
    line["class"] = device.device_class;
    line["subclass"] = device.subclass;
    line["clause"] = device.clause;
    end(line);
  }

  void write_pdo(const PdoInfo& pdo) const {
    Json line = line_of("pdo");
    line["direction"] = pdo.direction == PdoInfo::Direction::transmit ? "tpdo" : "rpdo";
    line["number"] = pdo.number;
    line["number_last"] = pdo.last_number == 0 ? pdo.number : pdo.last_number;
    line["cob_id"] = cob_id_text(pdo);
    line["mapping"] = Json::array();
    for (const std::uint32_t mapped : pdo.mapping) line["mapping"].push_back(hex(mapped, 8));
    if (pdo.multiplexed != MpdoKind::no) {
      line["multiplexed"] = pdo.multiplexed == MpdoKind::source ? "source" : "destination";
    }
    line["transmission_type"] = pdo.transmission_type;
    line["inhibit_time"] = pdo.inhibit_time;
    line["event_timer"] = pdo.event_timer;
    add_text(line, "name", pdo.name);
    if (!pdo.devices.empty()) {
      line["devices"] = Json::array();
      for (const std::uint8_t code : pdo.devices) line["devices"].push_back(hex(code, 2));
    }
    add_text(line, "condition", pdo.condition);
    add_text(line, "clause", pdo.clause);
    add_text(line, "errata", pdo.errata);
    end(line);
  }

  /// `$NODEID+0x180` as in EDS files, or hexadecimal digits.
  static std::string cob_id_text(const PdoInfo& pdo) {
    return pdo.plus_node_id ? fmt::format("$NODEID+0x{:X}", pdo.cob_id) : hex(pdo.cob_id, 3);
  }

  void write_error(const ErrorCodeInfo& error) const {
    Json line = line_of("emcy");
    line["code"] = hex(error.code, 4);
    line["meaning"] = error.text;
    add_text(line, "clause", error.clause);
    add_text(line, "description", error.description);
    end(line);
  }

  void write_reading(const ReadingInfo& reading) const {
    Json line = line_of("reading");
    line["name"] = reading.name;
    line["description"] = reading.description;
    line["errata"] = reading.errata;
    line["objects"] = Json::array();
    for (const ObjectInfo* object : reading.objects) {
      line["objects"].push_back(hex(object->index, 4));
    }
    end(line);
  }

  const Profile& profile_;
  const std::function<void(const std::string&)>& write_;
};

}  // namespace

void write_profile_json(const Profile& profile,
                        const std::function<void(const std::string& line)>& write) {
  Writer(profile, write).write_all();
}

}  // namespace canvoy::formats
