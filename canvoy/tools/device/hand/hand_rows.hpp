// Functions that make the rows of the tables of hands: name, values, changed object, and action.
//
//     using namespace hand_rows;
//     action<TaxiAlarmUnit>("reset", whole(taxi_alarm_system_status_object),
//                           [](TaxiAlarmUnit& unit) { unit.reset_alarm(); })
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "canvoy/profiles/cia447.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools::hand_rows {

/// A whole entry.
constexpr cia447::FieldPlace whole(const ObjectInfo& object, unsigned sub = 0) {
  return {.index = object.index, .sub = static_cast<std::uint8_t>(sub)};
}
inline DeviceHand row(std::string name, HandForm form, std::vector<cia447::FieldPlace> changes) {
  DeviceHand hand{.name = std::move(name), .form = form};
  hand.changes = std::move(changes);
  return hand;
}
/// Hands `input1` to `input8` from `input`.
inline DeviceHand numbered(unsigned count, DeviceHand hand) {
  hand.count = count;
  return hand;
}
/// Sets the clause of each hand to that of the object that it changes.
inline void take_clauses(std::vector<DeviceHand>& hands, const Profile& profile) {
  for (DeviceHand& hand : hands) {
    if (hand.changes.empty()) continue;
    const ObjectInfo* const object = find_object(profile, hand.changes.front().index);
    if (object != nullptr) hand.clause = object->clause;
  }
}

/// `act` takes the unit, and also the target if needed; it returns nothing, or whether it was
/// possible.
template <class Unit, class Act>
auto of_unit(Act act) {
  return [act](const HandTarget& target, const HandValue& value) {
    Unit& unit = target.as<Unit>();
    if constexpr (std::is_invocable_r_v<bool, Act, Unit&, const HandValue&, const HandTarget&>) {
      return act(unit, value, target);
    } else if constexpr (std::is_invocable_r_v<bool, Act, Unit&, const HandValue&>) {
      return act(unit, value);
    } else if constexpr (std::is_invocable_r_v<bool, Act, Unit&>) {
      return act(unit);
    } else if constexpr (std::is_invocable_v<Act, Unit&, const HandValue&>) {
      act(unit, value);
      return true;
    } else {
      act(unit);
      return true;
    }
  };
}

template <class Unit, class Act>
DeviceHand action(std::string name, cia447::FieldPlace changes, Act act) {
  DeviceHand hand = row(std::move(name), HandForm::action, {changes});
  hand.act = of_unit<Unit>(act);
  return hand;
}
/// A hand that needs the surroundings of the unit.
inline DeviceHand around(DeviceHand hand) {
  hand.is_around = true;
  return hand;
}
/// Words of a button or a contact; 0 and 1 are accepted as well.
inline std::vector<HandWord> two_words(std::string_view off, std::string_view on) {
  return {{std::string(off), 0},
          {std::string(on), 1},
          {"0", 0, Meaning::do_not_care},
          {"1", 1, Meaning::do_not_care}};
}
/// A key: pressed with code 1, released with code 0, or set to one of `words`.
template <class Unit, class Act>
DeviceHand key(std::string name, cia447::FieldPlace changes, Act act,
               std::vector<HandWord> words = {{"released", 0}, {"pressed", 1}}) {
  DeviceHand hand = row(std::move(name), HandForm::key, {changes});
  hand.words = std::move(words);
  hand.act = of_unit<Unit>(act);
  return hand;
}
/// Words with codes from 0 upward.
template <class Unit, class Act>
DeviceHand choice(std::string name, cia447::FieldPlace changes,
                  std::initializer_list<std::string_view> words, Act act) {
  DeviceHand hand = row(std::move(name), HandForm::word, {changes});
  for (const std::string_view word : words) {
    hand.words.push_back({std::string(word), static_cast<std::uint32_t>(hand.words.size())});
  }
  hand.act = of_unit<Unit>(act);
  return hand;
}

struct HandRange {
  double least = 0;
  double most = 0;
  std::string_view unit{};
};
template <class Unit, class Act>
DeviceHand number(std::string name, cia447::FieldPlace changes, const HandRange& range, Act act) {
  DeviceHand hand = row(std::move(name), HandForm::number, {changes});
  hand.least = range.least;
  hand.most = range.most;
  hand.unit = range.unit;
  hand.act = of_unit<Unit>(act);
  return hand;
}
template <class Unit, class Act>
DeviceHand text(std::string name, std::vector<cia447::FieldPlace> changes, std::string_view example,
                void (*check)(const HandValue&), Act act) {
  DeviceHand hand = row(std::move(name), HandForm::text, std::move(changes));
  hand.example = example;
  hand.check = check;
  hand.act = of_unit<Unit>(act);
  return hand;
}

/// The words of a field: its states, "failure" and "not-available"; if the first of two states
/// means absence, also "no" and "off", "yes" and "on".
std::vector<HandWord> words_of(const cia447::FieldPlace& place);
/// Accepts the words of the field that it changes.
template <class Unit, class Act>
DeviceHand status(std::string name, cia447::FieldPlace changes, Act act) {
  DeviceHand hand = row(std::move(name), HandForm::word, {changes});
  hand.words = words_of(changes);
  hand.act = of_unit<Unit>(act);
  return hand;
}

}  // namespace canvoy::tools::hand_rows
