#include "canvoy/tools/page/recorder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "canvoy/tools/page/refusal.hpp"

namespace canvoy::tools {

void Recorder::allow(const std::string& folder) {
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw UsageError(fmt::format("--allow-record: '{}' is no folder", folder));
  }
  folder_ = folder;
}

void Recorder::begin(Duration epoch) {
  if (!is_allowed()) {
    throw NotAllowed("to record is not allowed: start the command with --allow-record FOLDER");
  }
  if (log_) throw NotNow(fmt::format("{} is being recorded already", file_));
  if (logs_ == logs_max) throw NotNow("too much was recorded already: start the command anew");
  std::string file;
  for (unsigned number = 1; file.empty() || std::filesystem::exists(file); ++number) {
    file = fmt::format("{}/canvoy-{}.log", folder_, number);
  }
  log_.emplace(value_or_throw(host::CandumpWriter::create(file, epoch)));
  ++logs_;
  file_ = file;
  frames_ = 0;
  trouble_.clear();
}

void Recorder::end() {
  if (!log_) return;
  const host::Result<void> flushed = log_->flush();
  log_.reset();
  ok_or_throw(flushed);
}

void Recorder::hear(Time at, std::string_view bus, const Frame& frame) {
  if (!log_) return;
  const host::Result<void> written = log_->write(at, bus, frame);
  if (!written) trouble_ = written.error().line();
  if (written && ++frames_ == frames_max) trouble_ = fmt::format("{} is full", file_);
  if (!trouble_.empty()) log_.reset();
}

void Recorder::flush_each_second(Time clock) {
  if (!log_) return;
  const host::Result<void> flushed = log_->flush_each_second(clock);
  if (flushed) return;
  trouble_ = flushed.error().line();
  log_.reset();
}

nlohmann::ordered_json Recorder::json() const {
  return {{"on", log_.has_value()}, {"file", file_}, {"frames", frames_}, {"trouble", trouble_}};
}

}  // namespace canvoy::tools
