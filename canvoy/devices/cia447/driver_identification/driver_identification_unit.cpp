#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"

namespace canvoy::cia447 {

namespace {

/// The part of a UTF-8 text that fits, without half a character at its end.
std::string_view fitting(std::string_view text, std::size_t capacity) {
  if (text.size() <= capacity) return text;
  std::size_t length = capacity;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  return text.substr(0, length);
}

}  // namespace

constexpr ServiceHandlers DriverIdentificationUnit::service_calls = {
    .reset = method<&DriverIdentificationUnit::reset>};

DriverIdentificationUnit::DriverIdentificationUnit(CarNetwork& network,
                                                   const DriverIdentificationHardware& hardware,
                                                   const DriverIdentificationSettings& settings)
    : network_(network),
      hardware_(hardware),
      bus_clock_(network.node()),
      clock_objects_(
          network,
          {.provider = settings.clock_node, .objects = bus_clock_objects, .check = check_of_date}),
      clock_reader_(network, {.server = settings.clock_node,
                              .indices = clock_objects,
                              .period = settings.asking_period,
                              .came = callback<&DriverIdentificationUnit::clock_was_read>(*this)}) {
  network.node().attach(service_);
}

/// An NMT reset does not log a driver out.
void DriverIdentificationUnit::reset(ResetScope /*scope*/) {
  tell();
}

std::uint32_t DriverIdentificationUnit::now() {
  const std::optional<LocalTime> told = bus_clock_.read();
  const std::optional<LocalTime> time = told ? told : hardware_.clock();
  const bool is_told = time.has_value() && time->utc() >= 0 && time->utc() < 0xFFFF'FFFE;
  return is_told ? static_cast<std::uint32_t>(time->utc()) : no_time_told;
}

bool DriverIdentificationUnit::log_in(const DriverCard& card) {
  if (is_logged_in_ || reader_ != CardReader::working) return false;
  has_failed_ = hardware_.knows && !hardware_.knows(card.id);
  if (!has_failed_) {
    is_logged_in_ = true;
    id_ = card.id;
    name_length_ = fitting(card.name, name_.size()).copy(name_.data(), name_.size());
    login_ = now();
    logout_ = no_time_told;
  }
  tell();
  return !has_failed_;
}

bool DriverIdentificationUnit::log_out() {
  if (!is_logged_in_) return false;
  is_logged_in_ = false;
  id_ = 0;
  name_length_ = 0;
  logout_ = now();
  tell();
  return true;
}

void DriverIdentificationUnit::card_is_unreadable() {
  has_failed_ = true;
  tell();
}

void DriverIdentificationUnit::forget_failure() {
  has_failed_ = false;
  tell();
}

void DriverIdentificationUnit::reader_is(CardReader reader) {
  reader_ = reader;
  tell();
}

/// The logged-in driver is known while the reader fails; only new cards are not.
void DriverIdentificationUnit::tell() {
  const Values driver(network_.node().dictionary());
  driver[unique_driver_id].set_raw(id_);
  driver[drivers_name] = std::string_view(name_.data(), name_length_);
  driver[driver_login_time].set_raw(login_);
  driver[driver_logout_time].set_raw(logout_);
  const auto said = [this](bool is_so) {
    if (reader_ == CardReader::failed) return Signal::failure;
    if (reader_ == CardReader::not_available) return Signal::not_available;
    return is_so ? Signal::yes : Signal::no;
  };
  driver[driver_id_status_logged_in] = is_logged_in_ ? Signal::yes : Signal::no;
  driver[driver_id_status_data_state] = said(is_logged_in_);
  driver[driver_id_status_system_failure] = said(has_failed_);
}

}  // namespace canvoy::cia447
