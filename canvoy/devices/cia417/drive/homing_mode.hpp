// Homing mode of a car drive: the car searches its home position by the method of its maker, and
// stops; positions then count from there (CiA 402, homing mode; CiA 417-4, 4.11.5).
//
//     HomingMode mode(car, parameters, {.method = HomingMethod::home_switch_below});
//     mode.start(false, now);
//     if (mode.look(now) == true) ...      // each period: bits 10 and 12
//
// A search without a result fails: bit 13.
#pragma once

#include <optional>

#include "canvoy/devices/cia417/drive/drive_homing.hpp"
#include "canvoy/devices/cia417/drive/driven_car.hpp"

namespace canvoy::cia417 {

/// Method and limits of a search.
struct HomingSettings {
  HomingMethod method = HomingMethod::home_switch_below;  ///< by which it is found
  double velocity = 100;                                  ///< in units of 6430h
  double travel = 0;  ///< distance between the ends of the shaft, in units of position; 0: unknown
  Duration time_max = 5min;  ///< of a search if the distance is unknown
};

class HomingMode {
 public:
  /// All references must outlive this.
  HomingMode(DrivenCar& car, DriveParameters& parameters, const HomingSettings& settings)
      : car_(car), parameters_(parameters), settings_(settings), search_(settings.method) {}
  HomingMode(const HomingMode&) = delete;
  HomingMode& operator=(const HomingMode&) = delete;

  /// Discards the home position.
  void begin_anew();
  /// Ends the search: the car is stopped.
  void give_up() { step_ = Step::idle; }
  /// Starts a search. While the car is halted, the search waits for the next start.
  void start(bool is_halted, Time now);
  /// Ends the search on a command of the controlword.
  void cancel(Time now);
  /// True while the car searches.
  bool is_under_way() const { return step_ != Step::idle; }
  /// Returns whether the search has succeeded when the car has come to a standstill; nothing before
  /// that, and once only.
  std::optional<bool> look(Time now);

  /// True once a home position was found.
  bool has_homed() const { return has_homed_; }
  /// True if the last search has failed.
  bool has_failed() const { return has_failed_; }

 private:
  enum class Step : std::uint8_t { idle, searching, stopping };

  void seek(Time now);
  bool search(Time now);
  bool has_missed(Time now) const;
  void slow_down(Time now);
  void end();

  DrivenCar& car_;
  DriveParameters& parameters_;
  HomingSettings settings_;
  HomingSearch search_;
  std::optional<double> found_;  ///< the home position of this search, in increments
  Time since_{};
  double from_ = 0;  ///< where the search started or turned, in increments
  Step step_ = Step::idle;
  bool has_homed_ = false;
  bool has_failed_ = false;
};

}  // namespace canvoy::cia417
