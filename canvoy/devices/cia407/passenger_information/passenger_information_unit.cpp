#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"

#include <charconv>
#include <utility>

#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/devices/cia407/kit/errors.hpp"
#include "canvoy/devices/cia407/kit/motion_recognition.hpp"

namespace canvoy::cia407 {

namespace {

constexpr std::uint8_t flag_test_mode = 0b10;
constexpr std::uint8_t flag_cannot_be_displayed = 0b100;
constexpr std::uint8_t event_test_mode = 0b10;
constexpr unsigned characters_max = 8;

/// Texts in the character set of 6205h (9.2.8.6).
constexpr bool has_character_set(std::uint16_t index) {
  return index == text_line_route_description_object.index ||
         index == text_of_destination_object.index || index == text_of_stop_point_object.index;
}
constexpr std::uint8_t byte_at(std::uint32_t word, std::uint8_t first_bit) {
  return static_cast<std::uint8_t>(word >> first_bit);
}
template <class Mode>
constexpr Mode mode_at(std::uint8_t format, unsigned first_bit) {
  return static_cast<Mode>(format >> first_bit & 3);
}

std::span<const std::uint8_t> octets_of(std::span<const char> text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
template <std::size_t size>
std::span<const std::uint8_t> write_number(std::array<char, size>& text, std::int64_t number) {
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return octets_of({text.data(), static_cast<std::size_t>(end - text.data())});
}
/// Hours and minutes of a clock.
template <std::size_t size>
std::span<const std::uint8_t> write_clock(std::array<char, size>& text, const CivilTime& time) {
  const char digits[] = {
      static_cast<char>('0' + time.hour / 10), static_cast<char>('0' + time.hour % 10), ':',
      static_cast<char>('0' + time.minute / 10), static_cast<char>('0' + time.minute % 10)};
  std::ranges::copy(digits, text.begin());
  return octets_of({text.data(), std::size(digits)});
}
/// Whole degrees or km/h, for such values; nothing if it does not exist or is invalid.
std::optional<double> measured(Values values, std::uint16_t index) {
  switch (index) {
    case inside_temperature_object.index:
      return values[inside_temperature].value();
    case ambient_air_temperature_object.index:
      return values[ambient_air_temperature].value();
    case vehicle_speed_object.index:
      return values[vehicle_speed].value();
    case wheel_based_vehicle_speed_object.index:
      return values[wheel_based_vehicle_speed].value();
    case tachograph_speed_object.index:
      return values[tachograph_speed].value();
    case gps_based_speed_object.index: {
      const auto speed = values[gps_based_speed].value();
      return speed ? std::optional(*speed * kmh_of_metres_per_second) : std::nullopt;
    }
    default:
      return std::nullopt;
  }
}
constexpr bool is_measured(std::uint16_t index) {
  return index == inside_temperature_object.index ||
         index == ambient_air_temperature_object.index || index == vehicle_speed_object.index ||
         index == wheel_based_vehicle_speed_object.index ||
         index == tachograph_speed_object.index || index == gps_based_speed_object.index;
}
/// Numbers for passengers: of vehicles, lines, stops, zones.
constexpr bool is_shown_number(std::uint16_t index) {
  return index == body_id_object.index || index == stop_point_id_object.index ||
         index == route_segment_number_object.index || index == destination_number_object.index ||
         index == line_id_object.index || index == route_number_object.index;
}

}  // namespace

constexpr ServiceHandlers PassengerInformationUnit::service_calls = {
    .state_entered = method<&PassengerInformationUnit::state_entered>};

constexpr AccessHandlers PassengerInformationUnit::hook_calls[] = {
    before_write<&PassengerInformationUnit::check_character_set, selected_character_set>,
    after_write<&PassengerInformationUnit::update, display_update>,
    after_write<&PassengerInformationUnit::stop_request_written, bus_stop_request_object>};

PassengerInformationUnit::PassengerInformationUnit(VirtualDevice& device,
                                                   const DisplayHardware& hardware,
                                                   const NoSettings& /*settings*/)
    : device_(device),
      hardware_(hardware),
      state_(device),
      special_characters_(device, special_character_files_object.index),
      pictures_(device, referenced_files_for_xml_files_object.index) {
  device.on_reset = callback<&PassengerInformationUnit::reset>(*this);
  device.react(*this, hook_calls);
  device.on_event = callback<&PassengerInformationUnit::take_event>(*this);
  device.node().attach(service_);
}

void PassengerInformationUnit::reset(ResetScope scope) {
  if (scope != ResetScope::node) return;
  offer_character_sets();
  special_characters_.shelf().clear();
  pictures_.shelf().clear();
  is_testing_ = false;
  if (hardware_.test) hardware_.test(false);
  go_dark();
}

/// Offers each ISO 8859-n that exists and can be drawn; entries behind them name the default set.
void PassengerInformationUnit::offer_character_sets() {
  constexpr std::uint16_t sets[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15};
  unsigned number = 0;
  for (const std::uint16_t set : sets) {
    if (hardware_.has_character_set && !hardware_.has_character_set(set)) continue;
    device_[available_character_set(++number)].set_raw(set);
  }
  while (number < std::size(sets)) device_[available_character_set(++number)].set_raw(0);
}

void PassengerInformationUnit::go_dark() {
  if (hardware_.show) hardware_.show({});
  if (hardware_.show_stop_request) hardware_.show_stop_request(false);
}

void PassengerInformationUnit::state_entered(NmtState state) {
  const bool is_operational = state == NmtState::operational;
  if (std::exchange(was_operational_, is_operational) && !is_operational) go_dark();
}

/// A character set that is not available is not selected.
AbortCode PassengerInformationUnit::check_character_set(std::uint16_t wanted) {
  if (wanted == 0) return AbortCode::none;
  const Dictionary& dictionary = device_.node().dictionary();
  const auto count = dictionary.word(character_set_object.index, 0);
  for (std::uint8_t sub = 2; sub <= count; ++sub) {
    if (dictionary.word(character_set_object.index, sub) == wanted) return AbortCode::none;
  }
  return AbortCode::value_range;
}

void PassengerInformationUnit::stop_request_written() {
  if (!hardware_.show_stop_request) return;
  hardware_.show_stop_request(device_[bus_stop_request].is(BusStop::requested));
}

void PassengerInformationUnit::take_event(std::uint8_t flags, std::uint16_t /*information*/) {
  const bool wants_test = (flags & event_test_mode) != 0;
  if (wants_test != is_testing_) {
    is_testing_ = wants_test;
    if (hardware_.test) hardware_.test(wants_test);
  }
  device_.signal(flag_test_mode, wants_test);
  state_.take(flags);
}

void PassengerInformationUnit::update() {
  std::array<ShownElement, elements_max> elements;
  std::array<NumberText, elements_max> numbers;
  const unsigned wanted = device_[display_update].raw();
  std::size_t count = 0;
  bool has_failed = wanted > elements_max;
  for (unsigned number = 1; number <= wanted && number <= elements_max; ++number) {
    elements[count] = {};
    const auto mapping = device_[mapped_object(number)];
    if (mapping.exists() && fill(elements[count], numbers[count], mapping.raw())) {
      has_failed = has_failed || !can_draw(elements[count]);
      ++count;
    } else {
      has_failed = true;
    }
  }
  if (hardware_.show) hardware_.show({elements.data(), count});
  tell_failure(has_failed);
}

/// Whether each character is drawn: a text that lacks one is shown all the same.
bool PassengerInformationUnit::can_draw(const ShownElement& element) const {
  return !hardware_.has_characters_of || hardware_.has_characters_of(element);
}

bool PassengerInformationUnit::fill(ShownElement& element, NumberText& number,
                                    std::uint32_t mapping) {
  constexpr const DisplayLayout& layout = display_by_bit_number;
  const auto index = static_cast<std::uint16_t>(byte_at(mapping, layout.index_msb) << 8 |
                                                byte_at(mapping, layout.index_lsb));
  const std::uint8_t format = byte_at(mapping, layout.format);
  element.size = mode_at<FontSize>(format, 0);
  element.alignment = mode_at<Alignment>(format, 2);
  element.style = mode_at<FontStyle>(format, 4);
  element.flash = mode_at<FlashSpeed>(format, 6);
  if (!fill_content(element, number, index, byte_at(mapping, layout.sub_index))) return false;
  // Contents that include their own format have none here.
  return element.content == ShownElement::Content::text || format == 0;
}

bool PassengerInformationUnit::fill_content(ShownElement& element, NumberText& number,
                                            std::uint16_t index, std::uint8_t sub) {
  const Result<Entry> entry = device_.node().dictionary().find(index, sub);
  // Communication objects are not for passengers.
  if (!entry || index < vehicle_id_object.index) return false;
  if (entry->row->type == DataType::domain) return fill_file(element, index, sub);
  if (entry->row->is_text()) {
    element.octets = entry->bytes();
    if (has_character_set(index)) element.character_set = device_[selected_character_set].raw();
    if (index == xml_text_object.index) element.content = ShownElement::Content::xml;
    return true;
  }
  const bool is_line = index == line_short_representation_object.index;
  if (is_line && sub == 0) {
    const std::string_view text =
        device_[line_short_representation].value(std::span(number).first<characters_max>());
    element.octets = octets_of(text);
    return true;
  }
  if (index == local_time_and_date_object.index && sub == 0) {
    const std::optional<CivilTime> time = local_time(device_.values());
    if (time) element.octets = write_clock(number, *time);
    return time.has_value();
  }
  if (is_measured(index)) {
    const std::optional<double> value = measured(device_.values(), index);
    if (value) element.octets = write_number(number, std::lround(*value));
    return value.has_value();
  }
  if (!is_shown_number(index)) return false;
  element.octets = write_number(number, entry->word());
  return true;
}

/// Pictures, if the display can show them: subclass "graphics" or "extended".
bool PassengerInformationUnit::fill_file(ShownElement& element, std::uint16_t index,
                                         std::uint8_t sub) {
  const bool can_show =
      device_.info().subclass >= static_cast<std::uint8_t>(InformationSubclass::graphics);
  if (!can_show || index != referenced_files_for_xml_files_object.index) return false;
  element.content = ShownElement::Content::picture;
  element.octets = pictures_.shelf().file(sub);
  return !element.octets.empty();
}

void PassengerInformationUnit::tell_failure(bool has_failed) {
  device_.signal(flag_cannot_be_displayed, has_failed);
  device_.report(bus_error::mapping_not_supported, has_failed);
}

}  // namespace canvoy::cia407
