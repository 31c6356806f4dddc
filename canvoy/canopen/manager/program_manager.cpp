#include "canvoy/canopen/manager/program_manager.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/manager/nmt_startup.hpp"

namespace canvoy {

void ProgramManager::serve(BootHooks& hooks) {
  abandoned_ = hooks.abandon;
  hooks.update_program = callback<&ProgramManager::boot>(*this);
  hooks.abandon = callback<&ProgramManager::abandon>(*this);
}

void ProgramManager::boot(const BootTask& task) {
  for (Worker& worker : workers_) {
    if (worker.idle()) return worker.begin(*this, task);
  }
  task.done({BootError::program_download, AbortCode::out_of_memory});
}

void ProgramManager::abandon(NodeId slave) {
  for (Worker& worker : workers_) {
    if (worker.task_.slave == slave) worker.drop();
  }
  abandoned_(slave);
}

std::uint32_t ProgramManager::Worker::expected(std::uint16_t index) const {
  return static_cast<std::uint32_t>(node_.dictionary().number(index, task_.slave));
}

void ProgramManager::Worker::begin(ProgramManager& manager, const BootTask& task) {
  manager_ = &manager;
  task_ = task;
  position_ = 0;
  checks_ = {{{program::identification, 1, expected(program::expected_identification)},
              {program::verify, 1, expected(program::expected_date)},
              {program::verify, 2, expected(program::expected_time)}}};
  const bool any =
      std::ranges::any_of(checks_, [](const Check& check) { return check.expected != 0; });
  if (!any) return finish(BootError::no_program_data);
  check();
}

/// The client belongs to another service already.
void ProgramManager::Worker::drop() {
  if (download_) download_->forget();
  download_.reset();
  task_ = {};
}

void ProgramManager::Worker::check() {
  while (position_ < checks_.size() && checks_[position_].expected == 0) ++position_;
  if (position_ == checks_.size()) return finish(BootError::none);
  value_ = {};
  const AbortCode refused = task_.client->upload(
      task_.slave, checks_[position_].index, checks_[position_].sub, std::span(value_),
      SdoClient::Done::to<&Worker::checked>(*this), manager_->settings_.answer_time_out);
  if (refused != AbortCode::none) finish(BootError::no_program_data, refused);
}

void ProgramManager::Worker::checked(SdoClient::Outcome outcome) {
  if (!outcome) return finish(BootError::no_program_data, outcome);
  if (load<std::uint32_t>(value_.data()) != checks_[position_].expected) return update();
  ++position_;
  check();
}

void ProgramManager::Worker::update() {
  const SlaveAssignment assignment = slave_assignment(node_.dictionary(), task_.slave);
  if (!assignment.has_updated_program()) return finish(BootError::program_not_allowed);
  const Result<std::uint32_t> size = manager_->library_.open(task_.slave);
  if (!size || *size == 0) return finish(BootError::no_program_data, AbortCode::no_data);
  download(*size);
}

void ProgramManager::Worker::download(std::uint32_t size) {
  size_ = size;
  offset_ = 0;
  ProgramPlan plan{
      .server = task_.slave, .supply = SdoClient::Supply::to<&Worker::supply>(*this), .size = size};
  if (checks_[0].expected != 0) plan.identification = checks_[0].expected;
  if (checks_[1].expected != 0 || checks_[2].expected != 0) {
    plan.date = {{checks_[1].expected, checks_[2].expected}};
  }
  download_.emplace(node_, *task_.client, manager_->settings_);
  const AbortCode refused =
      download_->begin(plan, ProgramDownload::Done::to<&Worker::downloaded>(*this));
  if (refused != AbortCode::none) finish(BootError::program_download, refused);
}

Result<std::size_t> ProgramManager::Worker::supply(std::span<std::uint8_t> bytes) {
  const std::size_t size = std::min<std::size_t>(bytes.size(), size_ - offset_);
  const AbortCode answer = manager_->library_.read(task_.slave, offset_, bytes.first(size));
  if (answer != AbortCode::none) return answer;
  offset_ += static_cast<std::uint32_t>(size);
  return size;
}

/// Called before the boot-up continues; the callback may abandon the slave.
void ProgramManager::Worker::downloaded(const ProgramOutcome& outcome) {
  const NodeId slave = task_.slave;
  const ProgramOutcome ended = outcome;
  manager_->told_(slave, ended);
  if (task_.slave != slave) return;
  if (ended) return finish(BootError::none);
  finish(BootError::program_download, ended.end ? SdoEnd(AbortCode::cannot_store) : ended.end);
}

void ProgramManager::Worker::finish(BootError error, SdoEnd end) {
  const BootTask task = std::exchange(task_, {});
  task.done({error, end});
}

}  // namespace canvoy
