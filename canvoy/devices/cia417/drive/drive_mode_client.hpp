// Sets the mode of operation of a drive for its controller: by SDO, while the car stands (CiA
// 417-4, 4.11.2).
//
//     DriveModeClient mode(&client, 2, DriveMode::profile_position, told);
//     if (mode.now() != DriveMode::homing) mode.write(index, DriveMode::homing);
//
// Without an SDO client, the mode is the default of the drive.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/profiles/cia402/values.hpp"

namespace canvoy::cia417 {

class DriveModeClient {
 public:
  /// `client` may be null. `told` is called when the drive has answered, and when it has not.
  DriveModeClient(SdoClient* client, NodeId drive, cia402::DriveMode usual, Callback<void()> told)
      : client_(client), told_(told), drive_(drive), usual_(usual) {}
  DriveModeClient(const DriveModeClient&) = delete;
  DriveModeClient& operator=(const DriveModeClient&) = delete;

  /// Starts without a request under way.
  void begin_anew();
  /// Discards the known mode: the drive has restarted.
  void forget() { known_.reset(); }

  /// True with an SDO client.
  bool can_change() const { return client_ != nullptr; }
  /// The mode as far as it is known: no mode has the number 0.
  cia402::DriveMode now() const {
    return can_change() ? known_.value_or(cia402::DriveMode{}) : usual_;
  }
  /// Writes the object `index` of the drive, unless another request is under way.
  void write(std::uint16_t index, cia402::DriveMode wanted);

 private:
  void written(SdoClient::Outcome outcome);

  SdoClient* client_;
  Callback<void()> told_;
  NodeId drive_;
  cia402::DriveMode usual_;
  std::optional<cia402::DriveMode> known_;  ///< written to the drive
  std::array<std::uint8_t, 1> byte_{};
  bool is_writing_ = false;
};

}  // namespace canvoy::cia417
