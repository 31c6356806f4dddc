// Virtual devices of a bus (CiA 407): displays, and events of all devices.
#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/behaviour/stage.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"

namespace canvoy::conformance {

namespace of_407 {
namespace {

namespace bus = cia407;

constexpr std::uint16_t cannot_show = 0xFF04;
constexpr std::uint16_t error_is_over = 0x0000;

/// Texts of stop points, and their display: 6203h:01h is the number of elements from sub-index 02h
/// on that are shown, each with an index, a sub-index and a format.
constexpr Place stop_text{&bus::text_of_stop_point_object, 1};
constexpr Place last_stop_text{&bus::text_of_stop_point_object, 64};
constexpr Place destination_text{&bus::text_of_destination_object, 1};
constexpr Place update{&bus::display_mapping_object, 1};
constexpr Place first_element{&bus::display_mapping_object, 2};
constexpr Place character_set{&bus::character_set_object, 1};
constexpr Place stop_request{&bus::bus_stop_request_object, 0};
constexpr std::int64_t stop_text_plain = 0x0012'6101;
constexpr std::int64_t no_such_object = 0x0040'6700;
constexpr Step show_stop = put(first_element, stop_text_plain);
constexpr Step show_one = put(update, 1);
constexpr Step show_none = put(update, 0);
constexpr std::string_view text_128 =
    "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
    "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx";
constexpr std::string_view text_129 =
    "yyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyy"
    "yyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyy";

constexpr BehaviourRow display_rows[] = {
    row("407-display-01", "9.2.8.4", "a text that is mapped is shown",
        {start, put_text(stop_text, "Zoo"), show_stop, show_one, no_alarm(cannot_show),
         see("the display shows Zoo")}),
    row("407-display-02", "9.2.8.4", "a text that is written shows nothing before the update",
        {start, put_text(stop_text, "Zoo"), show_stop, show_one, put_text(stop_text, "Market"),
         see("the display shows Zoo"), show_one, see("the display shows Market")}),
    row("407-display-03", "9.2.8.4", "with no element the display is dark",
        {start, put_text(stop_text, "Zoo"), show_stop, show_one, show_none,
         see("the display is dark")}),
    row("407-display-04", "9.2.8.4", "an object that there is not cannot be shown",
        {start, show_none, put(first_element, no_such_object), show_one, alarm(cannot_show),
         show_none}),
    row("407-display-05", "9.2.8.4", "what could not be shown is over with the next update",
        {start, show_none, put(first_element, no_such_object), show_one, alarm(cannot_show),
         show_none, alarm(error_is_over)}),
    row("407-display-06", "9.2.8.4", "more elements than there are cannot be shown",
        {start, show_none, put(update, 0xFF), alarm(cannot_show), show_none}),
    row("407-display-07", "9.2.6.19", "a text of 128 octets is taken",
        {put_text(last_stop_text, text_128)}),
    row("407-display-08", "9.2.6.19", "a text of 129 octets is refused",
        {refuse_text(last_stop_text, text_129)}),
    row("407-display-09", "9.2.8.6", "a character set that there is not is refused",
        {refuse(character_set, 0x000C)}),
    row("407-display-10", "9.2.8.6", "a reserved character set is refused",
        {refuse(character_set, 0x8000)}),
    row("407-display-11", "9.2.8.5", "a stop that is wanted is shown, and no longer when it is not",
        {start, feed(stop_request, 1), see("the display shows that a stop is wanted"),
         feed(stop_request, 0), see("the display shows that no stop is wanted")},
        {update}),
    row("407-display-12", "9.2.6.14", "a text of a destination is taken",
        {put_text(destination_text, "Airport")}),
};

// Events (CiA 407, 9.2.4, 9.2.5): messages to and from a virtual device have its code in the most
// significant byte.

constexpr Place event_for{&bus::events_for_virtual_devices_object, 1};
constexpr Place event_from{&bus::events_from_virtual_devices_object, 2};
constexpr Place event_summary{&bus::events_from_virtual_devices_object, 1};
constexpr std::uint64_t code_and_state = 0xFF00'0001;
constexpr std::int64_t asked = 1;

/// True if bit 0 of the message requests the state of the device.
bool is_asked_for_its_state(std::int64_t code) {
  return std::ranges::any_of(event_for.entry()->fields, [code](const FieldInfo& field) {
    return field.first_bit == 0 && field.name == "send state information" &&
           std::ranges::any_of(field.when, [code](const FieldCondition& each) {
             return code >= each.first && code <= each.last;
           });
  });
}

/// The steps for the only virtual device of a node, with the code in the most significant byte of
/// 1000h.
template <class Steps>
Verdict play_event(Bench& bench, Steps steps_with) {
  const std::int64_t code = bench.number(object_index::device_type, 0).value_or(0) >> 24;
  if (!is_asked_for_its_state(code)) {
    return not_applicable("1000h names no single virtual device that is asked for its state");
  }
  return play(bench, {.steps = steps_with(code << 24)});
}

Verdict judge_asked(Bench& bench) {
  return play_event(bench, [](std::int64_t code) -> BehaviourSteps {
    return {start, put(event_for, 0), put(event_for, code | asked),
            is(event_from, code | asked, code_and_state), put(event_for, 0)};
  });
}
Verdict judge_told(Bench& bench) {
  return play_event(bench, [](std::int64_t code) -> BehaviourSteps {
    return {start, put(event_for, 0), put(event_for, code | asked),
            tells(event_from, code | asked, code_and_state), put(event_for, 0)};
  });
}
Verdict judge_summary(Bench& bench) {
  return play_event(bench, [](std::int64_t code) -> BehaviourSteps {
    return {start, put(event_for, 0), put(event_for, code | asked), is(event_summary, 1, 1),
            put(event_for, 0)};
  });
}
Verdict judge_over(Bench& bench) {
  return play_event(bench, [](std::int64_t code) -> BehaviourSteps {
    return {start, put(event_for, code | asked), is(event_from, code | asked, code_and_state),
            put(event_for, 0), is(event_from, 0, asked)};
  });
}
Verdict judge_other_device(Bench& bench) {
  return play_event(bench, [](std::int64_t code) -> BehaviourSteps {
    constexpr std::int64_t next_code = 0x0100'0000;
    return {start, put(event_for, 0), feed(event_for, (code + next_code) | asked),
            stays(event_from, 0, asked)};
  });
}
Verdict judge_reset(Bench& bench) {
  return play_event(bench, [](std::int64_t code) -> BehaviourSteps {
    return {start,
            put(event_for, code | asked),
            is(event_from, code | asked, code_and_state),
            enter(NmtCommand::reset_node),
            wait(2s),
            is(event_from, 0, asked)};
  });
}

constexpr CaseRow event_rows[] = {
    {"407-event-01", "CiA 407, 9.2.4 and 9.2.5", "a virtual device that is asked tells its state",
     "6002h:01h = its code and bit 0", "6001h:02h is the same", judge_asked},
    {"407-event-02", "CiA 407, 9.2.4", "an event is told", "6002h:01h = its code and bit 0",
     "a TPDO with 6001h:02h", judge_told},
    {"407-event-03", "CiA 407, 9.2.4", "the summary says which device has an event",
     "6002h:01h = its code and bit 0", "6001h:01h, bit 0 = 1", judge_summary},
    {"407-event-04", "CiA 407, 9.2.5", "a device that is asked no more has no event",
     "6002h:01h = its code and bit 0; 0", "6001h:02h, bit 0 = 0", judge_over},
    {"407-event-05", "CiA 407, 9.2.5", "an event for another virtual device is none of it",
     "an RPDO with 6002h:01h = another code and bit 0", "6001h:02h, bit 0 = 0", judge_other_device},
    {"407-event-06", "CiA 407, 9.2.4", "a reset ends an event",
     "6002h:01h = its code and bit 0; NMT 81h", "6001h:02h, bit 0 = 0", judge_reset},
};

}  // namespace
}  // namespace of_407

std::vector<std::span<const BehaviourRow>> rows_of_407() {
  using namespace of_407;  // NOLINT(google-build-using-namespace): its tables
  return {display_rows};
}

void add_event_cases(TestCases& cases) {
  add_rows(cases, Group::behaviour, of_407::event_rows);
}

}  // namespace canvoy::conformance
