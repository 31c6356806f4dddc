#include "canvoy/devices/cia417/drive/drive_mode_client.hpp"

namespace canvoy::cia417 {

void DriveModeClient::begin_anew() {
  forget();
  is_writing_ = false;
}

void DriveModeClient::write(std::uint16_t index, cia402::DriveMode wanted) {
  if (is_writing_) return;
  byte_[0] = static_cast<std::uint8_t>(wanted);
  const auto done = SdoClient::Done::to<&DriveModeClient::written>(*this);
  is_writing_ = client_->download(drive_, index, 0, byte_, done) == AbortCode::none;
}

void DriveModeClient::written(SdoClient::Outcome outcome) {
  is_writing_ = false;
  if (outcome) known_ = static_cast<cia402::DriveMode>(byte_[0]);
  told_();
}

}  // namespace canvoy::cia417
