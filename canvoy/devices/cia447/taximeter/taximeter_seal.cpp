// Behind the seal of a taximeter: service mode, k, errors, and the audit log.
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::cia447 {

bool TaximeterUnit::enter_service() {
  const bool is_idle = record_.state == Taximeter::for_hire ||
                       record_.state == Taximeter::signed_off ||
                       record_.state == Taximeter::standby_mode;
  if (!is_idle || !hardware_.seal_is_open()) return false;
  advance(0, false);
  enter(Taximeter::service_mode);
  watch_seal();
  note(AuditEvent::service_entered);
  return true;
}

bool TaximeterUnit::leave_service() {
  if (record_.state != Taximeter::service_mode || hardware_.seal_is_open()) return false;
  watch_seal();
  adopt_source();
  record_.tampering = 0;
  record_.totals_are_known = true;
  record_.date_of_securing = utc_now();
  calibration_.reset();
  wheel_.forget();
  wheel_check_.forget();
  set_error(TaximeterError::wheel_source, false);
  set_error(TaximeterError::wheel_node, false);
  set_error(TaximeterError::extra_pulses, false);
  set_error(TaximeterError::seal, false);
  note(AuditEvent::sealed, 0, record_.k);
  const bool is_done = enter(Taximeter::signed_off);
  publish_configuration();
  return is_done;
}

/// A seal that was opened outside of service mode has to be closed in service mode before the next
/// trip.
void TaximeterUnit::watch_seal() {
  const bool is_open = hardware_.seal_is_open();
  if (is_open != is_seal_open_) {
    is_seal_open_ = is_open;
    note(is_open ? AuditEvent::seal_opened : AuditEvent::seal_closed);
  }
  if (!is_open || record_.state == Taximeter::service_mode) return;
  set_error(TaximeterError::seal, true);
  tamper(tampering::seal);
}

void TaximeterUnit::tamper(std::uint8_t how) {
  if (is_tampered(how)) return;
  record_.tampering = static_cast<std::uint8_t>(record_.tampering | how);
  keep();
}

bool TaximeterUnit::set_k(std::uint32_t k) {
  if (record_.state != Taximeter::service_mode || k == 0 || k > amount_max) return false;
  note(AuditEvent::k_set, record_.k, k);
  record_.k = k;
  record_.distance_rest = 0;
  set_fastest();
  keep();
  publish_configuration();
  return true;
}

bool TaximeterUnit::set_mode(TaximeterMode mode) {
  if (record_.state != Taximeter::service_mode) return false;
  note(AuditEvent::mode_set, static_cast<std::uint32_t>(record_.mode),
       static_cast<std::uint32_t>(mode));
  record_.mode = mode;
  keep();
  publish_configuration();
  return true;
}

bool TaximeterUnit::begin_calibration() {
  if (record_.state != Taximeter::service_mode) return false;
  calibration_ = 0;
  return true;
}

bool TaximeterUnit::end_calibration(std::uint32_t distance) {
  constexpr std::uint64_t pulses_min = 1000;
  if (!calibration_ || distance == 0) return false;
  const std::uint64_t pulses = *calibration_;
  calibration_.reset();
  if (pulses < pulses_min) return false;
  const std::uint64_t k = (pulses * thousandths + distance / 2) / distance;
  if (k > amount_max || !set_k(static_cast<std::uint32_t>(k))) return false;
  note(AuditEvent::calibrated, capped(pulses), record_.k);
  return true;
}

void TaximeterUnit::set_error(TaximeterError error, bool is_present, std::uint8_t sealed,
                              std::uint8_t found) {
  const bool was_present = (errors_ & bit_of(error)) != 0;
  if (is_present == was_present) return;
  errors_ = static_cast<std::uint8_t>(errors_ ^ bit_of(error));
  report(error, is_present, sealed, found);
  if (!is_present) return;
  const bool is_of_sender = error == TaximeterError::wheel_node;
  note(AuditEvent::error, static_cast<std::uint32_t>(error), std::uint32_t{sealed} << 8 | found,
       is_of_sender ? found : by_meter);
  if (is_of_sender || error == TaximeterError::wheel_source) tamper(tampering::source);
}

void TaximeterUnit::report(TaximeterError error, bool is_present, std::uint8_t sealed,
                           std::uint8_t found) {
  const auto number = static_cast<std::uint8_t>(error);
  network_.node().report({.code = emergency_code::taximeter,
                          .instance = number,
                          .register_bits = error_register::profile,
                          .info = {number, sealed, found, 0, 0}},
                         is_present);
}

// The audit log.

void TaximeterUnit::note(AuditEvent what, std::uint32_t detail, std::uint32_t value,
                         std::uint8_t who) {
  const AuditEntry entry = {.at = seconds_since_1970(utc_now()),
                            .what = what,
                            .who = who,
                            .detail = detail,
                            .value = value};
  const AuditEntry& kept = audit_.note(entry);
  (kept.times == 1 ? has_new_audit_ : has_more_audit_) = true;
  hardware_.recorded(kept);
}

namespace {

std::uint8_t recorded_client(NodeId client) {
  return client == 0 ? by_default_channel : client;
}
std::uint32_t recorded_place(std::uint16_t index, std::uint8_t sub) {
  return std::uint32_t{index} << 8 | sub;
}

}  // namespace

void TaximeterUnit::write_refused(const RefusedWrite& refused) {
  note(AuditEvent::write_refused, recorded_place(refused.index, refused.sub), refused.value,
       recorded_client(refused.client));
}

/// The senders from which wheels and clock are read are behind the seal: PDO and SDO parameters.
AbortCode TaximeterUnit::check_settings(const Entry& entry, std::span<const std::uint8_t> value) {
  if (record_.state == Taximeter::service_mode) return AbortCode::none;
  note(AuditEvent::settings_refused, recorded_place(entry.index, entry.sub),
       static_cast<std::uint32_t>(load_unsigned(value)), recorded_client(network_.mesh_client()));
  return AbortCode::device_state;
}

void TaximeterUnit::report_audit() {
  Dictionary& dictionary = network_.node().dictionary();
  dictionary.set_number(audit_object.index, 1, audit_.events());
  dictionary.set_number(audit_object.index, 2, audit_.size());
  dictionary.set_number(audit_object.index, 3, audit_.lost());
}

void TaximeterUnit::report_audit_line(const Entry& entry) {
  if (entry.sub == 0) return;
  const AuditEntry* const kept = audit_.newest(entry.sub - 1U);
  const AuditText text = kept != nullptr ? audit_text(*kept) : AuditText();
  const std::string_view line = text.view();
  network_.node().dictionary().set(
      entry, {reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
}

/// A new entry is kept within a second; the counts of repetitions from time to time, so that events
/// cannot wear the flash out.
void TaximeterUnit::keep_audit(bool at_once) {
  const Time now = network_.node().now();
  const bool is_due = has_more_audit_ && now - audit_kept_at_ >= settings_.keeping_period;
  if (!has_new_audit_ && !is_due && !(at_once && has_more_audit_)) return;
  has_new_audit_ = has_more_audit_ = false;
  audit_kept_at_ = now;
  if (at_once) {
    audit_memory_.save_now(audit_);
  } else {
    audit_memory_.save(audit_);
  }
}

}  // namespace canvoy::cia447
