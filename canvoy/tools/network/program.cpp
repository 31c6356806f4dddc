// canvoy program BUS NODE FILE: a new program for a node (CiA 302-3).
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "canvoy/canopen/manager/program_download.hpp"
#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/network/program_text.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

namespace {

struct ProgramOptions {
  std::string bus;
  std::string node;
  std::string file;
  unsigned slot = 1;
  std::string time_out = {};
  bool segmented = false;
  bool check_crc = false;
  bool no_start = false;
  bool json = false;
};

constexpr std::uintmax_t size_max = 256U << 20U;

/// Reads the file piece by piece.
class ProgramFile {
 public:
  explicit ProgramFile(const std::string& path) : path_(path), stream_(path, std::ios::binary) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error || !stream_) {
      throw Failure(fmt::format("{}: it cannot be read; give the file of a program", path));
    }
    if (size == 0) throw Failure(fmt::format("{}: it is empty, and so no program", path));
    if (size > size_max) throw Failure(fmt::format("{}: it is longer than 256 MiB", path));
    size_ = static_cast<std::uint32_t>(size);
  }

  std::uint32_t size() const { return size_; }
  std::uint32_t crc() {
    Crc32 crc;
    std::array<std::uint8_t, 4096> piece;
    for (auto read = next(piece); read && *read > 0; read = next(piece)) {
      crc.add(std::span(piece).first(*read));
    }
    stream_.clear();
    stream_.seekg(0);
    return crc.value();
  }
  Result<std::size_t> next(std::span<std::uint8_t> bytes) {
    stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (stream_.bad()) return AbortCode::general;
    return static_cast<std::size_t>(stream_.gcount());
  }
  /// Time of the file, in the form of 1F52h: days since 1 January 1984, and ms since midnight.
  std::array<std::uint32_t, 2> date() const {
    using namespace std::chrono;
    const auto written = file_clock::to_sys(std::filesystem::last_write_time(path_));
    const auto day = floor<days>(written);
    constexpr sys_days epoch = 1984y / January / 1;
    return {static_cast<std::uint32_t>(std::max<days::rep>((day - epoch).count(), 0)),
            static_cast<std::uint32_t>(duration_cast<milliseconds>(written - day).count())};
  }

 private:
  std::string path_;
  std::ifstream stream_;
  std::uint32_t size_ = 0;
};

/// One line that is overwritten repeatedly; nothing without a terminal.
class Progress {
 public:
  void show(const ProgramDownload& download, std::uint32_t size) {
    if (!terminal_) return;
    const std::size_t sent = download.transferred();
    fmt::print(stderr, "\r{:3} %  {} of {} bytes", sent * 100 / size, sent, size);
    shown_ = true;
  }
  ~Progress() {
    if (shown_) fmt::print(stderr, "\n");
  }

 private:
  bool terminal_ = ::isatty(STDERR_FILENO) != 0;
  bool shown_ = false;
};

struct Ending {
  ProgramOutcome outcome{.step = ProgramStep::stop};
  void take(const ProgramOutcome& ended) { outcome = ended; }
};

ProgramOutcome run_download(const ProgramOptions& options, NodeId node, ProgramFile& file) {
  Session session(options.bus);
  SdoClient client(session.node());
  std::array<std::uint8_t, SdoBlockClient::buffer_size> buffer;
  SdoBlockClient blocks(client, buffer);
  if (options.segmented) client.choose(SdoTransfer::segmented);
  ProgramDownload download(session.node(), client,
                           {.answer_time_out = parse_answer_time(options.time_out).usual});
  ProgramPlan plan{.server = node,
                   .number = static_cast<std::uint8_t>(options.slot),
                   .supply = SdoClient::Supply::to<&ProgramFile::next>(file),
                   .size = file.size(),
                   .date = file.date(),
                   .start = !options.no_start};
  if (options.check_crc) plan.identification = file.crc();
  Ending ending;
  Progress progress;
  session.node().advance(session.loop().now());
  const AbortCode started = download.begin(plan, ProgramDownload::Done::to<&Ending::take>(ending));
  if (started != AbortCode::none) throw Failure(text::abort_text(started));
  while (download.busy()) {
    session.loop().run_until(session.loop().now() + Duration(100ms));
    progress.show(download, file.size());
    if (session.loop().signal() == 0) continue;
    const bool has_begun = download.step() >= ProgramStep::clear;
    download.cancel();
    session.loop().run_until(session.loop().now() + Duration(50ms));
    throw Failure(has_begun ? "interrupted: the node has no valid program now" : "interrupted");
  }
  return ending.outcome;
}

int download_program(const ProgramOptions& options) {
  const NodeId node = parse_node_id(options.node);
  ProgramFile file(options.file);
  const ProgramOutcome outcome = run_download(options, node, file);
  if (!outcome) {
    throw Failure(fmt::format("{}, program {}: {}", text::node_text(node), options.slot,
                              program_failure_text(outcome)));
  }
  const std::string text = fmt::format("{} bytes are program {}{}", file.size(), options.slot,
                                       options.no_start ? "" : ", and it was started");
  if (!options.json) {
    fmt::print("{}: {}\n", text::node_text(node), text);
    return exit_done;
  }
  JsonEvent event("programmed");
  event->key("node").number(node);
  event->key("program").number(options.slot);
  event->key("bytes").number(file.size());
  event->key("started").truth(!options.no_start);
  event->key("text").text(text);
  event.print();
  return exit_done;
}

}  // namespace

void add_program(Verb& app) {
  const auto options = std::make_shared<ProgramOptions>();
  Verb& command =
      app.add_verb("program", "Download a program into a node, and start it (CiA 302-3)");
  command.add({
      {"bus", options->bus, bus_text, required},
      {"node", options->node, "10, 0x0A, 0Ah, or its name in the file of --network", required},
      {"file", options->file, "the program, in the form that the node wants", required},
      {"--slot", options->slot, "number of the program: sub-index (default 1)", between(1U, 254U)},
      {"--timeout", options->time_out, answer_time_text, answer_time_rules},
      {"--segmented", options->segmented, "without block transfer"},
      {"--check-crc", options->check_crc, "1F56h has to be the CRC-32 of the file afterwards"},
      {"--no-start", options->no_start, "leave the program stopped"},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy program can0 10 pump.bin --check-crc\n"
      "  canvoy program can0 10 pump.bin --slot 2 --no-start --timeout 5s");
  command.runs([options] { return download_program(*options); });
}

}  // namespace canvoy::tools
