#include "canvoy/tools/device/bus/reported_errors.hpp"

namespace canvoy::tools {

void ReportedErrors::join(Environment& environment) {
  using cia407::CodeOnlyHardware, cia407::DeviceCode;
  environment.provide(callback<&ReportedErrors::radio<DeviceCode::data_radio>>(*this));
  environment.provide(callback<&ReportedErrors::radio<DeviceCode::voice_radio>>(*this));
  environment.provide(
      callback<&ReportedErrors::radio<DeviceCode::short_range_communication>>(*this));
  environment.provide(callback<&ReportedErrors::supply>(*this));
}

void ReportedErrors::act(const BusPress& press) {
  if (press.what == "connect" || press.what == "disconnect") {
    is_disconnected_ = press.what == "disconnect";
  }
  const auto code = static_cast<std::uint16_t>(press.number().value_or(0));
  if (press.what == "fail") errors_.insert(code);
  if (press.what == "mend") errors_.erase(code);
}

template <cia407::DeviceCode code>
cia407::CodeOnlyHardware<code> ReportedErrors::radio() {
  return {.has_error = callback<&ReportedErrors::is_disconnected>(*this)};
}

cia407::CodeOnlyHardware<cia407::DeviceCode::power_supply> ReportedErrors::supply() {
  return {.has_error = callback<&ReportedErrors::has>(*this)};
}

}  // namespace canvoy::tools
