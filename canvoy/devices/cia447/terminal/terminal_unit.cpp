#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* terminal_commands[] = {
    &number_pad_command_object,          &function_keys_command_object,
    &control_keys_command_object,        &steering_wheel_switch_pad_command_object,
    &emergency_key_command_object,       &display_1_command_object,
    &display_2_command_object,           &buzzer_command_object,
    &functional_warnings_command_object, &icon_display_1_command_object,
    &icon_display_2_command_object};

/// In the order of TerminalPart.
constexpr FieldPlace part_lock_commands[] = {place_of(number_pad_command),
                                             place_of(function_keys_command_key),
                                             place_of(control_keys_command),
                                             place_of(steering_wheel_switch_pad_command_access),
                                             place_of(emergency_key_command_access),
                                             place_of(display_1_command),
                                             place_of(display_2_command)};
static_assert(std::size(part_lock_commands) == lockable_part_count);

/// The part that a command locks, or no part.
constexpr unsigned locked_by(const FieldPlace& place) {
  unsigned part = 0;
  while (part < lockable_part_count && part_lock_commands[part] != place) ++part;
  return part;
}

constexpr TerminalPart part_of(TerminalDisplay display) {
  return display == TerminalDisplay::display_1 ? TerminalPart::display_1 : TerminalPart::display_2;
}

/// The code for this number of lines, columns or characters (errata A6).
template <class Handle>
constexpr auto told(const Handle&, unsigned count) {
  using Raw = typename Handle::Reference::Raw;
  return static_cast<Raw>(Handle::Place::rules.nearest(count));
}

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

constexpr AccessHandlers TerminalUnit::hook_calls[] = {
    before_write<&TerminalUnit::check_title, display_1_title_object>,
    before_write<&TerminalUnit::check_text_1, display_1_text_object>,
    before_write<&TerminalUnit::check_text_2, display_2_text_object>,
    after_write<&TerminalUnit::display_1_written, display_1_title_object>,
    after_write<&TerminalUnit::display_1_written, display_1_text_object>,
    after_write<&TerminalUnit::display_2_written, display_2_text_object>};
constexpr ServiceHandlers TerminalUnit::service_calls = {.reset = method<&TerminalUnit::reset>,
                                                         .hooks = hook_calls};

TerminalUnit::TerminalUnit(CarNetwork& network, const TerminalHardware& hardware,
                           const TerminalSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      values_(network.node().dictionary()),
      commands_(network, terminal_commands,
                {.commanded = callback<&TerminalUnit::commanded>(*this),
                 .refuses = callback<&TerminalUnit::refuses>(*this),
                 .lacking = (list_lacking(), std::span(lacking_).first(lacking_count_))}),
      icons_1_(network, IconDisplay::display_1, hardware.show_icon),
      icons_2_(network, IconDisplay::display_2, hardware.show_icon) {
  for (unsigned part = 0; part < terminal_part_count; ++part) {
    if (settings.missing[part]) states_[part] = PartState::not_available;
  }
  network.node().attach(service_);
  next_lost_ = network.on_lost(callback<&TerminalUnit::lost>(*this));
}

/// Called before all members are constructed: uses only settings and places.
void TerminalUnit::list_lacking() {
  const auto lack = [this](const FieldPlace& place) { lacking_[lacking_count_++] = place; };
  for (unsigned part = 0; part < lockable_part_count; ++part) {
    if (settings_.missing[part]) lack(part_lock_commands[part]);
  }
  if (settings_.missing[number_of(TerminalPart::buzzer)]) lack(place_of(buzzer_command));
  if (settings_.missing[number_of(TerminalPart::warnings)]) {
    lack(place_of(functional_warnings_command));
  }
  const auto lack_icons = [&](TerminalPart part, const auto&... fields) {
    if (!settings_.missing[number_of(part)]) return;
    for (FieldPlace place : {place_of(fields)...}) {
      for (unsigned icon = 0; icon < IconRow::icons; ++icon, ++place.sub) lack(place);
    }
  };
  lack_icons(TerminalPart::icon_display_1, icon_display_1_command, icon_display_1_command_content,
             icon_display_1_command_format);
  lack_icons(TerminalPart::icon_display_2, icon_display_2_command, icon_display_2_command_content,
             icon_display_2_command_format);
}

// Life of the node, and of other nodes.

/// The holder of a part detects the boot-up, and locks it again. Warnings stay as they are.
void TerminalUnit::reset(ResetScope) {
  for (PartLock& lock : locks_) lock.reset();
  takes_iso_tp_ = false;
  buzz(false, 0);
  report_parameters();
  for (unsigned part = 0; part < lockable_part_count; ++part) tell(TerminalPart(part));
  icons_1_.reset();
  icons_2_.reset();
  icons_1_.sense(state(TerminalPart::icon_display_1));
  icons_2_.sense(state(TerminalPart::icon_display_2));
  tell(TerminalPart::warnings);
}

void TerminalUnit::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  for (unsigned part = 0; part < lockable_part_count; ++part) {
    if (locks_[part].lose(node)) tell(TerminalPart(part));
  }
  icons_1_.lose(node);
  icons_2_.lose(node);
  if (is_buzzing_ && buzzed_by_ == node) buzz(false, 0);
}

// Commands.

AbortCode TerminalUnit::refuses(const Commanded& wanted) {
  const unsigned part = locked_by(wanted.place);
  // Missing parts are not commanded; icons are handled as whole words.
  if (part == lockable_part_count || !has(TerminalPart(part))) return AbortCode::none;
  const auto command = wanted.as<AccessCommand>();
  const bool locks = command != AccessCommand::release;
  if (locks && states_[part] != PartState::working) return AbortCode::device_state;
  return locks_[part].check(command, wanted.client);
}

void TerminalUnit::commanded(const Commanded& wanted) {
  const unsigned part = locked_by(wanted.place);
  if (part < lockable_part_count) {
    const auto command = wanted.as<AccessCommand>();
    locks_[part].command(command, wanted.client);
    if (locks_[part].is_held()) network_.watch(wanted.client);
    if (TerminalPart(part) == TerminalPart::display_1) {
      takes_iso_tp_ = command == AccessCommand::lock_for_iso_tp;
    }
    tell(TerminalPart(part));
  } else if (wanted.is_for(buzzer_command)) {
    buzz(wanted.as<Order>() == Order::on, wanted.client);
  } else if (wanted.is_for(functional_warnings_command)) {
    command_warnings(wanted.as<WarningCommand>());
  } else if (icons_1_.is_mine(wanted.place) && has(TerminalPart::icon_display_1)) {
    icons_1_.commanded(wanted);
  } else if (icons_2_.is_mine(wanted.place) && has(TerminalPart::icon_display_2)) {
    icons_2_.commanded(wanted);
  }
}

/// The buzzer stops when the device that switched it on is lost.
void TerminalUnit::buzz(bool is_on, NodeId client) {
  buzzed_by_ = client;
  if (is_on) network_.watch(client);
  if (is_on == is_buzzing_) return;
  is_buzzing_ = is_on;
  hardware_.buzz(is_on);
}

void TerminalUnit::command_warnings(WarningCommand command) {
  const auto code = static_cast<unsigned>(command);
  constexpr auto first_set = static_cast<unsigned>(WarningCommand::set_fire_cartridge_empty);
  if (command == WarningCommand::reset_all) {
    for (unsigned i = 1; i <= terminal_warning_count; ++i) set_warning(TerminalWarning(i), false);
  } else if (code >= first_set) {
    set_warning(TerminalWarning(code - first_set + 1), true);
  } else {
    set_warning(TerminalWarning(code), false);
  }
  tell(TerminalPart::warnings);
}

void TerminalUnit::set_warning(TerminalWarning warning, bool is_on) {
  bool& now = warnings_[static_cast<unsigned>(warning) - 1];
  if (now == is_on) return;
  now = is_on;
  hardware_.warn(warning, is_on);
}

// Texts.

AbortCode TerminalUnit::check_title(const Entry&, std::span<const std::uint8_t> text) {
  TextArea area = settings_.display_1;
  area.lines = 1;
  return check_text(TerminalPart::display_1, area, text);
}
AbortCode TerminalUnit::check_text_1(const Entry&, std::span<const std::uint8_t> text) {
  return check_text(TerminalPart::display_1, settings_.display_1, text);
}
AbortCode TerminalUnit::check_text_2(const Entry&, std::span<const std::uint8_t> text) {
  return check_text(TerminalPart::display_2, settings_.display_2, text);
}

AbortCode TerminalUnit::check_text(TerminalPart part, const TextArea& area,
                                   std::span<const std::uint8_t> text) const {
  const bool takes_other = part == TerminalPart::display_1 && takes_iso_tp_;
  const bool is_free = state(part) == PartState::working && !takes_other;
  if (!is_free || !locks_[number_of(part)].is_held_by(network_.client())) {
    return AbortCode::device_state;
  }
  return area.fits(as_text(text)) ? AbortCode::none : AbortCode::value_range;
}

void TerminalUnit::display_1_written() {
  report_display(TerminalDisplay::display_1);
}
void TerminalUnit::display_2_written() {
  report_display(TerminalDisplay::display_2);
}

DisplayContent TerminalUnit::content(TerminalDisplay display) const {
  const TerminalPart part = part_of(display);
  DisplayContent content = {
      .display = display, .holder = holder(part), .is_on = state(part) == PartState::working};
  if (display == TerminalDisplay::display_1) {
    content.title = values_[display_1_title].value();
    content.text = values_[display_1_text].value();
  } else {
    content.text = values_[display_2_text].value();
  }
  return content;
}

void TerminalUnit::report_display(TerminalDisplay display) {
  const TerminalPart part = part_of(display);
  // Contents of the car are no text of an add-on device.
  if (holder(part) == 0 && display == TerminalDisplay::display_1) {
    values_[display_1_text] = std::string_view();
    values_[display_1_title] = std::string_view();
  } else if (holder(part) == 0) {
    values_[display_2_text] = std::string_view();
  }
  if (has(part)) hardware_.show(content(display));
}

// Statuses.

void TerminalUnit::report_parameters() {
  const auto report_area = [this](const TextArea& area, TerminalPart part, const auto& lines,
                                  const auto& columns, const auto& characters) {
    if (!has(part)) {
      values_[lines] = std::nullopt;
      values_[columns] = std::nullopt;
      values_[characters] = std::nullopt;
      return;
    }
    values_[lines].set_raw(told(lines, area.lines));
    values_[columns].set_raw(told(columns, area.columns));
    values_[characters].set_raw(told(characters, area.characters));
  };
  report_area(settings_.display_1, TerminalPart::display_1, display_1_parameters_line_number,
              display_1_parameters_column_number, display_1_parameters_maximal_character_number);
  report_area(settings_.display_2, TerminalPart::display_2, display_2_parameters_line_number,
              display_2_parameters_column_number, display_2_parameters_maximal_character_number);
}

void TerminalUnit::sense(TerminalPart part, PartState state) {
  if (!has(part) || states_[number_of(part)] == state) return;
  states_[number_of(part)] = state;
  if (part == TerminalPart::icon_display_1) {
    icons_1_.sense(state);
  } else if (part == TerminalPart::icon_display_2) {
    icons_2_.sense(state);
  } else {
    tell(part);
  }
}

TerminalAccess TerminalUnit::access(TerminalPart part) const {
  switch (state(part)) {
    case PartState::working:
      return locks_[number_of(part)].access();
    case PartState::off:
      return TerminalAccess::none;
    case PartState::failure:
      return TerminalAccess::failure;
    case PartState::not_available:
      break;
  }
  return TerminalAccess::not_available;
}

/// Pressed keys and lit lamps, as far as the part works.
template <class Handle, class Code>
void TerminalUnit::report_sensed(TerminalPart part, const Handle& handle, Code sensed) {
  switch (state(part)) {
    case PartState::working:
      values_[handle] = sensed;
      break;
    case PartState::off:
      values_[handle] = Code{};
      break;
    case PartState::failure:
      values_[handle] = Code::failure;
      break;
    case PartState::not_available:
      values_[handle] = Code::not_available;
      break;
  }
}

void TerminalUnit::tell(TerminalPart part) {
  switch (part) {
    case TerminalPart::number_pad:
      values_[number_pad_status_access] = access(part);
      report_sensed(part, number_pad_user_interaction, number_pad_.state());
      break;
    case TerminalPart::function_pad:
      values_[function_keys_status_key_access] = access(part);
      report_sensed(part, function_keys_user_interaction_key, function_keys_.state());
      break;
    case TerminalPart::control_pad:
      values_[control_keys_status_key_access] = access(part);
      report_sensed(part, control_keys_user_interaction_key, control_keys_.state());
      break;
    case TerminalPart::switch_pad:
      values_[steering_wheel_switch_pad_status_access] = access(part);
      report_sensed(part, steering_wheel_switch_pad_user_interaction, switch_pad_.state());
      break;
    case TerminalPart::emergency_key:
      values_[emergency_key_status_access] = access(part);
      report_sensed(part, emergency_key_user_interaction,
                    emergency_key_ ? Signal::yes : Signal::no);
      break;
    case TerminalPart::display_1:
      values_[display_1_status] = access(part);
      report_display(TerminalDisplay::display_1);
      break;
    case TerminalPart::display_2:
      values_[display_2_status] = access(part);
      report_display(TerminalDisplay::display_2);
      break;
    case TerminalPart::warnings:
      report_warnings();
      break;
    default:
      break;
  }
}

void TerminalUnit::report_warnings() {
  const auto report_one = [this](const auto& handle, TerminalWarning warning) {
    report_sensed(TerminalPart::warnings, handle, is_warning(warning) ? Signal::yes : Signal::no);
  };
  report_one(functional_warnings_status_fire_extinguishing_system_cartridge_empty,
             TerminalWarning::fire_cartridge_empty);
  report_one(functional_warnings_status_fire_extinguishing_system_active,
             TerminalWarning::fire_active);
  report_one(functional_warnings_status_fire_extinguishing_system_on, TerminalWarning::fire_on);
  report_one(functional_warnings_status_fire_extinguishing_system_fault,
             TerminalWarning::fire_fault);
  report_one(functional_warnings_status_fresh_air_system_cylinder_empty,
             TerminalWarning::air_cylinder_empty);
  report_one(functional_warnings_status_fresh_air_system_active, TerminalWarning::air_active);
  report_one(functional_warnings_status_fresh_air_system_inactive, TerminalWarning::air_inactive);
}

void TerminalUnit::press_emergency_key(bool is_pressed) {
  emergency_key_ = is_pressed;
  tell(TerminalPart::emergency_key);
}

}  // namespace canvoy::cia447
