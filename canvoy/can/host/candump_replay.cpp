#include "canvoy/can/host/candump_replay.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::host {

namespace {

// Some thousand years in microseconds: a slow replay of odd times must not overflow.
constexpr double distance_max = 1e17;

}  // namespace

CandumpReplay::CandumpReplay(CandumpReader reader, const ReplayOptions& options, Play play)
    : reader_(std::move(reader)), options_(options), play_(play), due_(options.start) {
  fetch();
}

void CandumpReplay::advance(Time now) {
  while (due_ <= now && entry_) {
    const LogEntry entry = *std::move(entry_);
    const Time due = due_;
    fetch();
    ++played_;
    play_(entry, due);
  }
}

Task CandumpReplay::task() {
  return {Callback<Time()>::to<&CandumpReplay::deadline>(*this),
          Callback<void(Time)>::to<&CandumpReplay::advance>(*this)};
}

void CandumpReplay::fetch() {
  Result<std::optional<LogEntry>> next = reader_.next();
  if (!next) error_ = next.error();
  entry_ = next ? std::move(*next) : std::nullopt;
  if (!entry_) {
    due_ = never;
    return;
  }
  if (!first_) first_ = entry_->time;
  const double distance = static_cast<double>((entry_->time - *first_).count()) / options_.speed;
  const Duration stretched{static_cast<Duration::rep>(std::min(distance, distance_max))};
  due_ = std::max(due_, options_.start + stretched);
}

}  // namespace canvoy::host
