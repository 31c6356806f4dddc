#include "canvoy/tools/frame_printer.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/object_words.hpp"
#include "canvoy/tools/sheet_file.hpp"
#include "canvoy/tools/text.hpp"

namespace canvoy::tools {

namespace {

/// For comparing: in lower case, with a blank for each underscore.
std::string plain(std::string_view text) {
  std::string made(text);
  std::ranges::transform(made, made.begin(), [](char c) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    if (c == '_') return ' ';
    return is_upper ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return made;
}

/// `5=419` before and behind the sign; throws where there is none.
std::pair<std::string, std::string> split(const std::string& text, std::string_view example) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
    throw UsageError(fmt::format("'{}' is not understood: write {}", text, example));
  }
  return {text.substr(0, sign), text.substr(sign + 1)};
}

NodeId parse_node(std::string_view text) {
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  const std::string_view digits = is_hex ? text.substr(2) : text;
  unsigned node = 0;
  const char* last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, node, is_hex ? 16 : 10);
  if (error != std::errc{} || end != last || !is_node_id(node)) {
    throw UsageError(fmt::format("'{}' is no node-ID: 1 to 127", text));
  }
  return static_cast<NodeId>(node);
}

/// `node 10 (0Ah): temperature = 20.000 °C [!] wrong length`
std::string meaning(const FrameWords& words, const std::string& text) {
  const std::string marks = marks_text(words.marks);
  return fmt::format(
      "{}{}{}{}{}", words.client == 0 ? "" : fmt::format("node {} to ", unsigned{words.client}),
      words.node == 0 ? "" : node_text(words.node), words.node == 0 || text.empty() ? "" : ": ",
      text, marks.empty() ? "" : " [!] " + marks);
}

void print_text(double seconds, std::string_view bus, std::string_view frame,
                const FrameWords& words, const std::string& text) {
  fmt::print("({:.6f}) {} {:<21} {:<16} {}\n", seconds, bus, frame, words.service,
             meaning(words, text));
}

void print_json(double seconds, std::string_view bus, std::string_view frame,
                const FrameWords& words, const std::string& text) {
  nlohmann::ordered_json line = {
      {"time", seconds}, {"bus", bus}, {"frame", frame}, {"service", words.service}};
  if (words.node != 0) line["node"] = words.node;
  if (words.client != 0) line["client"] = words.client;
  if (!text.empty()) line["text"] = text;
  if (!words.values.empty()) line["values"] = values_json(words.values);
  if (!words.marks.empty()) line["marks"] = marks_json(words.marks);
  fmt::print("{}\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

void FramePrinterOptions::add_to(CLI::App& command) {
  command.add_option("--node", nodes,
                     "which profile a node has, where nobody reads its device type: 5=419, "
                     "7=447-3; of 407 and 417, whose CAN-IDs are fixed, any node will do");
  command.add_option("--eds", sheets, "the data sheet of a node (EDS, DCF, XDD, XDC): 5=FILE");
  command.add_option("--filter", filters,
                     "show only node=5, service=SDO, object=temperature; several: all must hold");
  command.add_flag("--transfers", transfers, "one line for each SDO transfer, with its value");
  command.add_flag("--json", json, "one JSON object a line");
}

FramePrinter::FramePrinter(const FramePrinterOptions& options)
    : transfers_(options.transfers), json_(options.json) {
  for (const std::string& text : options.nodes) add_node(text);
  for (const std::string& text : options.sheets) add_sheet(text);
  for (const std::string& text : options.filters) add_filter(text);
}

void FramePrinter::add_node(const std::string& text) {
  const auto [node, name] = split(text, "--node 5=419");
  const Profile* profile = find_profile(std::string_view(name));
  if (profile == nullptr) {
    throw UsageError(fmt::format("CiA {} is no profile that is known here", name));
  }
  decoder_.network().set_profile(parse_node(node), *profile);
}

void FramePrinter::add_sheet(const std::string& text) {
  const auto [node, path] = split(text, "--eds 5=FILE");
  const NodeId node_id = parse_node(node);
  formats::Findings findings;
  sheets_.emplace_back(read_sheet_file(path, findings)).apply(decoder_.network(), node_id);
}

void FramePrinter::add_filter(const std::string& text) {
  const auto [by, what] = split(text, "--filter node=5, service=SDO or object=temperature");
  if (by == "node") {
    filters_.push_back({Filter::By::node, {}, parse_node(what)});
  } else if (by == "service" || by == "object") {
    filters_.push_back({by == "object" ? Filter::By::object : Filter::By::service, plain(what), 0});
  } else {
    throw UsageError(fmt::format("no filter is called '{}': there are node, service, object", by));
  }
}

bool FramePrinter::passes(const Filter& filter, const FrameWords& words) {
  switch (filter.by) {
    case Filter::By::node:
      return words.node == filter.node || words.client == filter.node;
    case Filter::By::service:
      return plain(words.service).find(filter.text) != std::string::npos;
    case Filter::By::object:
      break;
  }
  return std::ranges::any_of(words.values, [&filter](const decoder::DecodedValue& value) {
    const std::string address = plain(object_text(value.index, value.sub));
    return address.starts_with(filter.text) ||
           plain(object_name_text(value)).find(filter.text) != std::string::npos;
  });
}

bool FramePrinter::is_wanted(const FrameWords& words) const {
  if (transfers_ && words.is_middle) return false;
  return std::ranges::all_of(filters_,
                             [&words](const Filter& filter) { return passes(filter, words); });
}

const std::string& FramePrinter::text_of(const FrameWords& words) const {
  return transfers_ && !words.transfer.empty() ? words.transfer : words.text;
}

bool FramePrinter::print(Duration time, std::string_view bus, const Frame& frame) {
  const FrameWords words = decoder_.decode(frame);
  if (!is_wanted(words)) return false;
  const double seconds = std::chrono::duration<double>(time).count();
  const FrameText text(frame);
  const auto show = json_ ? print_json : print_text;
  show(seconds, bus, text.view(), words, text_of(words));
  return true;
}

std::optional<std::string> FramePrinter::describe(const Frame& frame) {
  const FrameWords words = decoder_.decode(frame);
  if (!is_wanted(words)) return std::nullopt;
  const std::string text = meaning(words, text_of(words));
  return text.empty() ? words.service : fmt::format("{} {}", words.service, text);
}

}  // namespace canvoy::tools
