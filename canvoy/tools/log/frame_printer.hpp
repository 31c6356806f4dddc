// Frames with what they mean, a line each: as candump writes them, or as JSON. What `canvoy
// monitor` and `canvoy decode` have in common. What was heard on a bus is known of that bus only.
//
//     FramePrinter printer(options);
//     printer.append(lines, time, "can0", frame);
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/decoder/bus_table.hpp"
#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/formats/sheet/chosen_profile.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/filter/filter.hpp"
#include "canvoy/words/frame_decoder.hpp"
#include "canvoy/words/frame_json.hpp"

namespace canvoy::tools {

/// As given on the command line.
struct FramePrinterOptions {
  std::vector<std::string> nodes = {};     ///< `5=419`, or `can1:5=419`
  std::vector<std::string> profiles = {};  ///< of all nodes: `447-3`, or `can1=447-3`
  std::vector<std::string> readings = {};  ///< `852=wide-displays`
  std::vector<std::string> sheets = {};    ///< `5=FILE`, `can1:5=FILE`, or `FILE`
  /// `node=5 and temperature>40degC`; all of them have to hold
  std::vector<std::string> filters = {};
  bool transfers = false;  ///< one line for each SDO transfer
  bool json = false;
  bool csv = false;  ///< a row for each value in place of a line for each frame

  void add_to(Verb& command);
  /// Only what says of nodes what they are, or which frames are wanted: for who prints no lines.
  void add_nodes_to(Verb& command);
  void add_filter_to(Verb& command);
};

class FramePrinter {
 public:
  /// Throws UsageError where an option makes no sense.
  explicit FramePrinter(const FramePrinterOptions& options);

  /// The data sheets of a folder, each for the node that it is of (a DCF), or for those that tell
  /// its identity; at most `sheets_max`. Their names; what is none, or cannot be read, is passed
  /// over.
  static constexpr std::size_t sheets_max = 64;
  std::vector<std::string> use_sheets_of(const std::string& folder);

  /// `time` counts from 1970. Whether a line was added: no filter may have wanted it.
  bool append(std::string& lines, Duration time, std::string_view bus, const Frame& frame);
  /// The same of a frame of CAN FD, which says nothing in CANopen: raw, as candump writes it.
  bool append_fd(std::string& lines, const formats::TraceFrame& heard);
  /// What would be printed behind the frame; nothing where no filter wants it.
  std::optional<std::string> describe(Duration time, std::string_view bus, const Frame& frame);
  /// The same without a line, and whether a filter wants it or not.
  const words::FrameWords& decode(std::string_view bus, const Frame& frame) {
    return decoder_of(bus).decode(frame);
  }
  /// Of a node on a bus, as far as it is known: CiA 301 where nothing is.
  const Profile& profile(std::string_view bus, NodeId node) {
    return decoder_of(bus).network().profile(node);
  }

  /// Tells a decoder of the bus what the options say of it. This has to outlive it.
  void tell_network(std::string_view bus, decoder::Network& network);
  /// What `--eds 5=FILE` says.
  struct SheetOfNode {
    std::string bus = {};  ///< empty: of each
    NodeId node = 0;
    formats::DataSheet sheet;
  };
  const std::deque<SheetOfNode>& sheets_of_nodes() const { return read_; }

  /// What the frame says, until the next one; null where no filter wants it.
  const words::FrameWords* look(Duration time, std::string_view bus, const Frame& frame);
  /// Adds the line of a frame that look() has just returned.
  void append_words(std::string& lines, Duration time, std::string_view bus, const Frame& frame,
                    const words::FrameWords& words);

  /// How often what was known of a bus was forgotten, since there are more than buses_max().
  std::uint64_t forgotten_buses() const { return buses_.forgotten(); }
  std::size_t buses_max() const { return buses_.max(); }
  /// Buses that the options name, and of which no frame has come.
  std::vector<std::string_view> silent_buses() const;
  /// Where no frame has passed the filters: how many there were, and which conditions never held.
  /// Empty where one has passed, or none was heard.
  std::string without_match() const;

 private:
  /// What an option says of one bus.
  struct Given {
    std::string bus = {};
    NodeId node = 0;                              ///< 0: all of which nothing else is known
    const Profile* profile = nullptr;             ///< null: the sheet says it
    const decoder::DeviceSheet* sheet = nullptr;  ///< null: there is none
    bool is_heard = false;                        ///< the bus
  };

  void add_reading(const std::string& text);
  const Profile& reading_of(const Profile& profile);
  void add_profile(const std::string& text);
  void add_node(const std::string& text);
  void add_sheet(const std::string& text);
  bool use_sheet(const std::string& path);
  void add_filters(const std::vector<std::string>& filters);
  void add(const Given& given);
  static void tell(decoder::Network& network, const Given& given);
  struct Bus {
    Bus(std::string_view name, const std::shared_ptr<words::FrameDecoder::Said>& said);

    std::string name;  ///< as a terminal can show it
    words::FrameDecoder decoder;
  };

  Bus& bus_of(std::string_view name);
  words::FrameDecoder& decoder_of(std::string_view bus) { return bus_of(bus).decoder; }
  std::unique_ptr<Bus> make_bus(std::string_view name);
  void append_csv(std::string& lines, Duration time, std::string_view bus,
                  const words::FrameWords& words);
  void append_narrow(std::string& lines, Duration time, const Bus& heard, std::string_view frame,
                     const words::FrameWords& words, std::string_view text);
  std::string_view text_of(words::FrameDecoder& decoder, const words::FrameWords& words) const;
  bool is_wanted(Duration time, std::string_view bus, const Frame& frame,
                 const words::FrameWords& words);

  std::deque<formats::ChosenProfile> chosen_;
  std::deque<decoder::SheetProfile> sheets_;
  std::deque<SheetOfNode> read_;
  decoder::Network any_bus_;  ///< what is known of each bus before anything is heard
  std::vector<Given> given_;  ///< of one bus
  decoder::BusTable<Bus> buses_;
  std::shared_ptr<words::FrameDecoder::Said> said_ = std::make_shared<words::FrameDecoder::Said>();
  Filter filter_;
  std::optional<Duration> first_;  ///< when the first frame came
  bool transfers_;
  bool json_;
  bool csv_;
  bool has_head_ = false;   ///< of CSV
  std::size_t narrow_ = 0;  ///< columns of a terminal that has few; else 0
  std::string first_bus_;
  bool has_buses_ = false;
  words::FrameJson frame_json_;
};

}  // namespace canvoy::tools
