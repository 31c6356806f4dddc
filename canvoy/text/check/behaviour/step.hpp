// A behaviour case as data: actions on a device by SDO, PDO, NMT or by hand, and the expected
// answers, step by step. behaviour_cases.hpp has the tables; stage.hpp plays them.
//
//     constexpr BehaviourRow rows[] = {
//         row("401-outputs-01", "CiA 401, 6200h", "an output takes what is written",
//             {put({&write_output_8_bit_object, 1}, 5), is({&write_output_8_bit_object, 1}, 5)})};
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::conformance {

/// An entry of an object of a profile.
struct Place {
  /// Null: none.
  const ObjectInfo* object = nullptr;
  std::uint8_t sub = 0;     ///< its sub-index
  std::uint16_t above = 0;  ///< for one of several equal objects: offset from the first

  /// Its index.
  constexpr std::uint16_t index() const {
    return static_cast<std::uint16_t>(object->index + above);
  }
  /// The entry in the profile; never null for a place of a table.
  constexpr const EntryInfo* entry() const { return find_entry(*object, sub); }
};

/// Kind of a step.
enum class Act : std::uint8_t {
  none,
  // Actions.
  enter,     ///< an NMT command
  put,       ///< a download, which must succeed
  put_text,  ///< a download of a text, which must succeed
  feed,      ///< an RPDO with this value and the previous other values
  lose,      ///< a monitored heartbeat is sent once, and then stops
  hand,      ///< a person is asked to act on the device
  wait,      ///< for some time
  // Expectations.
  refuse,       ///< a download that must be aborted and change nothing
  refuse_text,  ///< a download of a text that must be aborted and change nothing
  is_text,      ///< an upload gives this text in time
  is,           ///< an upload gives this value in time
  stays,        ///< an upload gives this value the whole time
  tells,        ///< a TPDO carries this value in time
  is_silent,    ///< no TPDO carries the entry
  alarm,        ///< an emergency with this error code in time
  no_alarm,     ///< no emergency with this error code
  see,          ///< a person is asked for the state of the device
};

/// A step; made by the functions below.
struct Step {
  Act act = Act::none;          ///< kind of the step
  Place place = {};             ///< entry to write or read
  std::int64_t number = 0;      ///< a value, an NMT command or an error code
  std::uint64_t mask = ~0ULL;   ///< mask of the significant bits
  Duration time{};              ///< time limit or duration
  std::string_view words = {};  ///< a text, or the request to a person
};

/// Time for an answer of a device of these profiles if no clause gives one.
inline constexpr Duration answer_time = 500ms;

/// An NMT command to the device alone.
constexpr Step enter(NmtCommand command) {
  return {.act = Act::enter, .number = static_cast<std::int64_t>(command)};
}
/// First step of nearly every case with PDOs.
inline constexpr Step start = enter(NmtCommand::start);
/// A download by SDO.
constexpr Step put(Place place, std::int64_t number) {
  return {.act = Act::put, .place = place, .number = number};
}
/// An RPDO that carries the entry; its other entries keep their values.
constexpr Step feed(Place place, std::int64_t number) {
  return {.act = Act::feed, .place = place, .number = number};
}
/// A heartbeat consumer (1016h:01h) misses a heartbeat.
inline constexpr Step lose = {.act = Act::lose};
/// A request to a person: `press push-button 1 of cluster 1`.
constexpr Step hand(std::string_view words) {
  return {.act = Act::hand, .words = words};
}
/// A question to a person: `indicator 1 of cluster 1 is lit`.
constexpr Step see(std::string_view words) {
  return {.act = Act::see, .words = words};
}
/// A pause.
constexpr Step wait(Duration time) {
  return {.act = Act::wait, .time = time};
}
/// A download that must be aborted with any code, without a change of the value.
constexpr Step refuse(Place place, std::int64_t number) {
  return {.act = Act::refuse, .place = place, .number = number};
}
/// A download of a text, segmented if it has more than four characters.
constexpr Step put_text(Place place, std::string_view text) {
  return {.act = Act::put_text, .place = place, .words = text};
}
/// A download of a text that must be aborted with any code.
constexpr Step refuse_text(Place place, std::string_view text) {
  return {.act = Act::refuse_text, .place = place, .words = text};
}
/// An upload must give exactly this text.
constexpr Step is_text(Place place, std::string_view text, Duration within = answer_time) {
  return {.act = Act::is_text, .place = place, .time = within, .words = text};
}
/// An upload must give this value; `mask` has the significant bits.
constexpr Step is(Place place, std::int64_t number, std::uint64_t mask = ~0ULL,
                  Duration within = answer_time) {
  return {.act = Act::is, .place = place, .number = number, .mask = mask, .time = within};
}
/// Every upload within the time must give this value.
constexpr Step stays(Place place, std::int64_t number, std::uint64_t mask = ~0ULL,
                     Duration during = answer_time) {
  return {.act = Act::stays, .place = place, .number = number, .mask = mask, .time = during};
}
/// A TPDO since the last action must carry this value; earlier TPDOs may carry another.
constexpr Step tells(Place place, std::int64_t number, std::uint64_t mask = ~0ULL,
                     Duration within = answer_time) {
  return {.act = Act::tells, .place = place, .number = number, .mask = mask, .time = within};
}
/// A TPDO must carry the entry with any value.
constexpr Step tells_any(Place place, Duration within = answer_time) {
  return tells(place, 0, 0, within);
}
/// No TPDO since the last action may carry the entry.
constexpr Step is_silent(Place place, Duration during = answer_time) {
  return {.act = Act::is_silent, .place = place, .time = during};
}
/// An emergency with this code must come since the last action.
constexpr Step alarm(std::uint16_t code, std::uint16_t mask = 0xFFFF,
                     Duration within = answer_time) {
  return {.act = Act::alarm, .number = code, .mask = mask, .time = within};
}

/// No emergency with this code may come; others may.
constexpr Step no_alarm(std::uint16_t code, Duration during = answer_time) {
  return {.act = Act::no_alarm, .number = code, .mask = 0xFFFF, .time = during};
}

/// Maximum number of steps of a case.
inline constexpr std::size_t steps_max = 16;

/// Steps after the last one are `none`.
using BehaviourSteps = std::array<Step, steps_max>;

/// A case as a row of a table.
struct BehaviourRow {
  std::string_view id = {};      ///< `852-joystick-03`
  std::string_view clause = {};  ///< without the name of the profile if it is the profile's own
  std::string_view title = {};   ///< what is tested
  BehaviourSteps steps = {};     ///< in their order
  /// Further entries that the device must have; without an object: none.
  std::array<Place, 2> needs = {};
};
/// A row in its columns.
constexpr BehaviourRow row(std::string_view id, std::string_view clause, std::string_view title,
                           const BehaviourSteps& steps, const std::array<Place, 2>& needs = {}) {
  return {.id = id, .clause = clause, .title = title, .steps = steps, .needs = needs};
}

/// True if a case writes what may move a machine; it then needs --moves.
bool moves(const BehaviourRow& row);
/// Text of the actions of a case: `6200h:01h = 05h, heartbeat lost`.
std::string sends_text(const BehaviourRow& row);
/// Text of the expectations of a case.
std::string expects_text(const BehaviourRow& row);
/// `6200h:01h is 05h`
std::string step_text(const Step& step);
/// A number in the notation of the entry: `05h`, `-320`.
std::string number_text(const Place& place, std::int64_t number);

}  // namespace canvoy::conformance
