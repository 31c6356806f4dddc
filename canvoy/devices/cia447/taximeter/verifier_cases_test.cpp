// Plays the cases of verifier_cases.txt at the wire: a reader of its lines, and nothing of what
// they expect. Each case is a meter of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <source_location>
#include <sstream>
#include <vector>

#include "canvoy/devices/cia447/taximeter/meter_bench_test.hpp"
#include "canvoy/devices/cia447/taximeter/receipt.hpp"

namespace canvoy::cia447::verifier_cases_test {
namespace {

constexpr double thousandths_of = 1000;

/// `do` or `see`, and what stands behind it.
struct Part {
  bool is_see = false;
  std::vector<std::string> steps;
};
struct Case {
  std::string name;
  std::string clause;
  bool has_hand_calculation = false;
  std::vector<std::string> sets;
  std::vector<Part> parts;
};
std::ostream& operator<<(std::ostream& out, const Case& it) {
  return out << it.name;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) {
    part.erase(0, part.find_first_not_of(' '));
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

std::vector<Case> read_cases() {
  const std::filesystem::path here(std::source_location::current().file_name());
  std::ifstream file(here.parent_path() / "verifier_cases.txt");
  std::vector<Case> cases;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::string word = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(word.size() + 1, line.size()));
    if (word == "case") {
      cases.push_back({.name = rest});
    } else if (cases.empty()) {
      ADD_FAILURE() << "in front of the first case: " << line;
    } else if (word == "clause") {
      cases.back().clause = rest;
    } else if (word == "by") {
      cases.back().has_hand_calculation = true;
    } else if (word == "set") {
      cases.back().sets.push_back(rest);
    } else if (word == "do" || word == "see") {
      cases.back().parts.push_back({word == "see", split(rest, ',')});
    } else {
      ADD_FAILURE() << "no line of a case: " << line;
    }
  }
  return cases;
}

std::uint32_t money(const std::string& text) {
  return static_cast<std::uint32_t>(std::lround(std::stod(text) * thousandths_of));
}
/// `2026-11-23 12:00:00`
std::int64_t moment(const std::string& day, const std::string& time) {
  CivilTime at;
  unsigned year = 0;
  EXPECT_EQ(std::sscanf(day.c_str(), "%4u-%2u-%2u", &year, &at.month, &at.day), 3) << day;
  EXPECT_EQ(std::sscanf(time.c_str(), "%2u:%2u:%2u", &at.hour, &at.minute, &at.second), 3) << time;
  at.year = year;
  return seconds_since_1970(at);
}

/// The meter that all cases have; `set` lines change it.
struct Sealed {
  TariffLevel levels[2] = {{.name = {'1', 0},
                            .initial_fare = 3900,
                            .distance_rate = 2300,
                            .time_rate = 33'000,
                            .increment = 100},
                           {.name = {'2', 0},
                            .initial_fare = 4900,
                            .distance_rate = 2600,
                            .time_rate = 33'000,
                            .increment = 100}};
  TariffHours hours[2] = {{.days = on_sundays | on_holidays, .level = 1},
                          {.from = time_of_day(22, 0), .to = time_of_day(6, 0), .level = 1}};
  Holiday holidays[1] = {{.month = 12, .day = 25}};
  TariffLevel next_levels[1] = {{.name = {'1', 0}, .initial_fare = 7000, .increment = 100}};
  TaximeterSettings settings{.k = 10'000, .taxi_identifier = "T447"};
  std::int64_t local = MeterBench::noon;
  std::int32_t offset = 3600;

  Sealed() {
    settings.tariff = {.id = 1,
                       .levels = levels,
                       .hours = hours,
                       .holidays = holidays,
                       .supplements = example_supplements};
  }
  Sealed(const Sealed&) = delete;
  Sealed& operator=(const Sealed&) = delete;

  void set(const std::string& line) {
    const std::vector<std::string> words = split(line, ' ');
    if (words[0] == "k") {
      settings.k = static_cast<std::uint32_t>(std::stoul(words[1]));
    } else if (words[0] == "calculation") {
      settings.calculation = FareMode::double_calculation;
    } else if (words[0] == "clock") {
      local = moment(words[1], words[2]);
      if (words.size() > 3) offset = 7200;  // summer
    } else if (words[0] == "future") {
      settings.future_tariff = {.id = 2, .levels = next_levels};
      settings.future_from = moment(words[1], words[2]);
    } else if (words[0] == "level") {
      set_level(words);
    } else {
      ADD_FAILURE() << "not to be set: " << line;
    }
  }

 private:
  /// `level 1 initial 3.90, km 2.30, ...`
  void set_level(const std::vector<std::string>& words) {
    TariffLevel& level = levels[std::stoul(words[1]) - 1];
    level = {.name = level.name};
    const std::map<std::string, std::uint32_t TariffLevel::*> parts = {
        {"initial", &TariffLevel::initial_fare}, {"km", &TariffLevel::distance_rate},
        {"hour", &TariffLevel::time_rate},       {"step", &TariffLevel::increment},
        {"minimum", &TariffLevel::minimum_fare}, {"crossover", &TariffLevel::crossover_speed}};
    for (std::size_t i = 2; i + 1 < words.size(); i += 2)
      level.*parts.at(words[i]) = money(words[i + 1]);
  }
};

/// A number that an entry has.
struct Object {
  std::uint16_t index;
  unsigned sub;
  double unit;  ///< of its values
};
const std::map<std::string, Object> numbers = {{"fare", {0x60D0, 1, 1000}},
                                               {"supplements", {0x60D0, 2, 1000}},
                                               {"total", {0x60D0, 3, 1000}},
                                               {"minimum", {0x60D0, 5, 1000}},
                                               {"initial", {0x60D0, 6, 1000}},
                                               {"distance", {0x60D1, 0, 1}},
                                               {"duration", {0x60D2, 1, 1}},
                                               {"waiting", {0x60D2, 2, 1}},
                                               {"finish", {0x60D2, 4, 1}},
                                               {"hour-rate", {0x60D4, 1, 1000}},
                                               {"km-rate", {0x60D4, 2, 1000}},
                                               {"all-distance", {0x60D9, 1, 1}},
                                               {"shift-distance", {0x60D9, 2, 1}},
                                               {"all-hired", {0x60D9, 3, 1}},
                                               {"all-income", {0x60D9, 5, 1000}},
                                               {"all-hirings", {0x60D9, 7, 1}},
                                               {"shift-hirings", {0x60D9, 8, 1}},
                                               {"all-supplements", {0x60D9, 9, 1000}},
                                               {"all-fares", {0x60D9, 11, 1000}},
                                               {"shift-fares", {0x60D9, 12, 1000}},
                                               {"k", {0x60DA, 1, 1}},
                                               {"tariff", {0x60DA, 3, 1}}};
const std::map<std::string, Object> times = {
    {"start", {0x60D2, 3, 1}}, {"finish", {0x60D2, 4, 1}}, {"securing", {0x60DA, 6, 1}}};
/// 60D8h, the lowest 4 bits.
const std::map<std::string, unsigned> states = {{"for-hire", 0},   {"hired", 1},   {"stopped", 2},
                                                {"signed-off", 3}, {"service", 4}, {"standby", 5}};
const std::map<std::string, unsigned> modes = {{"S", 0}, {"D", 1}, {"fixed", 2}};
const std::map<std::string, AuditEvent> events = {
    {"clock-step", AuditEvent::clock_step},      {"clock-refused", AuditEvent::clock_refused},
    {"trip-cut", AuditEvent::trip_cut},          {"sealed", AuditEvent::sealed},
    {"calibrated", AuditEvent::calibrated},      {"seal-opened", AuditEvent::seal_opened},
    {"write-refused", AuditEvent::write_refused}};

const std::map<std::string, TaximeterMode> operations = {
    {"taximeter", TaximeterMode::taximeter_operation},
    {"odometer", TaximeterMode::odometer_operation}};

class Play {
 public:
  explicit Play(const Case& played) {
    for (const std::string& line : played.sets) sealed_.set(line);
    turn_on(sealed_.local);
    for (const Part& part : played.parts) {
      for (const std::string& step : part.steps) {
        SCOPED_TRACE((part.is_see ? "see " : "do ") + step);
        part.is_see ? see(split(step, ' '), step) : perform(step);
      }
    }
  }
  Play(const Play&) = delete;
  Play& operator=(const Play&) = delete;

 private:
  void turn_on(std::int64_t local) {
    car_.reset();
    flash_ = std::make_unique<SimulatedFlash>(MeterBench::geometry, flash_->bytes);
    car_.emplace(sealed_.settings, flash_.get(), local);
    car_->utc_offset = sealed_.offset;
    car_->turned = turned_;
    EXPECT_EQ(car_->ask_as(1, "27 56 60 00 FF FF FD 00"), "60 56 60 00 00 00 00 00");
    car_->send_count(turned_ % (car_->highest + 1));
  }
  std::int64_t local_now() const {
    return *car_->local_at_start + (car_->bench->cable.now - Time{}) / 1s;
  }
  /// Without a warning the meter has what it has kept.
  void lose_power(std::int64_t seconds, bool is_warned) {
    if (is_warned) car_->meter->power_fails();
    turned_ = car_->turned;
    turn_on(local_now() + seconds);
  }
  void drive(unsigned seconds, unsigned speed) {
    constexpr unsigned metres_a_km = 1000;
    car_->drive(seconds, speed * sealed_.settings.k / metres_a_km);
  }

  void perform(const std::string& step) {
    std::vector<std::string> words = split(step, ' ');
    const bool is_refused = words[0] == "refused";
    if (is_refused) words.erase(words.begin());
    if (const auto key = keys_.find(words[0]); key != keys_.end()) {
      EXPECT_EQ(key->second(words), !is_refused);
    } else if (words[0] == "write") {
      EXPECT_EQ(is_written(words), !is_refused);
    } else {
      EXPECT_TRUE(happens(words)) << "there is no such step";
    }
    car_->cable().run_for(0s);
  }

  bool happens(const std::vector<std::string>& words) {
    const std::string& what = words[0];
    if (what == "drive") {
      drive(number(words[1]), number(words[4]));
    } else if (what == "wait") {
      drive(number(words[1]), 0);
    } else if (what == "off" || what == "cut") {
      lose_power(number(words[1]), what == "off");
    } else if (what == "clock") {
      car_->local_at_start = *car_->local_at_start + moment(words[1], words[2]) - local_now();
    } else if (what == "winter-time") {
      car_->local_at_start = *car_->local_at_start - 3600;
      car_->utc_offset = 3600;
    } else if (what == "open-seal" || what == "close-seal") {
      car_->seal_is_open = what == "open-seal";
    } else {
      return false;
    }
    return true;
  }

  static unsigned number(const std::string& text) {
    return static_cast<unsigned>(std::stoul(text));
  }
  static unsigned place_of(const std::string& service) {
    const std::map<std::string, unsigned> places = {{"luggage", 0}, {"booking", 1}, {"airport", 2}};
    return places.at(service);
  }

  using Words = std::vector<std::string>;
  TaximeterUnit& meter() { return *car_->meter; }
  const std::map<std::string, std::function<bool(const Words&)>> keys_ = {
      {"sign-on", [this](const Words&) { return meter().sign_on(); }},
      {"sign-off", [this](const Words&) { return meter().sign_off(); }},
      {"hire", [this](const Words&) { return meter().hire(); }},
      {"stop", [this](const Words&) { return meter().stop(); }},
      {"for-hire", [this](const Words&) { return meter().for_hire(); }},
      {"standby", [this](const Words&) { return meter().standby(); }},
      {"wake", [this](const Words&) { return meter().wake(); }},
      {"level", [this](const Words& words) { return meter().choose_level(number(words[1]) - 1); }},
      {"charge", [this](const Words& words) { return meter().charge(place_of(words[1])); }},
      {"supplement",
       [this](const Words& words) { return meter().add_supplement(money(words[1])); }},
      {"clear-supplements", [this](const Words&) { return meter().clear_supplements(); }},
      {"agree", [this](const Words& words) { return meter().agree_price(money(words[1])); }},
      {"enter-service", [this](const Words&) { return meter().enter_service(); }},
      {"leave-service", [this](const Words&) { return meter().leave_service(); }},
      {"k", [this](const Words& words) { return meter().set_k(number(words[1])); }},
      {"operation",
       [this](const Words& words) { return meter().set_mode(operations.at(words[1])); }},
      {"calibrate", [this](const Words&) { return meter().begin_calibration(); }},
      {"calibrated",
       [this](const Words& words) { return meter().end_calibration(number(words[1])); }}};

  /// `write 60D9 1 0`, by a client on the default channel: of four bytes, or of the number given
  /// last.
  bool is_written(const Words& words) {
    const unsigned index = static_cast<unsigned>(std::stoul(words[1], nullptr, 16));
    const unsigned value = number(words[3]);
    const unsigned size = words.size() > 4 ? number(words[4]) : 4;
    char request[32];
    std::snprintf(request, sizeof request, "%02X %02X %02X %02X %02X %02X %02X %02X",
                  (0x23 | (4 - size) << 2) & 0xFF, index & 0xFF, index >> 8 & 0xFF,
                  number(words[2]) & 0xFF, value & 0xFF, value >> 8 & 0xFF, value >> 16 & 0xFF,
                  value >> 24);
    return car_->ask(request).starts_with("60");
  }

  void see(const Words& words, const std::string& step) {
    const std::string& what = words[0];
    if (what == "line") return see_line(step.substr(step.find('"') + 1));
    if (what == "state") {
      EXPECT_EQ(car_->get(0x60D8) & 0xF, states.at(words[1]));
    } else if (what == "mode") {
      EXPECT_EQ(car_->get(0x60D0, 4), modes.at(words[1]));
    } else if (what == "operation") {
      EXPECT_EQ(car_->get(0x60DA, 2), static_cast<unsigned>(operations.at(words[1])));
    } else if (what == "level") {
      EXPECT_EQ(car_->get(0x60D3), static_cast<unsigned char>(words[1][0]));
    } else if (what == "recorded") {
      EXPECT_TRUE(is_recorded(events.at(words[1])));
    } else if (what == "text") {
      EXPECT_EQ(
          text(static_cast<std::uint16_t>(std::stoul(words[1], nullptr, 16)), number(words[2])),
          words[3]);
    } else if (what == "text-of-calculation") {
      EXPECT_EQ(text(0x60DA, 5), words[1]);
    } else if (what.starts_with("shown-")) {
      see_display(words);
    } else if (times.contains(what) && words[1] != "-") {
      see_time(times.at(what), words);
    } else {
      ASSERT_TRUE(numbers.contains(what)) << "there is no such value";
      see_number(numbers.at(what), words);
    }
  }

  static double limit_of(const Words& words) {
    return words.size() > 2 ? std::stod(words[2].substr(2)) : 0;
  }

  void see_number(const Object& object, const Words& words) {
    const std::uint64_t told = car_->get(object.index, object.sub);
    if (words[1] == "-") {
      EXPECT_EQ(told, 0xFFFF'FFFFu);
      return;
    }
    EXPECT_NEAR(static_cast<double>(told) / object.unit, std::stod(words[1]),
                limit_of(words) + 1e-9);
  }

  /// `12:01:00`, of this day.
  void see_time(const Object& object, const Words& words) {
    constexpr std::int64_t a_day = 86'400;
    const std::int64_t expected = moment("1970-01-01", words[1]);
    const auto told = static_cast<std::int64_t>(car_->get(object.index, object.sub));
    EXPECT_NEAR(static_cast<double>((told + car_->utc_offset) % a_day),
                static_cast<double>(expected), limit_of(words));
  }

  void see_display(const Words& words) {
    const TaximeterDisplay& shown = car_->display;
    if (words[0] == "shown-state") {
      EXPECT_EQ(static_cast<unsigned>(shown.state), states.at(words[1]));
    } else {
      const bool is_fare = words[0] == "shown-fare";
      EXPECT_EQ(is_fare ? shown.trip.fare : shown.trip.supplements, money(words[1]));
    }
  }

  void see_line(std::string line) {
    line.erase(line.rfind('"'));
    const Receipt receipt(car_->display.trip,
                          {.head = {.distance_unit = "km"},
                           .kinds = meter().tariff().supplements,
                           .of_kinds = meter().record().trip.supplements_of_kind});
    const std::string text(receipt.text());
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << text;
  }

  bool is_recorded(AuditEvent event) {
    const AuditLog& log = meter().audit();
    for (std::size_t i = 0; i < log.size(); ++i) {
      if (log.newest(i)->what == event) return true;
    }
    return false;
  }

  /// Of four characters at most.
  std::string text(std::uint16_t index, unsigned sub) {
    std::string characters;
    std::uint64_t number = car_->get(index, sub);
    for (; number != 0; number >>= 8) characters += static_cast<char>(number & 0xFF);
    return characters;
  }

  Sealed sealed_;
  std::unique_ptr<SimulatedFlash> flash_ = std::make_unique<SimulatedFlash>(MeterBench::geometry);
  std::optional<MeterBench> car_;
  unsigned turned_ = 65'000;
};

class EachVerifierCase : public testing::TestWithParam<Case> {};

TEST_P(EachVerifierCase, Holds) {
  const Play play(GetParam());
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name;
  for (const char one : info.param.name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(one)) != 0;
    if (is_plain) name += one;
    if (!is_plain && !name.empty() && name.back() != '_') name += '_';
  }
  return name;
}
INSTANTIATE_TEST_SUITE_P(Verifier, EachVerifierCase, testing::ValuesIn(read_cases()), name_of);

TEST(VerifierCases, AreSixtyAndEachHasItsClause) {
  const std::vector<Case> cases = read_cases();
  EXPECT_GE(cases.size(), 60u);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_TRUE(cases[i].name.starts_with(std::to_string(i + 1) + " ")) << cases[i].name;
    EXPECT_FALSE(cases[i].clause.empty()) << cases[i].name;
    EXPECT_FALSE(cases[i].parts.empty()) << cases[i].name;
  }
}

}  // namespace
}  // namespace canvoy::cia447::verifier_cases_test
