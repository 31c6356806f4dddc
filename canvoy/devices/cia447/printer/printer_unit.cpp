#include "canvoy/devices/cia447/printer/printer_unit.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* commands_of_printer[] = {&printer_configuration_command_object,
                                                     &printer_mode_command_object};

constexpr Signal signal(bool is_so) {
  return is_so ? Signal::yes : Signal::no;
}

}  // namespace

constexpr ServiceHandlers PrinterUnit::service_calls = {.reset = method<&PrinterUnit::reset>};

PrinterUnit::PrinterUnit(CarNetwork& network, const PrinterHardware& hardware,
                         const PrinterSettings& settings)
    : network_(network),
      settings_(settings),
      values_(network.node().dictionary()),
      stream_(hardware.paper, {.dots_per_line = settings.font.dots_per_line,
                               .can_cut = settings.can.cut,
                               .logos = settings.logos}),
      font_(settings.font),
      commands_(network, commands_of_printer,
                {.commanded = callback<&PrinterUnit::commanded>(*this),
                 .refuses = callback<&PrinterUnit::refuses>(*this),
                 .lacking = (list_lacking(), std::span(lacking_).first(lacking_count_))}),
      timer_(callback<&PrinterUnit::finished>(*this)) {
  domain_.open_read = callback<&PrinterUnit::read_back>(*this);
  domain_.open_write = callback<&PrinterUnit::open>(*this);
  domain_.write = callback<&PrinterUnit::write>(*this);
  domain_.close_write = callback<&PrinterUnit::close>(*this);
  transport_hook_.first = transport_hook_.last = printer_transport_object.index;
  transport_hook_.domain = &domain_;
  network.node().dictionary().attach(transport_hook_);
  network.node().attach(service_);
}

/// Called before all members are constructed: uses only settings and places.
void PrinterUnit::list_lacking() {
  const auto lack = [this](bool is_lacking, const auto& handle) {
    if (is_lacking) lacking_[lacking_count_++] = place_of(handle);
  };
  const PrinterAbilities& can = settings_.can;
  lack(!can.bold, printer_configuration_command_print_bold);
  lack(!can.cursive, printer_configuration_command_print_cursive);
  lack(!can.variable_width, printer_configuration_command_use_variable_width_font);
  lack(!can.text, printer_configuration_command_height_of_used_font);
  lack(!can.text, printer_configuration_command_width_of_used_font);
  lack(!can.text, printer_configuration_command_number_of_chars_per_line);
}

/// After a reset, the printer has no settings of former clients; the contents on paper stay.
void PrinterUnit::reset(ResetScope) {
  is_transporting_ = false;
  stream_.end();
  count_motion();
  font_ = PrinterFont(settings_.font);
  stream_.set_mode(settings_.can.text ? PrinterMode::text : PrinterMode::graphics_black);
  use_font();
  values_[printer_mode_status] = stream_.mode();
  report_features();
  report_sizes();
  report_state();
}

// Settings of the clients.

bool PrinterUnit::allows(PrinterMode mode) const {
  switch (mode) {
    case PrinterMode::text:
      return settings_.can.text;
    case PrinterMode::graphics_black:
      return settings_.can.black;
    case PrinterMode::graphics_gray:
      return settings_.can.gray;
    case PrinterMode::graphics_rgb:
      return settings_.can.rgb;
    case PrinterMode::graphics_cmyk:
      return settings_.can.cmyk;
    case PrinterMode::logo:
      return !settings_.logos.empty();
    default:
      return false;
  }
}

bool PrinterUnit::allows(ColorSpaceCommand command) const {
  if (command == ColorSpaceCommand::rgb) return settings_.can.rgb;
  return command != ColorSpaceCommand::cmyk || settings_.can.cmyk;
}

AbortCode PrinterUnit::refuses(const Commanded& wanted) {
  bool is_allowed = true;
  if (wanted.is_for(printer_mode_command)) {
    // The settings apply to the bytes under way, and must not change.
    if (is_transporting_) return AbortCode::device_state;
    is_allowed = allows(wanted.as<PrinterMode>());
  } else if (wanted.is_for(printer_configuration_command_height_of_used_font)) {
    is_allowed = font_.allows_height(wanted.code);
  } else if (wanted.is_for(printer_configuration_command_width_of_used_font)) {
    is_allowed = font_.allows_width(wanted.code);
  } else if (wanted.is_for(printer_configuration_command_number_of_chars_per_line)) {
    is_allowed = font_.allows_characters(wanted.code);
  } else if (wanted.is_for(printer_configuration_command_use_certain_color_space)) {
    is_allowed = allows(wanted.as<ColorSpaceCommand>());
  }
  return is_allowed ? AbortCode::none : AbortCode::value_range;
}

void PrinterUnit::commanded(const Commanded& wanted) {
  const bool executes = wanted.as<FontCommand>() == FontCommand::execute;
  if (wanted.is_for(printer_mode_command)) {
    stream_.set_mode(wanted.as<PrinterMode>());
    values_[printer_mode_status] = stream_.mode();
    count_motion();
    return;
  }
  if (wanted.is_for(printer_configuration_command_print_bold)) {
    font_.is_bold = executes;
  } else if (wanted.is_for(printer_configuration_command_print_cursive)) {
    font_.is_cursive = executes;
  } else if (wanted.is_for(printer_configuration_command_use_variable_width_font)) {
    font_.has_variable_width = executes;
  } else if (wanted.is_for(printer_configuration_command_height_of_used_font)) {
    font_.set_height(wanted.code);
  } else if (wanted.is_for(printer_configuration_command_width_of_used_font)) {
    font_.set_width(wanted.code);
  } else if (wanted.is_for(printer_configuration_command_number_of_chars_per_line)) {
    font_.set_characters(wanted.code);
  } else if (wanted.as<ColorSpaceCommand>() == ColorSpaceCommand::rgb) {
    font_.color_space = ColorSpace::rgb;
  } else if (wanted.as<ColorSpaceCommand>() == ColorSpaceCommand::cmyk) {
    font_.color_space = ColorSpace::cmyk;
  }
  use_font();
}

void PrinterUnit::use_font() {
  stream_.set_style(font_.style(), font_.characters_per_line());
  report_font();
}

// The transport.

/// The printed contents are not stored.
Result<std::uint32_t> PrinterUnit::read_back(const Entry&) {
  return AbortCode::no_data;
}

AbortCode PrinterUnit::open(const Entry&, std::uint32_t) {
  if (!can_print() || is_transporting_) return AbortCode::device_state;
  mechanism_ = PrinterMechanism::working;
  is_transporting_ = true;
  report_state();
  return AbortCode::none;
}

AbortCode PrinterUnit::write(const Entry&, std::span<const std::uint8_t> bytes) {
  if (!can_print()) return AbortCode::device_state;
  stream_.write(bytes);
  wants_form_feed_ = settings_.lines_to_form_feed == 0;
  return AbortCode::none;
}

/// Printed contents cannot be undone, complete or not.
AbortCode PrinterUnit::close(const Entry&, bool) {
  is_transporting_ = false;
  if (can_print()) stream_.end();
  count_motion();
  report_state();
  return AbortCode::none;
}

void PrinterUnit::count_motion() {
  const std::uint32_t dots = stream_.fed() - counted_;
  counted_ = stream_.fed();
  const Time now = network_.node().now();
  if (settings_.dots_per_second > 0 && can_print()) {
    const auto takes = Duration(std::chrono::microseconds(1s)) * dots / settings_.dots_per_second;
    busy_until_ = std::max(busy_until_, now) + takes;
  }
  network_.node().timers().arm(timer_, std::max(busy_until_, now));
}

void PrinterUnit::finished(Time) {
  if (wants_form_feed_ && !is_transporting_ && can_print()) {
    wants_form_feed_ = false;
    stream_.feed_lines(settings_.automatic_lines);
    count_motion();
  }
  report_state();
}

// The mechanism.

void PrinterUnit::sense_paper(bool is_there) {
  has_paper_ = is_there;
  // Outstanding movements are cancelled.
  if (!is_there) busy_until_ = network_.node().now();
  report_state();
}

void PrinterUnit::sense(PrinterMechanism mechanism) {
  mechanism_ = mechanism;
  if (mechanism == PrinterMechanism::failure) busy_until_ = network_.node().now();
  report_state();
}

// Statuses.

/// Without paper, nothing can be printed: this is a failure, and 60E1h gives the reason.
void PrinterUnit::report_state() {
  const bool has_failed = mechanism_ == PrinterMechanism::failure;
  PrinterState state = is_busy() ? PrinterState::busy : PrinterState::ready;
  if (mechanism_ == PrinterMechanism::standby && !is_busy()) state = PrinterState::standby;
  if (!can_print()) state = PrinterState::failure;
  values_[printer_status] = state;
  values_[printer_status_buffer_empty] = has_failed ? Signal::failure : signal(!is_busy());
  values_[printer_errors_no_paper] = has_failed ? Signal::failure : signal(!has_paper_);
}

void PrinterUnit::report_features() {
  const PrinterAbilities& can = settings_.can;
  const PrinterFontLimits& font = settings_.font;
  const bool scales = font.height_max > font.height_min || font.width_max > font.width_min;
  values_[printer_features_able_to_print_text] = signal(can.text);
  values_[printer_features_able_to_print_bold] = signal(can.text && can.bold);
  values_[printer_features_able_to_print_cursive] = signal(can.text && can.cursive);
  values_[printer_features_able_to_scale_text] = signal(can.text && scales);
  values_[printer_features_variable_width_supported] = signal(can.text && can.variable_width);
  values_[printer_features_fixed_width_supported] = signal(can.text);
  values_[printer_features_able_to_print_graphics] =
      signal(can.black || can.gray || can.rgb || can.cmyk);
  values_[printer_features_able_to_print_black_white] = signal(can.black);
  values_[printer_features_able_to_print_gray] = signal(can.gray);
  values_[printer_features_able_to_print_rgb] = signal(can.rgb);
  values_[printer_features_able_to_print_cmyk] = signal(can.cmyk);
  values_[printer_features_logo_number] = settings_.logos.size();
  values_[printer_features_able_to_cut_paper] = signal(can.cut);
  values_[printer_features_lines_to_form_feed] = settings_.lines_to_form_feed;
}

void PrinterUnit::report_sizes() {
  const PrinterFontLimits& font = settings_.font;
  values_[printer_text_status_maximum_number_of_characters_per_full_line] = font.characters_max();
  values_[printer_text_status_minimum_number_of_characters_per_full_line] = font.characters_min();
  values_[printer_text_status_maximum_height] = font.height_max;
  values_[printer_text_status_minimum_height] = font.height_min;
  values_[printer_text_status_maximum_width] = font.width_max;
  values_[printer_text_status_minimum_width] = font.width_min;
  values_[printer_graphics_status_number_of_dots_per_line] = font.dots_per_line;
  // Eight bits of gray, and of each color.
  constexpr unsigned depth = 8;
  if (settings_.can.gray) {
    values_[printer_graphics_status_number_of_grayscales] = 1U << depth;
  } else {
    values_[printer_graphics_status_number_of_grayscales] = std::nullopt;
  }
  if (settings_.can.rgb || settings_.can.cmyk) {
    values_[printer_graphics_status_number_of_bits_per_colour_channel] = depth;
  } else {
    values_[printer_graphics_status_number_of_bits_per_colour_channel] = std::nullopt;
  }
}

void PrinterUnit::report_font() {
  const PrintStyle style = font_.style();
  values_[printer_text_status_current_number_of_characters_per_full_line] =
      font_.characters_per_line();
  values_[printer_text_status_current_height] = style.height;
  values_[printer_text_status_current_width] = style.width;
  values_[printer_configuration_status_text_bold] = signal(font_.is_bold);
  values_[printer_configuration_status_text_cursive] = signal(font_.is_cursive);
  values_[printer_configuration_status_variable_width_font] = signal(font_.has_variable_width);
  values_[printer_configuration_status_color_space] = font_.color_space;
  values_[printer_configuration_status_height_of_used_font].set_raw(font_.height());
  values_[printer_configuration_status_width_of_used_font].set_raw(font_.width());
  values_[printer_configuration_status_number_of_chars_per_line].set_raw(font_.characters());
}

}  // namespace canvoy::cia447
