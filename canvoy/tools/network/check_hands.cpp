#include "canvoy/tools/network/check_hands.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

using conformance::HandAnswer;
using conformance::HandRequest;

std::map<std::string, std::string, std::less<>> read_commands(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Failure(fmt::format("{}: cannot be read: check the path", path));
  std::map<std::string, std::string, std::less<>> commands;
  std::string text;
  for (unsigned number = 1; std::getline(file, text); ++number) {
    const std::string_view line = formats::trimmed(text);
    if (line.empty() || line.front() == '#') continue;
    const std::size_t equals = line.find('=');
    const std::string request(formats::trimmed(line.substr(0, equals)));
    const std::string command(
        equals == std::string_view::npos ? "" : formats::trimmed(line.substr(equals + 1)));
    if (request.empty() || command.empty()) {
      throw Failure(fmt::format("{}:{}: a line is `request = command`", path, number));
    }
    if (!commands.emplace(request, command).second) {
      throw Failure(
          fmt::format("{}:{}: there is a command for '{}' already", path, number, request));
    }
  }
  if (file.bad()) throw Failure(fmt::format("{}: cannot be read: is it a file?", path));
  return commands;
}

/// Reads standard input byte by byte: what follows the line is for the next question. Nothing at
/// its end.
std::optional<std::string> read_line(const std::function<void()>& wait) {
  constexpr std::size_t line_max = 1000;
  std::string line;
  while (line.size() < line_max) {
    wait();
    char byte = 0;
    if (::read(STDIN_FILENO, &byte, 1) != 1) return std::nullopt;
    if (byte == '\n') return line;
    line += byte;
  }
  return line;
}

HandAnswer run_command(const std::string& command, bool is_question) {
  // A command of the user, from a file that the user has named.
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  if (status == -1 || !WIFEXITED(status)) return HandAnswer::cannot;
  if (WEXITSTATUS(status) == 0) return HandAnswer::done;
  return is_question && WEXITSTATUS(status) == 1 ? HandAnswer::no : HandAnswer::cannot;
}

}  // namespace

CheckHands::CheckHands(const std::string& source, std::function<void()> wait)
    : is_person_(source == "-"), wait_(std::move(wait)) {
  if (!is_person_) commands_ = read_commands(source);
}

HandAnswer CheckHands::ask_person(const HandRequest& request) {
  if (request.is_question) {
    fmt::print("Look whether {}: Enter if so, n if not, ? if nobody can see it: ", request.words);
  } else {
    fmt::print("Please {}, then Enter; ? if nobody can: ", request.words);
  }
  std::fflush(stdout);
  const std::optional<std::string> said = read_line(wait_);
  if (!said) return HandAnswer::cannot;
  const std::string_view line = formats::trimmed(*said);
  if (line.empty() || line == "y") return HandAnswer::done;
  return line == "n" && request.is_question ? HandAnswer::no : HandAnswer::cannot;
}

HandAnswer CheckHands::answer(const HandRequest& request) {
  if (is_person_) return ask_person(request);
  const auto found = commands_.find(request.words);
  if (found == commands_.end()) return HandAnswer::cannot;
  std::fflush(stdout);
  return run_command(found->second, request.is_question);
}

}  // namespace canvoy::tools
