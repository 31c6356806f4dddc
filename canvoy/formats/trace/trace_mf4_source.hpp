// The frames of one data group of an MDF 4 file, in the order of the file.
//
//     Mf4Source source(file, group, start, kept);
//     Mf4Frame frame;
//     while (source.next(frame).item == TraceItem::frame) use(frame);
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/trace/trace_mf4_group.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

/// What holds for a file as a whole.
struct Mf4Start {
  Duration time{};          ///< since 1970, to which all others are added
  bool is_finished = true;  ///< counts and lengths are those of the file
  bool has_socketcan_errors =
      false;  ///< error frames are told as SocketCAN does: python-can's, ours
};

/// `frame.channel` is not set; `bus` counts from 0.
struct Mf4Frame {
  TraceFrame frame;                 ///< without its channel
  std::int64_t bus = 0;             ///< as the file numbers it
  TraceItem item = TraceItem::end;  ///< frame or fd
};

/// Its blocks are those of a data group: any number of channel groups.
class Mf4Source {
 public:
  /// `file` has to outlive it. `block` is that of the data group.
  Mf4Source(Mf4File& file, const Mf4Block& block, const Mf4Start& start);

  /// Whether any of its groups is one of CAN frames.
  bool has_frames() const;
  /// Of channels, whatever they hold.
  std::size_t groups() const { return groups_.size(); }
  /// A frame, one of CAN FD, what is bad, or the end.
  TraceStep next(Mf4Frame& frame);
  /// The place in the file.
  std::uint64_t position() const { return data_.position(); }

 private:
  /// Bytes of frames that stand in a row of their own, as they come by.
  struct Lengths {
    std::uint64_t group = 0;                                        ///< its block
    std::uint64_t end = 0;                                          ///< where the next begins
    std::deque<std::pair<std::uint64_t, std::string>> latest = {};  ///< place and bytes
  };
  /// The same as a block of data.
  struct Apart {
    std::uint64_t group = 0;  ///< whose frames they are of: its block
    std::uint64_t done = 0;   ///< where the next begins
    Mf4Data data;             ///< from there on
  };
  /// A frame whose bytes are still to come.
  struct Waiting {
    Mf4Frame frame;            ///< all but its bytes
    std::uint8_t length = 0;   ///< of its bytes, as the record says
    std::uint64_t group = 0;   ///< 0: they are there
    std::uint64_t offset = 0;  ///< where they stand in the group
  };

  TraceStep read_record();
  TraceStep end_of_data(bool is_within);
  Mf4Group* group_of(std::uint64_t id);
  TraceStep read_lengths(const Mf4Group& group);
  TraceStep read_head(const Mf4Group& group, std::string_view record);
  TraceStep read_frame(const Mf4Group& group, std::string_view record);
  TraceStep read_bytes(const Mf4Group& group, std::string_view record);
  TraceStep read_error(const Mf4Group& group, std::string_view record);
  bool read_apart(const Mf4Group& group, Waiting& made);
  bool find_bytes(Waiting& made);
  static void set_bytes(Waiting& made, std::string_view bytes);

  static constexpr std::size_t latest_max = 256;

  Mf4Start start_;
  unsigned id_size_;
  std::vector<Mf4Group> groups_;
  Mf4Data data_;
  std::vector<Lengths> lengths_;
  std::vector<std::unique_ptr<Apart>> apart_;
  Waiting made_;  ///< the frame that was read last
  std::deque<Waiting> waiting_;
  std::uint64_t frames_ = 0;
  bool is_over_ = false;
};

}  // namespace canvoy::formats
