#include "canvoy/tools/node/script_devices.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

/// Standard streams of a process; -1: nothing.
struct Streams {
  int input = -1;
  int errors = -1;  ///< -1: those of this process
};

void redirect(int from, int to, int how) {
  const int file = from >= 0 ? from : ::open("/dev/null", how);
  ::dup2(file, to);
}

/// `canvoy device` with these words, which ends with this process. Throws Failure if it cannot be
/// started.
pid_t start_device(std::vector<std::string> words, const Streams& streams) {
  words.insert(words.begin(), {"canvoy", "device"});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t process = ::fork();
  if (process < 0) throw Failure("a device of the script cannot be started");
  if (process != 0) return process;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  redirect(streams.input, STDIN_FILENO, O_RDONLY);
  redirect(-1, STDOUT_FILENO, O_WRONLY);
  if (streams.errors >= 0) ::dup2(streams.errors, STDERR_FILENO);
  ::execv("/proc/self/exe", arguments.data());
  ::_exit(exit_failed);
}

std::string first_line_of(int file) {
  std::string text;
  std::array<char, 1024> bytes;
  for (ssize_t size = 0; (size = ::read(file, bytes.data(), bytes.size())) > 0;) {
    text.append(bytes.data(), static_cast<std::size_t>(size));
  }
  text = text.substr(0, text.find('\n'));
  constexpr std::string_view own_name = "canvoy: ";
  return text.starts_with(own_name) ? text.substr(own_name.size()) : text;
}

/// What `canvoy device` says against these words; empty: nothing.
std::string complaint_about(const std::vector<std::string>& words) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw Failure("there are too many open files");
  const pid_t process = start_device(words, {.errors = pipe[1]});
  ::close(pipe[1]);
  const std::string said = first_line_of(pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  ::waitpid(process, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return said.empty() ? "canvoy device does not take it" : said;
}

/// With one of these options, `canvoy device` tells something, and plays nothing.
constexpr auto telling_options =
    std::to_array<std::string_view>({"--help", "-h", "--list", "--hands"});

bool is_boot_up(const Frame& frame) {
  return frame.is_plain() && frame.id > can_id::error_control &&
         frame.id <= can_id::error_control + node_id_max && frame.length == 1 && frame.data[0] == 0;
}

/// What a slave without a node-ID answers to identify_unconfigured (CiA 305).
bool is_unconfigured(const Frame& frame) {
  return frame.is_plain() && frame.id == can_id::lss_response && frame.length == lss::length &&
         frame.data[0] == static_cast<std::uint8_t>(lss::Command::unconfigured);
}

}  // namespace

ScriptDevices::~ScriptDevices() {
  for (const Device& device : devices_) {
    if (device.orders >= 0) ::close(device.orders);
    if (device.process == 0) continue;
    ::kill(device.process, SIGTERM);
    ::waitpid(device.process, nullptr, 0);
  }
}

std::vector<std::string> ScriptDevices::Device::words(
    const std::string& on_bus, std::initializer_list<std::string> further) const {
  std::vector<std::string> made = kinds;
  made.push_back(on_bus);
  made.insert(made.end(), options.begin(), options.end());
  made.insert(made.end(), further);
  return made;
}

std::function<void()> ScriptDevices::parse(const std::vector<std::string>& words,
                                           const std::string& bus, OpensSession session) {
  if (words.front() != "device") return parse_hand(words);
  const auto option =
      std::ranges::find_if(words, [](const std::string& word) { return word.starts_with('-'); });
  Device device{.kinds = {words.begin() + 1, option}, .options = {option, words.end()}, .bus = bus};
  if (device.kinds.empty()) throw UsageError("device is required: one of `canvoy device --list`");
  const auto telling = std::ranges::find_first_of(device.options, telling_options);
  if (telling != device.options.end()) {
    throw UsageError(fmt::format("a line has no {}: it plays a device", *telling));
  }
  const std::string wrong = complaint_about(device.words("sim", {"--for", "1ms"}));
  if (!wrong.empty()) throw UsageError(wrong);
  Device& played = devices_.emplace_back(std::move(device));
  return [&played, session = std::move(session)] { start(played, session()); };
}

/// The first device that has the hand, as with several devices of `canvoy device`.
std::function<void()> ScriptDevices::parse_hand(const std::vector<std::string>& words) {
  if (words.size() != 2) {
    throw UsageError(fmt::format("write {}", words.front() == "set" ? "set NAME=VALUE, or set "
                                                                      "NAME=VALUE@TIME"
                                                                    : "press NAME, or press "
                                                                      "NAME@TIME"));
  }
  if (devices_.empty()) throw UsageError("there is no device before this line: device battery");
  const std::string& order = words[1];
  const bool has_time = order.find('@') != std::string::npos;
  std::optional<std::string> complaint;
  for (Device& device : devices_) {
    const std::string wrong = complaint_about(device.words(
        "sim", {"--for", "1ms", "--" + words.front(), has_time ? order : order + "@0s"}));
    if (wrong.empty()) return [&device, order] { send(device, order); };
    if (!complaint) complaint = wrong;
  }
  throw UsageError(*complaint);
}

void ScriptDevices::start(Device& device) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw Failure("there are too many open files");
  device.process = start_device(device.words(device.bus, {"--stdin"}), {.input = pipe[0]});
  ::close(pipe[0]);
  device.orders = pipe[1];
}

void ScriptDevices::start(Device& device, Session& session) {
  constexpr Duration there_within = 5s;
  constexpr Duration asked_each = 50ms;
  const auto waits = std::ranges::count_if(device.options, [](const std::string& word) {
    return word == "lss" || word == "--node-id=lss";
  });
  auto boots = std::ssize(device.kinds) - waits;
  bool is_identified = waits == 0;
  session.hear([&](const host::BusFrame& heard) {
    if (is_boot_up(heard.frame)) --boots;
    is_identified = is_identified || is_unconfigured(heard.frame);
    if (boots <= 0 && is_identified) session.loop().stop();
  });
  start(device);
  const Time end = session.loop().now() + there_within;
  while ((boots > 0 || !is_identified) && session.loop().now() < end) {
    const Time now = session.loop().now();
    if (!is_identified) {
      session.send(lss::frame(can_id::lss_request, lss::Command::identify_unconfigured));
    }
    session.run_for(is_identified ? end - now : asked_each);
  }
  session.hear({});
}

void ScriptDevices::send(Device& device, const std::string& order) {
  const std::string line = order + "\n";
  const bool is_running = device.process != 0 && ::waitpid(device.process, nullptr, WNOHANG) == 0;
  if (!is_running) device.process = 0;
  const auto size = static_cast<ssize_t>(line.size());
  if (is_running && ::write(device.orders, line.data(), line.size()) == size) return;
  throw Failure(fmt::format("{} has ended, or its line has failed", device.kinds.front()));
}

}  // namespace canvoy::tools
