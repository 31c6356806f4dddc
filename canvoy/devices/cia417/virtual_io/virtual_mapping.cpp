#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::cia417 {

namespace {

constexpr unsigned mapped_max = 64;

}  // namespace

VirtualMapping::VirtualMapping(Node& node, Tpdos& tpdos, std::uint16_t index,
                               const VirtualSource& source)
    : node_(node),
      tpdos_(tpdos),
      source_(source),
      former_(tpdos.before_transmit),
      timer_(callback<&VirtualMapping::go_on>(*this)),
      index_(index) {
  tpdos_.before_transmit = callback<&VirtualMapping::before_transmit>(*this);
}

void VirtualMapping::announce() {
  if (const std::uint16_t number = find_pdo(); number != 0) {
    tpdos_.trigger(number);
  } else if (detour_.announce) {
    detour_.announce();
  }
}

bool VirtualMapping::is_working() {
  return find_pdo() != 0 || (detour_.is_working && detour_.is_working());
}

bool VirtualMapping::take(std::uint64_t& record) {
  if (!source_.waits()) return false;
  record = source_.next();
  node_.dictionary().set_number(index_, 0, record);
  return true;
}

void VirtualMapping::before_transmit(std::uint16_t number) {
  if (former_) former_(number);
  std::uint64_t record = 0;
  if (carries(number) && take(record)) node_.timers().arm(timer_, node_.now());
}

/// Sends the next one, if any.
void VirtualMapping::go_on(Time) {
  if (source_.waits()) announce();
}

/// Type 252 samples without sending: it would take records that no node receives.
bool VirtualMapping::carries(std::uint16_t number) const {
  const Dictionary& dictionary = node_.dictionary();
  const auto parameter = static_cast<std::uint16_t>(object_index::tpdo_parameter + number - 1);
  const auto mapping = static_cast<std::uint16_t>(object_index::tpdo_mapping + number - 1);
  if (dictionary.number(parameter, 2) == transmission_type::remote_synchronous) return false;
  const std::uint64_t count = dictionary.number(mapping, 0);
  if (count > mapped_max) return false;
  for (unsigned sub = 1; sub <= count; ++sub) {
    if (dictionary.number(mapping, static_cast<std::uint8_t>(sub)) >> 16 == index_) return true;
  }
  return false;
}

/// The first that is working and carries the object; 0: none.
std::uint16_t VirtualMapping::find_pdo() {
  if (node_.state() != NmtState::operational) return 0;
  for (std::size_t i = 0; i < tpdos_.size(); ++i) {
    const auto number = static_cast<std::uint16_t>(tpdos_.first() + i);
    if (tpdos_[number].is_active() && carries(number)) return number;
  }
  return 0;
}

}  // namespace canvoy::cia417
