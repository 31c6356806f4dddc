#include "canvoy/tools/network/boot_master.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/manager/program.hpp"

namespace canvoy::tools {

namespace {

std::vector<FixedConfigurations::Item> items_of(const BootPlan& plan) {
  std::vector<FixedConfigurations::Item> items;
  items.reserve(plan.slaves.size());
  for (const SlavePlan& slave : plan.slaves) items.push_back({slave.id, slave.concise_dcf});
  return items;
}

}  // namespace

BootMaster::BootMaster(const BootPlan& plan, const Port& port)
    : plan_(plan),
      master_(port, plan.master, {.options = {.resets_slaves = plan.resets}}),
      presets_(master_.node()),
      items_(items_of(plan)),
      stored_(master_.node(), items_),
      configuration_workers_(workers<ConfigurationManager::Worker>()),
      configurations_(master_.node(), configuration_workers_),
      program_workers_(workers<ProgramManager::Worker>()),
      programs_(program_workers_,
                {.open = decltype(ProgramLibrary::open)::to<&BootMaster::open_program>(*this),
                 .read = decltype(ProgramLibrary::read)::to<&BootMaster::read_program>(*this)}) {
  BootHooks hooks;
  configurations_.serve(hooks);
  programs_.serve(hooks);
  boot_manager().use(hooks);
  preset();
}

/// A lost heartbeat concerns the slave only: the master keeps its state (1029h = 1).
void BootMaster::preset() {
  presets_.add(master_object::nmt_startup, 0, plan_.startup());
  presets_.add(master_object::boot_time, 0, static_cast<std::uint32_t>(plan_.boot_time / 1ms));
  presets_.add(master_object::nmt_inhibit_time, 0,
               static_cast<std::uint32_t>(plan_.inhibit_time / 100us));
  presets_.add(object_index::error_behaviour, 1, 1);
  std::uint8_t watched = 0;
  for (const SlavePlan& slave : plan_.slaves) {
    preset(slave);
    if (slave.heartbeat == Duration::zero()) continue;
    const auto ms = static_cast<std::uint32_t>(slave.heartbeat / 1ms);
    presets_.add(object_index::heartbeat_consumers, ++watched,
                 static_cast<std::uint32_t>(slave.id) << 16 | ms);
  }
}

void BootMaster::preset(const SlavePlan& slave) {
  const std::pair<std::uint16_t, std::uint32_t> values[] = {
      {master_object::slave_assignment, slave.assignment()},
      {master_object::device_type, slave.device_type},
      {master_object::vendor_id, slave.vendor_id},
      {master_object::product_code, slave.product_code},
      {master_object::revision_number, slave.revision_number},
      {master_object::serial_number, slave.serial_number},
      {master_object::restore_configuration, slave.restored_sub},
      {object_index::expected_configuration_date, slave.configuration_date.days},
      {object_index::expected_configuration_time, slave.configuration_date.milliseconds},
      {program::expected_identification, slave.program_id},
      {program::expected_date, slave.program_date.days},
      {program::expected_time, slave.program_date.milliseconds},
  };
  for (const auto& [index, value] : values) presets_.add(index, slave.id, value);
}

const SlavePlan* BootMaster::find(NodeId slave) const {
  const auto found = std::ranges::find(plan_.slaves, slave, &SlavePlan::id);
  return found == plan_.slaves.end() ? nullptr : &*found;
}

Result<std::uint32_t> BootMaster::open_program(NodeId slave) {
  const SlavePlan* plan = find(slave);
  if (plan == nullptr || plan->program.empty()) return AbortCode::no_data;
  return static_cast<std::uint32_t>(plan->program.size());
}

AbortCode BootMaster::read_program(NodeId slave, std::uint32_t offset,
                                   std::span<std::uint8_t> bytes) {
  const SlavePlan* plan = find(slave);
  if (plan == nullptr) return AbortCode::no_data;
  std::ranges::copy(std::span(plan->program).subspan(offset, bytes.size()), bytes.begin());
  return AbortCode::none;
}

}  // namespace canvoy::tools
