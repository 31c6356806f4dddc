// Prints frames with their meaning, one per line, in the format of candump or as JSON: common part
// of `canvoy monitor` and `canvoy decode`. What is learned on a bus applies to that bus only.
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
#include "canvoy/decoder/unknown_pdos.hpp"
#include "canvoy/formats/sheet/chosen_profile.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/frame_json.hpp"
#include "canvoy/text/unknown_pdos_text.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/filter/filter.hpp"

namespace canvoy::tools {

/// What `--csv` says of itself in help.
inline constexpr const char* csv_text =
    "a row for each value: time, bus, node, index, sub, name, value, unit";

/// Options of the command line.
struct FramePrinterOptions {
  std::vector<std::string> nodes = {};     ///< `5=419`, or `can1:5=419`
  std::vector<std::string> profiles = {};  ///< for all nodes: `447-3`, or `can1=447-3`
  std::vector<std::string> readings = {};  ///< `852=wide-displays`
  std::vector<std::string> sheets = {};    ///< `5=FILE`, `can1:5=FILE`, or `FILE`
  /// `node=5 and temperature>40degC`; all must be true.
  std::vector<std::string> filters = {};
  bool transfers = false;  ///< one line for each SDO transfer
  bool json = false;
  bool csv = false;           ///< a row for each value instead of a line for each frame
  bool takes_filter = false;  ///< a node alone, without a profile, is a filter

  /// Words of a command line that describe nodes: `--profile`, `417-4`.
  std::vector<std::string> node_words() const;
  /// A line that shows this source by these words, to show it again.
  std::string view_line(const std::string& source) const;

  void add_to(Verb& command);
  /// Adds only the options that describe nodes or select frames, for verbs that print no lines.
  void add_nodes_to(Verb& command);
  void add_filter_to(Verb& command);
};

class FramePrinter {
 public:
  /// Throws UsageError if an option is not valid.
  explicit FramePrinter(const FramePrinterOptions& options);

  /// Adds the data sheets of a folder, each for its node (a DCF) or for nodes with its identity; at
  /// most `sheets_max`. Returns their names; ignores other and unreadable files.
  static constexpr std::size_t sheets_max = 64;
  std::vector<std::string> use_sheets_of(const std::string& folder);

  /// Appends a line; false if the filters drop the frame. `time` counts from 1970.
  bool append(std::string& lines, Duration time, std::string_view bus, const Frame& frame);
  /// Like append(), but for a CAN FD frame, which has no meaning in CANopen: raw, as candump writes
  /// it.
  bool append_fd(std::string& lines, const formats::TraceFrame& heard);
  /// The text after the frame; nothing if the filters drop it.
  std::optional<std::string> describe(Duration time, std::string_view bus, const Frame& frame);
  /// Decodes a frame without a line, whether or not the filters drop it.
  const text::FrameWords& decode(std::string_view bus, const Frame& frame) {
    return decode(bus_of(bus), frame);
  }
  /// As lines name the bus: as a terminal can show it.
  std::string_view bus_name(std::string_view bus) { return bus_of(bus).name; }
  /// Of a node on a bus, as far as it is known: CiA 301 where nothing is.
  const Profile& profile(std::string_view bus, NodeId node) {
    return decoder_of(bus).network().profile(node);
  }

  /// Of a bus, as far as it is known.
  const decoder::Network& network(std::string_view bus) { return decoder_of(bus).network(); }
  /// False if no frame like this one, whatever its bytes, passes the filters by what is known of
  /// the bus so far.
  bool may_pass(std::string_view bus, const Frame& frame);
  /// False if no frame between these times passes the filters, after a first frame has been looked
  /// at.
  bool may_pass(Duration from, Duration to) {
    return filter_.may_pass(from, to, first_.value_or(from));
  }

  /// Passes the options to the decoder of a bus. This must outlive it.
  void report_network(std::string_view bus, decoder::Network& network);
  /// A data sheet from `--eds 5=FILE`.
  struct SheetOfNode {
    std::string bus = {};  ///< empty: all buses
    NodeId node = 0;
    formats::DataSheet sheet;
  };
  const std::deque<SheetOfNode>& sheets_of_nodes() const { return read_; }

  /// The meaning of the frame, valid until the next one; null if the filters drop it.
  const text::FrameWords* look(Duration time, std::string_view bus, const Frame& frame);
  /// Adds the line of a frame that look() has just returned.
  void append_words(std::string& lines, Duration time, std::string_view bus, const Frame& frame,
                    const text::FrameWords& words);

  /// Number of times that the state of a bus was dropped, since there are more than buses_max().
  std::uint64_t forgotten_buses() const { return buses_.forgotten(); }
  std::size_t buses_max() const { return buses_.max(); }
  /// Buses named in the options without a frame so far.
  std::vector<std::string_view> silent_buses() const;
  /// Lines on PDOs that were not decoded since no node has told its profile, one for each bus, with
  /// the profile that would explain them, if there is one. With the bus if there are several.
  std::vector<std::string> unknown_pdos(text::UnknownPdosWords words);
  /// If no frame has passed the filters: number of frames, and the conditions that were never true.
  /// Empty if one has passed, or none was heard.
  std::string without_match() const;

 private:
  /// Options for one bus.
  struct Given {
    std::string bus = {};
    NodeId node = 0;                              ///< 0: all nodes without a better source
    const Profile* profile = nullptr;             ///< null: from the sheet
    const decoder::DeviceSheet* sheet = nullptr;  ///< null: none
    bool is_heard = false;                        ///< a frame of the bus was heard
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
    Bus(std::string_view name, const std::shared_ptr<text::FrameDecoder::Said>& said);

    std::string name;  ///< safe for a terminal
    text::FrameDecoder decoder;
    decoder::UnknownPdos unknown;  ///< of the frames that passed the filters
  };

  struct Heard {
    Duration time;
    std::string_view bus;  ///< as in the log
  };

  Bus& bus_of(std::string_view name);
  static const text::FrameWords& decode(Bus& bus, const Frame& frame);
  void append_words(std::string& lines, const Heard& when, Bus& heard, const Frame& frame,
                    const text::FrameWords& words);
  text::FrameDecoder& decoder_of(std::string_view bus) { return bus_of(bus).decoder; }
  std::unique_ptr<Bus> make_bus(std::string_view name);
  void append_csv(std::string& lines, Duration time, std::string_view bus,
                  const text::FrameWords& words);
  void append_narrow(std::string& lines, Duration time, const Bus& heard, std::string_view frame,
                     const text::FrameWords& words, std::string_view text);
  std::string_view text_of(text::FrameDecoder& decoder, const text::FrameWords& words) const;
  bool is_wanted(Duration time, std::string_view bus, const Frame& frame,
                 const text::FrameWords& words);

  std::deque<formats::ChosenProfile> chosen_;
  std::deque<decoder::SheetProfile> sheets_;
  std::deque<SheetOfNode> read_;
  decoder::Network any_bus_;  ///< initial state of each bus
  std::vector<Given> given_;  ///< by bus
  decoder::BusTable<Bus> buses_;
  std::shared_ptr<text::FrameDecoder::Said> said_ = std::make_shared<text::FrameDecoder::Said>();
  Filter filter_;
  std::optional<Duration> first_;  ///< time of the first frame
  bool transfers_;
  bool json_;
  bool csv_;
  bool has_head_ = false;   ///< of CSV
  std::size_t narrow_ = 0;  ///< columns of a narrow terminal; else 0
  std::string first_bus_;
  bool has_buses_ = false;
  text::FrameJson frame_json_;
};

/// Prints what unknown_pdos() tells as messages, behind the name of the source.
void print_unknown_pdos(std::string_view source, FramePrinter& printer,
                        text::UnknownPdosWords words);

}  // namespace canvoy::tools
