// Virtual devices of a bus for passengers (CiA 407): ticket canceller, ticket printer, passenger
// counter and passenger counting manager.
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/behaviour/stage.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"

namespace canvoy::conformance {

namespace of_407_passengers {
namespace {

namespace bus = cia407;

constexpr std::uint16_t out_of_paper = 0xFF01;
constexpr std::uint16_t trouble_is_over = 0x0000;
/// Time in which missing paper is noticed; no clause gives one.
constexpr Duration paper_is_seen = 10s;

// Date and time on tickets: 610Eh in years since 1985, quarters of days, months, hours, minutes and
// quarters of seconds; 23rd November 2026, 8:15.

constexpr Place clock_part(std::uint8_t sub) {
  return {&bus::local_time_and_date_object, sub};
}
constexpr Step tell_year = put(clock_part(1), 41);
constexpr Step tell_day = put(clock_part(2), 92);
constexpr Step tell_month = put(clock_part(3), 11);
constexpr Step tell_hour = put(clock_part(4), 8);
constexpr Step tell_minute = put(clock_part(5), 15);
constexpr Step tell_second = put(clock_part(6), 0);
constexpr Step tell_stop = put({&bus::stop_point_id_object, 0}, 815);
constexpr Place blocking{&bus::blocking_of_ticket_canceller_object, 0};
constexpr Step block = put(blocking, 0x80);
constexpr Step unblock = put(blocking, 0x00);
constexpr std::string_view put_in = "put a ticket into the canceller";
constexpr std::string_view is_cancelled = "the ticket is cancelled";
constexpr std::string_view is_not_cancelled = "the ticket is not cancelled";
constexpr std::string_view buy = "have a ticket printed";
constexpr std::string_view take_paper = "take the paper out of the ticket printer";
constexpr std::string_view give_paper = "put paper into the ticket printer";

constexpr BehaviourRow ticket_rows[] = {
    row("407-canceller-01", "6.5", "a ticket is cancelled",
        {start, tell_year, tell_day, tell_month, tell_hour, tell_minute, tell_second, tell_stop,
         unblock, hand(put_in), see(is_cancelled)}),
    row("407-canceller-02", "9.2.6.23", "a canceller that is blocked cancels none",
        {start, tell_year, tell_day, tell_month, tell_hour, tell_minute, tell_second, tell_stop,
         block, hand(put_in), see(is_not_cancelled), unblock}),
    row("407-canceller-03", "9.2.6.23", "a canceller that is in operation again cancels",
        {start, tell_year, tell_day, tell_month, tell_hour, tell_minute, tell_second, tell_stop,
         block, unblock, hand(put_in), see(is_cancelled)}),
    row("407-printer-01", "6.6", "a ticket is printed",
        {start, tell_year, tell_day, tell_month, tell_hour, tell_minute, tell_second, tell_stop,
         hand(buy), see("a ticket is printed")}),
    row("407-printer-02", "7.3", "a printer without paper says so",
        {hand(give_paper), start, wait(paper_is_seen), hand(take_paper),
         alarm(out_of_paper, 0xFFFF, paper_is_seen), hand(give_paper)}),
    row("407-printer-03", "7.3", "a printer that has paper again says so",
        {hand(give_paper), start, wait(paper_is_seen), hand(take_paper),
         alarm(out_of_paper, 0xFFFF, paper_is_seen), hand(give_paper),
         alarm(trouble_is_over, 0xFFFF, paper_is_seen)}),
};

// Passenger counter (CiA 407, 6.21): door 1 is in bits 7 (open) and 6 (valid) of 6488h:02h.
// Passengers in are in the upper byte of the count, passengers out in the lower one.

constexpr Place doors{&bus::state_of_doors_object, 2};
constexpr Place counted{&bus::passenger_counting_in_and_out_per_door_object, 0};
/// A counting manager does not allow the counts of others to be read.
constexpr Step is_counter = is(counted, 0, 0);
constexpr Step opens = put(doors, 0xC0);
constexpr Step closes = put(doors, 0x40);
constexpr Step two_come_in = hand("let two people in at the door");
constexpr Step one_goes_out = hand("let one person out at the door");

constexpr BehaviourRow counter_rows[] = {
    row("407-counter-01", "9.2.25.1", "who comes in and goes out is counted",
        {start, is_counter, closes, opens, two_come_in, one_goes_out, closes, is(counted, 0x0201)}),
    row("407-counter-02", "9.2.25.1", "what was counted is told",
        {start, is_counter, closes, opens, two_come_in, closes, tells(counted, 0x0200)}),
    row("407-counter-03", "6.21", "at a closed door nobody is counted",
        {start, is_counter, closes, opens, closes, is(counted, 0), two_come_in, stays(counted, 0)}),
    row("407-counter-04", "6.21", "each opening is counted for itself",
        {start, is_counter, closes, opens, two_come_in, closes, is(counted, 0x0200), opens,
         one_goes_out, closes, is(counted, 0x0001)}),
};

// Passenger counting manager (CiA 407, 6.22): it sums up, irrevocably.

constexpr Place total_in{&bus::total_in_out_passenger_counting_value_object, 1};
constexpr Place total_out{&bus::total_in_out_passenger_counting_value_object, 2};
constexpr Place aboard{&bus::counter_passenger_sum_object, 0};

/// The steps, from the previous count.
template <class Steps>
Verdict play_from_totals(Bench& bench, Steps steps_from) {
  const auto number_at = [&bench](const Place& place) {
    return std::int64_t{bench.number(place.index(), place.sub).value_or(0)};
  };
  return play(bench,
              {.steps = steps_from(number_at(total_in), number_at(total_out), number_at(aboard))});
}

Verdict judge_totals(Bench& bench) {
  return play_from_totals(bench,
                          [](std::int64_t in, std::int64_t out, std::int64_t) -> BehaviourSteps {
                            return {start, put(counted, 0x0302), is(total_in, in + 3),
                                    is(total_out, out + 2), put(counted, 0x0203)};
                          });
}
Verdict judge_aboard(Bench& bench) {
  return play_from_totals(bench,
                          [](std::int64_t, std::int64_t, std::int64_t before) -> BehaviourSteps {
                            return {start, put(counted, 0x0500), is(aboard, before + 5),
                                    put(counted, 0x0005), is(aboard, before)};
                          });
}
Verdict judge_aboard_told(Bench& bench) {
  return play_from_totals(
      bench, [](std::int64_t, std::int64_t, std::int64_t before) -> BehaviourSteps {
        return {start, put(counted, 0x0500), tells(aboard, before + 5), put(counted, 0x0005)};
      });
}

constexpr CaseRow manager_rows[] = {
    {"407-counting-01", "CiA 407, 9.2.26.2", "the count of a door is added to the totals",
     "6700h = 0302h; 0203h", "6721h:01h is 3 more, 6721h:02h 2 more", judge_totals},
    {"407-counting-02", "CiA 407, 9.2.26.3", "who is aboard is known", "6700h = 0500h; 0005h",
     "6722h is 5 more, then as before", judge_aboard},
    {"407-counting-03", "CiA 407, 9.2.26.3", "who is aboard is told", "6700h = 0500h; 0005h",
     "a TPDO with 6722h, 5 more", judge_aboard_told},
};

}  // namespace
}  // namespace of_407_passengers

std::vector<std::span<const BehaviourRow>> rows_of_407_passengers() {
  using namespace of_407_passengers;  // NOLINT(google-build-using-namespace): its tables
  return {ticket_rows, counter_rows};
}

void add_counting_cases(TestCases& cases) {
  add_rows(cases, Group::behaviour, of_407_passengers::manager_rows);
}

}  // namespace canvoy::conformance
