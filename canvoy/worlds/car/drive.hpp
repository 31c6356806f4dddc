// A car that is driven leg by leg: the true motion of its wheels, whatever is measured. The legs
// are invented, or those of a recorded drive.
//
//     Drive drive;
//     drive.go(800, 13.9);    // 800 m at 50 km/h, and it stands
//     drive.step(100ms);
//
//     Drive again(&record);
//     again.go_on();          // until it next arrives
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/gps/gps_reading.hpp"
#include "canvoy/devices/cia447/navigation/geography.hpp"
#include "canvoy/worlds/car/drive_record.hpp"

namespace canvoy::car {

class Drive {
 public:
  static constexpr double acceleration = 1.5;  ///< m/s^2
  static constexpr double deceleration = 2.0;  ///< m/s^2

  /// A record must outlive this object.
  explicit Drive(const DriveRecord* record = nullptr) : record_(record) {}

  /// Drives on from where the car stands; `metres_per_second` is the highest speed. Not for a
  /// record.
  void go(double metres, double metres_per_second);
  /// Drives the next leg of the record, from where the car stands.
  void go_on();
  /// Drives on for this time.
  void step(Duration time);
  /// Has the motion come from outside: roll() sets it.
  void be_led() { is_led_ = true; }
  /// Moves the car by this way within this time, which also brings it nearer to the end of a leg.
  void roll(double metres, Duration time);

  /// True if it plays a record.
  bool has_record() const { return record_ != nullptr; }
  /// True if the record has no more legs.
  bool is_through() const { return has_record() && leg_ == record_->legs.size(); }
  /// True if the leg is at its end.
  bool is_standing() const { return has_record() ? !plays_ : rest_ <= 0; }
  double speed() const { return speed_; }    ///< m/s
  double metres() const { return metres_; }  ///< since the start
  /// Position of a car after that way: its town is a road to the north, up and down.
  static cia447::GeoPosition town_position(double metres);
  /// Reading of a satellite receiver in the car. For a record, the recorded reading; while the car
  /// stands between two legs, the last one.
  cia447::GpsReading receiver() const;

 private:
  void play(Duration time);
  void play_until(Duration at);
  void hear(Duration until);

  const DriveRecord* record_;
  double rest_ = 0;  ///< m left of the leg
  double limit_ = 0;
  double speed_ = 0;
  double metres_ = 0;

  bool is_led_ = false;
  Duration since_roll_{};

  // True while a leg of the record is driven.
  bool plays_ = false;
  std::size_t leg_ = 0;     ///< the present leg, or the next one
  std::size_t sample_ = 0;  ///< the last sample that is not in the future
  std::size_t heard_ = 0;   ///< seconds of the record that the receiver has read
  Duration at_{};
  cia447::NmeaReceiver receiver_;
};

}  // namespace canvoy::car
