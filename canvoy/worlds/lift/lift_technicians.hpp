// The technician of each lift of a building, who is called when a safety chain must be closed by
// hand, by people who are shut in and press the alarm button (EN 81-28), where a controller reports
// that its lift stays out of order, and where a referee finds that people have reason to complain.
//
//     LiftTechnicians technicians(world, description, devices, crowd, told);
//     technicians.tripped(1);
//     technicians.look();        // each second
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/crowd.hpp"
#include "canvoy/worlds/lift/lift_devices.hpp"
#include "canvoy/worlds/lift/technician.hpp"

namespace canvoy::lift {

class LiftTechnicians {
 public:
  /// Called for each step; no_floor where the technician is at none.
  using Told = std::function<void(LiftNumber, TechnicianStep, FloorNumber)>;

  /// All must outlive this object. No technician comes where the description has none.
  LiftTechnicians(World& world, const LiftNetworkDescription& description, LiftDevices& devices,
                  const Crowd& crowd, Told told);
  LiftTechnicians(const LiftTechnicians&) = delete;
  LiftTechnicians& operator=(const LiftTechnicians&) = delete;

  /// Call it when the safety chain of this lift must be closed by hand.
  void tripped(LiftNumber lift);
  /// Call it when people complain of this lift.
  void complain(LiftNumber lift);
  /// Has each technician look at the lift, each second.
  void look();
  /// True if the technician is called, or at work.
  bool is_called(LiftNumber lift) const {
    return !technicians_.empty() && at(lift).technician->is_called();
  }

 private:
  struct Place {
    std::unique_ptr<Technician> technician;
    Time shut_in_since = never;  ///< people, behind shut doors
    Time out_since = never;      ///< out of order
  };

  TechnicianHands hands(LiftNumber lift);
  TechnicianView view(LiftNumber lift) const;
  void look_at(LiftNumber lift);
  void step(Time now);
  Place& at(LiftNumber lift) { return technicians_[lift - std::size_t{1}]; }
  const Place& at(LiftNumber lift) const { return technicians_[lift - std::size_t{1}]; }

  World* world_;
  const LiftNetworkDescription* description_;
  LiftDevices* devices_;
  const Crowd* crowd_;
  Told told_;
  PlantIndex plant_;
  std::vector<Place> technicians_;
};

}  // namespace canvoy::lift
