#include "canvoy/tools/device/bus/bus_wires.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

namespace canvoy::tools {

namespace {

std::string set_bits_text(std::uint32_t bits) {
  std::vector<unsigned> set;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((bits >> bit & 1) != 0) set.push_back(bit + 1);
  }
  return set.empty() ? "none" : fmt::format("{}", fmt::join(set, ", "));
}

}  // namespace

void BusWires::join(Environment& environment) {
  environment.provide(callback<&BusWires::hardware>(*this));
}

void BusWires::act(const BusPress& press) {
  if (press.what != "input") return;
  inputs_ ^= std::uint32_t{1} << (press.number().value_or(0) - 1);
}

cia407::GenericIoHardware BusWires::hardware() {
  return {.digital_inputs = callback<&BusWires::inputs>(*this),
          .set_digital_outputs = callback<&BusWires::set_outputs>(*this),
          .set_analogue_output = callback<&BusWires::set_analogue>(*this),
          .has_error = callback<&BusWires::has_error>(*this)};
}

void BusWires::set_outputs(std::uint32_t outputs) {
  if (std::exchange(outputs_, outputs) == outputs) return;
  output_.say("generic-io", fmt::format("outputs on: {}", set_bits_text(outputs)));
}

void BusWires::set_analogue(unsigned channel, std::int16_t value) {
  if (std::exchange(analogue_.at(channel - 1), value) == value) return;
  output_.say("generic-io", fmt::format("analogue output {}: {}", channel, value));
}

}  // namespace canvoy::tools
