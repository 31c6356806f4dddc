#include "canvoy/tools/sheet/eds_export.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/formats/sheet/sheet_export.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"
#include "canvoy/tools/device/catalogue/operator_elements.hpp"

namespace canvoy::tools {

namespace {

using formats::SheetIdentity;
using formats::SheetMaker;

SheetIdentity identity_of(const ExportOptions& options, std::string product) {
  SheetIdentity identity;
  identity.product_name = std::move(product);
  identity.node_id = static_cast<std::uint8_t>(options.node_id);
  identity.file_name = options.file_name;
  const std::tm now = fmt::gmtime(std::chrono::system_clock::now());
  identity.time = fmt::format("{:%I:%M%p}", now);
  identity.date = fmt::format("{:%m-%d-%Y}", now);
  return identity;
}

/// For several virtual devices on one node.
formats::DataSheet sheet_of_shared(const ExportOptions& options, const SharedNode& shared) {
  const bool is_bus = !shared.bus.empty();
  SheetIdentity identity = identity_of(
      options, is_bus ? shared.bus.front()->info.product : shared.car.front()->info.product);
  identity.answers_lss = true;
  SheetMaker maker(is_bus ? cia407::profile : cia447::profile, std::move(identity));
  const std::vector<Part> parts =
      is_bus ? cia407::bus_parts(shared.bus) : cia447::car_parts(shared.car);
  for (const Part& part : parts) maker.add(part);
  formats::DataSheet sheet = maker.take();
  // 6000h, which a device sets at its start (CiA 407, 9.2.3.1).
  constexpr std::uint16_t types_of_devices = 0x6000;
  for (std::size_t i = 0; i < shared.bus.size(); ++i) {
    const std::uint32_t type = cia407::device_type(*shared.bus[i]->provides) >> 16;
    sheet.objects.at(types_of_devices).subs.at(static_cast<std::uint8_t>(i + 1)).default_value =
        fmt::format("0x{:04X}", type);
  }
  return sheet;
}

std::optional<formats::DataSheet> sheet_of_kind(const ExportOptions& options) {
  const SharedNode shared = parse_shared_node(options.what);
  if (!shared.empty()) return sheet_of_shared(options, shared);
  const DeviceKind* kind = find_any_device_kind(options.what);
  if (kind == nullptr) return std::nullopt;
  SheetIdentity identity = identity_of(options, kind->info.product);
  identity.answers_lss = kind->answers_lss;
  SheetMaker maker(*kind->profile, std::move(identity));
  if (kind == &cia852::operator_kind) {
    const auto elements = parse_operator_elements(options.elements);
    for (const Part& part : cia852::operator_parts(elements, false)) maker.add(part);
  } else {
    for (const Part& part : kind->forms.front().parts()) maker.add(part);
  }
  return maker.take();
}

std::optional<unsigned> parse_code(std::string_view text) {
  unsigned code = 0;
  if (text.starts_with("0x")) text.remove_prefix(2);
  if (text.ends_with('h')) text.remove_suffix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code, 16);
  const bool is_all = error == std::errc{} && end == text.data() + text.size();
  return is_all ? std::optional(code) : std::nullopt;
}

const VirtualDeviceInfo& find_device(const Profile& profile, const ExportOptions& options) {
  const auto code = parse_code(options.device);
  std::vector<std::string> known;
  for (const VirtualDeviceInfo& device : profile.virtual_devices) {
    const bool is_named = same_name(device.name, options.device);
    if (!is_named && !(code && *code == device.code)) continue;
    const bool fits = device.device_class == options.device_class.value_or(device.device_class) &&
                      device.subclass == options.subclass.value_or(device.subclass);
    if (fits) return device;
    known.push_back(fmt::format("--class {} --subclass {}", device.device_class, device.subclass));
  }
  if (!known.empty()) {
    throw UsageError(
        fmt::format("device {} has no such class: {}", options.device, fmt::join(known, ", ")));
  }
  throw UsageError(fmt::format("'{}' is no virtual device of {}: see canvoy profile {}",
                               options.device, profile.name, short_name(profile)));
}

using Parts = DeviceDescription<512>;

/// Adds an object, or all objects of a range of one shape: `6100-611F`.
void add_objects(Parts& parts, const Profile& profile, const std::string& text) {
  const std::size_t dash = text.find('-');
  const auto first = parse_code(text.substr(0, dash));
  const auto last = dash == std::string::npos ? first : parse_code(text.substr(dash + 1));
  if (dash == std::string::npos || !first || !last) {
    const auto found = find_address(profile, text);
    if (!found || found->object == nullptr) {
      throw UsageError(fmt::format("{} has no object '{}'", profile.name, text));
    }
    const ObjectAddress& address = *found;
    const Part part(*address.object);
    if (parts.find(address.index) == nullptr) {
      parts.add(part.only(address.index - address.object->index));
    }
    return;
  }
  bool is_any = false;
  for (unsigned index = *first; index <= *last && index <= 0xFFFF; ++index) {
    const ObjectInfo* object = find_description(profile, index);
    if (object == nullptr || parts.find(index) != nullptr) continue;
    parts.add(Part(*object).only(index - object->index));
    is_any = true;
  }
  if (!is_any) throw UsageError(fmt::format("{} has no object in {}", profile.name, text));
}

bool has_pdo(const VirtualDeviceInfo& device, const PdoInfo& pdo) {
  return pdo.number != 0 && std::ranges::find(pdo.devices, device.code) != pdo.devices.end();
}

/// Adds the optional objects that its PDOs carry.
void add_mapped(Parts& parts, const Profile& profile, const VirtualDeviceInfo& device) {
  for (const PdoInfo& pdo : profile.pdos) {
    if (!has_pdo(device, pdo)) continue;
    for (const std::uint32_t mapped : pdo.mapping) {
      const unsigned index = MappingValue(mapped).index;
      const DeviceObject* object = canvoy::detail::find_device_object(device, index);
      if (object != nullptr) add_device_object(parts, profile, *object);
    }
  }
}

/// Adds the PDOs, except those with entries that the device does not have and that have no dummy.
void add_pdos(SheetMaker& maker, const Profile& profile, const VirtualDeviceInfo& device) {
  for (const PdoInfo& pdo : profile.pdos) {
    const bool is_sent = pdo.direction == PdoInfo::Direction::transmit;
    const bool is_whole = std::ranges::all_of(pdo.mapping, [&](std::uint32_t mapped) {
      return maker.has(MappingValue(mapped).index) || (!is_sent && SheetMaker::has_dummy(mapped));
    });
    if (has_pdo(device, pdo) && is_whole) maker.add(pdo);
  }
}

/// Adds the objects of CiA 301 that the profile requires in all devices.
void add_communication(Parts& parts, const Profile& profile) {
  for (const ObjectInfo* object : profile.objects) {
    const bool is_wanted = object->index <= object_index::communication_last &&
                           object->category == Category::mandatory;
    if (is_wanted && parts.find(object->index) == nullptr) parts.add(*object);
  }
}

formats::DataSheet sheet_of_profile(const ExportOptions& options, const Profile& profile) {
  const auto parts = std::make_unique<Parts>();
  const VirtualDeviceInfo* device = nullptr;
  const bool is_built_on_another = profile.device_types.mask != 0;
  std::uint32_t device_type = is_built_on_another ? profile.device_types.value : profile.number;
  if (!options.device.empty()) {
    device = &find_device(profile, options);
    for (const DeviceObject& object : device->objects) {
      if (!options.optional && object.category != Category::mandatory) continue;
      add_device_object(*parts, profile, object);
    }
    add_mapped(*parts, profile, *device);
    add_communication(*parts, profile);
    if (profile.device_type_of != nullptr) device_type = profile.device_type_of(*device);
  } else {
    for (const ObjectInfo* object : profile.objects) {
      if (options.optional || object->category == Category::mandatory) parts->add(*object);
    }
  }
  for (const std::string& text : options.objects) add_objects(*parts, profile, text);
  parts->add_mapped(profile);
  std::string product(device == nullptr ? profile.name : device->name);
  SheetMaker maker(profile, identity_of(options, std::move(product)));
  maker.add(*parts);
  if (device != nullptr) add_pdos(maker, profile, *device);
  maker.add_basics(device_type);
  return maker.take();
}

}  // namespace

formats::DataSheet export_sheet(const ExportOptions& options) {
  if (options.device.empty() && (options.device_class || options.subclass)) {
    throw UsageError("--class and --subclass need --device");
  }
  if (!options.elements.empty() && options.what != cia852::operator_kind.info.name) {
    throw UsageError("--elements: they are of the device operator");
  }
  if (auto sheet = sheet_of_kind(options)) return *std::move(sheet);
  const std::string meant = did_you_mean(options.what, all_device_names());
  if (!meant.empty() && find_profile(options.what) == nullptr)
    throw UsageError(fmt::format("'{}' is neither a profile nor a device{}", options.what, meant));
  const Profile& profile = parse_profile(options.what);
  if (options.reading.empty()) return sheet_of_profile(options, profile);
  const formats::ChosenProfile chosen(profile, parse_reading(profile, options.reading));
  return sheet_of_profile(options, chosen.profile());
}

}  // namespace canvoy::tools
