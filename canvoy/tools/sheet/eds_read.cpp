#include "canvoy/tools/sheet/eds_read.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/sheet/node_reader.hpp"
#include "canvoy/tools/sheet/scan_line.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

using formats::DataSheet;
using formats::SheetScan;

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
  bool json = false;
};

/// Reports what was read, and what was not.
void report_scan(const NodeReader& reader, NodeId node, const std::string& out) {
  const std::vector<SheetScan::Unread>& left = reader.scan().unread();
  for (const SheetScan::Unread& unread : left) {
    print_message(fmt::format(
        "{} {}: {}", text::object_text(unread.index, unread.sub), formats::plain_text(unread.name),
        unread.abort == AbortCode::none ? unread.reason : text::abort_text(unread.abort)));
  }
  fmt::print("{}, by {}: {} entries read{}, written to {}\n", text::node_text(node),
             reader.source(), reader.scan().count(),
             left.empty() ? "" : fmt::format(", {} not", left.size()), out);
}

void tell_scan(const NodeReader& reader, NodeId node, const std::string& out) {
  for (const SheetScan::Unread& unread : reader.scan().unread()) {
    JsonEvent event("unread");
    event->key("node").number(node);
    append_index(*event, unread.index, unread.sub);
    event->key("name").text(unread.name);
    event->key("text").text(unread.abort == AbortCode::none ? unread.reason
                                                            : text::abort_text(unread.abort));
    event.print();
  }
  JsonEvent event("written");
  event->key("node").number(node);
  event->key("file").text(out);
  event->key("source").text(reader.source());
  event->key("entries").number(reader.scan().count());
  event->key("unread").number(reader.scan().unread().size());
  event.print();
}

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
  Session session(named.bus, parse_answer_time(named.time_out));
  NodeReader reader(session, node,
                    {.bus = named.bus,
                     .profile = named.profile,
                     .name = named.name,
                     .out = named.out,
                     .bit_rate = named.bit_rate});
  ScanLine line;
  reader.on_progress([&line](const SheetScan::Progress& progress) { line.show(progress); });
  DataSheet sheet = given ? reader.read_by(*given, named.sheet) : reader.read();
  line.end();
  if (!named.domains.empty()) reader.read_domains(sheet, named.domains);
  const std::string text = sheet_text(sheet, named.out);
  write_value_file(named.out, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (options.json) {
    tell_scan(reader, node, named.out);
  } else {
    report_scan(reader, node, named.out);
  }
  return exit_done;
}

}  // namespace

void add_eds_read(Verb& eds) {
  const auto options = std::make_shared<ReadOptions>();
  Verb& command = eds.add_verb("read", "Read all of a running node by SDO, and write its DCF");
  command.add({
      {"bus", options->bus, bus_text, required},
      {"node", options->node, "10, 0x0A, 0Ah, or its name in the file of --network", required},
      {"--eds", options->sheet,
       "what the node has (default: the EDS that it stores in 1021h, else what "
       "its profile and CiA 301 and 302 describe)"},
      {"--profile", options->profile, "447-3, 417-4 (default: what the node's 1000h says)",
       excludes("--eds")},
      {"--out", options->out, "into this file: .dcf or .xdc (default: node10.dcf)"},
      {"--domains", options->domains,
       "read the domains too, each into a file of this folder, which the DCF names "
       "as its UploadFile (default: they are described without a value)"},
      {"--name", options->name, "of the node in the DCF (default: its 1008h)"},
      {"--bit-rate", options->bit_rate,
       "in kbit/s, for the DCF (default: that of the interface, else 125)", between(1U, 1000U)},
      {"--timeout", options->time_out, answer_time_text, answer_time_rules},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy eds read can0 10\n"
      "  canvoy eds read can0 10 --profile 418 --out battery.xdc --name battery");
  command.runs([options] { return read_node(*options); });
}

}  // namespace canvoy::tools
