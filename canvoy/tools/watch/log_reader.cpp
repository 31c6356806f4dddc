#include "canvoy/tools/watch/log_reader.hpp"

#include <algorithm>
#include <csignal>
#include <utility>

#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::tools {

using formats::TraceFrame;
using formats::TraceRead;

void LogReader::Batch::clear() {
  items.clear();
  channels.clear();
  fds.clear();
  bad.clear();
}

void LogReader::Batch::add(TraceRead read, const TraceFrame& heard,
                           const formats::TraceReader& trace) {
  const bool is_told = read == TraceRead::frame || read == TraceRead::fd;
  if (is_told && (channels.empty() || !formats::same_bytes(channels.back(), heard.channel))) {
    channels.emplace_back(heard.channel);
  }
  const std::size_t channel = channels.empty() ? 0 : channels.size() - 1;
  // In its place: a copy of what was stored in smaller parts waits until they are stored.
  Item& item = items.emplace_back();
  item.time = heard.time;
  item.frame = heard.frame;
  item.read = read;
  item.direction = heard.direction;
  item.channel = static_cast<std::uint32_t>(channel);
  if (read == TraceRead::fd) fds.push_back(heard.fd);
  if (read == TraceRead::bad) bad.push_back({trace.where(), trace.problem()});
}

LogReader::LogReader(formats::TraceReader trace, std::uint64_t ahead_from)
    : trace_(std::move(trace)), size_(trace_.size()) {
  if (size_ == 0 || size_ < ahead_from) return;
  for (std::size_t i = 0; i < batches_max; ++i) free_.push_back(std::make_unique<Batch>());
  // Signals are handled by the working thread.
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  worker_ = std::thread([this] { read_all(); });
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

LogReader::~LogReader() {
  if (!worker_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

void LogReader::read_all() {
  TraceFrame heard;
  TraceRead read = TraceRead::frame;
  while (read != TraceRead::end) {
    std::unique_ptr<Batch> batch = take_free();
    if (batch == nullptr) return;
    while (batch->items.size() < batch_size && read != TraceRead::end) {
      read = trace_.next(heard);
      batch->add(read, heard, trace_);
    }
    batch->position = trace_.position();
    pass_on(std::move(batch));
  }
}

std::unique_ptr<LogReader::Batch> LogReader::take_free() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_over_ || !free_.empty(); });
  if (is_over_) return nullptr;
  std::unique_ptr<Batch> batch = std::move(free_.back());
  free_.pop_back();
  return batch;
}

void LogReader::pass_on(std::unique_ptr<Batch> batch) {
  {
    const std::scoped_lock lock(mutex_);
    full_.push_back(std::move(batch));
  }
  changed_.notify_all();
}

void LogReader::take_batch() {
  if (batch_ != nullptr) {
    position_ = batch_->position;
    batch_->clear();
  }
  std::unique_lock lock(mutex_);
  if (batch_ != nullptr) free_.push_back(std::move(batch_));
  changed_.notify_all();
  changed_.wait(lock, [this] { return !full_.empty(); });
  batch_ = std::move(full_.front());
  full_.erase(full_.begin());
  item_ = 0;
  fd_ = 0;
  bad_ = 0;
}

TraceRead LogReader::take_item(TraceFrame& frame) {
  if (batch_ == nullptr || item_ == batch_->items.size()) take_batch();
  const Item& item = batch_->items[item_];
  if (item.read == TraceRead::end) return TraceRead::end;  // repeatedly
  ++item_;
  frame.time = item.time;
  frame.frame = item.frame;
  frame.direction = item.direction;
  if (!batch_->channels.empty()) frame.channel = batch_->channels[item.channel];
  if (item.read == TraceRead::fd) frame.fd = batch_->fds[fd_++];
  if (item.read == TraceRead::bad) bad_place_ = std::move(batch_->bad[bad_++]);
  return item.read;
}

std::uint64_t LogReader::position() const {
  if (!worker_.joinable()) return trace_.position();
  if (batch_ == nullptr) return 0;
  // The last item, which marks the end, is kept.
  const std::size_t last = std::max<std::size_t>(batch_->items.size() - 1, 1);
  return position_ + (batch_->position - position_) * std::min(item_, last) / last;
}

TraceRead LogReader::next(TraceFrame& frame) {
  const TraceRead read = worker_.joinable() ? take_item(frame) : trace_.next(frame);
  if (read == TraceRead::frame) ++counts_.frames;
  if (read == TraceRead::fd) ++counts_.fd_frames;
  if (read == TraceRead::bad) ++counts_.bad;
  return read;
}

}  // namespace canvoy::tools
