#include "canvoy/tools/sheet/eds_read.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "canvoy/can/host/can_link.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/eds_writer.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/sheet_scan.hpp"
#include "canvoy/formats/sheet_value.hpp"
#include "canvoy/tools/bus/session.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/sheet/profile_argument.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/value_file.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

namespace {

using formats::DataSheet;
using formats::SheetIdentity;
using formats::SheetScan;
using Bytes = SheetScan::Bytes;

struct ReadOptions {
  std::string bus;
  std::string node;
  std::string sheet;
  std::string profile;
  std::string name;
  std::string out;
  std::string domains;  ///< a folder
  unsigned bit_rate = 0;
  std::string time_out = {};
};

constexpr unsigned bit_rate_default = 125;

/// Of the interface, in kbit/s, where it can be known.
unsigned present_bit_rate(const std::string& bus) {
  const host::BusAddress address = real_bus(bus);
  if (address.kind != host::BusKind::socketcan) return bit_rate_default;
  const auto link = host::read_can_link(address.interface);
  return link && link->bit_rate != 0 ? link->bit_rate / 1000 : bit_rate_default;
}

/// A line that is written anew: how far the scan is.
class ScanLine {
 public:
  void show(const SheetScan::Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (!is_terminal_ || now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    fmt::print(stderr, "\r{}/{}  {:04X}h", progress.done, progress.all, progress.index);
    std::fflush(stderr);
  }
  void end() const {
    if (shown_ != std::chrono::steady_clock::time_point{}) fmt::print(stderr, "\r\x1B[K");
  }

 private:
  bool is_terminal_ = ::isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point shown_{};
};

/// A running node, and the sheet that comes of it.
class NodeReader {
 public:
  NodeReader(const ReadOptions& options, NodeId node)
      : options_(options),
        node_(node),
        session_(options.bus, parse_duration_argument(options.time_out, 1s)),
        scan_([this](std::uint16_t index, std::uint8_t sub) {
          return session_.try_read(node_, index, sub);
        }) {
    scan_.on_progress([this](const SheetScan::Progress& progress) { line_.show(progress); });
  }

  /// `given`: the EDS of the user, or null.
  DataSheet read(const DataSheet* given) {
    const std::uint32_t device_type = number(object_index::device_type, 0);
    SheetIdentity identity = identity_of();
    DataSheet sheet;
    if (given != nullptr) {
      identity.last_eds = options_.sheet;
      sheet = read_by(*given, identity);
    } else if (const auto stored = options_.profile.empty() ? stored_sheet() : std::nullopt) {
      source_ = "the EDS that it stores (1021h)";
      identity.last_eds = "1021h";
      sheet = read_by(*stored, identity);
    } else {
      const Profile& profile = profile_of(device_type);
      source_ = std::string(profile.name);
      sheet = scan_.read_profile(profile, identity);
    }
    line_.end();
    if (!options_.domains.empty()) read_domains(sheet);
    return sheet;
  }

  void report(const std::string& out) const {
    for (const SheetScan::Unread& unread : scan_.unread()) {
      fmt::print(stderr, "{} {}: {}\n", words::object_text(unread.index, unread.sub),
                 formats::plain_text(unread.name),
                 unread.abort == AbortCode::none ? unread.reason : words::abort_text(unread.abort));
    }
    const std::size_t left = scan_.unread().size();
    fmt::print("{}, by {}: {} entries read{}, written to {}\n", words::node_text(node_), source_,
               scan_.count(), left == 0 ? "" : fmt::format(", {} not", left), out);
  }

 private:
  /// In blocks where the node knows them: domains are long.
  void read_domains(DataSheet& sheet) {
    const std::filesystem::path folder(options_.domains);
    session_.choose(SdoTransfer::automatic);
    session_.show_progress();
    scan_.read_domains(sheet, [&](std::uint16_t index, std::uint8_t sub, const Bytes& bytes) {
      const std::string name = formats::place_text(index, sub) + ".bin";
      write_value_file(folder / name, bytes);
      return (folder / name).string();
    });
    session_.choose(SdoTransfer::segmented);
  }

  DataSheet read_by(DataSheet sheet, const SheetIdentity& identity) {
    scan_.read_values(sheet);
    formats::commission(sheet, identity);
    return sheet;
  }

  /// 0 where the node does not have it.
  std::uint32_t number(std::uint16_t index, std::uint8_t sub) {
    const Result<Bytes> answer = session_.try_read(node_, index, sub);
    return answer ? static_cast<std::uint32_t>(load_unsigned(*answer)) : 0;
  }

  SheetIdentity identity_of() {
    SheetIdentity identity;
    const Result<Bytes> name = session_.try_read(node_, object_index::device_name, 0);
    if (name) {
      identity.product_name =
          formats::sheet_value_text(DataType::visible_string, *name).value_or("");
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

  /// The EDS that the node has in 1021h, in the one format that is readable (1022h: 0).
  std::optional<DataSheet> stored_sheet() {
    session_.choose(SdoTransfer::automatic);
    session_.show_progress();
    const Result<Bytes> content = session_.try_read(node_, object_index::store_eds, 0);
    session_.choose(SdoTransfer::segmented);
    if (!content || number(object_index::store_eds_format, 0) != 0) return std::nullopt;
    formats::Findings findings;
    DataSheet sheet = parse_sheet_text(
        {reinterpret_cast<const char*>(content->data()), content->size()}, findings);
    return sheet.objects.empty() ? std::nullopt : std::optional(std::move(sheet));
  }

  const Profile& profile_of(std::uint32_t device_type) const {
    if (!options_.profile.empty()) return parse_profile(options_.profile);
    const Profile* known = find_profile(device_type);
    return known == nullptr ? base_profile() : *known;
  }

  const ReadOptions& options_;
  NodeId node_;
  Session session_;
  SheetScan scan_;
  ScanLine line_;
  std::string source_ = "the given sheet";
};

int read_node(const ReadOptions& options) {
  const NodeId node = parse_node_id(options.node);
  if (!options.profile.empty()) parse_profile(options.profile);
  ReadOptions named = options;
  if (named.out.empty()) named.out = fmt::format("node{}.dcf", node);
  formats::Findings findings;
  std::optional<DataSheet> given;
  if (!options.sheet.empty()) given = read_sheet_file(options.sheet, findings);
  if (!named.out.ends_with(".dcf") && !named.out.ends_with(".xdc")) {
    throw UsageError(fmt::format("{}: name it .dcf or .xdc", named.out));
  }
  std::error_code none;
  if (!named.domains.empty() && !std::filesystem::is_directory(named.domains, none)) {
    throw UsageError(fmt::format("{}: it is no folder", named.domains));
  }
  NodeReader reader(named, node);
  const DataSheet sheet = reader.read(given ? &*given : nullptr);
  const std::string text = sheet_text(sheet, named.out);
  write_value_file(named.out, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  reader.report(named.out);
  return exit_done;
}

}  // namespace

void add_eds_read(CLI::App& eds, Action& action) {
  const auto options = std::make_shared<ReadOptions>();
  CLI::App* command =
      eds.add_subcommand("read", "Read all of a running node by SDO, and write its DCF");
  command->add_option("bus", options->bus, bus_text)->required();
  command->add_option("node", options->node, "10, 0x0A, 0Ah, or its name in the file of --network")
      ->required();
  CLI::Option* sheet =
      command->add_option("--eds", options->sheet,
                          "what the node has (default: the EDS that it stores in 1021h, else what "
                          "its profile and CiA 301 and 302 describe)");
  command
      ->add_option("--profile", options->profile,
                   "447-3, 417-4 (default: what the node's 1000h says)")
      ->excludes(sheet);
  command->add_option("--out", options->out, "into this file: .dcf or .xdc (default: node10.dcf)");
  command->add_option("--domains", options->domains,
                      "read the domains too, each into a file of this folder, which the DCF names "
                      "as its UploadFile (default: they are described without a value)");
  command->add_option("--name", options->name, "of the node in the DCF (default: its 1008h)");
  command
      ->add_option("--bit-rate", options->bit_rate,
                   "in kbit/s, for the DCF (default: that of the interface, else 125)")
      ->check(CLI::Range(1U, 1000U));
  command->add_option("--timeout", options->time_out, "for one answer: 500ms, 2s (default 1s)");
  add_examples(*command,
               "  canvoy eds read can0 10\n"
               "  canvoy eds read can0 10 --profile 418 --out battery.xdc --name battery");
  command->callback([options, &action] { action = [options] { return read_node(*options); }; });
}

}  // namespace canvoy::tools
