#include "canvoy/tools/device/bus/bus_counting.hpp"

namespace canvoy::tools {

void BusCounting::join(Environment& environment) {
  using namespace cia407;
  environment.provide(
      Callback<PassengerCounterSettings()>::to<&BusCounting::counter_settings>(*this));
  environment.watch(
      Callback<void(PassengerCounterUnit&, Node&)>::to<&BusCounting::is_counter>(*this));
  environment.provide(
      Callback<CountingManagerSettings()>::to<&BusCounting::manager_settings>(*this));
  environment.watch(
      Callback<void(CountingManagerUnit&, Node&)>::to<&BusCounting::is_manager>(*this));
}

void BusCounting::act(const BusPress& press) {
  const unsigned people = press.number().value_or(1);
  if (press.what == "in") counter_->count_in(people);
  if (press.what == "out") counter_->count_out(people);
  if (press.what == "open-door" || press.what == "close-door") {
    counter_->set_door(press.what == "open-door");
  }
  if (press.what == "clear") manager_->clear();
}

std::optional<BusCounting::Counts> BusCounting::counts() const {
  return manager_ == nullptr ? std::nullopt : std::optional(manager_->counts());
}

void BusCounting::is_manager(cia407::CountingManagerUnit& unit, Node& /*node*/) {
  manager_ = &unit;
  unit.restore(settings_.kept);
}

}  // namespace canvoy::tools
