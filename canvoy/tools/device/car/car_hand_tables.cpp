#include "canvoy/tools/device/car/car_hand_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "canvoy/tools/device/hand/hand_rows.hpp"

namespace canvoy::tools {

namespace hand_rows {

namespace {

/// True if the first of two states means absence.
bool is_nothing(std::string_view first) {
  constexpr std::string_view signs[] = {"no", "not", "off", "disabled", "disengaged"};
  const std::string word = "-" + hand_word(first) + "-";
  return std::ranges::any_of(signs, [&word](std::string_view sign) {
    return word.find(fmt::format("-{}-", sign)) != std::string::npos;
  });
}

}  // namespace

std::vector<HandWord> words_of(const cia447::FieldPlace& place) {
  std::vector<HandWord> words;
  const ValueInfo* const value = cia447::find_value_info(place);
  if (value == nullptr) return words;
  std::string_view first;
  std::size_t states = 0;
  const auto add = [&words](std::string word, std::int64_t code, Meaning meaning) {
    const bool is_new = std::ranges::find(words, word, &HandWord::word) == words.end();
    if (is_new) words.push_back({std::move(word), static_cast<std::uint32_t>(code), meaning});
  };
  for (const NamedValue& named : value->names) {
    if (named.meaning == Meaning::state) {
      if (++states == 1) first = named.name;
      add(hand_word(named.name), named.first, Meaning::state);
    } else if (named.meaning == Meaning::failure) {
      add("failure", named.first, Meaning::failure);
    } else if (named.meaning == Meaning::invalid) {
      add("not-available", named.first, Meaning::invalid);
    }
  }
  // Marked like words that are not listed.
  if (states == 2 && is_nothing(first)) {
    for (const char* word : {"no", "off"}) add(word, 0, Meaning::do_not_care);
    for (const char* word : {"yes", "on"}) add(word, 1, Meaning::do_not_care);
  }
  return words;
}

}  // namespace hand_rows

namespace {

using cia447::FieldPlace;

const EntryInfo* entry_at(const FieldPlace& place) {
  const ObjectInfo* const object = find_object(cia447::profile, place.index);
  return object == nullptr ? nullptr : find_entry(*object, place.sub);
}

const FieldInfo* field_at(const FieldPlace& place) {
  const EntryInfo* const entry = entry_at(place);
  if (entry == nullptr) return nullptr;
  for (const FieldInfo& field : entry->fields) {
    if (field.first_bit == place.first_bit && field.bits == place.bits) return &field;
  }
  return nullptr;
}

bool covers(const FieldPlace& place, const FieldPlace& status) {
  if (place.index != status.index || place.sub != status.sub) return false;
  return place.bits == 0 || place == status;
}
bool covers(const WithoutHand& without, const FieldPlace& status) {
  return without.index == status.index &&
         (without.sub == WithoutHand::all || without.sub == status.sub) &&
         (without.first_bit == WithoutHand::all || without.first_bit == status.first_bit);
}

std::string without_status(std::string word) {
  const std::size_t at = word.find("-status");
  if (at != std::string::npos) word.erase(at, std::string_view("-status").size());
  return word;
}

/// The part that distinguishes several entries of one shape: `Door status driver`.
std::string object_word(const FieldPlace& place) {
  const ObjectInfo& object = *find_object(cia447::profile, place.index);
  return without_status(hand_word(name_of(object, *entry_at(place))));
}

/// The word of the field; for an abbreviation, which has no blank, its meaning.
std::string field_word(const FieldPlace& place) {
  const EntryInfo& entry = *entry_at(place);
  const FieldInfo* const field = field_at(place);
  if (field == nullptr || only_field(entry) != nullptr) return object_word(place);
  const bool is_short = field->name.find(' ') == std::string_view::npos;
  const bool has_words = is_short && !field->description.empty();
  std::string word = hand_word(has_words ? field->description : field->name);
  return field->number == 0 ? word : fmt::format("{}-{}", word, field->number);
}

/// The hand for a status of the table of the unit.
DeviceHand status_hand(const CarHandTable& table, const FieldPlace& place) {
  DeviceHand hand = hand_rows::row(table.name != nullptr ? table.name(place) : field_word(place),
                                   HandForm::word, {place});
  hand.words = hand_rows::words_of(place);
  const auto is_it = [&place](const FieldPlace& other) { return covers(other, place); };
  if (std::ranges::any_of(table.sensed_only, is_it)) {
    std::erase_if(hand.words, [](const HandWord& word) {
      return word.meaning != Meaning::failure && word.meaning != Meaning::invalid;
    });
    hand.words.push_back({"working", 0, Meaning::padding});
  } else if (const ValueInfo* const value = cia447::find_value_info(place);
             value != nullptr && value->limits.kind == Limits::Kind::absolute) {
    hand.form = HandForm::number;
    hand.least = static_cast<double>(value->limits.low);
    hand.most = static_cast<double>(value->limits.high);
  }
  hand.act = [tell = table.tell, place](const HandTarget& target, const HandValue& value) {
    tell(target, place, value);
    return true;
  };
  return hand;
}

void add_statuses(const cia447::CarUnit& unit, const CarHandTable& table,
                  std::vector<DeviceHand>& hands) {
  std::vector<FieldPlace> places;
  each_car_status(unit, [&](const FieldPlace& place) {
    const bool is_row = std::ranges::any_of(table.rows, [&place](const DeviceHand& row) {
      return std::ranges::any_of(row.changes,
                                 [&place](const FieldPlace& own) { return covers(own, place); });
    });
    const bool has_none = std::ranges::any_of(
        table.without, [&place](const WithoutHand& one) { return covers(one, place); });
    if (!is_row && !has_none) places.push_back(place);
  });
  std::map<std::string, unsigned> counts;
  for (const FieldPlace& place : places) ++counts[status_hand(table, place).name];
  for (const FieldPlace& place : places) {
    DeviceHand hand = status_hand(table, place);
    if (counts[hand.name] > 1) hand.name = object_word(place) + "-" + hand.name;
    hands.push_back(std::move(hand));
  }
}

const std::vector<CarHandTable>& all_tables() {
  static const std::vector<CarHandTable> tables = [] {
    std::vector<CarHandTable> all;
    all.push_back(gateway_hands());
    for (CarHandTable& table : taxi_hands()) all.push_back(std::move(table));
    for (CarHandTable& table : add_on_hands()) all.push_back(std::move(table));
    return all;
  }();
  return tables;
}

const CarHandTable* table_of(const cia447::CarUnit& unit) {
  const auto found = std::ranges::find(all_tables(), unit.info.name, &CarHandTable::device);
  return found == all_tables().end() ? nullptr : &*found;
}

}  // namespace

void each_car_status(const cia447::CarUnit& unit,
                     const std::function<void(const FieldPlace&)>& each) {
  for (const DeviceObject& provided : unit.provides->objects) {
    const ObjectInfo* const object = find_object(cia447::profile, provided.index);
    if (object == nullptr) continue;
    for (const EntryInfo& entry : object->entries()) {
      const bool is_status = entry.access == Access::ro && entry.consumer_access == Access::rw;
      if (!is_status) continue;
      if (entry.fields.empty()) {
        const unsigned bits = bit_length(entry.type);
        each({object->index, entry.sub_first, 0, static_cast<std::uint8_t>(bits)});
      }
      for (const FieldInfo& field : entry.fields) {
        if (is_reserved(field)) continue;
        each({object->index, entry.sub_first, field.first_bit, field.bits});
      }
    }
  }
}

const std::vector<DeviceHand>& car_hands(const cia447::CarUnit& unit) {
  static std::map<std::string_view, std::vector<DeviceHand>> made;
  const auto [at, is_new] = made.try_emplace(unit.info.name);
  const CarHandTable* const table = table_of(unit);
  if (!is_new || table == nullptr) return at->second;
  at->second = table->rows;
  if (table->tell != nullptr) add_statuses(unit, *table, at->second);
  hand_rows::take_clauses(at->second, cia447::profile);
  return at->second;
}

std::span<const WithoutHand> without_hands(const cia447::CarUnit& unit) {
  const CarHandTable* const table = table_of(unit);
  return table == nullptr ? std::span<const WithoutHand>() : table->without;
}

}  // namespace canvoy::tools
