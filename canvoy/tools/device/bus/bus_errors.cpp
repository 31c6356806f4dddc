#include "canvoy/tools/device/bus/bus_errors.hpp"

namespace canvoy::tools {

void BusErrors::join(Site& site) {
  using cia407::CodeOnlyHardware, cia407::DeviceCode;
  site.offer(Callback<CodeOnlyHardware<DeviceCode::data_radio>()>::to<
             &BusErrors::radio<DeviceCode::data_radio>>(*this));
  site.offer(Callback<CodeOnlyHardware<DeviceCode::voice_radio>()>::to<
             &BusErrors::radio<DeviceCode::voice_radio>>(*this));
  site.offer(Callback<CodeOnlyHardware<DeviceCode::short_range_communication>()>::to<
             &BusErrors::radio<DeviceCode::short_range_communication>>(*this));
  site.offer(Callback<CodeOnlyHardware<DeviceCode::power_supply>()>::to<&BusErrors::supply>(*this));
}

void BusErrors::act(const BusPress& press) {
  if (press.what == "connect" || press.what == "disconnect") {
    is_disconnected_ = press.what == "disconnect";
  }
  const auto code = static_cast<std::uint16_t>(press.number().value_or(0));
  if (press.what == "fail") errors_.insert(code);
  if (press.what == "mend") errors_.erase(code);
}

template <cia407::DeviceCode code>
cia407::CodeOnlyHardware<code> BusErrors::radio() {
  return {.has_error = Callback<bool(std::uint16_t)>::to<&BusErrors::is_disconnected>(*this)};
}

cia407::CodeOnlyHardware<cia407::DeviceCode::power_supply> BusErrors::supply() {
  return {.has_error = Callback<bool(std::uint16_t)>::to<&BusErrors::has>(*this)};
}

}  // namespace canvoy::tools
