#include "canvoy/tools/device/interface_bit_timing.hpp"

#include <fmt/format.h>

namespace canvoy::tools {

std::uint8_t InterfaceBitTiming::present() const {
  const host::Result<host::CanLink> link = host::read_can_link(interface_);
  return link ? lss_bit_timing::index(link->bit_rate) : lss_bit_timing::unknown;
}

LssError InterfaceBitTiming::configure(std::uint8_t index) const {
  const host::Result<host::CanLink> link = host::read_can_link(interface_);
  if (!link || !link->has_controller) {
    say_(link ? fmt::format("{} has no bit rate that LSS could set", interface_)
              : link.error().line());
    return {.code = LssError::out_of_range};
  }
  const bool is_known = lss_bit_timing::bit_rate(index) != 0;
  return {.code = is_known ? LssError::none : LssError::out_of_range};
}

void InterfaceBitTiming::switch_to(std::uint8_t index) const {
  const std::uint32_t bit_rate = lss_bit_timing::bit_rate(index);
  const host::Result<host::CanLink> link = host::read_can_link(interface_);
  if (link && link->is_up && link->bit_rate == bit_rate) return;
  const host::Result<void> done = host::restart_can_link(interface_, bit_rate, false);
  say_(done ? fmt::format("{} has {} bit/s now", interface_, bit_rate) : done.error().line());
}

}  // namespace canvoy::tools
