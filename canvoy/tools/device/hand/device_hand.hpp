// A hand on a device: something that the device senses, reports or is given by a person, with its
// words or numbers and the object that changes.
//
//     DeviceHand load = hand_rows::number<LoadCell>("load", ...);
//     load.act({.unit = &cell}, parse_hand_value(load, "300"));
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::tools {

class DeviceCar;

enum class HandForm : std::uint8_t {
  action,  ///< an action without a value
  key,     ///< pressed and released after a time, or set to one of its words
  word,
  number,
  text
};

/// A word that a hand accepts, and its code.
struct HandWord {
  std::string word;
  std::uint32_t code = 0;
  Meaning meaning = Meaning::state;
};

/// The value given to a hand; unused for an action.
struct HandValue {
  std::uint32_t code = 0;  ///< for a word
  Meaning meaning = Meaning::state;
  double number = 0;
  std::string text{};  ///< as given
};

/// Target of a hand: the unit of its device or the plant with its sensors, and the surroundings.
struct HandTarget {
  void* unit = nullptr;
  unsigned number = 0;  ///< number of a numbered hand, from 1
  Time now{};
  DeviceCar* car = nullptr;       ///< null: moved by a simulated world
  bool* seal_is_open = nullptr;   ///< for a taximeter
  std::uint32_t calibration = 0;  ///< for a taximeter: 0.001 of the distance unit

  template <class Unit>
  Unit& as() const {
    return *static_cast<Unit*>(unit);
  }
};

struct DeviceHand {
  std::string name;
  HandForm form = HandForm::action;
  unsigned count = 0;             ///< numbered, `input1` to `input8`; 0: a single hand
  std::vector<HandWord> words{};  ///< for a number: words accepted beside numbers
  // For a number.
  double least = 0;
  double most = 0;
  std::string_view unit{};

  std::string_view example{};                 ///< for a text
  std::vector<cia447::FieldPlace> changes{};  ///< without bits: the whole entry
  std::string_view clause{};
  /// For a text: throws UsageError if it is not valid.
  void (*check)(const HandValue&) = nullptr;
  /// Performs the action. False: not possible in this state; nothing has changed.
  std::function<bool(const HandTarget&, const HandValue&)> act{};
  /// The reason for a refusal; null or empty: the state of the device.
  std::string (*why)(const HandTarget&) = nullptr;
  /// Needs the surroundings of the unit: DeviceCar, the seal.
  bool is_around = false;

  /// True if it is performed, or held for a while, without a value.
  bool is_pressed() const { return form == HandForm::action || form == HandForm::key; }
};

/// Text of the reason for a refusal.
std::string why_refused(const DeviceHand& hand, const HandTarget& target);

/// Time for which a pressed key is held.
inline constexpr Duration hand_key_time = std::chrono::milliseconds(300);

/// All hands of one device.
struct HandTable {
  std::string_view device;
  std::span<const DeviceHand> hands;
};

/// Text of the names: `door`, `input1 to input8`.
std::string hand_name_text(const DeviceHand& hand);
/// Text of the values: `open, closed, failure`, `0 to 250 km/h`; empty for an action.
std::string hand_values_text(const DeviceHand& hand);
/// Reads a value. Throws UsageError with the accepted values if the hand does not take it.
HandValue parse_hand_value(const DeviceHand& hand, std::string_view value);
/// The value of a pressed or released key.
HandValue hand_key_value(bool is_pressed);

/// A name of the profile as a word: `Is getting open (tilt)` is `is-getting-open-tilt`.
std::string hand_word(std::string_view name);

}  // namespace canvoy::tools
