// The canvoy command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <system_error>
#include <vector>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {
namespace {

/// CLI11 explains some errors over several lines; the first says what is wrong.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// The command as far as it was understood: `canvoy run charger`.
std::string understood(const CLI::App& app) {
  std::string text = app.get_name();
  for (const CLI::App* sub = &app; !sub->get_subcommands().empty();) {
    sub = sub->get_subcommands().front();
    text += ' ' + sub->get_name();
  }
  return text;
}

/// CLI11 asks for what is missing before it looks at what is too much, which is mostly the same
/// thing misspelt.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining(true);
  const int code = error.get_exit_code();
  const bool is_unknown =
      !unknown.empty() && (code == static_cast<int>(CLI::ExitCodes::RequiredError) ||
                           code == static_cast<int>(CLI::ExitCodes::ExtrasError));
  fmt::print(stderr, "canvoy: {}; see {} --help\n",
             is_unknown ? fmt::format("'{}' is not known here", first_line(unknown.front()))
                        : first_line(error.what()),
             understood(app));
  return exit_usage;
}

constexpr const char* output_lost = "the output could not be written: is there room on the disk?";

/// What was printed may still be on its way, to a disk that is full.
int finish_output(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  throw Failure(output_lost);
}

int run(int count, char** arguments) {
  CLI::App app("Canvoy: see, simulate, test and drive CANopen networks", "canvoy");
  app.set_version_flag("--version", "canvoy 0.1.0");
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  Action action;
  add_run(app, action);
  add_device(app, action);
  add_monitor(app, action);
  add_view(app, action);
  add_decode(app, action);
  add_convert_log(app, action);
  add_read(app, action);
  add_write(app, action);
  add_configure(app, action);
  add_nmt(app, action);
  add_program(app, action);
  add_boot(app, action);
  add_gateway(app, action);
  add_lss(app, action);
  add_profile(app, action);
  add_eds(app, action);
  try {
    app.parse(count, arguments);
    return finish_output(action());
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : refuse(app, error);
  } catch (const Failure& failure) {
    // It may quote what stands in a file.
    fmt::print(stderr, "canvoy: {}\n", formats::plain_text(failure.what()));
    return failure.status();
  } catch (const std::system_error&) {
    // What {fmt} throws where it cannot print.
    fmt::print(stderr, "canvoy: {}\n", output_lost);
    return exit_failed;
  }
}

}  // namespace
}  // namespace canvoy::tools

int main(int count, char** arguments) {
  return canvoy::tools::run(count, arguments);
}
