// The canvoy command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {
namespace {

/// CLI11 explains some errors over several lines; the first says what is wrong.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
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
  add_read(app, action);
  add_write(app, action);
  add_nmt(app, action);
  try {
    app.parse(count, arguments);
    return action();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    fmt::print(stderr, "canvoy: {}; see canvoy --help\n", first_line(error.what()));
    return exit_usage;
  } catch (const Failure& failure) {
    fmt::print(stderr, "canvoy: {}\n", failure.what());
    return failure.status();
  }
}

}  // namespace
}  // namespace canvoy::tools

int main(int count, char** arguments) {
  return canvoy::tools::run(count, arguments);
}
