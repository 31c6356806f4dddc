#include "canvoy/devices/cia417/controller/unit_errors.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::cia417 {

namespace {

/// A unit that starts at the same time may not be ready for the first request.
constexpr std::uint8_t questions_max = 3;
/// While a unit has an error.
constexpr Duration looks_again_after = 5s;

/// True if an error register reports more than bus and voltage errors. Any error sets the generic
/// bit; alone, it gives no further information.
constexpr bool concerns_trips(std::uint8_t bits) {
  constexpr unsigned harmless =
      error_register::generic | error_register::communication | error_register::voltage;
  return bits == error_register::generic || (bits & ~harmless) != 0;
}

}  // namespace

constexpr ServiceHandlers UnitErrors::service_calls = {
    .reset = method<&UnitErrors::reset>,
    .state_entered = method<&UnitErrors::state_entered>,
    .error_changed = method<&UnitErrors::error_changed>};

UnitErrors::UnitErrors(Node& node, EmergencyConsumer& emergencies, SdoClient& client,
                       const LiftUnits& units)
    : node_(node),
      client_(client),
      units_(units),
      timer_(callback<&UnitErrors::ask_next>(*this)),
      again_timer_(callback<&UnitErrors::look_again>(*this)) {
  node.attach(service_);
  emergencies.on_emergency(callback<&UnitErrors::heard>(*this));
}

LiftParts UnitErrors::guard(const LiftParts& parts) {
  behind_ = parts;
  LiftParts guarded = parts;
  guarded.motion.status = callback<&UnitErrors::motion>(*this);
  guarded.doors.status = callback<&UnitErrors::doors>(*this);
  if (parts.load) guarded.load = callback<&UnitErrors::load>(*this);
  return guarded;
}

MotionStatus UnitErrors::motion() {
  MotionStatus status = behind_.motion.status();
  if (has_error(units_.drive) || has_error(units_.position_unit)) status.available = false;
  return status;
}

DoorsStatus UnitErrors::doors() {
  DoorsStatus status = behind_.doors.status();
  for (unsigned door = 0; door < door_count; ++door) {
    const auto bit = static_cast<DoorMask>(1U << door);
    if (has_error(units_.door_units[door])) status.faulty |= bit;
    if (has_error(units_.light_barrier_units[door])) status.unprotected |= bit;
  }
  return status;
}

LiftLoad UnitErrors::load() {
  LiftLoad now = behind_.load();
  if (has_error(units_.load_unit)) now.known = false;
  return now;
}

void UnitErrors::reset(ResetScope) {
  errors_.reset();
  node_.timers().disarm(timer_);
  node_.timers().disarm(again_timer_);
  questions_ = {};
}

void UnitErrors::state_entered(NmtState state) {
  if (state == NmtState::operational) ask_anew();
}

void UnitErrors::ask_anew() {
  ask(units_.position_unit);
  ask(units_.load_unit);
}

void UnitErrors::error_changed(const Error& error, bool present) {
  if (error.code != canvoy::emergency_code::heartbeat || !is_node_id(error.instance)) return;
  const auto unit = static_cast<NodeId>(error.instance);
  if (present) {
    set(unit, false);
  } else if (unit == units_.position_unit || unit == units_.load_unit) {
    ask(unit);
  }
}

void UnitErrors::heard(NodeId unit, const Emergency& emergency) {
  told_(unit, emergency);
  if (concerns_trips(emergency.code)) set(unit, true);
  const bool is_free =
      emergency.code == canvoy::emergency_code::no_error && emergency.register_bits == 0;
  if (is_free) set(unit, false);
}

void UnitErrors::set(NodeId unit, bool has_error) {
  if (errors_[unit] == has_error) return;
  errors_[unit] = has_error;
  if (has_error) node_.timers().arm(again_timer_, node_.now() + looks_again_after);
  changed_();
}

/// One after the other, for units that have an error.
void UnitErrors::look_again(Time now) {
  if (errors_.none()) return;
  node_.timers().arm(again_timer_, now + looks_again_after);
  Question& question = questions_.back();
  do {
    question.unit = static_cast<NodeId>(question.unit < node_id_max ? question.unit + 1 : 1);
  } while (!errors_[question.unit]);
  question.left = 1;
  ask_next(now);
}

// Reading of error registers.

void UnitErrors::ask(NodeId unit) {
  if (!is_node_id(unit)) return;
  questions_[unit == units_.position_unit ? 0 : 1] = {.unit = unit, .left = questions_max};
  ask_next(node_.now());
}

/// In turn: a unit that does not answer does not delay the others.
void UnitErrors::ask_next(Time) {
  if (client_.busy()) return;
  const auto asked = static_cast<std::size_t>(asking_ - questions_.data());
  for (std::size_t i = 1; i <= questions_.size(); ++i) {
    Question& question = questions_[(asked + i) % questions_.size()];
    if (question.left == 0) continue;
    --question.left;
    asking_ = &question;
    const AbortCode started = client_.upload(question.unit, object_index::error_register, 0,
                                             std::span<std::uint8_t>(register_),
                                             SdoClient::Done::to<&UnitErrors::answered>(*this));
    if (started == AbortCode::none) return;
  }
}

void UnitErrors::answered(SdoClient::Outcome outcome) {
  if (!outcome.is_silence()) asking_->left = 0;
  if (outcome && concerns_trips(register_[0])) set(asking_->unit, true);
  if (outcome && register_[0] == 0) set(asking_->unit, false);
  // Not from here: the NMT state may have ended it.
  node_.timers().arm(timer_, node_.now());
}

}  // namespace canvoy::cia417
