#include "canvoy/devices/cia447/terminal/icon_row.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

/// The corresponding field of the first icon of the first display.
FieldPlace first_of(FieldPlace place) {
  if (place.index == icon_display_2_command_object.index) {
    place.index = icon_display_1_command_object.index;
  }
  place.sub = place_of(icon_display_1_command).sub;
  return place;
}

/// A field in a value to be written, equal for both displays.
template <class Handle>
auto field_in(std::uint64_t value, const Handle&) {
  return extract(value, Handle::Place::bits);
}

}  // namespace

constexpr AccessHandlers IconRow::hook_calls[] = {
    before_write<&IconRow::check, icon_display_1_command_object>};
constexpr ServiceHandlers IconRow::service_calls = {.hooks = hook_calls};

std::uint16_t IconRow::shift_to(IconDisplay display) {
  constexpr unsigned between =
      icon_display_2_command_object.index - icon_display_1_command_object.index;
  return display == IconDisplay::display_1 ? 0 : between;
}

IconRow::IconRow(CarNetwork& network, IconDisplay display, Callback<void(const ShownIcon&)> shown)
    : network_(network), display_(display), show_(shown) {
  network.node().attach(service_);
  for (unsigned number = 1; number <= icons; ++number) {
    shown_[number - 1].display = display;
    shown_[number - 1].number = number;
  }
}

bool IconRow::is_mine(const FieldPlace& place) const {
  return place.index == icon_display_1_command_object.index + shift_to(display_);
}

AbortCode IconRow::check(const Entry& entry, std::span<const std::uint8_t> value) {
  const bool is_icon = entry.sub >= 1 && entry.sub <= icons;
  if (!is_icon || state_ == PartState::not_available) return AbortCode::none;
  const std::uint64_t word = load_unsigned(value);
  const auto command = static_cast<AccessCommand>(field_in(word, icon_display_1_command));
  const auto icon = static_cast<Icon>(field_in(word, icon_display_1_command_content));
  const auto format = static_cast<IconFormat>(field_in(word, icon_display_1_command_format));
  const PartLock& lock = locks_[entry.sub - 1U];
  const NodeId client = network_.client();
  const bool locks = command == AccessCommand::lock;
  if (locks && state_ != PartState::working) return AbortCode::device_state;
  const AbortCode answer = lock.check(command, client);
  if (answer != AbortCode::none || command != AccessCommand::do_not_care) return answer;
  const bool shows = icon != Icon::do_not_care || format != IconFormat::do_not_care;
  return shows && !lock.is_held_by(client) ? AbortCode::device_state : AbortCode::none;
}

void IconRow::commanded(const Commanded& wanted) {
  const unsigned number = wanted.place.sub;
  ShownIcon& shown = shown_[number - 1];
  PartLock& lock = locks_[number - 1];
  const FieldPlace field = first_of(wanted.place);
  if (field == place_of(icon_display_1_command)) {
    lock.command(wanted.as<AccessCommand>(), wanted.client);
    if (!lock.is_held()) return release(number);
    network_.watch(wanted.client);
    shown.is_locked = true;
  } else if (!lock.is_held()) {
    // Selected in the same word as the release.
    return;
  } else if (field == place_of(icon_display_1_command_content)) {
    shown.icon = wanted.as<Icon>();
  } else if (field == place_of(icon_display_1_command_format)) {
    shown.is_highlighted = wanted.as<IconFormat>() == IconFormat::highlighted;
  }
  tell(number);
}

void IconRow::release(unsigned number) {
  locks_[number - 1].reset();
  shown_[number - 1] = {.display = display_, .number = number};
  tell(number);
}

void IconRow::lose(NodeId node) {
  for (unsigned number = 1; number <= icons; ++number) {
    if (locks_[number - 1].is_held_by(node)) release(number);
  }
}

void IconRow::reset() {
  for (unsigned number = 1; number <= icons; ++number) release(number);
}

void IconRow::sense(PartState state) {
  state_ = state;
  for (unsigned number = 1; number <= icons; ++number) tell(number);
}

void IconRow::tell(unsigned number) {
  const ShownIcon& shown = shown_[number - 1];
  IconAccess access = shown.is_locked ? IconAccess::locked : IconAccess::released;
  Icon icon = shown.icon;
  IconFormat format = shown.is_highlighted ? IconFormat::highlighted : IconFormat::standard;
  if (state_ == PartState::off) {
    icon = Icon::none;
    format = IconFormat::standard;
  } else if (state_ == PartState::failure) {
    access = IconAccess::failure;
    icon = Icon::failure;
    format = IconFormat::failure;
  } else if (state_ == PartState::not_available) {
    access = IconAccess::not_available;
    icon = Icon::not_available;
    format = IconFormat::not_available;
  }
  Values values(network_.node().dictionary());
  if (display_ == IconDisplay::display_1) {
    values[icon_display_1_status[number]] = access;
    values[icon_display_1_status_content[number]] = icon;
    values[icon_display_1_status_format[number]] = format;
  } else {
    values[icon_display_2_status[number]] = access;
    values[icon_display_2_status_content[number]] = icon;
    values[icon_display_2_status_format[number]] = format;
  }
  if (show_ && state_ != PartState::not_available) show_(shown);
}

}  // namespace canvoy::cia447
