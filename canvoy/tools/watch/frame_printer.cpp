#include "canvoy/tools/watch/frame_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/encoding.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/frame_line.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/service_words.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/meant_line.hpp"
#include "canvoy/tools/sheet/described_nodes.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"
#include "canvoy/tools/watch/value_table.hpp"

namespace canvoy::tools {

namespace {

/// `can1:5`; all buses if none is given.
struct NodeOfBus {
  std::string bus;
  NodeId node = 0;
};

NodeOfBus parse_node_of_bus(const std::string& text) {
  // Some bus names contain colons: udp:239.74.163.2:43113.
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) return {{}, parse_node_id(text)};
  return {text.substr(0, colon), parse_node_id(std::string_view(text).substr(colon + 1))};
}

/// Names of buses (`udp:239.74.163.2:43113?ttl=1`) and of files may contain the sign: the last one
/// separates, or for a file the first one after a node-ID.
enum class Behind : std::uint8_t { word, file };

std::size_t sign_in(std::string_view text, Behind behind) {
  if (behind == Behind::word) return text.rfind('=');
  const std::size_t first = text.find('=');
  for (std::size_t sign = first; sign != std::string_view::npos; sign = text.find('=', sign + 1)) {
    const std::string_view before = text.substr(0, sign);
    if (names_node(before.substr(before.rfind(':') + 1))) return sign;
  }
  return first;
}

/// `5=419` before and after the sign; throws if there is none.
std::pair<std::string, std::string> split(const std::string& text, std::string_view example,
                                          Behind behind = Behind::word) {
  const std::size_t sign = sign_in(text, behind);
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
    throw UsageError(fmt::format("'{}' is not understood: write {}", text, example));
  }
  return {text.substr(0, sign), text.substr(sign + 1)};
}

}  // namespace

std::vector<std::string> FramePrinterOptions::node_words() const {
  std::vector<std::string> words;
  const auto add = [&words](const char* option, const std::vector<std::string>& given) {
    for (const std::string& each : given) words.insert(words.end(), {option, each});
  };
  add("--node", nodes);
  add("--profile", profiles);
  add("--reading", readings);
  add("--eds", sheets);
  return words;
}

std::string FramePrinterOptions::view_line(const std::string& source) const {
  std::vector<std::string> words = node_words();
  words.insert(words.begin(), {"view", source});
  return typed_line(words);
}

void FramePrinterOptions::add_nodes_to(Verb& command) {
  command.add({
      {"--node", nodes,
       "which profile a node has, where nobody reads its device type: 5=419, "
       "7=447-3; of one bus only: can1:5=419; of 407 and 417, whose CAN-IDs are "
       "fixed, any node will do; or which device of canvoy device --list it is: "
       "11=vehicle-gateway"},
      {"--profile", profiles,
       "the profile of all nodes of which nothing else is known: 447-3; of one bus: "
       "can1=447-3",
       one_each},
      {"--reading", readings,
       "where the text of a profile contradicts itself: another reading than the "
       "usual one, as `canvoy profile 852` tells them: 852=wide-displays"},
      {"--eds", sheets,
       "the data sheet of a node (EDS, DCF, XDD, XDC): 5=FILE, or of one bus "
       "can1:5=FILE; FILE alone is for all nodes that tell its vendor-ID and product "
       "code"},
  });
}

void FramePrinterOptions::add_filter_to(Verb& command) {
  command.add({
      {"--filter", filters,
       "show only frames of which this holds: bus=can1, node=5, id=180..1FF, service=SDO, "
       "object=temperature, temperature>40degC, time=10s..1min, marks; joined by and, "
       "or, not and parentheses; several: all must hold; --node 5 alone is node=5",
       one_each},
  });
  takes_filter = true;
}

void FramePrinterOptions::add_to(Verb& command) {
  add_nodes_to(command);
  add_filter_to(command);
  command.add({
      {"--transfers", transfers, "one line for each SDO transfer, with its value"},
      {"--json", json, "one JSON object a line"},
  });
}

FramePrinter::FramePrinter(const FramePrinterOptions& options)
    : transfers_(options.transfers), json_(options.json), csv_(options.csv) {
  constexpr std::size_t narrow_below = 120;
  const std::size_t width = json_ || csv_ ? 0 : terminal_width(STDOUT_FILENO);
  if (width != 0 && width < narrow_below) narrow_ = width;
  for (const std::string& text : options.readings) add_reading(text);
  for (const std::string& text : options.profiles) add_profile(text);
  std::vector<std::string> filters = options.filters;
  std::string only;
  for (const std::string& text : options.nodes) {
    if (!options.takes_filter || text.find('=') != std::string::npos) {
      add_node(text);
    } else {
      only += fmt::format("{}node={}", only.empty() ? "" : " or ", text);
    }
  }
  if (!only.empty()) filters.push_back(only);
  for (const std::string& text : options.sheets) add_sheet(text);
  if (!filters.empty()) add_filters(filters);
}

void FramePrinter::add_reading(const std::string& text) {
  const auto [name, reading] = split(text, "--reading 852=wide-displays");
  const Profile& profile = parse_profile(name);
  // A profile may have several.
  chosen_.emplace_back(reading_of(profile), parse_reading(profile, reading));
  any_bus_.replace_profile(profile, chosen_.back().profile());
}

/// The reading of a profile.
const Profile& FramePrinter::reading_of(const Profile& profile) {
  return any_bus_.reading_of(profile);
}

void FramePrinter::add_profile(const std::string& text) {
  if (text.find('=') == std::string::npos) {
    return add({.profile = &reading_of(parse_profile(text))});
  }
  const auto [bus, name] = split(text, "--profile 447-3, or can1=447-3");
  add({.bus = bus, .profile = &reading_of(parse_profile(name))});
}

void FramePrinter::add_node(const std::string& text) {
  if (text.find('=') == std::string::npos) {
    throw UsageError(fmt::format("which profile has node {0}? --node {0}=418", text));
  }
  const auto [node, name] = split(text, "--node 5=419, or can1:5=419");
  const auto [bus, node_id] = parse_node_of_bus(node);
  if (!is_device_name(name)) {
    return add({.bus = bus, .node = node_id, .profile = &reading_of(parse_profile(name))});
  }
  const DescribedNode device = describe_nodes(fmt::format("{}={}", node_id, name)).front();
  const auto& sheet = sheets_.emplace_back(device.sheet, &any_bus_);
  add({.bus = bus, .node = node_id, .sheet = &sheet.sheet()});
}

void FramePrinter::add_sheet(const std::string& text) {
  const std::size_t sign = text.find('=');
  std::error_code none;
  const bool is_for_all = sign == std::string::npos || std::filesystem::exists(text, none);
  formats::Findings findings;
  if (!is_for_all) {
    const auto [node, path] = split(text, "--eds 5=FILE, or can1:5=FILE", Behind::file);
    const auto [bus, node_id] = parse_node_of_bus(node);
    read_.push_back({bus, node_id, read_sheet_file(path, findings)});
    const auto& sheet = sheets_.emplace_back(read_.back().sheet, &any_bus_);
    return add({.bus = bus, .node = node_id, .sheet = &sheet.sheet()});
  }
  const auto& sheet = sheets_.emplace_back(read_sheet_file(text, findings), &any_bus_);
  if (!sheet.sheet().identity.is_product()) {
    throw UsageError(fmt::format(
        "{}: it has no vendor-ID and product code: say which node it is of, 5={}", text, text));
  }
  any_bus_.add_sheet(sheet.sheet());
}

std::vector<std::string> FramePrinter::use_sheets_of(const std::string& folder) {
  namespace fs = std::filesystem;
  constexpr std::uintmax_t size_max = 8'000'000;
  std::vector<std::string> names;
  std::error_code none;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, none)) {
    const std::string ending = file.path().extension().string();
    const bool is_sheet = std::ranges::any_of(
        std::array{".eds", ".dcf", ".xdd", ".xdc"},
        [&ending](const char* each) { return formats::same_letters(ending, each); });
    const std::uintmax_t size = is_sheet ? file.file_size(none) : 0;
    if (is_sheet && !none && size <= size_max) names.push_back(file.path().filename().string());
  }
  std::ranges::sort(names);
  if (names.size() > sheets_max) names.resize(sheets_max);
  std::erase_if(names, [&](const std::string& name) { return !use_sheet(folder + "/" + name); });
  return names;
}

/// False if it does not identify a node.
bool FramePrinter::use_sheet(const std::string& path) {
  try {
    formats::Findings findings;
    const formats::DataSheet read = read_sheet_file(path, findings);
    const NodeId node = read.node_id();
    const auto& sheet = sheets_.emplace_back(read, &any_bus_);
    if (node != 0) {
      add({.node = node, .sheet = &sheet.sheet()});
      return true;
    }
    if (!sheet.sheet().identity.is_product()) return false;
    any_bus_.add_sheet(sheet.sheet());
    return true;
  } catch (const Failure&) {
    return false;
  }
}

/// Options for one bus take precedence over those for all buses.
void FramePrinter::add(const Given& given) {
  if (!given.bus.empty()) return given_.push_back(given);
  tell(any_bus_, given);
}

void FramePrinter::tell(decoder::Network& network, const Given& given) {
  if (given.sheet != nullptr) return network.set_sheet(given.node, *given.sheet);
  if (given.node == 0) return network.assume_profile(*given.profile);
  network.set_profile(given.node, *given.profile);
}

void FramePrinter::add_filters(const std::vector<std::string>& filters) {
  FilterNames names;
  for (const formats::ChosenProfile& chosen : chosen_) names.add(chosen.profile());
  for (const decoder::SheetProfile& sheet : sheets_) names.add(sheet.profile());
  for (const std::string& text : filters) filter_.add(text, names);
}

bool FramePrinter::is_wanted(Duration time, std::string_view bus, const Frame& frame,
                             const text::FrameWords& words) {
  if (!first_) first_ = time;
  if (transfers_ && words.is_middle) return false;
  if (filter_.empty()) return true;
  return filter_.passes({time, time - *first_, bus, frame, words});
}

bool FramePrinter::may_pass(std::string_view bus, const Frame& frame) {
  const auto may = [&](std::string_view service, NodeId node, NodeId client) {
    const text::FrameWords words{.service = service, .node = node, .client = client};
    return filter_.may_pass({{}, {}, bus, frame, words});
  };
  if (frame.is_error()) return may("error frame", 0, 0);
  if (frame.is_extended()) return may("29-bit frame", 0, 0);
  return std::ranges::any_of(text::possible_words(network(bus), frame.id),
                             [&may](const text::PossibleWords& words) {
                               return may(words.service, words.node, words.client);
                             });
}

std::string FramePrinter::without_match() const {
  if (filter_.seen() == 0 || filter_.passed() != 0) return {};
  const std::vector<std::string_view> never = filter_.never_true();
  return fmt::format("none of {} frames passes the filter{}{}", filter_.seen(),
                     never.empty() ? "" : ", never true: ", fmt::join(never, "; "));
}

std::string_view FramePrinter::text_of(text::FrameDecoder& decoder,
                                       const text::FrameWords& words) const {
  return transfers_ && words.is_end ? decoder.transfer_text() : words.text;
}

FramePrinter::Bus::Bus(std::string_view name, const std::shared_ptr<text::FrameDecoder::Said>& said)
    : name(formats::plain_text(formats::as_utf8(name))), decoder(said) {}

FramePrinter::Bus& FramePrinter::bus_of(std::string_view name) {
  return buses_.at(name, [this, name] { return make_bus(name); });
}

std::unique_ptr<FramePrinter::Bus> FramePrinter::make_bus(std::string_view name) {
  auto made = std::make_unique<Bus>(name, said_);
  report_network(name, made->decoder.network());
  return made;
}

void FramePrinter::report_network(std::string_view bus, decoder::Network& network) {
  network = any_bus_;
  for (Given& given : given_) {
    if (given.bus != bus) continue;
    given.is_heard = true;
    tell(network, given);
  }
}

const text::FrameWords& FramePrinter::decode(Bus& bus, const Frame& frame) {
  const text::FrameWords& words = bus.decoder.decode(frame);
  if (words.is_unknown_pdo) bus.unknown.add(frame);
  return words;
}

std::vector<std::string> FramePrinter::unknown_pdos(text::UnknownPdosWords words) {
  std::vector<std::string> lines;
  std::size_t count = 0;
  buses_.for_each([&count](std::string_view, const Bus&) { ++count; });
  buses_.for_each([&](std::string_view, Bus& bus) {
    if (count > 1) words.bus = bus.name;
    std::string line = text::unknown_pdos_text(bus.unknown, bus.decoder.network(), words);
    if (line.empty()) return;
    if (count > 1) line.insert(0, bus.name + ": ");
    lines.push_back(std::move(line));
  });
  return lines;
}

std::vector<std::string_view> FramePrinter::silent_buses() const {
  std::vector<std::string_view> silent;
  for (const Given& given : given_) {
    const bool is_told = std::ranges::find(silent, given.bus) != silent.end();
    if (!given.is_heard && !is_told) silent.push_back(given.bus);
  }
  return silent;
}

bool FramePrinter::append(std::string& lines, Duration time, std::string_view bus,
                          const Frame& frame) {
  Bus& heard = bus_of(bus);
  const text::FrameWords& words = heard.decoder.decode(frame);
  if (!is_wanted(time, bus, frame, words)) return false;
  if (words.is_unknown_pdo) heard.unknown.add(frame);
  append_words(lines, {time, bus}, heard, frame, words);
  return true;
}

void FramePrinter::append_narrow(std::string& lines, Duration time, const Bus& heard,
                                 std::string_view frame, const text::FrameWords& words,
                                 std::string_view text) {
  if (first_bus_.empty()) first_bus_ = heard.name;
  has_buses_ = has_buses_ || first_bus_ != heard.name;
  const Duration since = time - first_.value_or(time);
  text::append_narrow_line(lines, {since, has_buses_ ? heard.name : std::string_view{}, frame},
                           words, text, narrow_);
  lines += '\n';
}

void FramePrinter::append_csv(std::string& lines, Duration time, std::string_view bus,
                              const text::FrameWords& words) {
  if (!has_head_) lines += csv_head();
  has_head_ = true;
  for (const decoder::DecodedValue& value : words.values) {
    tools::append_csv(lines, {time, bus, words.node, value});
  }
}

bool FramePrinter::append_fd(std::string& lines, const formats::TraceFrame& heard) {
  const text::FrameWords words{.service = "CAN FD"};
  const Duration time = heard.time.time_since_epoch();
  if (!is_wanted(time, heard.channel, heard.frame, words)) return false;
  // `185##1`: identifier and flags, then the bytes.
  std::string text = formats::hex(heard.frame.id, heard.frame.is_extended() ? 8 : 3);
  text += fmt::format("##{:X}", heard.fd.flags);
  for (std::size_t at = 0; at < heard.fd.length; ++at)
    text += formats::hex(heard.fd.data.at(at), 2);
  if (csv_) return false;
  if (json_) {
    frame_json_.append(lines, time, heard.channel, text, words, {});
  } else if (narrow_ != 0) {
    append_narrow(lines, time, bus_of(heard.channel), text, words,
                  fmt::format("{} bytes", heard.fd.length));
    return true;
  } else {
    text::append_frame_line(lines, {time, bus_of(heard.channel).name, text}, words,
                            fmt::format("{} bytes", heard.fd.length));
  }
  lines += '\n';
  return true;
}

void FramePrinter::append_words(std::string& lines, Duration time, std::string_view bus,
                                const Frame& frame, const text::FrameWords& words) {
  append_words(lines, {time, bus}, bus_of(bus), frame, words);
}

void FramePrinter::append_words(std::string& lines, const Heard& when, Bus& heard,
                                const Frame& frame, const text::FrameWords& words) {
  const auto& [time, bus] = when;
  const FrameText text(frame);
  if (csv_) return append_csv(lines, time, heard.name, words);
  if (narrow_ != 0) {
    append_narrow(lines, time, heard, text.view(), words, text_of(heard.decoder, words));
    return;
  }
  if (json_) {
    frame_json_.append(lines, time, bus, text.view(), words, text_of(heard.decoder, words));
  } else {
    text::append_frame_line(lines, {time, heard.name, text.view()}, words,
                            text_of(heard.decoder, words));
  }
  lines += '\n';
}

std::optional<std::string> FramePrinter::describe(Duration time, std::string_view bus,
                                                  const Frame& frame) {
  const text::FrameWords* words = look(time, bus, frame);
  if (words == nullptr) return std::nullopt;
  std::string text(words->service);
  const std::size_t bare = text.size() + 1;
  text += ' ';
  text::append_meaning(text, *words, text_of(decoder_of(bus), *words));
  if (text.size() == bare) text.pop_back();
  return text;
}

const text::FrameWords* FramePrinter::look(Duration time, std::string_view bus,
                                           const Frame& frame) {
  Bus& heard = bus_of(bus);
  const text::FrameWords& words = heard.decoder.decode(frame);
  if (!is_wanted(time, bus, frame, words)) return nullptr;
  if (words.is_unknown_pdo) heard.unknown.add(frame);
  return &words;
}

void print_unknown_pdos(std::string_view source, FramePrinter& printer,
                        text::UnknownPdosWords words) {
  for (const std::string& line : printer.unknown_pdos(words)) {
    print_message(fmt::format("{}: {}", source, line));
  }
}

}  // namespace canvoy::tools
