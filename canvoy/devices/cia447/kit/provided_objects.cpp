#include "canvoy/devices/cia447/kit/provided_objects.hpp"

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"

namespace canvoy::cia447 {

ProvidedObjects::ProvidedObjects(CarNetwork& network, const Settings& settings)
    : network_(network), settings_(settings) {
  check_invariant(settings.objects.size() <= objects_max);
  for (std::size_t i = 0; i < settings.objects.size(); ++i) {
    Hook& hook = hooks_[i];
    hook.first = hook.last = settings.objects[i]->index;
    hook.before_write = callback<&ProvidedObjects::asked>(*this);
    network.node().dictionary().attach(hook);
  }
}

/// A client that is not the provider is refused before its values are checked.
AbortCode ProvidedObjects::asked(const Entry& entry, std::span<const std::uint8_t> value) {
  if (!network_.is_request()) return AbortCode::none;
  const NodeId client = network_.mesh_client();
  if (client == 0 || client != settings_.provider) {
    const auto told = static_cast<std::uint32_t>(load_unsigned(value));
    settings_.refused({client, entry.index, entry.sub, told});
    return AbortCode::local_control;
  }
  const AbortCode answer = check_codes(entry, value);
  return answer != AbortCode::none ? answer : settings_.check(entry, value);
}

}  // namespace canvoy::cia447
