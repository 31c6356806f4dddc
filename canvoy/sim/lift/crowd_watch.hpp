// How long people of a building wait and ride, and whether more come than lifts can carry; time in
// which something hindered them is nobody's fault.
//
//     CrowdWatch watch(building, people);
//     watch.look(now, is_hindered, crowd);    // from time to time, a second say
//     referee.waited(crowd.longest_wait(now, watch.hindered_at()), is_hindered);
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/crowd.hpp"

namespace canvoy::lift {

class CrowdWatch {
 public:
  CrowdWatch(const Building& building, const PassengerOptions& people);

  void look(Time now, bool is_hindered, const Crowd& crowd) {
    look(now, is_hindered, crowd.waiting_count());
  }
  void look(Time now, bool is_hindered, std::size_t waiting);

  /// The last time that anything hindered them; 0: never.
  Time hindered_at() const { return hindered_at_; }
  /// The same, or that the crowd which it left had not once become small enough for all cars; for
  /// half an hour at most.
  Time excused_at() const { return excused_at_; }
  /// For five minutes on end more people waited than fill each car twice.
  bool is_saturated() const { return is_saturated_; }

 private:
  double places_ = 0;  ///< in all cars, as people fill them
  Time hindered_at_{};
  Time excused_at_{};
  Time not_crowded_at_{};  ///< or hindered; the last time
  bool is_left_ = false;   ///< a crowd, by what hindered it
  bool is_saturated_ = false;
};

}  // namespace canvoy::lift
