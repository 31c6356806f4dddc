// Makes and mends the faults of a plan while a world runs, and reports when each begins and ends.
// Several of one kind may overlap at one place: the last one that ends mends it.
//
//     FaultEngine<FaultKind> faults(plan.faults, FaultEngine<FaultKind>::of(maker));
//     faults.plan(world);
//     if (faults.is_present(FaultKind::no_paper)) ...
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

/// How several faults of the same kind at the same place are made: the first one alone; each of
/// them, with one mending at the end; or each, made and mended separately, since the world decides
/// which faults are alike.
enum class FaultMaking : std::uint8_t { first, each, by_world };

template <class Kind>
class FaultEngine {
 public:
  /// A fault of the plan.
  using Fault = ScheduledFault<Kind>;
  /// Functions that are called with the index of the fault in the plan: the one that notes it, and
  /// the one that makes and mends it, in this order.
  struct Hooks {
    Callback<void(std::size_t fault)> began;                 ///< before it is made
    Callback<void(std::size_t fault)> ended;                 ///< before it is mended
    Callback<void(std::size_t fault, bool is_present)> set;  ///< makes or mends it
  };

  /// Binds the members of `Maker` of these names.
  template <class Maker>
  static Hooks of(Maker& maker) {
    return {.began = callback<&Maker::began>(maker),
            .ended = callback<&Maker::ended>(maker),
            .set = callback<&Maker::set>(maker)};
  }

  /// The faults must outlive this object.
  FaultEngine(std::span<const Fault> faults, const Hooks& hooks,
              FaultMaking making = FaultMaking::first)
      : faults_(faults), hooks_(hooks), making_(making) {}
  FaultEngine(const FaultEngine&) = delete;
  FaultEngine& operator=(const FaultEngine&) = delete;

  /// Plans the faults in the world; this object must outlive the world's last run. At one instant,
  /// the order is that of the plan; where the world decides what is alike, all that begins comes
  /// first, so that a fault that takes over from another leaves no pause.
  void plan(World& world) {
    const auto plan_end = [&](std::size_t i) {
      if (faults_[i].end() != never) world.at(faults_[i].end(), [this, i](Time) { end(i); });
    };
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      world.at(faults_[i].start, [this, i](Time) { begin(i); });
      if (making_ != FaultMaking::by_world) plan_end(i);
    }
    for (std::size_t i = 0; making_ == FaultMaking::by_world && i < faults_.size(); ++i)
      plan_end(i);
  }

  const Fault& operator[](std::size_t fault) const { return faults_[fault]; }
  /// Indices in the plan.
  std::span<const std::size_t> present() const { return present_; }
  /// True if a fault of this kind is present, anywhere. Linear in the faults present.
  bool is_present(Kind kind) const {
    return std::ranges::any_of(present_, [&](std::size_t i) { return faults_[i].kind == kind; });
  }
  /// True if a fault of this kind is present at this node.
  bool is_present(Kind kind, NodeId node) const {
    return std::ranges::any_of(present_, [&](std::size_t i) {
      return faults_[i].kind == kind && node_of(faults_[i]) == node;
    });
  }
  /// True if the plan has a fault of this kind, at any time.
  bool has_any(Kind kind) const {
    return std::ranges::any_of(faults_, [&](const Fault& fault) { return fault.kind == kind; });
  }

 private:
  bool has_like(const Fault& fault) const {
    return making_ != FaultMaking::by_world && std::ranges::any_of(present_, [&](std::size_t i) {
             const Fault& other = faults_[i];
             return other.kind == fault.kind &&
                    (!has_node(fault.kind) || node_of(other) == node_of(fault)) &&
                    (!has_spot(fault.kind) || spot_of(other) == spot_of(fault));
           });
  }
  void begin(std::size_t fault) {
    hooks_.began(fault);
    const bool is_made =
        making_ == FaultMaking::each || !lasts(faults_[fault].kind) || !has_like(faults_[fault]);
    present_.push_back(fault);
    if (is_made) hooks_.set(fault, true);
  }
  void end(std::size_t fault) {
    hooks_.ended(fault);
    std::erase(present_, fault);
    if (!has_like(faults_[fault])) hooks_.set(fault, false);
  }

  std::span<const Fault> faults_;
  Hooks hooks_;
  FaultMaking making_;
  std::vector<std::size_t> present_;  ///< in the order in which they began
};

}  // namespace canvoy
