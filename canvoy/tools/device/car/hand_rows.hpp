// The rows of which the tables of hands are made: what a hand is called, what it takes, what it
// changes, and what it does.
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
#include "canvoy/tools/device/car/car_hand.hpp"

namespace canvoy::tools::hand_rows {

/// All of an entry.
constexpr cia447::FieldPlace whole(const ObjectInfo& object, unsigned sub = 0) {
  return {.index = object.index, .sub = static_cast<std::uint8_t>(sub)};
}
inline std::string_view clause_of(const cia447::FieldPlace& place) {
  const ObjectInfo* const object = find_object(cia447::profile, place.index);
  return object == nullptr ? std::string_view() : object->clause;
}
inline CarHand row(std::string name, HandForm form, std::vector<cia447::FieldPlace> changes) {
  CarHand hand{.name = std::move(name), .form = form};
  hand.clause = clause_of(changes.front());
  hand.changes = std::move(changes);
  return hand;
}

/// `act` takes the unit, and the target where it wants more; it answers nothing, or whether it was
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
CarHand action(std::string name, cia447::FieldPlace changes, Act act) {
  CarHand hand = row(std::move(name), HandForm::action, {changes});
  hand.act = of_unit<Unit>(act);
  return hand;
}
/// It is pressed with code 1, and released with code 0.
template <class Unit, class Act>
CarHand key(std::string name, cia447::FieldPlace changes, Act act) {
  CarHand hand = row(std::move(name), HandForm::key, {changes});
  hand.words = {{"released", 0}, {"pressed", 1}};
  hand.act = of_unit<Unit>(act);
  return hand;
}
/// Of words that are counted from 0 upward.
template <class Unit, class Act>
CarHand choice(std::string name, cia447::FieldPlace changes,
               std::initializer_list<std::string_view> words, Act act) {
  CarHand hand = row(std::move(name), HandForm::word, {changes});
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
CarHand number(std::string name, cia447::FieldPlace changes, const HandRange& range, Act act) {
  CarHand hand = row(std::move(name), HandForm::number, {changes});
  hand.least = range.least;
  hand.most = range.most;
  hand.unit = range.unit;
  hand.act = of_unit<Unit>(act);
  return hand;
}
template <class Unit, class Act>
CarHand text(std::string name, std::vector<cia447::FieldPlace> changes, std::string_view example,
             void (*check)(const HandValue&), Act act) {
  CarHand hand = row(std::move(name), HandForm::text, std::move(changes));
  hand.example = example;
  hand.check = check;
  hand.act = of_unit<Unit>(act);
  return hand;
}

/// The words of a field: its states, "failure" and "not-available"; of two states of which the
/// first is that there is nothing, "no" and "off", "yes" and "on" as well.
std::vector<HandWord> words_of(const cia447::FieldPlace& place);
/// Takes the words of the field that it changes.
template <class Unit, class Act>
CarHand status(std::string name, cia447::FieldPlace changes, Act act) {
  CarHand hand = row(std::move(name), HandForm::word, {changes});
  hand.words = words_of(changes);
  hand.act = of_unit<Unit>(act);
  return hand;
}

}  // namespace canvoy::tools::hand_rows
