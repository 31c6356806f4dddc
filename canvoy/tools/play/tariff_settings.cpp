#include "canvoy/tools/play/tariff_settings.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

namespace canvoy::tools {

namespace {

using cia447::TariffHours;
using cia447::TariffLevel;
using taxi::AgreedPrices;
using taxi::Business;
using taxi::TaxiOptions;

constexpr double thousandths = 1000;  ///< of the currency unit, as in amounts of a taximeter
constexpr double amount_max = 100'000;
constexpr std::size_t levels_max = 20;
constexpr std::size_t hours_max = 50;
constexpr std::size_t holidays_max = 400;
constexpr unsigned minutes_of_hour = 60;
constexpr unsigned minutes_of_day = 24 * minutes_of_hour;

struct Days {
  std::string_view name;
  std::uint8_t bits;
};
constexpr Days days_names[] = {{"weekdays", cia447::on_mondays_to_fridays},
                               {"saturdays", cia447::on_saturdays},
                               {"sundays", cia447::on_sundays},
                               {"holidays", cia447::on_holidays}};

/// An integer of this number of thousandths; the words state the error otherwise.
std::uint32_t whole_amount(double wanted, std::uint32_t unit, std::string_view otherwise) {
  const double counted = std::round(wanted * thousandths / unit);
  if (std::abs(counted - wanted * thousandths / unit) > 1e-6) {
    throw UsageError(fmt::format("{} {}", wanted, otherwise));
  }
  return static_cast<std::uint32_t>(counted) * unit;
}

/// A price: in units of the currency in a file, in thousandths here, from `least` on.
template <auto member, class Owner = TariffLevel>
Setting<Owner> amount(std::string key, double least, std::uint32_t unit, std::string otherwise,
                      std::string help) {
  return mapped<Owner, double>(
      {.key = std::move(key),
       .takes = fmt::format("a number from {} to {}", least, amount_max),
       .read = [unit, otherwise = std::move(otherwise)](
                   Owner& owner,
                   double wanted) { owner.*member = whole_amount(wanted, unit, otherwise); },
       .write = [](const Owner& owner) { return owner.*member / thousandths; },
       .range = {least, amount_max}},
      std::move(help));
}
/// For a distance or a time unit: fares use the result of whole steps.
template <auto member>
Setting<TariffLevel> rate(std::string key, std::string help = {}) {
  return amount<member>(std::move(key), 0, 1, "is no whole number of thousandths", std::move(help));
}
std::string otherwise_than(std::uint32_t coin) {
  return fmt::format(
      "is no whole number of coins, of which nobody can pay a part: take a multiple of {}",
      coin / thousandths);
}

/// Shown, printed and paid as it is.
template <auto member, class Owner = TariffLevel>
Setting<Owner> payable(std::string key, std::uint32_t coin, double least = 0,
                       std::string help = {}) {
  return amount<member, Owner>(std::move(key), least, coin, otherwise_than(coin), std::move(help));
}

std::string level_name(const TariffLevel& level) {
  std::string name;
  for (const char character : level.name) {
    if (character != 0) name += character;
  }
  return name;
}

std::array<char, 2> name_of_level(const std::string& name) {
  const bool is_name = !name.empty() && name.size() <= 2 &&
                       std::ranges::all_of(name, [](char one) { return one > ' ' && one < 0x7F; });
  if (!is_name) {
    throw UsageError(
        fmt::format("{} is no name of one or two characters of ASCII", text_value(name)));
  }
  return {name[0], name.size() == 2 ? name[1] : '\0'};
}

/// `22:00`, up to `24:00`.
std::optional<std::uint16_t> minutes_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.size() - colon != 3) return std::nullopt;
  unsigned hour = 0;
  unsigned minute = 0;
  const auto is_number = [](std::string_view part, unsigned& number) {
    const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    return error == std::errc{} && stop == part.data() + part.size();
  };
  const bool is_time = is_number(text.substr(0, colon), hour) &&
                       is_number(text.substr(colon + 1), minute) && hour <= 24 &&
                       minute < minutes_of_hour;
  const unsigned minutes = hour * minutes_of_hour + minute;
  if (!is_time || minutes > minutes_of_day) return std::nullopt;
  return static_cast<std::uint16_t>(minutes);
}
/// `from = "22:00"`
template <auto member>
Setting<TariffHours> time_of_day(std::string key) {
  return mapped<TariffHours, std::string>(
      {.key = std::move(key),
       .takes = "a time of day, as `\"22:00\"`",
       .read =
           [](TariffHours& hours, const std::string& text) {
             const auto minutes = minutes_of(text);
             if (!minutes)
               throw UsageError(fmt::format("{} is no time as \"22:00\"", text_value(text)));
             hours.*member = *minutes;
           },
       .write =
           [](const TariffHours& hours) {
             return fmt::format("{}:{:02}", hours.*member / minutes_of_hour,
                                hours.*member % minutes_of_hour);
           }});
}

/// `12-25`, or `2026-04-03`.
std::optional<cia447::Holiday> holiday_of(std::string_view text) {
  constexpr std::size_t year_length = 4;
  unsigned parts[3] = {};  // year, month, day
  const bool has_year = text.size() == std::string_view("2026-04-03").size();
  if (!has_year && text.size() != std::string_view("12-25").size()) return std::nullopt;
  std::size_t at = 0;
  for (std::size_t part = has_year ? 0 : 1; part < 3; ++part) {
    const std::size_t length = part == 0 ? year_length : 2;
    const char* const end = text.data() + at + length;
    const auto [stop, error] = std::from_chars(text.data() + at, end, parts[part]);
    if (error != std::errc{} || stop != end) return std::nullopt;
    at += length;
    if (at < text.size() && text[at++] != '-') return std::nullopt;
  }
  // A year without a date has the days of a leap year.
  constexpr int some_leap_year = 2024;
  const std::chrono::year_month_day date{
      std::chrono::year(has_year ? static_cast<int>(parts[0]) : some_leap_year),
      std::chrono::month(parts[1]), std::chrono::day(parts[2])};
  if (!date.ok() || (has_year && parts[0] == 0)) return std::nullopt;
  return cia447::Holiday{static_cast<std::uint16_t>(parts[0]), static_cast<std::uint8_t>(parts[1]),
                         static_cast<std::uint8_t>(parts[2])};
}
std::string holiday_text(const cia447::Holiday& holiday) {
  const std::string day = fmt::format("{:02}-{:02}", holiday.month, holiday.day);
  return holiday.year == 0 ? day : fmt::format("{:04}-{}", holiday.year, day);
}

Setting<TariffHours> days_setting() {
  using Texts = std::vector<std::string>;
  return mapped<TariffHours, Texts>(
      {.key = "days",
       .takes = "a list of `weekdays`, `saturdays`, `sundays`, `holidays`",
       .read =
           [](TariffHours& hours, const Texts& days) {
             hours.days = 0;
             for (const std::string& day : days) {
               const auto* const found = std::ranges::find(days_names, day, &Days::name);
               if (found == std::end(days_names)) {
                 throw UsageError(fmt::format(
                     "{} is none of weekdays, saturdays, sundays, holidays", text_value(day)));
               }
               hours.days = static_cast<std::uint8_t>(hours.days | found->bits);
             }
           },
       .write =
           [](const TariffHours& hours) {
             Texts days;
             for (const Days& each : days_names) {
               if ((hours.days & each.bits) == each.bits) days.emplace_back(each.name);
             }
             return days;
           }});
}

/// The levels for hours: of the file, or of the example.
std::vector<TariffLevel> levels_of(const TaxiRun& run) {
  const auto& levels = run.network.meter.tariff.levels;
  return run.tariff->levels.empty() ? std::vector<TariffLevel>(levels.begin(), levels.end())
                                    : run.tariff->levels;
}

Setting<TariffHours> level_of_hours(const std::vector<TariffLevel>& levels) {
  return mapped<TariffHours, std::string>(
      {.key = "level",
       .takes = "the name of a level",
       .read =
           [levels](TariffHours& hours, const std::string& name) {
             const auto level = std::ranges::find(levels, name_of_level(name), &TariffLevel::name);
             if (level == levels.end()) throw UsageError("there is no such level of the tariff");
             hours.level = static_cast<std::uint8_t>(level - levels.begin());
           },
       .write = [levels](const TariffHours& hours) { return level_name(levels[hours.level]); },
       .is_needed = true});
}

FilePart<TaxiRun> tariff_levels() {
  return several<TaxiRun, TariffLevel>(
      [](const TaxiRun& run) {
        const std::uint32_t coin = run.network.meter.currency.coin;
        const auto name = mapped<TariffLevel, std::string>(
            {.key = "level",
             .takes = "one or two characters of ASCII",
             .read = [](TariffLevel& level,
                        const std::string& name) { level.name = name_of_level(name); },
             .write = [](const TariffLevel& level) { return level_name(level); },
             .is_needed = true});
        return SettingTable<TariffLevel>{
            "tariff",
            "",
            {name, payable<&TariffLevel::initial_fare>("initial_fare", coin),
             payable<&TariffLevel::minimum_fare>("minimum_fare", coin),
             rate<&TariffLevel::distance_rate>("per_km"),
             rate<&TariffLevel::time_rate>("per_hour",
                                           "of waiting: below the speed at which it "
                                           "costs more than the way"),
             payable<&TariffLevel::increment>("step", coin, coin / thousandths,
                                              "by which the fare grows")}};
      },
      [](const TaxiRun& run) {
        const auto& levels = run.network.meter.tariff.levels;
        return std::vector<TariffLevel>(levels.begin(), levels.end());
      },
      [](const TomlTable& table, TaxiRun& run, TariffLevel level) {
        std::vector<TariffLevel>& levels = run.tariff->levels;
        if (std::ranges::find(levels, level.name, &TariffLevel::name) != levels.end()) {
          table.refuse("level", "there is one of this name already");
        }
        if (levels.size() == levels_max)
          table.refuse(fmt::format("there are more than {} levels", levels_max));
        if (level.increment == 0) level.increment = run.network.meter.currency.coin;
        levels.push_back(level);
      });
}

FilePart<TaxiRun> tariff_hours() {
  return several<TaxiRun, TariffHours>(
      [](const TaxiRun& run) {
        return SettingTable<TariffHours>{
            "tariff_hours",
            "the first that fit hold; else the first level",
            {level_of_hours(levels_of(run)), days_setting(),
             time_of_day<&TariffHours::from>("from"), time_of_day<&TariffHours::to>("to")}};
      },
      [](const TaxiRun& run) {
        const auto& hours = run.network.meter.tariff.hours;
        return std::vector<TariffHours>(hours.begin(), hours.end());
      },
      [](const TomlTable& table, TaxiRun& run, TariffHours hours) {
        if (run.tariff->levels.empty())
          table.refuse("level", "there is no such level of the tariff");
        if (run.tariff->hours.size() == hours_max) {
          table.refuse(fmt::format("there are more than {} of them", hours_max));
        }
        run.tariff->hours.push_back(hours);
      });
}

/// True for characters that an ASCII printer has.
bool is_printable(const std::string& text) {
  return std::ranges::all_of(text, [](char one) { return one >= ' ' && one < 0x7F; });
}

template <class Run>
auto& currency_of(Run& run) {
  return run.network.meter.currency;
}
template <class Run>
auto& agreed_of(Run& run) {
  return run.network.shift.agreed;
}

SettingTable<TaxiRun> currency_table() {
  const auto code = mapped<TaxiRun, std::string>(
      {.key = "code",
       .takes = "three capitals, as `\"EUR\"`",
       .read =
           [](TaxiRun& run, const std::string& code) {
             const bool is_code = code.size() == 3 && std::ranges::all_of(code, [](char one) {
                                    return one >= 'A' && one <= 'Z';
                                  });
             if (!is_code) {
               throw UsageError(fmt::format("{} is no code of three capitals", text_value(code)));
             }
             run.tariff->code = code;
             currency_of(run).code = run.tariff->code;
             if (run.tariff->symbol.empty()) currency_of(run).symbol = run.tariff->code;
           },
       .write = [](const TaxiRun& run) { return std::string(currency_of(run).code); }},
      "60DAh:08h");
  const auto symbol = mapped<TaxiRun, std::string>(
      {.key = "symbol",
       .takes = "1 to 4 characters of ASCII",
       .read =
           [](TaxiRun& run, const std::string& symbol) {
             if (symbol.empty() || symbol.size() > 4 || !is_printable(symbol)) {
               throw UsageError(fmt::format("{} is no symbol of 1 to 4 characters of ASCII",
                                            text_value(symbol)));
             }
             run.tariff->symbol = symbol;
             currency_of(run).symbol = run.tariff->symbol;
           },
       .write = [](const TaxiRun& run) { return std::string(currency_of(run).symbol); }},
      "beside TOTAL on receipts");
  const Setting<TaxiRun> leads{
      .key = "symbol_leads",
      .takes = "`true` or `false`",
      .help = "it stands before the amount",
      .take = [](TomlTable& table,
                 TaxiRun& run) { table.take("symbol_leads", currency_of(run).leads); },
      .value = [](const TaxiRun& run) { return fmt::format("{}", currency_of(run).leads); }};
  const auto coin = mapped<TaxiRun, double>(
      {.key = "coin",
       .takes = "a number from 0.001 to 1000",
       .read =
           [](TaxiRun& run, double wanted) {
             currency_of(run).coin = whole_amount(wanted, 1, "is no whole number of thousandths");
           },
       .write = [](const TaxiRun& run) { return currency_of(run).coin / thousandths; },
       .range = {1 / thousandths, 1000}},
      "the smallest: all that is paid is whole ones");
  return {"currency", "", {code, symbol, leads, coin}};
}

/// First words of lines on receipts.
constexpr std::string_view words_of_receipts[] = {
    "taxi",    "receipt", "driver", "from",   "to",    "tariff",   "distance",
    "waiting", "fare",    "agreed", "extras", "total", "shift of", "paid:"};

std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char one) { return static_cast<char>(std::tolower(one)); });
  return text;
}

/// Text that fits on a receipt, and is not mistaken for another line.
std::string name_of_supplement(const std::string& name) {
  constexpr std::size_t name_max = 11;
  const bool is_name = !name.empty() && name.size() <= name_max && is_printable(name) &&
                       std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
                       name.back() != ' ';
  if (!is_name) {
    throw UsageError(
        fmt::format("{} is no name of 1 to {} characters of ASCII, with a letter first",
                    text_value(name), name_max));
  }
  const std::string word = small_letters(name);
  const bool is_taken = word.starts_with("vat") ||
                        std::ranges::find(words_of_receipts, word) != std::end(words_of_receipts);
  if (is_taken) {
    throw UsageError(fmt::format("{} is another line of receipts", text_value(name)));
  }
  return name;
}

FilePart<TaxiRun> supplements() {
  return several<TaxiRun, TariffSupplement>(
      [](const TaxiRun& run) {
        const auto name = mapped<TariffSupplement, std::string>(
            {.key = "name",
             .takes = "1 to 11 characters of ASCII",
             .read = [](TariffSupplement& item,
                        const std::string& name) { item.name = name_of_supplement(name); },
             .write = [](const TariffSupplement& item) { return item.name; },
             .is_needed = true},
            "its line on receipts");
        return SettingTable<TariffSupplement>{
            "supplement",
            "a service that costs extra",
            {name,
             payable<&TariffSupplement::price, TariffSupplement>("price",
                                                                 run.network.meter.currency.coin),
             setting<&TariffSupplement::share>("share", "of the trips that have it", {{0, 1}})}};
      },
      [](const TaxiRun& run) {
        std::vector<TariffSupplement> items;
        for (const cia447::SupplementKind& kind : run.network.meter.tariff.supplements) {
          items.push_back({.name = std::string(kind.name),
                           .price = kind.price,
                           .share = run.network.shift.service_shares.at(items.size())});
        }
        return items;
      },
      [](const TomlTable& table, TaxiRun& run, TariffSupplement item) {
        std::vector<TariffSupplement>& items = run.tariff->supplements;
        const bool is_there = std::ranges::any_of(items, [&](const auto& each) {
          return small_letters(each.name) == small_letters(item.name);
        });
        if (is_there) table.refuse("name", "there is one of this name already");
        if (items.size() == cia447::supplement_kinds_max) {
          table.refuse(
              fmt::format("there are more than {} supplements", cia447::supplement_kinds_max));
        }
        items.push_back(std::move(item));
      });
}

FilePart<TaxiRun> agreed_price() {
  const auto rows = [](const TaxiRun& run) {
    return SettingTable<AgreedPrices>{
        "agreed_price",
        "before they go, up to a whole unit",
        {setting<&AgreedPrices::share>("share", "of the trips that have one", {{0, 1}}),
         amount<&AgreedPrices::per_km, AgreedPrices>("per_km", 0, 1,
                                                     "is no whole number of thousandths", {}),
         payable<&AgreedPrices::least, AgreedPrices>("least", run.network.meter.currency.coin, 0,
                                                     "that such a trip costs")}};
  };
  return {[=](TomlTable& file, TaxiRun& run) {
            take_settings(file, rows(run), agreed_of(run));
            const AgreedPrices& prices = agreed_of(run);
            if (prices.share > 0 && prices.per_km == 0 && prices.least == 0) {
              file.refuse("agreed_price", "a trip costs nothing: write per_km or least");
            }
          },
          [=](const TaxiRun& run) { return settings_text(rows(run), agreed_of(run)); },
          keys_text("[agreed_price]", rows(TaxiRun{}).settings)};
}

SettingTable<TaxiRun> business_table() {
  constexpr auto network = &TaxiRun::network;
  constexpr auto business = &TaxiOptions::business;
  constexpr double vat_max = 50;
  return {
      "business",
      "who drives for whom, on receipts",
      {setting<network, business, &Business::taxi>("taxi", "its licence, on receipts"),
       setting<network, business, &Business::company>("company"),
       setting<network, business, &Business::driver>("driver"),
       setting<network, business, &Business::vat_percent>("vat_percent", "that fares have in them",
                                                          {{0, vat_max}})},
      [](const TomlTable& table, TaxiRun& run) {
        constexpr std::size_t columns = 24;
        const Business& it = run.network.business;
        constexpr std::size_t of_taxi = columns - std::string_view("TAXI ").size();
        const auto check = [&table](const char* key, const std::string& text, std::size_t most) {
          if (text.size() <= most && is_printable(text)) return;
          table.refuse(
              key, fmt::format("{} is no text of {} characters of ASCII", text_value(text), most));
        };
        check("taxi", it.taxi, of_taxi);
        check("company", it.company, columns);
        check("driver", it.driver, columns);
        if (std::abs(it.vat_percent * 10 - it.vat_permille()) > 1e-6) {
          table.refuse("vat_percent",
                       fmt::format("{} is no whole number of tenths", it.vat_percent));
        }
      }};
}

}  // namespace

Setting<TaxiRun> holidays_setting() {
  using Texts = std::vector<std::string>;
  return mapped<TaxiRun, Texts>(
      {.key = "holidays",
       .takes = R"(a list of days, as `"12-25"` in each year, or `"2026-04-03"`)",
       .read =
           [](TaxiRun& run, const Texts& days) {
             if (days.size() > holidays_max) {
               throw UsageError(fmt::format("there are more than {}", holidays_max));
             }
             std::vector<cia447::Holiday>& holidays = run.tariff->holidays.emplace();
             for (const std::string& day : days) {
               const auto holiday = holiday_of(day);
               if (!holiday) {
                 throw UsageError(
                     fmt::format(R"({} is no day as "12-25" or "2026-04-03")", text_value(day)));
               }
               holidays.push_back(*holiday);
             }
           },
       .write =
           [](const TaxiRun& run) {
             Texts days;
             for (const cia447::Holiday& holiday : run.tariff->tariff().holidays) {
               days.push_back(holiday_text(holiday));
             }
             return days;
           }},
      "of the tariff");
}

cia447::Tariff TariffParts::tariff() const {
  cia447::Tariff made = cia447::example_tariff;
  if (!levels.empty()) {
    made.levels = levels;
    made.hours = hours;
  }
  if (!levels.empty() || !kinds.empty()) made.supplements = kinds;
  if (holidays) made.holidays = *holidays;
  return made;
}

namespace {

/// Checks values that were not checked in their own lines.
void check_coins(const TomlTable& file, const TaxiRun& run) {
  const cia447::Tariff tariff = run.tariff->tariff();
  const std::uint32_t coin = run.network.meter.currency.coin;
  const auto is_whole = [coin](std::uint32_t amount) { return amount % coin == 0; };
  const bool are_levels = std::ranges::all_of(tariff.levels, [&](const TariffLevel& level) {
    return is_whole(level.initial_fare) && is_whole(level.minimum_fare) &&
           is_whole(level.increment);
  });
  const bool are_supplements = std::ranges::all_of(
      tariff.supplements, [&](const auto& kind) { return is_whole(kind.price); });
  if (are_levels && are_supplements) return;
  file.refuse("currency",
              fmt::format("the {} of the example {} no coins of {}: write [[{}]]",
                          are_levels ? "supplements" : "tariff", are_levels ? "are" : "is",
                          coin / thousandths, are_levels ? "supplement" : "tariff"));
}

/// Names and prices, and the share of trips with them.
void take_supplements(TaxiRun& run) {
  const std::vector<TariffSupplement>& supplements = run.tariff->supplements;
  if (supplements.empty()) return;
  auto& shares = run.network.shift.service_shares;
  shares = {};
  run.tariff->kinds.clear();
  for (const TariffSupplement& each : supplements) {
    shares.at(run.tariff->kinds.size()) = each.share;
    run.tariff->kinds.push_back({.name = each.name, .price = each.price});
  }
}

}  // namespace

Setting<TaxiRun> taxi_identifier_setting() {
  return mapped<TaxiRun, std::string>(
      {.key = "taxi_identifier",
       .takes = "a text of up to 19 characters of ASCII",
       .read =
           [](TaxiRun& run, const std::string& text) {
             constexpr std::size_t columns = 24 - std::string_view("TAXI ").size();
             if (text.size() > columns || !is_printable(text)) {
               throw UsageError(fmt::format("{} is no text of {} characters of ASCII",
                                            text_value(text), columns));
             }
             run.tariff->taxi_identifier = text;
           },
       .write = [](const TaxiRun& run) { return std::string(run.network.meter.taxi_identifier); }},
      "60DAh:04h, as its receipts have it; without it, `taxi` of [business]");
}

void take_tariff(const TomlTable& file, TaxiRun& run) {
  std::optional<std::string>& identifier = run.tariff->taxi_identifier;
  if (!identifier) identifier = run.network.business.taxi;
  run.network.meter.taxi_identifier = *identifier;
  take_supplements(run);
  check_coins(file, run);
  const cia447::Tariff tariff = run.tariff->tariff();
  run.network.tariff_of_town = run.network.meter.tariff = tariff;
  run.network.currency_of_town = run.network.meter.currency;
  const bool names_holidays = std::ranges::any_of(
      tariff.hours, [](const TariffHours& hours) { return hours.days == cia447::on_holidays; });
  if (names_holidays && tariff.holidays.empty()) {
    file.refuse("holidays", "[[tariff_hours]] has hours of holidays alone, and there are none");
  }
}

void add_tariff_settings(std::vector<FilePart<TaxiRun>>& parts) {
  parts.emplace_back(currency_table());
  parts.push_back(tariff_levels());
  parts.push_back(tariff_hours());
  parts.push_back(supplements());
  parts.push_back(agreed_price());
  parts.emplace_back(business_table());
}

}  // namespace canvoy::tools
