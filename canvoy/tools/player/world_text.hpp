// Common text and JSON of all worlds (docs/json.md): events on their buses, faults, invariants,
// buses and nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/sim/event.hpp"
#include "canvoy/sim/fault.hpp"
#include "canvoy/sim/hand_acted.hpp"
#include "canvoy/sim/invariant.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/tools/player/reported_event.hpp"

namespace canvoy::tools {

using Json = nlohmann::ordered_json;

/// A fault of a plan that has begun, and is not mended.
struct PresentFault {
  std::string text{};  ///< as in a plan: `dead-encoder:lift=2@5min`
  Time since{};
  bool is_excuse = true;  ///< false: what it causes is judged all the same
};

/// Names of the parts of a world.
class WorldNames {
 public:
  WorldNames() = default;
  virtual ~WorldNames() = default;
  WorldNames(const WorldNames&) = delete;
  WorldNames& operator=(const WorldNames&) = delete;

  virtual std::string bus(BusIndex bus) const = 0;                ///< `sim0`
  virtual std::string device(BusIndex bus, NodeId id) const = 0;  ///< `lift1: lift-drive (2)`
  virtual std::string_view part() const { return {}; }            ///< `lift`
  /// Name of a fault of the plan: `dead-encoder`.
  virtual std::string fault(std::size_t fault) const = 0;
  virtual std::string_view emergency(std::uint16_t code) const;
  /// Faults of the plan that are present at this time.
  virtual std::vector<PresentFault> faults_at(Time) const { return {}; }
};

/// For a world with a plan of faults in its options.
template <class Kind>
class PlanNames : public WorldNames {
 public:
  /// The plan must outlive this.
  explicit PlanNames(const FaultPlan<Kind>& plan) : plan_(plan) {}

  std::string bus(BusIndex bus) const override { return "sim" + std::to_string(bus); }
  std::string fault(std::size_t fault) const override {
    return std::string(fault_name(plan_.faults.at(fault).kind));
  }
  std::vector<PresentFault> faults_at(Time now) const override {
    std::vector<PresentFault> present;
    for (const ScheduledFault<Kind>& fault : plan_.faults) {
      const bool is_there = lasts(fault.kind) && fault.start <= now && now < fault.end();
      if (!is_there) continue;
      const bool is_excuse = !is_harmless(fault.kind) && !is_tampering(fault.kind);
      present.push_back({fault_text(fault), fault.start, is_excuse});
    }
    return present;
  }

 private:
  const FaultPlan<Kind>& plan_;
};

/// An event in both forms: the text, and an object without the time.
class Told {
 public:
  Told(std::string told, Json json);
  Told(Told&& other) noexcept;
  Told& operator=(Told&& other) noexcept;
  ~Told();

  Json& json() { return *json_; }

  std::string text;

 private:
  std::unique_ptr<Json> json_;
};
ReportedEvent reported_at(Time at, Told told);
Told told(const WorldNames& names, const BootedUp& event);
Told told(const WorldNames& names, const NmtStateSeen& event);
Told told(const WorldNames& names, const NmtCommandSeen& event);
Told told(const WorldNames& names, const EmergencySeen& event);
Told told(const WorldNames& names, const BusStateChanged& event);
Told told(const WorldNames& names, const HandActed& event);
/// `where` is a place in words: `at lift2: lift-drive (2)`.
Told reported_fault(const WorldNames& names, bool begins, std::string_view fault,
                    const FaultPlace& place, std::string_view where);

/// An invariant of any world.
using Judged = Invariant<const InvariantRow*>;
template <class Kind>
Judged judged(const Invariant<Kind>& it) {
  return {&invariant_name(it.kind), it.part, it.fault, it.worst, it.allowed, it.held, it.judged};
}
/// Text of an invariant: `lift 1: longest wait 62 s, 300 s allowed`.
std::string invariant_text(const WorldNames& names, const Judged& invariant);
Json invariant_json(const WorldNames& names, const Judged& invariant);
Told reported_broken(const WorldNames& names, const Judged& invariant);
/// Lines such as `  PASS  longest wait ...`.
template <class Kind>
std::string invariants_text(const WorldNames& names, std::span<const Invariant<Kind>> all);
/// Adds `invariants`, `all_held`, `all_decided` and, by its `time`, `faults_left` at the end of a
/// summary.
void add_judged(Json& json, const WorldNames& names, std::span<const Judged> all);
template <class Kind>
void add_invariants(Json& json, const WorldNames& names, std::span<const Invariant<Kind>> all);

/// Reports what all worlds have in common: events on buses, faults, invariants. A world adds a
/// class for its other events.
template <class Names>
class WorldTeller {
 public:
  template <class... Arguments>
  explicit WorldTeller(const Arguments&... arguments) : names_(arguments...) {}

  template <class Event>
    requires requires(const WorldNames& names, const Event& event) { told(names, event); }
  Told operator()(const Event& event) const {
    return told(names_, event);
  }
  template <class Kind>
  Told operator()(const FaultBegan<Kind>& event) const {
    return reported_fault(names_, true, fault_name(event.kind), event.place, where(event.place));
  }
  template <class Kind>
  Told operator()(const FaultEnded<Kind>& event) const {
    return reported_fault(names_, false, fault_name(event.kind), event.place, where(event.place));
  }
  template <class Kind>
  Told operator()(const InvariantBroken<Kind>& event) const {
    return reported_broken(names_, judged(event.invariant));
  }

 protected:
  std::string where(const FaultPlace& place) const {
    return place.node == 0 ? "" : "at " + names_.device(place.bus, place.node);
  }

  Names names_;
};

/// `time` and `event`, with which each line begins.
Json line_json(Time at, std::string_view event);
Json buses_json(const WorldNames& names, std::span<const BusSnapshot> buses);
Json nodes_json(const WorldNames& names, std::span<const NodeSnapshot> nodes);
/// Text of an NMT state, or `off`.
std::string_view state_text(const NodeSnapshot& node);

std::string invariant_line(const WorldNames& names, const Judged& invariant);

template <class Kind>
std::string invariants_text(const WorldNames& names, std::span<const Invariant<Kind>> all) {
  std::string text;
  for (const Invariant<Kind>& each : all) text += invariant_line(names, judged(each));
  return text;
}

template <class Kind>
void add_invariants(Json& json, const WorldNames& names, std::span<const Invariant<Kind>> all) {
  std::vector<Judged> each;
  for (const Invariant<Kind>& invariant : all) each.push_back(judged(invariant));
  add_judged(json, names, each);
}

/// A line for each of `faults_left` of a summary: what stands at its end has a cause there.
std::string faults_left_text(const Json& summary);

/// The last events, one per line.
template <class Network>
std::string last_events(const Network& network, std::size_t count) {
  std::string text;
  const auto events = network.events();
  for (const auto& event : events.last(std::min(count, events.size()))) {
    text += "  " + WorldText<Network>::event(event, network).line();
  }
  return text;
}

}  // namespace canvoy::tools
