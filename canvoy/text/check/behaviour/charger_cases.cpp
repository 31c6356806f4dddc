// Behaviour of a charger with a battery that the test plays (CiA 419).
#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/text/check/behaviour/battery_partner.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

namespace index = object_index;

/// Time after which a value of the battery has arrived: its PDO is an event, or comes every 200 ms.
constexpr Duration told_by_then = 1s;
/// Time after which a missed heartbeat is a failure, with any consumer time of the charger.
constexpr Duration loss_max = 15s;
/// Time for a first heartbeat of the battery, before which none can be missed (CiA 301,
/// 7.2.8.3.2.2).
constexpr Duration heard_once = 2s;
/// Time in which 6052h increments while a current flows, and does not while none flows.
constexpr Duration counting = 30s;
/// Time for a request to take effect.
constexpr Duration stopping = 3s;
constexpr double asked_ampere = 40;

/// A row with a judge that receives the linked battery.
struct ChargerRow {
  std::string_view id;
  std::string_view clause;
  std::string_view title;
  std::string_view sends;
  std::string_view expects;
  bool moves;  ///< a current may flow
  Verdict (*judge)(Bench&, BatteryPartner&);
};

/// True if an entry gets this value.
Verdict becomes(Bench& bench, std::uint16_t at, std::uint32_t wanted, std::uint32_t mask,
                Duration within = told_by_then) {
  if (!bench.has(at)) return not_applicable(fmt::format("the device has no {:04X}h", at));
  const Time until = bench.now() + within;
  std::optional<std::uint32_t> number;
  do {
    number = bench.number(at, 0);
    if (number && ((*number ^ wanted) & mask) == 0) return passed();
    bench.listen(20ms);
  } while (!bench.is_broken() && bench.now() < until);
  if (!number) return failed(fmt::format("{:04X}h is not read", at));
  return failed(fmt::format("{:04X}h is {:X}h in place of {:X}h", at, *number & mask, wanted));
}

// Linking (CiA 419, 6.1).

Verdict judge_search(Bench&, BatteryPartner& battery) {
  return battery.was_read(index::device_type, 0) ? passed() : failed("1000h was not read");
}

Verdict judge_questions(Bench&, BatteryPartner& battery) {
  for (const std::uint16_t of : {index::tpdo_parameter, index::rpdo_parameter}) {
    bool is_asked = false;
    for (std::uint16_t i = 0; i < 3; ++i) {
      is_asked |= battery.was_read(static_cast<std::uint16_t>(of + i), 1);
    }
    if (!is_asked) return failed(fmt::format("no COB-ID from {:04X}h on was read", of));
  }
  return passed();
}

/// The COB-ID of the charger must match the PDO of the battery.
Verdict judge_linked(Bench& bench, BatteryPartner& battery, std::uint16_t own,
                     std::uint16_t other) {
  std::size_t linked = 0;
  for (std::uint16_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::uint16_t>(own + i);
    const auto cob_id = bench.has(at, 1) ? bench.number(at, 1) : std::nullopt;
    if (!cob_id || !CobId{*cob_id}.valid()) continue;
    const std::uint32_t of_battery = battery.own(static_cast<std::uint16_t>(other + i), 1);
    if ((*cob_id & Frame::id_max) != (of_battery & Frame::id_max)) {
      return failed(fmt::format("{:04X}h:01h is {:08X}h, and the battery's is {:08X}h", at, *cob_id,
                                of_battery));
    }
    ++linked;
  }
  return linked != 0 ? passed() : failed(fmt::format("none from {:04X}h on is valid", own));
}
Verdict judge_rpdos(Bench& bench, BatteryPartner& battery) {
  return judge_linked(bench, battery, index::rpdo_parameter, index::tpdo_parameter);
}
Verdict judge_tpdos(Bench& bench, BatteryPartner& battery) {
  return judge_linked(bench, battery, index::tpdo_parameter, index::rpdo_parameter);
}

Verdict judge_one_of_two(Bench& bench, BatteryPartner&) {
  if (!bench.has(index::rpdo_parameter + 1, 1)) return not_applicable("the device has no RPDO 2");
  const auto first = bench.number(index::rpdo_parameter, 1);
  const auto second = bench.number(index::rpdo_parameter + 1, 1);
  const bool has_both = first && second && CobId{*first}.valid() && CobId{*second}.valid();
  return has_both ? failed("RPDO 1 and RPDO 2 are valid at once") : passed();
}

/// Without a battery, PDOs are invalid.
Verdict judge_unlinked(Bench& bench, BatteryPartner& battery) {
  battery.fall_silent();
  bench.command(NmtCommand::reset_node);
  bench.await(can_id::error_control + bench.node(), 5s);
  bench.command(NmtCommand::enter_pre_operational);
  bench.listen(100ms);
  for (const std::uint16_t at : {index::rpdo_parameter, index::tpdo_parameter}) {
    for (std::uint16_t i = 0; i < 3; ++i) {
      const auto object = static_cast<std::uint16_t>(at + i);
      if (!bench.has(object, 1)) continue;
      const auto cob_id = bench.number(object, 1);
      if (cob_id && CobId{*cob_id}.valid()) {
        return failed(fmt::format("{:04X}h:01h is {:08X}h after a reset", object, *cob_id));
      }
    }
  }
  return passed();
}

// Values of the battery.

constexpr std::uint16_t status_index = cia419::battery_status_object.index;
constexpr std::uint16_t charger_index = cia419::charger_status_object.index;
constexpr std::uint16_t temperature_index = cia419::battery_temperature_object.index;
constexpr std::uint16_t voltage_index = cia419::battery_voltage_object.index;
constexpr std::uint16_t request_index = cia419::charge_current_requested_object.index;
constexpr std::uint16_t charge_index = cia419::battery_state_of_charge_object.index;
constexpr std::uint16_t returned_index = cia419::ah_returned_during_last_charge_object.index;
constexpr std::uint16_t estimate_index = cia419::charger_state_of_charge_object.index;
constexpr std::uint32_t ready_bit = 1;

Verdict judge_temperature(Bench& bench, BatteryPartner& battery) {
  battery.says.temperature_celsius = 21.5;
  return becomes(bench, temperature_index, 172, 0xFFFF);
}
Verdict judge_cold(Bench& bench, BatteryPartner& battery) {
  battery.says.temperature_celsius = -10;
  return becomes(bench, temperature_index, 0xFFB0, 0xFFFF);
}
Verdict judge_no_temperature(Bench& bench, BatteryPartner& battery) {
  battery.says.temperature_celsius = std::nullopt;
  return becomes(bench, temperature_index, 0xFFFF, 0xFFFF);
}
Verdict judge_voltage(Bench& bench, BatteryPartner& battery) {
  battery.says.voltage_volt = 48.5;
  return becomes(bench, voltage_index, 49664, 0xFFFF'FFFF);
}
Verdict judge_no_voltage(Bench& bench, BatteryPartner& battery) {
  battery.says.voltage_volt = std::nullopt;
  return becomes(bench, voltage_index, 0xFFFF'FFFF, 0xFFFF'FFFF);
}
Verdict judge_request(Bench& bench, BatteryPartner& battery) {
  battery.says.requested_current_ampere = 12.5;
  return becomes(bench, request_index, 200, 0xFFFF);
}
Verdict judge_no_request(Bench& bench, BatteryPartner& battery) {
  battery.says.requested_current_ampere = std::nullopt;
  return becomes(bench, request_index, 0xFFFF, 0xFFFF);
}
Verdict judge_charge(Bench& bench, BatteryPartner& battery) {
  battery.says.state_of_charge_percent = 55;
  return becomes(bench, charge_index, 55, 0xFF);
}
Verdict judge_no_charge(Bench& bench, BatteryPartner& battery) {
  battery.says.state_of_charge_percent = std::nullopt;
  return becomes(bench, charge_index, 0xFF, 0xFF);
}
Verdict judge_not_ready(Bench& bench, BatteryPartner&) {
  return becomes(bench, status_index, 0, ready_bit);
}
Verdict judge_ready(Bench& bench, BatteryPartner& battery) {
  battery.says.ready = true;
  return becomes(bench, status_index, 1, ready_bit);
}

/// More than 100 %, and no sentinel: sent by the third TPDO of the battery.
Verdict judge_beyond_range(Bench& bench, BatteryPartner& battery) {
  constexpr std::uint16_t third = index::tpdo_parameter + 2;
  if (!bench.has(charge_index)) return not_applicable("the device has no 6081h");
  battery.says.state_of_charge_percent = 55;
  if (becomes(bench, charge_index, 55, 0xFF).outcome != Outcome::passed) {
    return not_applicable("6081h does not follow the battery");
  }
  bench.send(Frame::data_frame(battery.own(third, 1) & Frame::id_max, {0x00, 0x00, 0x65}));
  const std::uint32_t now = bench.number(charge_index, 0).value_or(0xFF);
  return now <= 100 || now == 0xFF ? passed() : failed(fmt::format("6081h is {}", now));
}

// Values of the charger.

Verdict judge_charger_ready(Bench& bench, BatteryPartner& battery) {
  battery.says.ready = true;
  battery.says.requested_current_ampere = asked_ampere;
  return becomes(bench, charger_index, 1, ready_bit, 5s);
}

/// The first valid TPDO: each begins with 6001h (CiA 419, 6.2.4.3, 6.2.6.3, 6.2.8.3).
std::optional<std::uint16_t> valid_tpdo(Bench& bench) {
  for (std::uint16_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::uint16_t>(index::tpdo_parameter + i);
    const auto cob_id = bench.has(at, 1) ? bench.number(at, 1) : std::nullopt;
    if (cob_id && CobId{*cob_id}.valid()) return at;
  }
  return std::nullopt;
}

Verdict judge_period(Bench& bench, BatteryPartner&) {
  const auto at = valid_tpdo(bench);
  if (!at) return not_applicable("no TPDO is valid");
  const std::uint32_t id = bench.number(*at, 1).value_or(0) & Frame::id_max;
  const Duration period = std::chrono::milliseconds(bench.number(*at, 5).value_or(200));
  if (period == Duration{}) return not_applicable("its event timer is 0");
  bench.await(id, 2 * period);
  for (int i = 0; i < 5; ++i) {
    if (!bench.await(id, period + period / 5)) {
      return failed(fmt::format("none came in {} ms", (period + period / 5) / 1ms));
    }
  }
  return passed();
}

Verdict judge_status_in_pdo(Bench& bench, BatteryPartner&) {
  const auto at = valid_tpdo(bench);
  if (!at) return not_applicable("no TPDO is valid");
  const auto came = bench.await(bench.number(*at, 1).value_or(0) & Frame::id_max, told_by_then);
  if (!came) return failed("none came");
  const std::uint32_t status = bench.number(charger_index, 0).value_or(0);
  return came->frame.length > 0 && came->frame.data[0] == status
             ? passed()
             : failed(fmt::format("it carries {}, and 6001h is {:02X}h",
                                  text::bytes_text(came->frame.payload()), status));
}

Verdict judge_previous(Bench& bench, BatteryPartner& battery) {
  if (!bench.has(returned_index)) return not_applicable("the device has no 6052h");
  return battery.was_read(returned_index, 0) ? passed() : failed("6052h was not read");
}

// A battery that falls silent (CiA 419, 5.2).

/// Ends the heartbeats of the battery while the device reports its state.
bool lose_battery(Bench& bench, BatteryPartner& battery) {
  const bool is_watched = bench.watch_state();
  bench.listen(heard_once);
  battery.fall_silent();
  return is_watched;
}

std::optional<Verdict> wait_for_state(Bench& bench, NmtState wanted) {
  const Time until = bench.now() + loss_max;
  std::optional<NmtState> state;
  while (!bench.is_broken() && bench.now() < until) {
    state = bench.state();
    if (state == wanted) return std::nullopt;
    bench.listen(50ms);
  }
  return failed(state ? fmt::format("it is {}", text::nmt_state_text(*state))
                      : std::string("it tells no state"));
}

Verdict judge_loss(Bench& bench, BatteryPartner& battery) {
  if (!lose_battery(bench, battery)) return not_applicable("the device does not tell its state");
  return wait_for_state(bench, NmtState::pre_operational).value_or(passed());
}

Verdict judge_loss_is_told(Bench& bench, BatteryPartner& battery) {
  const std::uint32_t id = emergency_id(bench);
  bench.listen(heard_once);
  battery.fall_silent();
  const Time until = bench.now() + loss_max;
  while (!bench.is_broken() && bench.now() < until) {
    const auto came = bench.await(id, until - bench.now());
    if (came && came->frame.length == 8 && error_code(came->frame) == 0x8130) return passed();
  }
  return failed("no emergency 8130h within 15 s");
}

Verdict judge_loss_with_behaviour(Bench& bench, BatteryPartner& battery) {
  constexpr unsigned no_change = 1;
  const Reply done = bench.set(index::error_behaviour, 1, no_change, 1);
  if (!done) return cannot_set("1029h:01h", done);
  if (!lose_battery(bench, battery)) return not_applicable("the device does not tell its state");
  bench.listen(loss_max);
  const auto state = bench.state();
  return state == NmtState::operational ? passed() : failed("it has left operational");
}

Verdict judge_alone(Bench& bench, BatteryPartner& battery) {
  battery.says.ready = true;
  if (becomes(bench, status_index, 1, ready_bit).outcome != Outcome::passed) {
    return not_applicable("6000h does not follow the battery");
  }
  battery.fall_silent();
  bench.listen(loss_max);
  return becomes(bench, charger_index, 0, ready_bit);
}

// Current flow, as counted by 6052h.

/// Nothing if it increases while the battery requests a current.
std::optional<Verdict> begin_to_charge(Bench& bench, BatteryPartner& battery) {
  if (!bench.has(returned_index)) return not_applicable("the device has no 6052h");
  battery.says.ready = true;
  battery.says.requested_current_ampere = asked_ampere;
  if (becomes(bench, charger_index, 1, ready_bit, 5s).outcome != Outcome::passed) {
    return not_applicable("it does not become ready");
  }
  bench.listen(stopping);
  const auto before = bench.number(returned_index, 0);
  bench.listen(counting);
  const auto after = bench.number(returned_index, 0);
  if (before && after && *after > *before) return std::nullopt;
  return not_applicable("6052h does not grow: no current flows");
}

/// It delivers no more than the battery asks for, and so counts no more: 40 A for the time of
/// counting, in eighths of an ampere-hour, and one for the fraction at each end. A charger without
/// a load counts nothing, and is not judged.
Verdict judge_counts(Bench& bench, BatteryPartner& battery) {
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  const auto before = bench.number(returned_index, 0);
  bench.listen(counting);
  const auto after = bench.number(returned_index, 0);
  if (!before || !after) return failed("6052h is not read");
  constexpr auto seconds = std::chrono::duration_cast<std::chrono::seconds>(counting).count();
  constexpr double most = asked_ampere * static_cast<double>(seconds) / 3600 * 8 + 2;
  const bool is_within = *after >= *before && *after - *before <= most;
  return is_within ? passed()
                   : failed(fmt::format("6052h goes from {} to {} in 30 s at {} A", *before, *after,
                                        asked_ampere));
}

Verdict stands_still(Bench& bench) {
  bench.listen(stopping);
  const auto before = bench.number(returned_index, 0);
  bench.listen(counting);
  const auto after = bench.number(returned_index, 0);
  if (before && before == after) return passed();
  return failed(fmt::format("6052h goes on from {} to {}", before.value_or(0), after.value_or(0)));
}

Verdict judge_stop_not_ready(Bench& bench, BatteryPartner& battery) {
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  battery.says.ready = false;
  return stands_still(bench);
}
Verdict judge_stop_no_request(Bench& bench, BatteryPartner& battery) {
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  battery.says.requested_current_ampere = 0;
  return stands_still(bench);
}
Verdict judge_stop_invalid_request(Bench& bench, BatteryPartner& battery) {
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  battery.says.requested_current_ampere = std::nullopt;
  return stands_still(bench);
}
Verdict judge_stop_silent(Bench& bench, BatteryPartner& battery) {
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  battery.fall_silent();
  bench.listen(loss_max);
  return stands_still(bench);
}

Verdict judge_written_back(Bench& bench, BatteryPartner& battery) {
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  battery.says.state_of_charge_percent = 100;
  battery.says.requested_current_ampere = 0;
  battery.says.ready = false;
  bench.listen(5s);
  return battery.was_written(returned_index, 0) ? passed() : failed("6052h was not written");
}

Verdict judge_estimate(Bench& bench, BatteryPartner& battery) {
  if (!bench.has(estimate_index)) return not_applicable("the device has no 6080h");
  if (auto cannot = begin_to_charge(bench, battery)) return *cannot;
  const std::uint32_t now = bench.number(estimate_index, 0).value_or(0xFE);
  return now <= 100 || now == 0xFF ? passed() : failed(fmt::format("6080h is {}", now));
}

constexpr std::string_view a_battery = "a battery that the test plays";
constexpr ChargerRow charger_rows[] = {
    {"419-link-01", "CiA 419, 6.1", "it looks for a battery module", a_battery,
     "an upload of 1000h", false, judge_search},
    {"419-link-02", "CiA 419, 6.1", "it reads the COB-IDs of the battery's PDOs", a_battery,
     "uploads of 1400h:01h and 1800h:01h, or of those above", false, judge_questions},
    {"419-link-03", "CiA 419, 6.1", "its RPDOs take the COB-IDs of the battery's TPDOs", a_battery,
     "the same in 1400h:01h to 1402h:01h", false, judge_rpdos},
    {"419-link-04", "CiA 419, 6.1", "its TPDOs take the COB-IDs of the battery's RPDOs", a_battery,
     "the same in 1800h:01h to 1802h:01h", false, judge_tpdos},
    {"419-link-05", "CiA 419, 6.2.5.1", "RPDO 2 is in the place of RPDO 1", a_battery,
     "one of them is not valid", false, judge_one_of_two},
    {"419-link-06", "CiA 419, 6.1", "without a battery its PDOs are not valid", "NMT 81h",
     "bit 31 in 1400h:01h and 1800h:01h, and those above", false, judge_unlinked},
    {"419-link-07", "CiA 419, 7.2.4", "it reads what was returned during the charge before",
     a_battery, "an upload of 6052h", false, judge_previous},
    {"419-battery-01", "CiA 419, 7.2.3", "the battery's temperature is taken", "21.5 degC by PDO",
     "6010h = 172", false, judge_temperature},
    {"419-battery-02", "CiA 419, 7.2.3", "a temperature below 0 is taken", "-10 degC by PDO",
     "6010h = FFB0h", false, judge_cold},
    {"419-battery-03", "CiA 419, 7.2.3", "an invalid temperature is taken as invalid",
     "FFFFh by PDO", "6010h = FFFFh", false, judge_no_temperature},
    {"419-battery-04", "CiA 419, 7.2.5", "the battery's voltage is taken", "48.5 V by PDO",
     "6060h = 49664", false, judge_voltage},
    {"419-battery-05", "CiA 419, 7.2.5", "an invalid voltage is taken as invalid",
     "FFFF FFFFh by PDO", "6060h = FFFF FFFFh", false, judge_no_voltage},
    {"419-battery-06", "CiA 419, 7.2.6", "the requested current is taken", "12.5 A by PDO",
     "6070h = 200", false, judge_request},
    {"419-battery-07", "CiA 419, 7.2.6", "an invalid request is taken as invalid", "FFFFh by PDO",
     "6070h = FFFFh", false, judge_no_request},
    {"419-battery-08", "CiA 419, 7.2.8", "the battery's state of charge is taken", "55 % by PDO",
     "6081h = 55", false, judge_charge},
    {"419-battery-09", "CiA 419, 7.2.8", "an invalid state of charge is taken as invalid",
     "FFh by PDO", "6081h = FFh", false, judge_no_charge},
    {"419-battery-10", "CiA 419, 7.2.8", "a state of charge out of its range is not taken",
     "101 % by PDO", "6081h is 100 at most, or FFh", false, judge_beyond_range},
    {"419-battery-11", "CiA 419, 7.2.1", "a battery that is not ready is not ready", "0 by PDO",
     "6000h, bit 0 = 0", false, judge_not_ready},
    {"419-battery-12", "CiA 419, 7.2.1", "a battery that is ready is ready", "1 by PDO",
     "6000h, bit 0 = 1", true, judge_ready},
    {"419-status-01", "CiA 419, 6.2.4.1", "it sends its status periodically", a_battery,
     "a TPDO in each event time", false, judge_period},
    {"419-status-02", "CiA 419, 6.2.4.3", "its TPDO begins with its status", a_battery, "6001h",
     false, judge_status_in_pdo},
    {"419-status-03", "CiA 419, 7.2.2", "it is ready to deliver a charge to a battery that is",
     "ready, 40 A by PDO", "6001h, bit 0 = 1 within 5 s", true, judge_charger_ready},
    {"419-loss-01", "CiA 419, 5.2", "a battery whose heartbeat is lost is a device failure",
     "the battery falls silent", "pre-operational within 15 s", false, judge_loss},
    {"419-loss-02", "CiA 419, 5.1", "the lost heartbeat is an emergency",
     "the battery falls silent", "EMCY 8130h within 15 s", false, judge_loss_is_told},
    {"419-loss-03", "CiA 419, 5.2", "with 1029h:01h = 1 it remains as it is",
     "1029h:01h = 1; the battery falls silent", "operational", false, judge_loss_with_behaviour},
    {"419-loss-04", "CiA 419, 7.2.2", "without its battery it is not ready to deliver a charge",
     "ready by PDO; the battery falls silent", "6001h, bit 0 = 0", true, judge_alone},
    {"419-charge-01", "CiA 419, 7.2.4", "it counts what it delivers", "ready, 40 A by PDO",
     "6052h grows in 30 s, by no more than 40 A deliver", true, judge_counts},
    {"419-charge-02", "CiA 419, 7.2.1", "it stops where the battery is not ready any more",
     "ready, 40 A; not ready", "6052h stands still", true, judge_stop_not_ready},
    {"419-charge-03", "CiA 419, 7.2.6", "it stops where the battery asks for no current",
     "ready, 40 A; 0 A", "6052h stands still", true, judge_stop_no_request},
    {"419-charge-04", "CiA 419, 7.2.6", "it stops where the request is invalid",
     "ready, 40 A; FFFFh", "6052h stands still", true, judge_stop_invalid_request},
    {"419-charge-05", "CiA 419, 5.2", "it stops where the battery falls silent",
     "ready, 40 A; nothing more", "6052h stands still", true, judge_stop_silent},
    {"419-charge-06", "CiA 419, 7.2.4", "it writes back what was returned", "40 A; full, not ready",
     "a download of 6052h within 5 s", true, judge_written_back},
    {"419-charge-07", "CiA 419, 7.2.7", "its estimate stays within its range", "ready, 40 A by PDO",
     "6080h is 100 at most, or FFh", true, judge_estimate},
};

Verdict judge_charger(Bench& bench, const ChargerRow& row) {
  if (row.moves && !bench.options().moves) {
    return not_applicable("a current may flow: with --moves only");
  }
  BatteryPartner battery(bench);
  if (auto cannot = battery.wait_until_linked()) return *cannot;
  return row.judge(bench, battery);
}

}  // namespace

void add_charger_cases(TestCases& cases) {
  for (const ChargerRow& row : charger_rows) {
    cases.push_back({std::string(row.id), Group::behaviour, std::string(row.clause),
                     std::string(row.title), std::string(row.sends), std::string(row.expects),
                     [&row](Bench& bench) { return judge_charger(bench, row); }});
  }
}

}  // namespace canvoy::conformance
