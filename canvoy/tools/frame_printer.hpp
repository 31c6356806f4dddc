// Frames with what they mean, a line each: as candump writes them, or as JSON. What `canvoy
// monitor` and `canvoy decode` have in common.
//
//     FramePrinter printer(options);
//     printer.append(lines, time, "can0", frame);
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/formats/chosen_profile.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/frame_decoder.hpp"

namespace canvoy::tools {

/// As given on the command line.
struct FramePrinterOptions {
  std::vector<std::string> nodes = {};     ///< `5=419`
  std::string profile = {};                ///< `447-3`: of all nodes
  std::vector<std::string> readings = {};  ///< `852=wide-displays`
  std::vector<std::string> sheets = {};    ///< `5=FILE`, or `FILE`
  std::vector<std::string> filters = {};   ///< `node=5`, `service=SDO`, `object=temperature`
  bool transfers = false;                  ///< one line for each SDO transfer
  bool json = false;

  void add_to(CLI::App& command);
};

class FramePrinter {
 public:
  /// Throws UsageError where an option makes no sense.
  explicit FramePrinter(const FramePrinterOptions& options);

  /// `time` counts from 1970. Whether a line was added: no filter may have wanted it.
  bool append(std::string& lines, Duration time, std::string_view bus, const Frame& frame);
  /// What would be printed behind the frame; nothing where no filter wants it.
  std::optional<std::string> describe(const Frame& frame);

 private:
  struct Filter {
    enum class By : std::uint8_t { node, service, object };
    By by = By::node;
    std::string text;  ///< in lower case
    NodeId node = 0;
  };

  void add_reading(const std::string& text);
  const Profile& reading_of(const Profile& profile);
  void add_node(const std::string& text);
  void add_sheet(const std::string& text);
  void add_filter(const std::string& text);
  std::string_view text_of(const FrameWords& words);
  bool is_wanted(const FrameWords& words) const;
  static bool passes(const Filter& filter, const FrameWords& words);

  std::deque<formats::ChosenProfile> chosen_;
  std::deque<decoder::SheetProfile> sheets_;
  FrameDecoder decoder_;
  std::vector<Filter> filters_;
  bool transfers_;
  bool json_;
};

}  // namespace canvoy::tools
