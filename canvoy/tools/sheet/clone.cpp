// canvoy clone BUS NODE: reads an existing device into a data sheet, from which `canvoy device`
// makes a stand-in.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <memory>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/sheet/node_reader.hpp"
#include "canvoy/tools/sheet/scan_line.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"

namespace canvoy::tools {

namespace {

struct CloneOptions {
  std::string bus;
  std::string node;
  std::string out;
  std::vector<std::string> ranges = {"2000-5FFF", "6000-9FFF"};
  std::string time_out = {};
  bool json = false;
};

struct IndexRange {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
};

/// `2000-2FFF`, `6010`
IndexRange parse_index_range(std::string_view text) {
  const auto number = [&](std::string_view digits) {
    unsigned value = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const bool is_index = error == std::errc{} && end == digits.data() + digits.size() &&
                          value >= 0x1000 && value <= 0xFFFF;
    if (!is_index)
      throw UsageError(fmt::format("--ask: '{}' is no range of indices: 2000-5FFF", text));
    return static_cast<std::uint16_t>(value);
  };
  const std::size_t dash = text.find('-');
  const IndexRange range = {number(text.substr(0, dash)),
                            number(dash == std::string_view::npos ? text : text.substr(dash + 1))};
  if (range.first > range.last)
    throw UsageError(fmt::format("--ask: '{}' ends before it begins", text));
  return range;
}

int clone_node(const CloneOptions& options) {
  const NodeId node = parse_node_id(options.node);
  std::vector<IndexRange> ranges;
  ranges.reserve(options.ranges.size());
  for (const std::string& text : options.ranges) ranges.push_back(parse_index_range(text));
  const std::string out = options.out.empty() ? fmt::format("node{}.dcf", node) : options.out;
  require_values(out, {"clone", options.bus, options.node});
  Session session(options.bus, parse_answer_time(options.time_out));
  NodeReader reader(session, node, {.bus = options.bus, .out = out});
  ScanLine line;
  reader.on_progress(
      [&line](const formats::SheetScan::Progress& progress) { line.show(progress); });
  formats::DataSheet sheet = reader.read();
  const std::size_t described = sheet.objects.size();
  for (const IndexRange& range : ranges) reader.read_undescribed(sheet, range.first, range.last);
  line.end();
  const std::string text = sheet_text(sheet, out);
  write_value_file(out, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  const std::size_t unknown = sheet.objects.size() - described;
  if (options.json) {
    std::string json_text;
    text::JsonLine json(json_text);
    json.begin_object();
    json.key("node").number(std::int64_t{node});
    json.key("objects").number(static_cast<std::uint64_t>(sheet.objects.size()));
    json.key("undescribed").number(static_cast<std::uint64_t>(unknown));
    json.key("entries").number(static_cast<std::uint64_t>(reader.scan().count()));
    json.key("file").text(out);
    json.end_object();
    fmt::print("{}\n", json_text);
    return exit_done;
  }
  fmt::print("{}: {} objects that {} describes, {} that nobody does, {} entries read\n",
             text::node_text(node), described, reader.source(), unknown, reader.scan().count());
  fmt::print("written to {}; a stand-in for it: canvoy device {} {} --node-id {}\n", out, out,
             options.bus, node);
  return exit_done;
}

}  // namespace

void add_clone(Verb& app) {
  const auto options = std::make_shared<CloneOptions>();
  Verb& command = app.add_verb("clone", "Make a data sheet of a device, for a stand-in");
  command.add({
      {"bus", options->bus, bus_text, required},
      {"node", options->node, "10, 0x0A, 0Ah, or its name in the file of --network", required},
      {"--out", options->out, "into this file: .dcf or .xdc (default: node10.dcf)"},
      {"--ask", options->ranges,
       "indices that are asked for beside those that are described (default: "
       "2000-5FFF,6000-9FFF)",
       separated_by(',')},
      {"--timeout", options->time_out, answer_time_text, answer_time_rules},
      {"--json", options->json, "one JSON object"},
  });
  command.set_footer(
      "Nothing is written to the device. Of objects that nobody describes the types are guessed "
      "by\n"
      "the length of their values, and the stand-in lets all of them be written.\n"
      "Examples:\n"
      "  canvoy clone can0 10\n"
      "  canvoy clone can0 10 --ask 2000-20FF --out pump.dcf\n"
      "  canvoy device pump.dcf can0 --node-id 10");
  command.runs([options] { return clone_node(*options); });
}

}  // namespace canvoy::tools
