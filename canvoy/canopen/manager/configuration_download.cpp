#include "canvoy/canopen/manager/configuration_download.hpp"

#include <algorithm>

namespace canvoy {

AbortCode ConfigurationDownload::start(SdoClient& client, NodeId slave, const ByteSource& source,
                                       Done done, Duration time_out) {
  if (busy_) return AbortCode::device_state;
  const Result<std::uint32_t> checked = check_concise_dcf(source);
  if (!checked) return checked.abort();
  if (*checked == 0) return AbortCode::no_data;
  const AbortCode opened = dcf_.open(source);
  if (opened != AbortCode::none) return opened;
  client_ = &client;
  slave_ = slave;
  done_ = done;
  time_out_ = time_out;
  written_ = 0;
  busy_ = true;  // before the first answer, which comes at once on some buses
  const AbortCode refused = write_next();
  if (refused != AbortCode::none) busy_ = false;
  return refused;
}

void ConfigurationDownload::cancel() {
  if (!busy_) return;
  busy_ = false;
  client_->cancel();
}

/// The entry is read again after the check: the owner of the source may have changed it.
AbortCode ConfigurationDownload::write_next() {
  const Result<ConciseDcf::Item> item = dcf_.next();
  item_ = *item;
  if (!item) return item.abort();
  return item_.size <= buffer_.size() ? write_short() : write_long();
}

AbortCode ConfigurationDownload::write_short() {
  const auto value = std::span(buffer_).first(item_.size);
  const AbortCode answer = dcf_.read(item_, 0, value);
  if (answer != AbortCode::none) return answer;
  return client_->download(slave_, item_.index, item_.sub, value,
                           SdoClient::Done::to<&ConfigurationDownload::written>(*this), time_out_);
}

AbortCode ConfigurationDownload::write_long() {
  supplied_ = 0;
  return client_->download(slave_, item_.index, item_.sub,
                           SdoClient::Supply::to<&ConfigurationDownload::supply>(*this), item_.size,
                           SdoClient::Done::to<&ConfigurationDownload::written>(*this), time_out_);
}

Result<std::size_t> ConfigurationDownload::supply(std::span<std::uint8_t> bytes) {
  const std::size_t count = std::min<std::size_t>(bytes.size(), item_.size - supplied_);
  const AbortCode answer = dcf_.read(item_, supplied_, bytes.first(count));
  if (answer != AbortCode::none) return answer;
  supplied_ += static_cast<std::uint32_t>(count);
  return count;
}

void ConfigurationDownload::written(SdoClient::Outcome outcome) {
  if (!busy_) return;
  if (!outcome) return finish(outcome);
  ++written_;
  if (dcf_.at_end()) return finish({});
  const AbortCode refused = write_next();
  if (refused != AbortCode::none) finish(refused);
}

/// Nothing is used after the callback, which may have started the next download.
void ConfigurationDownload::finish(SdoEnd end) {
  busy_ = false;
  Outcome outcome{.end = end, .written = written_};
  if (!end) {
    outcome.index = item_.index;
    outcome.sub = item_.sub;
  }
  const Done done = done_;
  done(outcome);
}

}  // namespace canvoy
