// A car that is driven leg by leg: what its wheels have really turned, whatever anybody counts. The
// legs are made up, or those of a drive that was recorded.
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
#include "canvoy/sim/car/drive_record.hpp"

namespace canvoy::car {

class Drive {
 public:
  static constexpr double acceleration = 1.5;  ///< m/s^2
  static constexpr double deceleration = 2.0;  ///< m/s^2

  /// A record must outlive this.
  explicit Drive(const DriveRecord* record = nullptr) : record_(record) {}

  /// From where it stands; `metres_per_second` is the highest speed. Not where there is a record.
  void go(double metres, double metres_per_second);
  /// The next leg of the record, from where the car stands.
  void go_on();
  void step(Duration time);
  /// From now on others say how far the car goes: it does what roll() says.
  void be_led() { is_led_ = true; }
  /// So far within so much time; whoever wanted to go somewhere has come nearer.
  void roll(double metres, Duration time);

  bool has_record() const { return record_ != nullptr; }
  /// The record has no more legs.
  bool is_through() const { return has_record() && leg_ == record_->legs.size(); }
  bool is_standing() const { return has_record() ? !plays_ : rest_ <= 0; }
  double speed() const { return speed_; }    ///< m/s
  double metres() const { return metres_; }  ///< since the start
  /// Where the car is that far from the start: its town is a road to the north, up and down.
  static cia447::GeoPosition town_position(double metres);
  /// What a satellite receiver in the car says. That of a record says what it said then, and while
  /// the car stands between two legs, what it said last.
  cia447::GpsReading receiver() const;

 private:
  void play(Duration time);
  void play_until(Duration at);
  void hear(Duration until);

  const DriveRecord* record_;
  double rest_ = 0;  ///< of the leg, in m
  double limit_ = 0;
  double speed_ = 0;
  double metres_ = 0;

  bool is_led_ = false;
  Duration since_roll_{};

  // In the record.
  bool plays_ = false;
  std::size_t leg_ = 0;     ///< that is played, or comes next
  std::size_t sample_ = 0;  ///< the last one that is not in the future
  std::size_t heard_ = 0;   ///< so many seconds of what the receiver said
  Duration at_{};
  cia447::NmeaReceiver receiver_;
};

}  // namespace canvoy::car
