// canvoy eds export|read|check|diff|convert: data sheets of devices.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "canvoy/formats/eds/eds_writer.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/sheet/sheet_check.hpp"
#include "canvoy/formats/sheet/sheet_diff.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/cli/meant_line.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/device/catalogue/operator_elements.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"
#include "canvoy/tools/sheet/eds_export.hpp"
#include "canvoy/tools/sheet/node_reader.hpp"
#include "canvoy/tools/sheet/scan_line.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

// canvoy eds read BUS NODE: the DCF of a running node.

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

/// Reports what was read, and what was not. `clone` is the line that reads more; empty: there is
/// none.
void report_scan(const NodeReader& reader, NodeId node, const std::string& out,
                 std::string_view clone) {
  const std::vector<SheetScan::Unread>& left = reader.scan().unread();
  for (const SheetScan::Unread& unread : left) {
    print_message(fmt::format(
        "{} {}: {}", text::object_text(unread.index, unread.sub), formats::plain_text(unread.name),
        unread.abort == AbortCode::none ? unread.reason : text::abort_text(unread.abort)));
  }
  fmt::print("{}, by {}: {} entries read{}, written to {}\n", text::node_text(node),
             reader.source(), reader.scan().count(),
             left.empty() ? "" : fmt::format(", {} not", left.size()), out);
  if (clone.empty()) return;
  fmt::print("what {} does not describe is left out: {} reads 2000h to 9FFFh whole\n",
             reader.source(), clone);
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
  require_values(named.out, {"eds", "read", named.bus, named.node});
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
    report_scan(
        reader, node, named.out,
        reader.is_by_profile() ? typed_line({"clone", named.bus, named.node}) : std::string{});
  }
  return exit_done;
}

/// Adds it as a subcommand of `eds`.
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

void write_text(const std::string& path, const std::string& text) {
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void report_written(const std::string& path, const formats::DataSheet& sheet) {
  JsonEvent event("written");
  event->key("file").text(path);
  event->key("objects").number(sheet.objects.size());
  event.print();
}

int export_to(const ExportOptions& options, const std::string& out, bool json) {
  if (json && out.empty()) throw UsageError("--json says what was written: give a file by --out");
  if (options.node_id > 127) throw UsageError("--node-id: give 1 to 127");
  ExportOptions named = options;
  const std::size_t slash = out.rfind('/');
  named.file_name =
      out.empty() ? "device.eds" : out.substr(slash == std::string::npos ? 0 : slash + 1);
  const formats::DataSheet sheet = export_sheet(named);
  if (out.empty()) {
    fmt::print("{}", formats::write_eds(sheet));
  } else {
    write_text(out, sheet_text(sheet, out));
    if (json) report_written(out, sheet);
  }
  return exit_done;
}

void report_finding(const std::string& path, const formats::Finding& finding) {
  JsonEvent event("finding");
  event->key("file").text(path);
  if (finding.line != 0) event->key("line").number(finding.line);
  if (!finding.section.empty()) event->key("place").text(finding.section);
  const bool is_error = finding.weight == formats::Finding::Weight::error;
  event->key("weight").text(is_error ? "error" : "warning");
  event->key("text").text(finding.text);
  if (!finding.expected.empty()) event->key("expected").text(finding.expected);
  event.print();
}

int check(const std::string& path, const std::string& profile_name, bool json) {
  const Profile* profile = profile_name.empty() ? nullptr : &parse_profile(profile_name);
  formats::Findings findings;
  const formats::DataSheet sheet = read_sheet_file(path, findings);
  formats::check_sheet(sheet, profile, findings);
  for (const formats::Finding& finding : findings) {
    if (json) {
      report_finding(path, finding);
    } else {
      fmt::print("{}\n", finding_text(path, finding));
    }
  }
  const auto errors =
      std::ranges::count(findings, formats::Finding::Weight::error, &formats::Finding::weight);
  const auto warnings = std::ssize(findings) - errors;
  if (json) {
    JsonEvent event("summary");
    event->key("objects").number(sheet.objects.size());
    event->key("errors").number(errors);
    event->key("warnings").number(warnings);
    event.print();
  } else {
    fmt::print("{} objects, {} errors, {} warnings\n", sheet.objects.size(), errors, warnings);
  }
  return errors == 0 ? exit_done : exit_failed;
}

void report_difference(const formats::Difference& difference) {
  JsonEvent event("difference");
  event->key("place").text(difference.place);
  if (!difference.key.empty()) event->key("key").text(difference.key);
  event->key("first").text(difference.first);
  event->key("second").text(difference.second);
  event.print();
}

int compare(const std::string& first, const std::string& second, bool json) {
  formats::Findings findings;
  const formats::DataSheet one = read_sheet_file(first, findings);
  const formats::DataSheet other = read_sheet_file(second, findings);
  const std::vector<formats::Difference> differences = formats::compare_sheets(one, other);
  const auto side = [](const std::string& text) { return text.empty() ? "-" : text; };
  for (const formats::Difference& difference : differences) {
    if (json) {
      report_difference(difference);
      continue;
    }
    const std::string line = fmt::format("[{}]{}: {} | {}", difference.place,
                                         difference.key.empty() ? "" : " " + difference.key,
                                         side(difference.first), side(difference.second));
    fmt::print("{}\n", formats::plain_text(line));
  }
  return differences.empty() ? exit_done : exit_failed;
}

/// Content of 1F22h in a configuration manager (CiA 302-3).
int write_concise(const std::string& from, const std::string& to, bool json) {
  const Configuration configuration = read_configuration(from, 0);
  const std::vector<std::uint8_t> bytes = formats::concise_dcf_of(configuration.entries);
  write_value_file(to, bytes);
  if (json) {
    JsonEvent event("written");
    event->key("file").text(to);
    event->key("entries").number(configuration.entries.size());
    event.print();
  }
  return exit_done;
}

void report_lost(const std::string& path, const formats::Difference& lost) {
  JsonEvent event("lost");
  event->key("file").text(path);
  event->key("place").text(lost.place);
  if (!lost.key.empty()) event->key("key").text(lost.key);
  event->key("value").text(lost.first);
  event.print();
}

int convert(const std::string& from, const std::string& to, bool json) {
  if (to.ends_with(".cdcf")) return write_concise(from, to, json);
  formats::Findings findings;
  const formats::DataSheet sheet = read_sheet_file(from, findings);
  const std::string text = sheet_text(sheet, to);
  write_text(to, text);
  std::size_t values = 0;
  for (const formats::Difference& lost : compare_sheets(sheet, read_sheet_file(to, findings))) {
    if (lost.first.empty()) continue;  // nothing was said
    if (json) {
      report_lost(to, lost);
      continue;
    }
    if (lost.key == "ParameterValue") {
      ++values;
      continue;
    }
    fmt::print("{} does not hold {}\n", to,
               formats::plain_text(fmt::format("[{}] {}: {}", lost.place, lost.key, lost.first)));
  }
  // Of an EDS there are none, and a line for each of a hundred would hide what else is lost.
  if (values != 0) fmt::print("{} does not hold ParameterValue of {} entries\n", to, values);
  if (json) report_written(to, sheet);
  return exit_done;
}

std::shared_ptr<bool> add_json_flag(Verb& command) {
  auto json = std::make_shared<bool>(false);
  command.add({
      {"--json", *json, "one JSON object a line"},
  });
  return json;
}

void add_export(Verb& eds) {
  const auto options = std::make_shared<ExportOptions>();
  const auto out = std::make_shared<std::string>();
  Verb& command = eds.add_verb("export", "Write the data sheet of a device");
  command.add({
      {"what", options->what, "a profile (407, 417-4), or a device of canvoy device --list",
       required},
      {"--device", options->device, "a virtual device: its code (03) or name"},
      {"--class", options->device_class, "of the virtual device"},
      {"--subclass", options->subclass, "of the virtual device"},
      {"--objects", options->objects,
       "further objects: 6010, 6100-611F, or names, with commas between them", separated_by(',')},
      {"--optional", options->optional, "with all that is optional"},
      {"--elements", options->elements, operator_elements_help},
      {"--reading", options->reading,
       "where the text of the profile contradicts itself: another reading"},
      {"--node-id", options->node_id, "a DCF of the node with this node-ID"},
      {"--out", *out, "into this file: .eds, .dcf, .xdd or .xdc"},
  });
  const auto json = add_json_flag(command);
  command.add_examples(
      "  canvoy eds export charger --out charger.eds\n"
      "  canvoy eds export 407 --device 03 --class 1 --subclass 2 --out indicator.eds\n"
      "  canvoy eds export battery --node-id 10 --out node10.dcf");
  command.runs([=] { return export_to(*options, *out, *json); });
}

void add_sheet_check(Verb& eds) {
  const auto path = std::make_shared<std::string>();
  const auto profile = std::make_shared<std::string>();
  Verb& command = eds.add_verb("check", "Say what is wrong with a data sheet");
  command.add({
      {"file", *path, "EDS, DCF, XDD or XDC", required},
      {"--profile", *profile, "check it against this profile, too: 447-3"},
  });
  const auto json = add_json_flag(command);
  command.add_examples(
      "  canvoy eds check pump.eds\n"
      "  canvoy eds check battery.dcf --profile 418");
  command.runs([=] { return check(*path, *profile, *json); });
}

/// A subcommand with two files.
void add_pair(Verb& eds, const char* name, const char* text, const char* first, const char* second,
              const char* second_text, const char* examples,
              int (*run)(const std::string&, const std::string&, bool)) {
  const auto one = std::make_shared<std::string>();
  const auto other = std::make_shared<std::string>();
  Verb& command = eds.add_verb(name, text);
  command.add({
      {first, *one, "EDS, DCF, XDD or XDC", required},
      {second, *other, second_text, required},
  });
  const auto json = add_json_flag(command);
  command.add_examples(examples);
  command.runs([=] { return run(*one, *other, *json); });
}

}  // namespace

void add_eds(Verb& app) {
  Verb& eds = app.add_verb("eds", "Write, read from nodes, check, compare and convert data sheets");
  eds.require_verb();
  eds.add_examples(
      "  canvoy eds check pump.eds\n"
      "  canvoy eds read can0 10 --out node10.dcf");
  add_export(eds);
  add_sheet_check(eds);
  add_eds_read(eds);
  add_pair(eds, "diff", "Say what two data sheets say differently", "first", "second",
           "EDS, DCF, XDD or XDC", "  canvoy eds diff pump.eds battery.dcf", compare);
  add_pair(eds, "convert", "Write a data sheet in another form", "from", "to",
           ".eds, .dcf, .xdd, .xdc; .cdcf: of a DCF, what a configuration manager has in 1F22h",
           "  canvoy eds convert pump.eds pump.xdd\n"
           "  canvoy eds convert battery.dcf battery.cdcf",
           convert);
}

}  // namespace canvoy::tools
