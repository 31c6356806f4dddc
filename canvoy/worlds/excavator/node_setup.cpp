#include "canvoy/worlds/excavator/node_setup.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::excavator {

namespace {

constexpr unsigned setup_tries = 3;
constexpr Duration setup_answer = 100ms;

}  // namespace

void NodeSetup::begin() {
  stop();
  place_ = 0;
  tries_left_ = setup_tries;
  write();
}

void NodeSetup::stop() {
  if (client_.busy()) client_.cancel();
}

void NodeSetup::write() {
  if (place_ == writes_.size()) return done_(server_, true);
  const SetupWrite& it = writes_[place_];
  store(buffer_.data(), it.value);
  --tries_left_;
  const AbortCode started = client_.download(
      server_, it.index, it.sub, std::span<const std::uint8_t>(buffer_).first(it.bytes),
      SdoClient::Done::to<&NodeSetup::written>(*this), setup_answer);
  if (started != AbortCode::none) done_(server_, false);
}

void NodeSetup::written(SdoClient::Outcome outcome) {
  if (outcome.is_silence() && tries_left_ != 0) return write();
  const bool may_fail = outcome.is_refusal() && writes_[place_].may_be_missing;
  if (!outcome && !may_fail) return done_(server_, false);
  ++place_;
  tries_left_ = setup_tries;
  write();
}

}  // namespace canvoy::excavator
