// Measures how long people of a building wait and ride, and whether more come than the lifts can
// carry. Time in which a fault hinders the lifts is excused.
//
//     CrowdWatch watch(building, people);
//     watch.look(now, is_hindered, crowd);    // from time to time, a second say
//     referee.waited(crowd.longest_wait(now, watch.hindered_at()), is_hindered);
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/crowd.hpp"

namespace canvoy::lift {

class CrowdWatch {
 public:
  /// `building` and `people` say how many a group can carry, and how long people wait by
  /// themselves.
  CrowdWatch(const Building& building, const PassengerOptions& people);

  /// Counts the people who wait; call it from time to time, as each second.
  void look(Time now, bool is_hindered, const Crowd& crowd) {
    look(now, is_hindered, crowd.waiting_count());
  }
  /// The same, by a number of waiting people.
  void look(Time now, bool is_hindered, std::size_t waiting);

  /// Last time at which a fault hindered the lifts; 0: never.
  Time hindered_at() const { return hindered_at_; }
  /// Like hindered_at(), but including the time until the crowd that it left has once become small
  /// enough for all cars; at most half an hour.
  Time excused_at() const { return excused_at_; }
  /// True if for five minutes without interruption more people waited than fill each car twice.
  bool is_saturated() const { return is_saturated_; }

 private:
  double places_ = 0;  ///< in all cars, as far as people fill them
  Time hindered_at_{};
  Time excused_at_{};
  Time not_crowded_at_{};  ///< last time without a crowd, or hindered
  bool is_left_ = false;   ///< a crowd that remains of a hindrance
  bool is_saturated_ = false;
};

}  // namespace canvoy::lift
