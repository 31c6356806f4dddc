// ASAM MDF 4 (.mf4) with CAN frames as its bus logging has them: the reader merges the channel
// groups of a file by time; the writer puts all frames into one data group, so that it can be
// written from front to back.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_mf4_encoder.hpp"
#include "canvoy/formats/trace/trace_mf4_source.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

class Mf4Parser final : public TraceFileParser {
 public:
  const TraceFormat& format() const override { return TraceFormat::mf4; }
  host::Result<void> open(TraceFile file, const std::string& name) override;
  TraceStep read(TraceFrame& frame) override;
  std::string where() const override { return "byte " + std::to_string(position_); }
  std::uint64_t position() const override { return progress_; }

 private:
  /// A data group, and its next frame.
  struct Merged {
    std::unique_ptr<Mf4Source> source;
    Mf4Frame head = {};
    bool has_head = false;
    bool is_over = false;
  };

  host::Result<void> find_frames(const std::string& name);
  Merged* earliest(TraceStep& step);

  std::optional<Mf4File> file_;
  Mf4Start start_;
  std::vector<Merged> merged_;
  TraceChannel channel_;
  std::uint64_t position_ = 0;
  std::uint64_t progress_ = 0;
};

host::Result<void> Mf4Parser::open(TraceFile file, const std::string& name) {
  std::array<char, mf4_header_at> head{};
  file.read(0, head);
  const std::string_view text(head.data(), head.size());
  file_.emplace(std::move(file));
  const std::string_view version = text.substr(8, 4);
  if (version[0] != '4') {
    return host::Error{name, "it is an MDF file of version " + plain_text(version),
                       "version 4 is read: save it as .mf4 with the tool that made it"};
  }
  const std::string_view program = text.substr(16, 8);
  start_.is_finished = text.starts_with(mf4_mark);
  start_.has_socketcan_errors = program.starts_with("canvoy") || program.starts_with("amdf");
  return find_frames(name);
}

host::Result<void> Mf4Parser::find_frames(const std::string& name) {
  constexpr std::size_t merged_max = 256;
  const std::optional<Mf4Block> header = file_->block(mf4_header_at, "HD");
  if (!header) return host::Error{name, "the MDF file ends within its header", ""};
  start_.time = Duration{static_cast<std::int64_t>(file_->number(*header, 0, 8) / 1000)};
  std::size_t groups = 0;
  std::uint64_t link = file_->link(*header, 0);
  while (const std::optional<Mf4Block> block = file_->block(link, "DG")) {
    auto source = std::make_unique<Mf4Source>(*file_, *block, start_);
    groups += source->groups();
    if (source->has_frames()) merged_.push_back({std::move(source)});
    if (merged_.size() > merged_max) {
      return host::Error{name, "its frames are in more than 256 data groups",
                         "let the tool that made it write them into few"};
    }
    link = file_->link(*block, 0);
  }
  if (!merged_.empty()) return {};
  return host::Error{name,
                     "the MDF file has no CAN frames (CAN_DataFrame), but " +
                         std::to_string(groups) + " groups of other signals",
                     "record the bus itself, not signals of it"};
}

/// The group whose next frame is the earliest; null where `step` is to be told before, or at the
/// end.
Mf4Parser::Merged* Mf4Parser::earliest(TraceStep& step) {
  Merged* first = nullptr;
  for (Merged& each : merged_) {
    if (!each.has_head && !each.is_over) {
      step = each.source->next(each.head);
      position_ = each.source->position();
      progress_ = std::max(progress_, position_);
      if (step.item == TraceItem::bad) return nullptr;
      each.is_over = step.item == TraceItem::end;
      each.has_head = !each.is_over;
    }
    const bool is_earlier =
        each.has_head && (first == nullptr || each.head.frame.time < first->head.frame.time);
    if (is_earlier) first = &each;
  }
  step = {TraceItem::end, 0, {}};
  return first;
}

TraceStep Mf4Parser::read(TraceFrame& frame) {
  TraceStep step;
  Merged* const first = earliest(step);
  if (first == nullptr) return step;
  frame = first->head.frame;
  frame.channel = channel_.name(first->head.bus + 1);
  first->has_head = false;
  return {first->head.item, 0, {}};
}

std::unique_ptr<TraceParser> recognize_mf4(const TraceHead& head) {
  const bool is_mf4 = head.rest.starts_with(mf4_mark) || head.rest.starts_with(mf4_unfinished_mark);
  if (!head.is_first || !is_mf4 || head.rest.size() < mf4_header_at) return nullptr;
  return std::make_unique<Mf4Parser>();
}

}  // namespace

constinit const TraceFormat TraceFormat::mf4{
    .name = "ASAM MDF 4",
    .endings = ".mf4 .mdf",
    .lacks = trace_lack::bus_names | trace_lack::comments,
    .recognize = recognize_mf4,
    .encoder = make_mf4_encoder,
};

}  // namespace canvoy::formats
