#include "canvoy/canopen/manager/program_download.hpp"

namespace canvoy {

namespace {

ProgramStep after(ProgramStep step) {
  return static_cast<ProgramStep>(static_cast<unsigned>(step) + 1);
}

/// An absent object is optional.
}  // namespace

AbortCode ProgramDownload::begin(const ProgramPlan& plan, Done done) {
  if (busy()) return AbortCode::device_state;
  plan_ = plan;
  done_ = done;
  restarting_ = false;
  const AbortCode started = enter(ProgramStep::stop);
  if (started != AbortCode::none) step_ = ProgramStep::done;
  return started;
}

void ProgramDownload::cancel() {
  if (busy() && client_.busy()) client_.cancel();
  forget();
}

void ProgramDownload::forget() {
  node_.timers().disarm(timer_);
  step_ = ProgramStep::done;
}

std::size_t ProgramDownload::transferred() const {
  if (step_ < ProgramStep::download) return 0;
  return step_ == ProgramStep::download ? client_.transferred() : plan_.size;
}

AbortCode ProgramDownload::enter(ProgramStep step) {
  const bool has_no_date = step == ProgramStep::date && !plan_.date;
  const bool has_nothing_to_compare = step == ProgramStep::identify && !plan_.identification;
  const bool is_not_started = step == ProgramStep::start && !plan_.start;
  if (has_no_date || has_nothing_to_compare || is_not_started) return enter(after(step));
  step_ = step;
  date_part_ = 1;
  const bool waits = step == ProgramStep::wait_cleared || step == ProgramStep::wait_programmed;
  step_ends_ = node_.now() + (waits ? settings_.flash_time_out : settings_.restart_time_out);
  if (step == ProgramStep::done) {
    finish(AbortCode::none);
    return AbortCode::none;
  }
  return ask();
}

AbortCode ProgramDownload::ask() {
  switch (step_) {
    case ProgramStep::stop:
      return command(ProgramCommand::stop, settings_.answer_time_out);
    case ProgramStep::clear:
      return command(ProgramCommand::clear,
                     restarting_ ? settings_.answer_time_out : settings_.clear_time_out);
    case ProgramStep::start:
      return command(ProgramCommand::start, settings_.answer_time_out);
    case ProgramStep::date:
      return write(program::verify, date_part_, (*plan_.date)[date_part_ - std::size_t{1}], 4,
                   settings_.answer_time_out);
    case ProgramStep::identify:
      return read(program::identification);
    case ProgramStep::wait_cleared:
    case ProgramStep::wait_programmed:
      return read(program::status);
    case ProgramStep::download:
      return client_.download(plan_.server, program::data, plan_.number, plan_.supply, plan_.size,
                              SdoClient::Done::to<&ProgramDownload::answered>(*this),
                              settings_.answer_time_out);
    case ProgramStep::done:
      break;
  }
  return AbortCode::none;
}

AbortCode ProgramDownload::command(ProgramCommand command, Duration time_out) {
  return write(program::control, plan_.number, static_cast<std::uint32_t>(command), 1, time_out);
}

AbortCode ProgramDownload::write(std::uint16_t index, std::uint8_t sub, std::uint32_t value,
                                 std::size_t size, Duration time_out) {
  store(value_.data(), value);
  return client_.download(plan_.server, index, sub, std::span(value_).first(size),
                          SdoClient::Done::to<&ProgramDownload::answered>(*this), time_out);
}

AbortCode ProgramDownload::read(std::uint16_t index) {
  value_ = {};
  return client_.upload(plan_.server, index, plan_.number, std::span(value_),
                        SdoClient::Done::to<&ProgramDownload::answered>(*this),
                        settings_.answer_time_out);
}

void ProgramDownload::answered(SdoClient::Outcome outcome) {
  const SdoEnd answer = outcome;
  switch (step_) {
    case ProgramStep::stop:
    case ProgramStep::start:
      restarting_ = answer.is_silence();
      return answer || restarting_ ? go_on() : finish(answer);
    case ProgramStep::clear:
      return cleared(answer);
    case ProgramStep::wait_cleared:
    case ProgramStep::wait_programmed:
      return status_came(answer);
    case ProgramStep::date:
      if (answer.is_silence()) return finish(answer);
      if (!answer || date_part_++ == 2) return go_on();
      return repeat(node_.now());
    case ProgramStep::identify:
      return identified(answer);
    case ProgramStep::download:
      return answer ? go_on() : finish(answer);
    case ProgramStep::done:
      return;
  }
}

void ProgramDownload::repeat(Time) {
  const AbortCode started = ask();
  if (started != AbortCode::none) finish(started);
}

/// A node that restarts answers late.
void ProgramDownload::cleared(SdoEnd answer) {
  if (answer) return go_on();
  const bool may_come = answer.is_silence() && restarting_ && node_.now() < step_ends_;
  return may_come ? repeat(node_.now()) : finish(answer);
}

void ProgramDownload::status_came(SdoEnd answer) {
  if (is_absent(answer)) return go_on();
  if (!answer) return finish(answer);
  const FlashStatus status(load<std::uint32_t>(value_.data()));
  if (status.busy()) {
    if (node_.now() >= step_ends_) return finish(SdoEnd::no_answer(), status);
    return node_.timers().arm(timer_, node_.now() + settings_.poll_interval);
  }
  // There is no program after clearing, and some nodes report that as an error.
  const bool is_expected =
      step_ == ProgramStep::wait_cleared && status.error() == FlashError::no_valid_program;
  if (status.error() == FlashError::none || is_expected) return go_on();
  finish({}, status);
}

void ProgramDownload::identified(SdoEnd answer) {
  if (is_absent(answer)) return go_on();
  if (!answer) return finish(answer);
  if (load<std::uint32_t>(value_.data()) == plan_.identification) return go_on();
  finish({}, FlashStatus(FlashError::checksum));
}

void ProgramDownload::go_on() {
  const AbortCode started = enter(after(step_));
  if (started != AbortCode::none) finish(started);
}

void ProgramDownload::finish(SdoEnd end, FlashStatus status) {
  const ProgramOutcome outcome{.step = step_, .end = end, .status = status};
  step_ = ProgramStep::done;
  done_(outcome);
}

}  // namespace canvoy
