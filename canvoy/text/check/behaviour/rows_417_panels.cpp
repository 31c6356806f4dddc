// Panels of landings and cars, and a car door controller (CiA 417-4): a button and a lamp by their
// records in the panel, and a door that the test plays.
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/behaviour/stage.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"

namespace canvoy::conformance {

namespace of_417_panels {
namespace {

namespace lift = cia417;

constexpr Duration button_is_seen = 100ms;

// A record has basic function, sub-function, lifts, floor, doors and function data, the first in
// the lowest byte.

constexpr std::uint64_t record_bits = 0xFFFF'FFFF'FFFF;
constexpr unsigned lifts_at = 16;
constexpr unsigned floor_at = 24;
constexpr unsigned data_at = 40;

std::int64_t record_at(Bench& bench, const Place& place) {
  const Reply value = bench.read(place.index(), place.sub);
  return value ? static_cast<std::int64_t>(value.number() & record_bits) : 0;
}

// Buttons (CiA 417-4, 4.3): the call request is in bits 1 and 0 of the function data.

constexpr Place button{&lift::input_group_object, 1};
constexpr Place told{&lift::virtual_input_mapping_object, 0};
constexpr Place enable{&lift::input_parameter_1_object, 1};
constexpr Place edges{&lift::input_parameter_3_object, 1};
constexpr std::int64_t request_bits = std::int64_t{3} << data_at;
constexpr std::int64_t request = std::int64_t{1} << data_at;
constexpr std::string_view press_button = "press button 1 of the panel";
constexpr std::string_view let_button_go = "let button 1 of the panel go";
/// Byte 0: not enabled; no error code.
constexpr std::int64_t disabled = 0xFFFF'FFFE;
constexpr std::int64_t enabled = 0xFFFF'FFFF;
/// Byte 1: low-to-high edge only, not inverted; no debounce time.
constexpr std::int64_t when_pressed = 0xFFFF'7DFF;
constexpr std::int64_t when_let_go = 0xFFFF'7EFF;

/// The steps, from the records for a released and a pressed button.
template <class Steps>
Verdict play_button(Bench& bench, Steps steps_of) {
  if (!bench.has(button.index(), button.sub)) return not_applicable("the device has no 6100h:01h");
  const std::int64_t free = record_at(bench, button) & ~request_bits;
  if ((free & 0xFF) == 0) return not_applicable("6100h:01h has no function");
  return play(bench, {.steps = steps_of(free, free | request)});
}

Verdict judge_press(Bench& bench) {
  return play_button(bench, [](std::int64_t free, std::int64_t pressed) -> BehaviourSteps {
    return {hand(let_button_go),
            start,
            wait(button_is_seen),
            hand(press_button),
            tells(told, pressed, record_bits),
            hand(let_button_go),
            tells(told, free, record_bits)};
  });
}
Verdict judge_stored(Bench& bench) {
  return play_button(bench, [](std::int64_t free, std::int64_t pressed) -> BehaviourSteps {
    return {hand(let_button_go),
            start,
            is(button, free, record_bits),
            hand(press_button),
            is(button, pressed, record_bits),
            hand(let_button_go),
            is(button, free, record_bits)};
  });
}
Verdict judge_disabled(Bench& bench) {
  return play_button(bench, [](std::int64_t, std::int64_t) -> BehaviourSteps {
    return {hand(let_button_go), start,           wait(button_is_seen), put(enable, disabled),
            hand(press_button),  is_silent(told), hand(let_button_go)};
  });
}
Verdict judge_rising(Bench& bench) {
  return play_button(bench, [](std::int64_t, std::int64_t pressed) -> BehaviourSteps {
    return {hand(let_button_go),
            start,
            put(enable, enabled),
            put(edges, when_pressed),
            wait(button_is_seen),
            hand(press_button),
            tells(told, pressed, record_bits),
            hand(let_button_go),
            is_silent(told)};
  });
}
Verdict judge_falling(Bench& bench) {
  return play_button(bench, [](std::int64_t free, std::int64_t) -> BehaviourSteps {
    return {hand(let_button_go),
            start,
            put(enable, enabled),
            put(edges, when_let_go),
            wait(button_is_seen),
            hand(press_button),
            is_silent(told),
            hand(let_button_go),
            tells(told, free, record_bits)};
  });
}
Verdict judge_not_in_pre_operational(Bench& bench) {
  return play_button(bench, [](std::int64_t, std::int64_t) -> BehaviourSteps {
    return {enter(NmtCommand::enter_pre_operational),
            hand(let_button_go),
            wait(button_is_seen),
            hand(press_button),
            is_silent(told),
            hand(let_button_go)};
  });
}
Verdict judge_strange_button(Bench& bench) {
  return play_button(bench, [](std::int64_t, std::int64_t pressed) -> BehaviourSteps {
    return {hand(let_button_go), refuse(button, pressed)};
  });
}

constexpr CaseRow button_rows[] = {
    {"417-4-button-01", "CiA 417-4, 4.3.1", "a button that is pressed is told, and let go",
     "by hand: button 1", "a TPDO with the record of 6100h:01h", judge_press},
    {"417-4-button-02", "CiA 417-4, 4.3.1", "the state of a button is stored in its record",
     "by hand: button 1", "6100h:01h with the call request", judge_stored},
    {"417-4-button-03", "CiA 417-4, 4.3.2", "a button that is disabled is not told",
     "6120h:01h = FFFF FFFEh; by hand: button 1", "no TPDO with 6010h", judge_disabled},
    {"417-4-button-04", "CiA 417-4, 4.3.4",
     "with its low-to-high edge a button is told when pressed",
     "6160h:01h = FFFF 7DFFh; by hand: button 1", "a TPDO with 6010h, and none when it is let go",
     judge_rising},
    {"417-4-button-05", "CiA 417-4, 4.3.4",
     "with its high-to-low edge a button is told when let go",
     "6160h:01h = FFFF 7EFFh; by hand: button 1", "a TPDO with 6010h when it is let go alone",
     judge_falling},
    {"417-4-button-06", "CiA 301, 7.3.2.2.2", "no button is told in pre-operational",
     "by hand: button 1", "no TPDO with 6010h", judge_not_in_pre_operational},
    {"417-4-button-07", "CiA 417-4, 4.3.1", "nobody writes the state of a button",
     "6100h:01h with a call request", "an abort", judge_strange_button},
};

// Lamps (CiA 417-4, 4.4.1): the state is bit 0 of the function data. A record applies to outputs
// with its function, its sub-function, one of its lifts, its floor and one of its doors.

constexpr Place lamp{&lift::output_group_object, 1};
constexpr Place shown{&lift::virtual_output_mapping_object, 0};
constexpr Place lamp_enable{&lift::output_parameter_1_object, 1};
constexpr std::int64_t data_bits = std::int64_t{0xFF} << data_at;
constexpr std::int64_t is_shown = std::int64_t{1} << data_at;
constexpr std::int64_t floor_bits = std::int64_t{0xFF} << floor_at;
constexpr std::int64_t lift_bits = std::int64_t{0xFF} << lifts_at;
constexpr Step is_lit = see("lamp 1 of the panel is lit");
constexpr Step is_dark = see("lamp 1 of the panel is dark");
/// Byte 0: not enabled; the others are unused.
constexpr std::int64_t lamp_disabled = 0xFFFF'FFFE;

/// The steps, from the records that switch the lamp off and on.
template <class Steps>
Verdict play_lamp(Bench& bench, Steps steps_of) {
  if (!bench.has(lamp.index(), lamp.sub)) return not_applicable("the device has no 6200h:01h");
  const std::int64_t off = record_at(bench, lamp) & ~data_bits;
  if ((off & 0xFF) == 0) return not_applicable("6200h:01h has no function");
  return play(bench, {.steps = steps_of(off, off | is_shown)});
}
/// A record for another output leaves the lamp dark.
Verdict play_other(Bench& bench, std::int64_t (*other)(std::int64_t lit)) {
  return play_lamp(bench, [other](std::int64_t off, std::int64_t lit) -> BehaviourSteps {
    return {start,
            feed(shown, off),
            is_dark,
            feed(shown, other(lit)),
            wait(button_is_seen),
            is_dark,
            stays(lamp, 0, static_cast<std::uint64_t>(is_shown))};
  });
}

Verdict judge_lamp(Bench& bench) {
  return play_lamp(bench, [](std::int64_t off, std::int64_t lit) -> BehaviourSteps {
    return {start, feed(shown, off), is_dark, feed(shown, lit), is_lit, feed(shown, off), is_dark};
  });
}
Verdict judge_lamp_stored(Bench& bench) {
  return play_lamp(bench, [](std::int64_t off, std::int64_t lit) -> BehaviourSteps {
    return {start,
            feed(shown, off),
            is(lamp, off, record_bits),
            feed(shown, lit),
            is(lamp, lit, record_bits),
            feed(shown, off)};
  });
}
Verdict judge_other_lift(Bench& bench) {
  return play_other(bench, [](std::int64_t lit) {
    // All lifts except its own; if it has all lifts, none.
    return (lit & ~lift_bits) | (~lit & lift_bits);
  });
}
Verdict judge_other_floor(Bench& bench) {
  return play_other(bench, [](std::int64_t lit) {
    constexpr std::int64_t one_floor = std::int64_t{1} << floor_at;
    return (lit & floor_bits) == one_floor ? lit + one_floor : (lit & ~floor_bits) | one_floor;
  });
}
Verdict judge_other_function(Bench& bench) {
  // No panel with calls has publicity (46h).
  return play_other(bench, [](std::int64_t lit) { return (lit & ~std::int64_t{0xFF}) | 0x46; });
}
Verdict judge_lamp_disabled(Bench& bench) {
  return play_lamp(bench, [](std::int64_t off, std::int64_t lit) -> BehaviourSteps {
    return {start,
            feed(shown, off),
            put(lamp_enable, lamp_disabled),
            feed(shown, lit),
            wait(button_is_seen),
            is_dark};
  });
}
Verdict judge_lamp_in_pre_operational(Bench& bench) {
  return play_lamp(bench, [](std::int64_t off, std::int64_t lit) -> BehaviourSteps {
    return {start,
            feed(shown, off),
            enter(NmtCommand::enter_pre_operational),
            feed(shown, lit),
            wait(button_is_seen),
            is_dark};
  });
}

constexpr CaseRow lamp_rows[] = {
    {"417-4-lamp-01", "CiA 417-4, 4.4.1", "a lamp is lit and put out by its record",
     "an RPDO with the record of 6200h:01h, data indicated and not", "to be seen: lamp 1",
     judge_lamp},
    {"417-4-lamp-02", "CiA 417-4, 4.4.1", "the state of a lamp is stored in its record",
     "an RPDO with the record of 6200h:01h, data indicated and not", "6200h:01h is the same",
     judge_lamp_stored},
    {"417-4-lamp-03", "CiA 417-4, 4.4.1", "a record for another lift lights no lamp",
     "an RPDO with the record of 6200h:01h for other lifts", "to be seen: lamp 1 is dark",
     judge_other_lift},
    {"417-4-lamp-04", "CiA 417-4, 4.4.1", "a record for another floor lights no lamp",
     "an RPDO with the record of 6200h:01h for another floor", "to be seen: lamp 1 is dark",
     judge_other_floor},
    {"417-4-lamp-05", "CiA 417-4, 4.4.1", "a record of another function lights no lamp",
     "an RPDO with the record of 6200h:01h with function 46h", "to be seen: lamp 1 is dark",
     judge_other_function},
    {"417-4-lamp-06", "CiA 417-4, 4.5.1", "a lamp that is disabled is not lit",
     "6220h:01h = FFFF FFFEh; an RPDO with its record", "to be seen: lamp 1 is dark",
     judge_lamp_disabled},
    {"417-4-lamp-07", "CiA 301, 7.3.2.2.2", "a lamp follows no RPDO in pre-operational",
     "an RPDO with the record of 6200h:01h", "to be seen: lamp 1 is dark",
     judge_lamp_in_pre_operational},
};

// A car door controller (CiA 417-4, 4.6): its command is in bits 15 to 12 of the controlword of the
// door. The door that the test plays reports its state in the same bits of 6301h.

constexpr Place command{&lift::door_controlword_object, 1};
constexpr Place other_command{&lift::door_controlword_object, 2};
constexpr Place door{&lift::door_statusword_object, 1};
constexpr std::uint64_t command_bits = 0xF000;
/// Close with limited force is 1h, without is 0h.
constexpr std::uint64_t close_bits = 0xE000;
constexpr std::int64_t order_open = 0x4000;
constexpr std::int64_t order_close = 0x0000;
constexpr std::int64_t order_stop = 0x8000;
constexpr std::int64_t order_none = 0xF000;
constexpr Step says_closed = feed(door, 0x0FFF);
constexpr Step says_opened = feed(door, 0x3FFF);
constexpr Step says_opening = feed(door, 0x5FFF);
constexpr Step says_closing = feed(door, 0x2FFF);
constexpr std::string_view open_door = "have the controller open door 1";
constexpr std::string_view close_door = "have the controller close door 1";
constexpr std::string_view stop_door = "have the controller stop door 1";
/// Reaction time of a controller; no clause gives one.
constexpr Duration obeyed = 2s;

constexpr BehaviourRow controller_rows[] = {
    row("417-4-door-controller-01", "4.6.1", "a controller that is to open a door tells it to",
        {start, says_closed, hand(open_door), tells(command, order_open, command_bits, obeyed),
         says_opening, says_opened}),
    row("417-4-door-controller-02", "4.6.1", "a controller that is to close a door tells it to",
        {start, says_opened, hand(close_door), tells(command, order_close, close_bits, obeyed),
         says_closing, says_closed}),
    row("417-4-door-controller-03", "4.6.1", "a controller that is to stop a door tells it to",
        {start, says_closed, hand(open_door), tells(command, order_open, command_bits, obeyed),
         says_opening, hand(stop_door), tells(command, order_stop, command_bits, obeyed)}),
    row("417-4-door-controller-04", "4.6.1", "a controller that opens door 1 leaves door 2",
        {start, says_closed, hand(open_door),
         tells(other_command, order_none, command_bits, obeyed), says_opened}),
    row("417-4-door-controller-05", "4.6.1", "reserved bits of the controlword are 1",
        {start, says_opened, hand(close_door), tells(command, 0x0003, 0x0003, obeyed),
         says_closed}),
    row("417-4-door-controller-06", "4.7.1", "a controller keeps what its door says",
        {start, says_opened, is(door, 0x3FFF, command_bits), says_closed,
         is(door, 0x0FFF, command_bits)},
        {command}),
    row("417-4-door-controller-07", "CiA 301, 7.3.2.2.2",
        "a controller tells its door nothing in pre-operational",
        {enter(NmtCommand::enter_pre_operational), hand(open_door), is_silent(command)}),
};

}  // namespace
}  // namespace of_417_panels

std::vector<std::span<const BehaviourRow>> rows_of_417_controllers() {
  return {of_417_panels::controller_rows};
}

void add_panel_cases(TestCases& cases) {
  add_rows(cases, Group::behaviour, of_417_panels::button_rows);
  add_rows(cases, Group::behaviour, of_417_panels::lamp_rows);
}

}  // namespace canvoy::conformance
