// A hand on a device of CiA 447: one thing that it senses, reports or is told by a person, with the
// words or numbers that it takes and the object that it changes.
//
//     const CarHand* hand = find_car_hand(hands, "door-driver");
//     hand->act(target, parse_hand_value(*hand, "open"));
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/commands.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::tools {

class DeviceCar;

enum class HandForm : std::uint8_t {
  action,  ///< is done: it takes no value
  key,     ///< is pressed, and released after a time; or set to one of its words
  word,
  number,
  text
};

/// A word that a hand takes, and the code that it is.
struct HandWord {
  std::string word;
  std::uint32_t code = 0;
  Meaning meaning = Meaning::state;
};

/// What a hand was told; of an action nothing.
struct HandValue {
  std::uint32_t code = 0;  ///< of a word
  Meaning meaning = Meaning::state;
  double number = 0;
  std::string text{};  ///< as it was written
};

/// What a hand acts on: the unit of its device, and what is around that.
struct HandTarget {
  void* unit = nullptr;
  DeviceCar* car = nullptr;
  bool* seal_is_open = nullptr;   ///< of a taximeter
  std::uint32_t calibration = 0;  ///< of a taximeter: 0.001 of the distance unit

  template <class Unit>
  Unit& as() const {
    return *static_cast<Unit*>(unit);
  }
};

struct CarHand {
  std::string name;
  HandForm form = HandForm::action;
  std::vector<HandWord> words{};  ///< of a number: what it takes beside numbers
  // Of a number.
  double least = 0;
  double most = 0;
  std::string_view unit{};

  std::string_view example{};                 ///< of a text
  std::vector<cia447::FieldPlace> changes{};  ///< no bits: all of that entry
  std::string_view clause{};
  /// Of a text: throws UsageError for one that means nothing.
  void (*check)(const HandValue&) = nullptr;
  /// False: not in this state; nothing has changed.
  std::function<bool(const HandTarget&, const HandValue&)> act{};
};

/// A key that is pressed is held for so long.
inline constexpr Duration hand_key_time = std::chrono::milliseconds(300);

/// `open, closed, failure`, `0 to 250 km/h`; empty of an action.
std::string hand_values_text(const CarHand& hand);
/// Throws UsageError for a value that the hand does not take, with those that it does.
HandValue parse_hand_value(const CarHand& hand, std::string_view value);
/// That of a key that is pressed or released.
HandValue hand_key_value(bool is_pressed);

/// A name of the profile as a word: `Is getting open (tilt)` is `is-getting-open-tilt`.
std::string hand_word(std::string_view name);

}  // namespace canvoy::tools
