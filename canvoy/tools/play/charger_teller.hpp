// Words for the events of a charger and its battery: of a network of the two, or of one bay of a
// charging yard, whose number stands before them.
//
//     std::visit(ChargerTeller(options, options.faults), event.what);    // "charger: may deliver"
//     std::visit(ChargerTeller(bay, plan, 2U), event.what);      // "bay 2: charger: may deliver"
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/worlds/charger/charger_event.hpp"
#include "canvoy/worlds/charger/charger_options.hpp"

namespace canvoy::tools {

class ChargerNames : public PlanNames<charger::FaultKind> {
 public:
  using Plan = charger::FaultPlan;

  /// Both must outlive this object. `bay` is from 1 on; 0: there are no bays.
  ChargerNames(const charger::ChargerOptions& options, const Plan& plan, unsigned bay = 0)
      : PlanNames(plan), options_(options), bay_(bay) {}

  std::string device(BusIndex bus, NodeId id) const override;
  std::string_view part() const override { return bay_ == 0 ? "" : "bay"; }
  const charger::ChargerOptions& options() const { return options_; }
  unsigned bay() const { return bay_; }

 private:
  const charger::ChargerOptions& options_;
  unsigned bay_;
};

class ChargerTeller : public WorldTeller<ChargerNames> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const charger::PhaseEntered& event) const;
  Told operator()(const charger::ReasonChanged& event) const;
  Told operator()(const charger::ChargeBegan& event) const;
  Told operator()(const charger::ChargeEnded& event) const;
  Told operator()(const charger::TimeSeen& event) const;
  Told operator()(const charger::SdoConnectionChanged& event) const;

 private:
  Told charger(const std::string& text, Json json) const;
};

}  // namespace canvoy::tools
