#include "canvoy/tools/sheet/node_reader.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "canvoy/can/host/can_link.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"

namespace canvoy::tools {

namespace {

using formats::DataSheet;
using formats::SheetIdentity;

constexpr unsigned dcf_bit_rate_default = 125;

/// Bit rate of the interface in kbit/s, if known.
unsigned present_bit_rate(const std::string& bus) {
  const host::BusAddress address = real_bus(bus);
  if (address.kind != host::BusType::socketcan) return dcf_bit_rate_default;
  const auto link = host::read_can_link(address.interface);
  return link && link->bit_rate != 0 ? link->bit_rate / 1000 : dcf_bit_rate_default;
}

}  // namespace

NodeReader::NodeReader(Session& session, NodeId node, NodeReaderOptions options)
    : options_(std::move(options)),
      node_(node),
      session_(session),
      scan_([this](std::uint16_t index, std::uint8_t sub) {
        return session_.try_read(node_, index, sub);
      }) {}

DataSheet NodeReader::read() {
  const std::uint32_t device_type = number(object_index::device_type, 0);
  SheetIdentity identity = identity_of();
  if (auto stored = options_.profile.empty() ? stored_sheet() : std::nullopt) {
    source_ = "the EDS that it stores (1021h)";
    identity.last_eds = "1021h";
    scan_.read_values(*stored);
    formats::commission(*stored, identity);
    return *std::move(stored);
  }
  const Profile& profile = profile_of(device_type);
  source_ = std::string(profile.name);
  is_by_profile_ = true;
  return scan_.read_profile(profile, identity);
}

DataSheet NodeReader::read_by(const DataSheet& given, const std::string& path) {
  SheetIdentity identity = identity_of();
  identity.last_eds = path;
  DataSheet sheet = given;
  scan_.read_values(sheet);
  formats::commission(sheet, identity);
  return sheet;
}

/// In blocks if the node supports them: domains are long.
void NodeReader::read_domains(DataSheet& sheet, const std::string& folder) {
  const std::filesystem::path path(folder);
  session_.choose(SdoTransfer::automatic);
  session_.show_progress();
  scan_.read_domains(sheet, [&](std::uint16_t index, std::uint8_t sub, const Bytes& bytes) {
    const std::string name = formats::place_text(index, sub) + ".bin";
    write_value_file(path / name, bytes);
    return (path / name).string();
  });
  session_.choose(SdoTransfer::segmented);
}

/// 0 if the node does not have it.
std::uint32_t NodeReader::number(std::uint16_t index, std::uint8_t sub) {
  const Result<Bytes> answer = session_.try_read(node_, index, sub);
  return answer ? static_cast<std::uint32_t>(load_unsigned(*answer)) : 0;
}

SheetIdentity NodeReader::identity_of() {
  SheetIdentity identity;
  const Result<Bytes> name = session_.try_read(node_, object_index::device_name, 0);
  if (name) {
    identity.product_name = formats::sheet_value_text(DataType::visible_string, *name).value_or("");
  }
  identity.vendor_id = number(object_index::identity, 1);
  identity.product_code = number(object_index::identity, 2);
  identity.revision = number(object_index::identity, 3);
  identity.serial_number = number(object_index::identity, 4);
  identity.node_id = node_;
  identity.node_name = options_.name;
  identity.kilobits_per_second =
      options_.bit_rate != 0 ? options_.bit_rate : present_bit_rate(options_.bus);
  const std::size_t slash = options_.out.rfind('/');
  identity.file_name = options_.out.substr(slash == std::string::npos ? 0 : slash + 1);
  const std::tm now = fmt::gmtime(std::chrono::system_clock::now());
  identity.time = fmt::format("{:%I:%M%p}", now);
  identity.date = fmt::format("{:%m-%d-%Y}", now);
  return identity;
}

/// The EDS in 1021h of the node, in the only readable format (1022h: 0).
std::optional<DataSheet> NodeReader::stored_sheet() {
  session_.choose(SdoTransfer::automatic);
  session_.show_progress();
  const Result<Bytes> content = session_.try_read(node_, object_index::store_eds, 0);
  session_.choose(SdoTransfer::segmented);
  if (!content || number(object_index::store_eds_format, 0) != 0) return std::nullopt;
  formats::Findings findings;
  DataSheet sheet =
      parse_sheet_text({reinterpret_cast<const char*>(content->data()), content->size()}, findings);
  return sheet.objects.empty() ? std::nullopt : std::optional(std::move(sheet));
}

const Profile& NodeReader::profile_of(std::uint32_t device_type) const {
  if (!options_.profile.empty()) return parse_profile(options_.profile);
  const Profile* known = find_profile(device_type);
  return known == nullptr ? base_profile() : *known;
}

}  // namespace canvoy::tools
