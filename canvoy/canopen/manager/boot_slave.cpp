#include "canvoy/canopen/manager/boot_slave.hpp"

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

/// A read request to a slave, and the expected value of its answer. An expected value of 0 matches
/// all.
struct Question {
  std::uint16_t index;
  std::uint8_t sub;
  std::uint16_t expected_index;
  BootError error;
};

constexpr Question question_of(BootStep step) {
  switch (step) {
    case BootStep::vendor_id:
      return {object_index::identity, 1, master_object::vendor_id, BootError::vendor_id};
    case BootStep::product_code:
      return {object_index::identity, 2, master_object::product_code, BootError::product_code};
    case BootStep::revision_number:
      return {object_index::identity, 3, master_object::revision_number,
              BootError::revision_number};
    case BootStep::serial_number:
      return {object_index::identity, 4, master_object::serial_number, BootError::serial_number};
    default:
      return {object_index::device_type, 0, master_object::device_type, BootError::device_type};
  }
}

constexpr BootStep next(BootStep step) {
  return static_cast<BootStep>(static_cast<unsigned>(step) + 1);
}

}  // namespace

BootSlave::BootSlave(Node& node) : client_(node), timer_(callback<&BootSlave::expired>(*this)) {}

void BootSlave::prepare(BootContext& context, Finished finished) {
  context_ = &context;
  finished_ = finished;
}

SlaveAssignment BootSlave::assignment() const {
  return slave_assignment(context_->node.dictionary(), slave_);
}

void BootSlave::begin(NodeId slave, bool is_fresh) {
  check_invariant(!busy());
  slave_ = slave;
  is_fresh_ = is_fresh;
  was_reset_ = false;
  if (!assignment().is_booted()) return start_error_control();
  ask(BootStep::device_type);
}

void BootSlave::abandon() {
  if (!busy()) return;
  context_->node.timers().disarm(timer_);
  if (has_task_) context_->hooks.abandon(slave_);
  has_task_ = is_restarting_ = false;
  client_.cancel();
  slave_ = 0;
}

/// A download of software ends with a restart.
bool BootSlave::expects_boot_up() const {
  return step_ == BootStep::reset || step_ == BootStep::program || is_restarting_;
}

void BootSlave::booted_up() {
  if (is_restarting_ && timer_.armed()) return end_restart(AbortCode::none);
  if (step_ != BootStep::reset || !timer_.armed()) return;
  context_->node.timers().disarm(timer_);
  update_program();
}

void BootSlave::heard(RemoteState state) {
  if (step_ == BootStep::node_state) state_known(state);
  if (step_ == BootStep::error_control) finish({});
}

BootReport BootSlave::report_of(BootEvent event) const {
  return {.slave = slave_,
          .event = event,
          .step = step_,
          .outcome = {},
          .expected = expected_,
          .found = found_};
}

/// False if the report of the step had the work abandoned.
bool BootSlave::enter(BootStep step) {
  step_ = step;
  expected_ = found_ = 0;
  context_->report(report_of(BootEvent::step));
  return busy();
}

void BootSlave::wait(Duration duration) {
  context_->node.timers().arm(timer_, context_->node.now() + duration);
}

bool BootSlave::is_asked_for(BootStep step) const {
  const std::uint16_t expected_index = question_of(step).expected_index;
  return step == BootStep::device_type ||
         context_->node.dictionary().number(expected_index, slave_) != 0;
}

/// Reads this value, or the next one that is expected.
void BootSlave::ask(BootStep step) {
  while (step < BootStep::node_state && !is_asked_for(step)) step = next(step);
  if (step == BootStep::node_state) return ask_for_state();
  if (!enter(step)) return;
  const Question question = question_of(step);
  expected_ = static_cast<std::uint32_t>(
      context_->node.dictionary().number(question.expected_index, slave_));
  value_.fill(0);
  const AbortCode refused = client_.upload(
      slave_, question.index, question.sub, std::span<std::uint8_t>(value_),
      SdoClient::Done::to<&BootSlave::answered>(*this), context_->options.sdo_time_out);
  if (refused != AbortCode::none) finish({BootError::no_answer, refused});
}

/// A lost frame does not prove a wrong device: a slave without an answer is asked again later. A
/// refusal is an answer, with any abort code.
void BootSlave::answered(SdoClient::Outcome outcome) {
  const BootError error = question_of(step_).error;
  if (!outcome) return finish({outcome.is_silence() ? BootError::no_answer : error, outcome});
  found_ = load<std::uint32_t>(value_.data());
  if (expected_ != 0 && found_ != expected_) return finish({error, AbortCode::none});
  // Without a boot-up message after its reset, the answer proves its presence.
  if (was_reset_) return update_program();
  ask(next(step_));
}

void BootSlave::ask_for_state() {
  const SlaveAssignment slave = assignment();
  if (!slave.is_kept_alive()) return is_fresh_ ? update_program() : reset();
  const Duration heartbeat = heartbeat_time(context_->node.dictionary(), slave_);
  if (heartbeat != Duration::zero()) {
    if (enter(BootStep::node_state)) wait(heartbeat);
    return;
  }
  if (slave.guard_time() == Duration::zero()) {
    return state_known(context_->master.remote(slave_).state());
  }
  if (!enter(BootStep::node_state)) return;
  context_->node.transmitter().send(
      Frame::remote_frame(std::uint32_t{can_id::error_control} + slave_, 1));
  wait(slave.guard_time());
}

void BootSlave::state_known(RemoteState state) {
  context_->node.timers().disarm(timer_);
  if (state != RemoteState::operational) return is_fresh_ ? update_program() : reset();
  watch();
  finish({BootError::already_operational, AbortCode::none});
}

void BootSlave::reset() {
  if (!enter(BootStep::reset)) return;
  if (!context_->commands.add({slave_, NmtCommand::reset_communication})) {
    finish({BootError::no_answer, AbortCode::out_of_memory});
  }
}

void BootSlave::reset_sent() {
  if (step_ == BootStep::reset || is_restarting_) wait(context_->options.boot_up_time_out);
}

/// Empty hooks end at once.
void BootSlave::update_program() {
  const auto& hook = context_->hooks.update_program;
  if (!hook || !assignment().has_verified_program()) return update_configuration();
  if (!enter(BootStep::program)) return;
  has_task_ = true;
  hook({slave_, &client_, callback<&BootSlave::program_updated>(*this),
        decltype(BootTask::restart)::to<&BootSlave::restart>(*this)});
}

void BootSlave::program_updated(BootOutcome outcome) {
  has_task_ = false;
  if (outcome.error != BootError::none) return finish(outcome);
  update_configuration();
}

void BootSlave::update_configuration() {
  const auto& hook = context_->hooks.update_configuration;
  if (!hook) return start_error_control();
  if (!enter(BootStep::configuration)) return;
  has_task_ = true;
  hook({slave_, &client_, callback<&BootSlave::configuration_updated>(*this),
        decltype(BootTask::restart)::to<&BootSlave::restart>(*this)});
}

/// The time for the boot-up message begins when the command is sent.
void BootSlave::restart(NmtCommand command, Callback<void(AbortCode)> restarted) {
  if (!context_->commands.add({slave_, command})) return restarted(AbortCode::out_of_memory);
  restarted_ = restarted;
  is_restarting_ = true;
}

void BootSlave::end_restart(AbortCode answer) {
  context_->node.timers().disarm(timer_);
  is_restarting_ = false;
  restarted_(answer);
}

void BootSlave::configuration_updated(BootOutcome outcome) {
  has_task_ = false;
  if (outcome.error != BootError::none) return finish(outcome);
  start_error_control();
}

/// False if a first heartbeat must be waited for.
bool BootSlave::watch() {
  const Duration heartbeat = heartbeat_time(context_->node.dictionary(), slave_);
  if (heartbeat != Duration::zero()) {
    context_->master.set_time_out(slave_, heartbeat);
    return false;
  }
  const SlaveAssignment slave = assignment();
  if (slave.guard_time() != Duration::zero()) {
    context_->guarding.start(slave_, slave.guard_time(), slave.retry_factor());
  }
  return true;
}

void BootSlave::start_error_control() {
  if (!enter(BootStep::error_control)) return;
  if (watch()) return finish({});
  wait(heartbeat_time(context_->node.dictionary(), slave_));
}

void BootSlave::expired(Time) {
  if (is_restarting_) return end_restart(AbortCode::time_out);
  switch (step_) {
    case BootStep::node_state: {
      const bool by_heartbeat =
          heartbeat_time(context_->node.dictionary(), slave_) != Duration::zero();
      return finish({by_heartbeat ? BootError::no_heartbeat : BootError::no_guarding_answer,
                     AbortCode::none});
    }
    case BootStep::reset:
      context_->report(report_of(BootEvent::no_boot_up));
      if (!busy()) return;
      was_reset_ = true;
      return ask(BootStep::device_type);
    default:
      return finish({BootError::no_error_control, AbortCode::none});
  }
}

/// If NMT stopped this node, no slave is at fault: the manager ends the work in progress. Nothing
/// is used after the callback, which may have begun with the next slave.
void BootSlave::finish(BootOutcome outcome) {
  if (!busy()) return;
  const NmtState state = context_->node.state();
  context_->node.timers().disarm(timer_);
  if (state == NmtState::initialisation || state == NmtState::stopped) return;
  finished_(*this, outcome);
}

}  // namespace canvoy
