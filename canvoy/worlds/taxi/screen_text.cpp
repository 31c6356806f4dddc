#include "canvoy/worlds/taxi/screen_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "canvoy/can/real_text.hpp"

namespace canvoy::taxi {

namespace {

constexpr std::string_view level_word = "Tariff ";
constexpr std::string_view fare_word = "FARE";
constexpr std::string_view arrow = "> ";
constexpr std::string_view to_go = " km to go";
constexpr double thousandths = 1000;

std::string with_digits(double number, int digits) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number,
                                          std::chars_format::fixed, digits);
  return {text.data(), error == std::errc{} ? end : text.data()};
}

std::string_view behind_spaces(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text;
}

/// Number at the beginning of the text, after spaces, which is removed with them.
std::optional<double> take_number(std::string_view& text) {
  text = behind_spaces(text);
  double number = 0;
  const auto [end, error] = real_from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}
std::optional<double> read_number(std::string_view text) {
  return take_number(text);
}

/// Rest of the line that begins with a word; empty: there is none.
std::optional<std::string_view> rest_of_line(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.starts_with(word)) return line.substr(word.size());
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return std::nullopt;
}

std::string amount_line(std::string_view name, std::uint32_t amount,
                        const cia447::Currency& currency) {
  constexpr std::size_t amount_end = 16;
  const std::string number =
      with_digits(amount / thousandths, static_cast<int>(currency.decimals()));
  std::string line(name);
  if (line.size() + number.size() < amount_end) {
    line.append(amount_end - line.size() - number.size(), ' ');
  }
  return line + number + " " + std::string(currency.code);
}

}  // namespace

std::string trip_text(const cia447::TaximeterDisplay& display, const cia447::Currency& currency) {
  const bool has_passengers =
      display.state == cia447::Taximeter::hired || display.state == cia447::Taximeter::stopped;
  const cia447::TripData& trip = display.trip;
  if (!has_passengers || trip.fare == cia447::TripData::unknown) return {};
  std::string text(level_word);
  for (const std::uint8_t character : trip.level) {
    if (character >= ' ' && character < 0x7F) text += static_cast<char>(character);
  }
  text += "\n" + amount_line(fare_word, trip.fare, currency);
  const bool has_extras = trip.supplements != 0 && trip.supplements != cia447::TripData::unknown;
  if (has_extras) text += "\n" + amount_line("EXTRAS", trip.supplements, currency);
  return text;
}

std::string place_text(const ShownPlace& shown) {
  std::string text(shown.street);
  if (!shown.destination.empty())
    text += "\n" + std::string(arrow) + std::string(shown.destination);
  if (shown.metres_to_go) {
    return text + "\n" + with_digits(*shown.metres_to_go / thousandths, 1) + std::string(to_go);
  }
  const bool has_city = shown.destination.empty() && !shown.city.empty();
  return has_city ? text + "\n" + std::string(shown.city) : text;
}

std::optional<double> read_fare(std::string_view text) {
  const std::optional<ShownAmount> fare = read_amount(text, fare_word);
  return fare ? std::optional(fare->amount) : std::nullopt;
}

std::optional<ShownAmount> read_amount(std::string_view text, std::string_view name) {
  std::optional<std::string_view> line = rest_of_line(text, name);
  if (!line) return std::nullopt;
  const std::optional<double> amount = take_number(*line);
  if (!amount) return std::nullopt;
  return ShownAmount{std::round(*amount * thousandths), behind_spaces(*line)};
}

std::string_view read_level(std::string_view text) {
  return rest_of_line(text, level_word).value_or(std::string_view());
}

std::string_view read_street(std::string_view text) {
  return text.substr(0, text.find('\n'));
}

std::string_view read_destination(std::string_view text) {
  const std::size_t at = text.find(arrow);
  if (at == std::string_view::npos) return {};
  return read_street(text.substr(at + arrow.size()));
}

std::optional<double> read_metres_to_go(std::string_view text) {
  const std::size_t end = text.find(to_go);
  if (end == std::string_view::npos) return std::nullopt;
  text = text.substr(0, end);
  const std::optional<double> kilometres = read_number(text.substr(text.rfind('\n') + 1));
  return kilometres ? std::optional(*kilometres * thousandths) : std::nullopt;
}

}  // namespace canvoy::taxi
