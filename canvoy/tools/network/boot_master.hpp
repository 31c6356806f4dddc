// The NMT master of `canvoy boot`: boots the slaves of a plan, and gives each the configuration and
// the program that the plan has for it (CiA 302-2, CiA 302-3).
//
//     BootMaster master(plan, port);
//     master.boot_manager().on_report(...);
//     master.node().start(now);
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/manager/fixed_configurations.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/canopen/manager/program_manager.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/tools/network/boot_plan.hpp"
#include "canvoy/tools/network/presets.hpp"

namespace canvoy::tools {

inline constexpr auto boot_master_device =
    describe(cia301::device_type(0), cia301::error_register_object, cia301::identity({}),
             cia301::heartbeat_consumers(node_id_max), cia301::heartbeat_producer(0),
             cia301::error_behavior(), cia302::nmt_master(), cia302::restore_configuration_object,
             cia302::configuration(), cia302::expected_programs());
inline constexpr auto boot_master_layout = lay_out_device<boot_master_device>();

class BootMaster {
 public:
  /// `plan` must outlive this.
  BootMaster(const BootPlan& plan, const Port& port);
  BootMaster(const BootMaster&) = delete;
  BootMaster& operator=(const BootMaster&) = delete;

  Node& node() { return master_.node(); }
  BootManager& boot_manager() { return master_.boot_manager(); }
  ConfigurationManager& configurations() { return configurations_; }
  ProgramManager& programs() { return programs_; }

 private:
  static constexpr std::size_t slots = 32;
  using Master =
      MasterNode<boot_master_layout,
                 MasterSize{.slots = slots, .guarded = node_id_max, .own_routes = slots}>;

  template <class Worker, std::size_t... numbers>
  std::array<Worker, slots> workers(std::index_sequence<numbers...>) {
    return {((void)numbers, Worker(node()))...};
  }
  template <class Worker>
  std::array<Worker, slots> workers() {
    return workers<Worker>(std::make_index_sequence<slots>{});
  }
  void preset();
  void preset(const SlavePlan& slave);
  const SlavePlan* find(NodeId slave) const;
  Result<std::uint32_t> open_program(NodeId slave);
  AbortCode read_program(NodeId slave, std::uint32_t offset, std::span<std::uint8_t> bytes);

  const BootPlan& plan_;
  Master master_;
  Presets presets_;
  std::vector<FixedConfigurations::Item> items_;
  FixedConfigurations stored_;
  std::array<ConfigurationManager::Worker, slots> configuration_workers_;
  ConfigurationManager configurations_;
  std::array<ProgramManager::Worker, slots> program_workers_;
  ProgramManager programs_;
};

}  // namespace canvoy::tools
