// Hands of the devices of a taxi: meter, printer, clock, card of the driver, sign, alarm (CiA
// 447-3, 4.2.12 to 4.2.17).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/formats/eds/ini.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/device/car/gps_hands.hpp"
#include "canvoy/tools/device/hand/hand_rows.hpp"

namespace canvoy::tools {

namespace taxi_hand_rows {
namespace {

using namespace hand_rows;
using namespace cia447;

constexpr double money_steps = 1000;  ///< of 60D0h, in a unit of the currency
constexpr std::uint8_t all = WithoutHand::all;

constexpr WithoutHand meter_without[] = {{0x60D0, 1, all, "the fare follows the trip"},
                                         {0x60D0, 3, all, "fare and supplements"},
                                         {0x60D0, 5, all, "the tariff's"},
                                         {0x60D0, 6, all, "the tariff's"},
                                         {0x60D1, all, all, "counted from 6055h"},
                                         {0x60D2, 1, all, "follows the trip"},
                                         {0x60D2, 2, all, "follows the trip"},
                                         {0x60D2, 4, all, "follows stop, and clock"},
                                         {0x60D4, all, all, "the tariff's"},
                                         {0x60D9, all, all, "sums of trips and shifts"},
                                         {0x60DA, 3, all, "the tariff's"},
                                         {0x60DA, 4, all, "the maker's"},
                                         {0x60DA, 5, all, "the maker's"},
                                         {0x60DA, 6, all, "follows leave-service"},
                                         {0x60DA, 7, all, "at the start: --future-tariff"},
                                         {0x60DA, 8, all, "the maker's"},
                                         {0x60DA, 9, all, "the maker's"},
                                         {0x60DB, all, all, "counts changes of the trip"}};
constexpr WithoutHand printer_without[] = {{0x60E2, all, all, "the maker's: what it is able to"},
                                           {0x60E3, all, all, "follows 60E5h"},
                                           {0x60E4, all, all, "the maker's: what it is able to"},
                                           {0x60E6, all, all, "follows 60E5h"},
                                           {0x60EA, all, all, "follows 60E9h"}};
constexpr WithoutHand clock_without[] = {
    {0x60F4, all, all, "the maker's, and whether the time was set"},
    {0x60F5, all, all, "the maker's: UTC here"}};
constexpr WithoutHand sign_without[] = {
    {0x6100, all, all, "the maker's, and what 6108h says"},
    {0x6104, all, all, "follows 6106h, and lamp-failure-1 to 8"},
    {0x6105, all, all, "follows 6107h, and lamp-failure-9 to 16"}};

std::uint32_t money(const HandValue& value) {
  return static_cast<std::uint32_t>(std::llround(value.number * money_steps));
}

template <class Act>
DeviceHand meter_key(const char* name, Act act) {
  return action<TaximeterUnit>(name, whole(taximeter_status_object), act);
}

/// A meter with a tamper record is for hire, and starts no trip.
std::string why_no_trip(const HandTarget& target) {
  const TaximeterRecord& record = target.as<TaximeterUnit>().record();
  if (record.state != Taximeter::for_hire || record.tampering == 0) return "";
  const bool is_seal = (record.tampering & tampering::seal) != 0;
  return fmt::format(
      "refused for tampering: {}; it is to be sealed anew in service mode",
      is_seal ? "the seal was opened" : "the wheel pulses have another source or sender");
}

DeviceHand hire_key() {
  DeviceHand hand = meter_key("hire", [](TaximeterUnit& meter) { return meter.hire(); });
  hand.why = why_no_trip;
  return hand;
}

std::vector<DeviceHand> meter_states() {
  using Meter = TaximeterUnit;
  return {meter_key("sign-on", [](Meter& meter) { return meter.sign_on(); }),
          hire_key(),
          meter_key("stop", [](Meter& meter) { return meter.stop(); }),
          meter_key("for-hire", [](Meter& meter) { return meter.for_hire(); }),
          meter_key("sign-off", [](Meter& meter) { return meter.sign_off(); }),
          meter_key("standby", [](Meter& meter) { return meter.standby(); }),
          meter_key("wake", [](Meter& meter) { return meter.wake(); }),
          meter_key("turn-off", [](Meter& meter) { return meter.turn_off(); })};
}

/// Index in the supplements of the tariff; their number if it is none of them.
unsigned service_of(const TaximeterUnit& meter, const HandValue& value) {
  const auto& kinds = meter.tariff().supplements;
  const auto is_it = [&value](const SupplementKind& kind) {
    return formats::same_letters(kind.name, value.text);
  };
  return static_cast<unsigned>(std::ranges::find_if(kinds, is_it) - kinds.begin());
}

/// The tariff does not have it, or no passenger is in the car.
std::string why_no_service(const HandTarget& target) {
  const auto& meter = target.as<TaximeterUnit>();
  const bool has_trip = meter.state() == Taximeter::hired || meter.state() == Taximeter::stopped;
  if (!has_trip) return "";
  std::string names;
  for (const SupplementKind& kind : meter.tariff().supplements) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
  }
  return fmt::format("the tariff has no such supplement; there are {}", names);
}

DeviceHand service_key() {
  DeviceHand hand = text<TaximeterUnit>(
      "service", {place_of(taxi_trip_payment_supplement_charge)}, "luggage",
      [](const HandValue& value) {
        if (!value.text.empty()) return;
        throw UsageError("write the name of a supplement, as luggage");
      },
      [](TaximeterUnit& meter, const HandValue& value) {
        return meter.charge(service_of(meter, value));
      });
  hand.why = why_no_service;
  return hand;
}

std::vector<DeviceHand> meter_trip() {
  using Meter = TaximeterUnit;
  constexpr HandRange amounts = {0, 1'000'000, "of the currency"};
  return {
      service_key(),
      number<Meter>(
          "supplement", place_of(taxi_trip_payment_supplement_charge), amounts,
          [](Meter& meter, const HandValue& value) { return meter.add_supplement(money(value)); }),
      action<Meter>("clear-supplements", place_of(taxi_trip_payment_supplement_charge),
                    [](Meter& meter) { return meter.clear_supplements(); }),
      number<Meter>(
          "agreed-price", whole(taxi_trip_payment_object, 4), amounts,
          [](Meter& meter, const HandValue& value) { return meter.agree_price(money(value)); }),
      number<Meter>("level", whole(taxi_trip_tariff_level_object), {1, 254, "of the tariff"},
                    [](Meter& meter, const HandValue& value) {
                      const bool is_whole = std::floor(value.number) == value.number;
                      return is_whole &&
                             meter.choose_level(static_cast<unsigned>(value.number) - 1);
                    }),
      action<Meter>("level-by-clock", whole(taxi_trip_tariff_level_object),
                    [](Meter& meter) { meter.choose_level_by_clock(); }),
      around(text<Meter>("clock", {whole(taxi_trip_time_information_object, 3)},
                         "2026-10-25T00:59:50", check_clock_text,
                         [](Meter& /*meter*/, const HandValue& value, const HandTarget& target) {
                           target.car->set_clock(CarClock::meter, parse_clock_text(value.text));
                           return true;
                         }))};
}

std::vector<DeviceHand> meter_seal() {
  using Meter = TaximeterUnit;
  const auto seal = [](const char* name, bool is_open) {
    return around(
        meter_key(name, [is_open](Meter& /*meter*/, const HandValue&, const HandTarget& target) {
          *target.seal_is_open = is_open;
          return true;
        }));
  };
  const FieldPlace k = whole(taximeter_configuration_object, 1);
  return {
      seal("open-seal", true),
      seal("close-seal", false),
      meter_key("enter-service", [](Meter& meter) { return meter.enter_service(); }),
      meter_key("leave-service", [](Meter& meter) { return meter.leave_service(); }),
      action<Meter>("begin-calibration", k, [](Meter& meter) { return meter.begin_calibration(); }),
      around(action<Meter>("end-calibration", k,
                           [](Meter& meter, const HandValue&, const HandTarget& target) {
                             return meter.end_calibration(target.calibration);
                           })),
      number<Meter>("k", k, {1, 10'000'000, "pulses for a kilometre"},
                    [](Meter& meter, const HandValue& value) {
                      return meter.set_k(static_cast<std::uint32_t>(value.number));
                    }),
      choice<Meter>("mode", whole(taximeter_configuration_object, 2), {"taximeter", "odometer"},
                    [](Meter& meter, const HandValue& value) {
                      return meter.set_mode(static_cast<TaximeterMode>(value.code));
                    })};
}

CarHandTable meter_hands() {
  CarHandTable table{.device = TaximeterKind::info.name, .without = meter_without};
  for (auto& part : {meter_states(), meter_trip(), meter_seal()}) {
    table.rows.insert(table.rows.end(), part.begin(), part.end());
  }
  return table;
}

CarHandTable printer_hands() {
  CarHandTable table{.device = PrinterKind::info.name, .without = printer_without};
  table.rows = {choice<PrinterUnit>("paper", whole(printer_errors_object), {"no", "yes"},
                                    [](PrinterUnit& unit, const HandValue& value) {
                                      unit.sense_paper(value.code == 1);
                                    }),
                choice<PrinterUnit>("mechanism", whole(printer_status_object),
                                    {"working", "standby", "failure"},
                                    [](PrinterUnit& unit, const HandValue& value) {
                                      unit.sense(static_cast<PrinterMechanism>(value.code));
                                    })};
  return table;
}

CarHandTable clock_hands() {
  CarHandTable table{.device = RealTimeClockKind::info.name, .without = clock_without};
  table.rows = {text<RealTimeClockUnit>("time", {whole(rtc_date_object), whole(rtc_time_object)},
                                        "2026-10-25T00:59:50", check_clock_text,
                                        [](RealTimeClockUnit& unit, const HandValue& value) {
                                          unit.set(parse_clock_text(value.text));
                                        })};
  return table;
}

/// `4711` or `4711:A. Driver`
DriverCard card_of(const HandValue& value) {
  DriverCard card;
  const std::string& text = value.text;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, card.id);
  const bool has_name = stop != end && *stop == ':' && stop + 1 != end;
  if (error != std::errc{} || (stop != end && !has_name)) {
    throw UsageError(
        fmt::format("'{}' is no card: write its number, as 4711, or number and name, "
                    "as '4711:A. Driver'",
                    text));
  }
  if (has_name) card.name = std::string_view(stop + 1, static_cast<std::size_t>(end - stop - 1));
  return card;
}

CarHandTable driver_hands() {
  using Unit = DriverIdentificationUnit;
  const FieldPlace failure = place_of(driver_id_status_system_failure);
  CarHandTable table{.device = DriverIdentificationKind::info.name};
  table.rows = {
      text<Unit>(
          "card",
          {whole(unique_driver_id_object), whole(drivers_name_object),
           place_of(driver_id_status_logged_in), whole(driver_login_and_logout_time_object, 1)},
          "'4711:A. Driver'", [](const HandValue& value) { card_of(value); },
          [](Unit& unit, const HandValue& value) { return unit.log_in(card_of(value)); }),
      action<Unit>("remove-card", whole(driver_login_and_logout_time_object, 2),
                   [](Unit& unit) { return unit.log_out(); }),
      action<Unit>("unreadable-card", failure, [](Unit& unit) { unit.card_is_unreadable(); }),
      action<Unit>("forget-failure", failure, [](Unit& unit) { unit.forget_failure(); }),
      choice<Unit>("reader", place_of(driver_id_status_data_state),
                   {"working", "failure", "not-available"}, [](Unit& unit, const HandValue& value) {
                     unit.reader_is(static_cast<CardReader>(value.code));
                   })};
  return table;
}

/// Lamp or input of a field: two bits each of 6103h, four of 6101h and 6102h.
unsigned sign_number(const FieldPlace& place) {
  const unsigned number = place.first_bit / unsigned{place.bits} + 1;
  return place.index == tariff_display_lamp_failures_2_object.index ? number + 8 : number;
}

CarHandTable sign_hands() {
  CarHandTable table{.device = TariffDisplayKind::info.name, .without = sign_without};
  table.rows = {text<TariffDisplayUnit>(
      "level", {whole(tariff_display_tariff_level_object)}, "2",
      [](const HandValue& value) {
        if (value.text.size() <= 2) return;
        throw UsageError(fmt::format("'{}': a level has one or two characters", value.text));
      },
      [](TariffDisplayUnit& unit, const HandValue& value) {
        const std::string& text = value.text;
        unit.show_level({text[0], text.size() == 2 ? text[1] : '\0'});
      })};
  table.tell = [](const HandTarget& target, const FieldPlace& place, const HandValue& value) {
    auto& sign = target.as<TariffDisplayUnit>();
    const unsigned number = sign_number(place);
    if (place.index == tariff_display_inputs_status_object.index) {
      sign.set_input(number, static_cast<Signal>(value.code));
    } else {
      sign.lamp_failed(number, static_cast<LampFailure>(value.code));
    }
  };
  table.name = [](const FieldPlace& place) {
    const bool is_input = place.index == tariff_display_inputs_status_object.index;
    return fmt::format("{}-{}", is_input ? "input" : "lamp-failure", sign_number(place));
  };
  return table;
}

CarHandTable alarm_hands() {
  using Unit = TaxiAlarmUnit;
  const auto raise = [](const char* name, const FieldPlace& place, AlarmKind kind) {
    return action<Unit>(name, place, [kind](Unit& unit) { unit.raise_alarm(kind); });
  };
  const auto with_sensor = [](DeviceHand hand) {
    hand.words.push_back({"failure", 2, Meaning::failure});
    hand.words.push_back({"not-available", 3, Meaning::invalid});
    return hand;
  };
  CarHandTable table{.device = TaxiAlarmKind::info.name};
  table.rows = {
      with_sensor(key<Unit>("alarm", place_of(taxi_alarm_system_status_key_pressed),
                            [](Unit& unit, const HandValue& value) {
                              unit.press_key(static_cast<Signal>(value.code));
                            })),
      with_sensor(key<Unit>("remote-alarm", place_of(taxi_alarm_system_status_remote_key_pressed),
                            [](Unit& unit, const HandValue& value) {
                              unit.press_remote_key(static_cast<Signal>(value.code));
                            })),
      raise("silent-alarm", place_of(taxi_alarm_system_status_silent_activated), AlarmKind::silent),
      raise("full-alarm", place_of(taxi_alarm_system_status_full_activated), AlarmKind::full),
      action<Unit>("radio-has-called",
                   place_of(taxi_alarm_system_status_radio_emergency_call_requested),
                   [](Unit& unit) { unit.radio_has_called(); }),
      action<Unit>("reset", whole(taxi_alarm_system_status_object),
                   [](Unit& unit) { unit.reset_alarm(); })};
  return table;
}

std::vector<CarHandTable> all_tables() {
  return {meter_hands(),  printer_hands(), clock_hands(),
          driver_hands(), sign_hands(),    alarm_hands()};
}

}  // namespace
}  // namespace taxi_hand_rows

std::vector<CarHandTable> taxi_hands() {
  return taxi_hand_rows::all_tables();
}

}  // namespace canvoy::tools
