#include "canvoy/tools/node/other_programs.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <optional>
#include <span>
#include <string_view>

#include "canvoy/tools/argument/bus_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/word_order.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

struct ProgramOption {
  char letter;
  bool has_value = false;
  std::string_view meant = {};  ///< our option; `.`: a place; empty: left out
};

struct OtherProgram {
  std::string_view name;
  std::string_view verb;
  std::span<const ProgramOption> options;
  std::string_view added = {};  ///< an option that is always meant
};

// As their manuals say them: can-utils 2023, wireshark 4.
constexpr std::array candump_options = {
    ProgramOption{'t', true}, ProgramOption{'H'},
    ProgramOption{'c'},       ProgramOption{'i'},
    ProgramOption{'a'},       ProgramOption{'S'},
    ProgramOption{'s', true}, ProgramOption{'D'},
    ProgramOption{'d'},       ProgramOption{'e'},
    ProgramOption{'8'},       ProgramOption{'x'},
    ProgramOption{'r', true}, ProgramOption{'l'},
    ProgramOption{'L'},       ProgramOption{'n', true, "--count"}};
constexpr std::array canplayer_options = {ProgramOption{'I', true, "."},
                                          ProgramOption{'l', true, "--loop"},
                                          ProgramOption{'t', false, "--speed=0"},
                                          ProgramOption{'i'},
                                          ProgramOption{'v'},
                                          ProgramOption{'x'},
                                          ProgramOption{'g', true},
                                          ProgramOption{'s', true}};
constexpr std::array log_to_log_options = {ProgramOption{'I', true, "."},
                                           ProgramOption{'O', true, "."},
                                           ProgramOption{'n'},
                                           ProgramOption{'4'},
                                           ProgramOption{'f'},
                                           ProgramOption{'d'}};
constexpr std::array canbusload_options = {ProgramOption{'t'}, ProgramOption{'b'},
                                           ProgramOption{'c'}, ProgramOption{'r'},
                                           ProgramOption{'i'}, ProgramOption{'e'}};
constexpr std::array cansniffer_options = {
    ProgramOption{'c'},       ProgramOption{'B'},       ProgramOption{'8'},
    ProgramOption{'q'},       ProgramOption{'r', true}, ProgramOption{'t', true},
    ProgramOption{'h', true}, ProgramOption{'l', true}, ProgramOption{'f', true}};
constexpr std::array tshark_options = {ProgramOption{'r', true, "."},
                                       ProgramOption{'i', true, "."},
                                       ProgramOption{'c', true, "--count"},
                                       ProgramOption{'Y', true, "--filter"},
                                       ProgramOption{'w', true, "--out"},
                                       ProgramOption{'V'},
                                       ProgramOption{'x'},
                                       ProgramOption{'n'},
                                       ProgramOption{'O', true},
                                       ProgramOption{'T', true, "--json"}};

// As python-can 4 says them.
constexpr std::array python_can_options = {
    ProgramOption{'c', true, "."}, ProgramOption{'f', true, "."}, ProgramOption{'i', true},
    ProgramOption{'b', true},      ProgramOption{'s', true},      ProgramOption{'a'}};

constexpr auto other_programs = std::to_array<OtherProgram>({
    {"candump", "monitor", candump_options},
    {"canplayer", "replay", canplayer_options},
    {"log2asc", "convert-log", log_to_log_options},
    {"asc2log", "convert-log", log_to_log_options},
    {"canbusload", "load", canbusload_options},
    {"cansniffer", "monitor", cansniffer_options, "--table"},
    {"tshark", "decode", tshark_options},
    {"logger", "record", python_can_options},
    {"player", "replay", python_can_options},
    {"viewer", "monitor", python_can_options, "--table"},
});

/// A line of a program, option by option.
class ProgramLine {
 public:
  ProgramLine(const OtherProgram& program, Words rest) : program_(program), rest_(std::move(rest)) {
    while (at_ < rest_.size()) take(rest_[at_++]);
  }

  Words meant() const {
    std::string_view verb = program_.verb;
    const bool is_live = program_.name == "tshark" && !places_.empty() && names_bus(places_[0]);
    // Without a file, the logger prints.
    const bool is_printed = program_.name == "logger" && !has('f');
    if (is_live || is_printed) verb = "monitor";
    Words words = {std::string(verb)};
    words.insert(words.end(), places_.begin(), places_.end());
    words.insert(words.end(), said_.begin(), said_.end());
    if (!program_.added.empty()) words.emplace_back(program_.added);
    return words;
  }
  bool has(char letter) const { return letters_.find(letter) != std::string::npos; }
  const Words& places() const { return places_; }

 private:
  void take(const std::string& word) {
    // An option of ours: the rest is of the verb.
    is_of_verb_ = is_of_verb_ || word.starts_with("--");
    const bool is_joined = word.size() > 1 && word.front() == '-';
    if (is_of_verb_ || !is_joined) return (is_of_verb_ ? said_ : places_).push_back(word);
    for (std::size_t i = 1; i < word.size(); ++i) {
      const auto option = std::ranges::find(program_.options, word[i], &ProgramOption::letter);
      if (option == program_.options.end()) {
        said_.push_back("-" + word.substr(i));
        return;
      }
      letters_ += word[i];
      if (!option->has_value) {
        add(option->meant, "");
        continue;
      }
      const bool is_behind = i + 1 == word.size();
      if (is_behind && at_ == rest_.size()) return;
      return add(option->meant, is_behind ? rest_[at_++] : word.substr(i + 1));
    }
  }

  void add(std::string_view meant, const std::string& value) {
    if (meant.empty()) return;
    if (meant == ".") {
      // Input stands before what it is written into, or sent to.
      places_.insert(letters_.back() == 'O' ? places_.end() : places_.begin(), value);
      return;
    }
    const std::size_t sign = meant.find('=');
    said_.emplace_back(meant.substr(0, sign));
    if (sign != std::string_view::npos) said_.emplace_back(meant.substr(sign + 1));
    const bool is_endless = meant == "--loop" && value == "i";
    if (!value.empty() && meant != "--json" && !is_endless) said_.push_back(value);
  }

  const OtherProgram& program_;
  Words rest_;
  std::size_t at_ = 0;
  Words places_;
  Words said_;
  std::string letters_;
  bool is_of_verb_ = false;
};

/// `candump -l` names the file by the time.
std::string candump_file() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  return fmt::format("candump-{:%Y-%m-%d_%H%M%S}.log", parts);
}

/// `can0@125000` as the bus and its bit rate.
void part_bit_rate(Words& words) {
  const std::size_t sign = words.size() > 1 ? words[1].find('@') : std::string::npos;
  if (sign == std::string::npos) return;
  constexpr std::size_t thousands = 3;
  std::string rate = words[1].substr(sign + 1);
  rate.resize(std::min(rate.size(), rate.find(',')));
  words[1].resize(sign);
  if (!rate.ends_with("000")) return;
  words.insert(words.end(), {"--bit-rate", rate.substr(0, rate.size() - thousands)});
}

constexpr auto drivers = std::to_array<std::string_view>(
    {"socketcan", "pcan", "kvaser", "vector", "ixxat", "slcan", "virtual", "gs_usb", "usb2can",
     "systec", "neovi", "nican", "serial", "socketcand", "udp_multicast", "canalystii", "cantact",
     "etas", "seeedstudio"});
bool is_driver(std::string_view word) {
  return std::ranges::find(drivers, word) != drivers.end();
}

}  // namespace

void use_program(Words& words) {
  const std::string name = words.front();
  if (name == "cangen") {
    throw UsageError("frames are sent by canvoy send can0 123#1122 --every 10ms");
  }
  const auto* const program = std::ranges::find(other_programs, name, &OtherProgram::name);
  if (program == other_programs.end()) return;
  const ProgramLine line(*program, {words.begin() + 1, words.end()});
  const std::string bus = line.places().empty() ? "can0" : line.places().front();
  if (line.has('L')) {
    throw UsageError(
        fmt::format("lines of a candump log are written by canvoy record {} heard.log", bus));
  }
  words = line.meant();
  if (name == "candump" && line.has('l')) words = {"record", bus, candump_file()};
  if (name == "canbusload") part_bit_rate(words);
}

void use_python_can_options(Words& words) {
  if (!take_option(words, {"-i", "--interface", "--bustype"}, is_driver)) return;
  const auto channel = take_option(words, {"-c", "--channel"});
  take_option(words, {"-b", "--bitrate"});  // of an interface of this machine: that of ip link
  if (channel) words.insert(words.begin() + 1, *channel);
}

}  // namespace canvoy::tools
