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

/// The words of a device on a bus of its own, for an instant.
std::vector<std::string> tried(const std::vector<std::string>& device,
                               const std::vector<std::string>& further = {}) {
  std::vector<std::string> words;
  const auto option =
      std::ranges::find_if(device, [](const std::string& word) { return word.starts_with("--"); });
  words.assign(device.begin(), option);
  words.emplace_back("sim");
  words.insert(words.end(), option, device.end());
  words.insert(words.end(), {"--for", "1ms"});
  words.insert(words.end(), further.begin(), further.end());
  return words;
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

std::function<void()> ScriptDevices::parse(const std::vector<std::string>& words,
                                           const std::string& bus) {
  if (words.front() != "device") return parse_hand(words);
  std::vector<std::string> of_device(words.begin() + 1, words.end());
  if (of_device.empty()) throw UsageError("device is required: one of `canvoy device --list`");
  const std::string wrong = complaint_about(tried(of_device));
  if (!wrong.empty()) throw UsageError(wrong);
  Device& device = devices_.emplace_back(Device{.words = std::move(of_device), .bus = bus});
  return [&device] { start(device); };
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
    const std::string wrong = complaint_about(
        tried(device.words, {"--" + words.front(), has_time ? order : order + "@0s"}));
    if (wrong.empty()) return [&device, order] { send(device, order); };
    if (!complaint) complaint = wrong;
  }
  throw UsageError(*complaint);
}

void ScriptDevices::start(Device& device) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw Failure("there are too many open files");
  std::vector<std::string> words = device.words;
  const auto option =
      std::ranges::find_if(words, [](const std::string& word) { return word.starts_with("--"); });
  words.insert(option, device.bus);
  words.emplace_back("--stdin");
  device.process = start_device(words, {.input = pipe[0]});
  ::close(pipe[0]);
  device.orders = pipe[1];
}

void ScriptDevices::send(Device& device, const std::string& order) {
  const std::string line = order + "\n";
  const bool is_running = device.process != 0 && ::waitpid(device.process, nullptr, WNOHANG) == 0;
  if (!is_running) device.process = 0;
  const auto size = static_cast<ssize_t>(line.size());
  if (is_running && ::write(device.orders, line.data(), line.size()) == size) return;
  throw Failure(fmt::format("{} has ended, or its line has failed", device.words.front()));
}

}  // namespace canvoy::tools
