// When a car is not judged: while a fault lasts, for a time after it has begun or ended, and until
// real devices have come.
//
//     Excuse excuse(has_real_devices);
//     excuse.fault_begins();
//     excuse.extend(now + 20s);
//     if (excuse.is_excused(now)) ...
#pragma once

#include <algorithm>

#include "canvoy/can/time.hpp"

namespace canvoy::car {

class Excuse {
 public:
  explicit Excuse(bool waits_for_real) : waits_for_real_(waits_for_real) {}

  /// Of a fault that lasts.
  void fault_begins() { ++faults_; }
  void fault_ends() { --faults_; }
  /// What has just begun or ended costs others the time to come back.
  void extend(Time until) { until_ = std::max(until_, until); }
  /// Once all were there, nobody is waited for again.
  bool waits_for_real() const { return waits_for_real_; }
  void all_have_come() { waits_for_real_ = false; }

  bool has_fault(Time now) const { return faults_ != 0 || now < until_; }
  bool is_excused(Time now) const { return has_fault(now) || waits_for_real_; }

 private:
  unsigned faults_ = 0;
  Time until_{};
  bool waits_for_real_;
};

}  // namespace canvoy::car
