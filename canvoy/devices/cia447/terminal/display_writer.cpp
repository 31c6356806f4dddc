#include "canvoy/devices/cia447/terminal/display_writer.hpp"

#include <algorithm>

#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/profiles/cia447/terminal.hpp"

namespace canvoy::cia447 {

namespace {

/// The command is in bits 0 and 1; the others are reserved.
constexpr std::uint8_t reserved_bits = 0xFC;

std::span<const std::uint8_t> bytes_of(const char* text, std::size_t length) {
  return {reinterpret_cast<const std::uint8_t*>(text), length};
}

}  // namespace

DisplayWriter::DisplayWriter(CarNetwork& network, const Settings& settings)
    : network_(network),
      settings_(settings),
      client_(network.node(), mesh_channel_to(settings.terminal)),
      timer_(Callback<void(Time)>::to<&DisplayWriter::go_on>(*this)) {
  next_lost_ = network.on_lost(Callback<void(NodeId)>::to<&DisplayWriter::lost>(*this));
  service_.reset = Callback<void(ResetScope)>::to<&DisplayWriter::reset>(*this);
  network.node().attach(service_);
}

void DisplayWriter::reset(ResetScope) {
  begin_anew();
}

void DisplayWriter::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  if (node == settings_.terminal) begin_anew();
}

/// Whoever had the display, has it no longer, and nothing is left on it.
void DisplayWriter::begin_anew() {
  has_display_ = false;
  is_known_ = true;
  shown_ = {};
  network_.node().timers().arm(timer_, network_.node().now() + settings_.repetition);
}

void DisplayWriter::show(std::string_view text) {
  wanted_.length = std::min(text.size(), text_max);
  std::copy_n(text.begin(), wanted_.length, wanted_.bytes.begin());
  if (!is_shown()) network_.node().timers().arm(timer_, network_.node().now());
}

void DisplayWriter::go_on(Time now) {
  if (settings_.terminal == 0) return;
  network_.watch(settings_.terminal);
  if (is_shown() && wanted_.length == 0) return;
  network_.node().timers().arm(timer_, now + settings_.repetition);
  if (step_ != Step::none) return;
  if (wanted_.length == 0) return write_command(false);
  // A terminal that has not heard this device for a while gives the display to others, and forgets
  // its text: nobody tells this device.
  if (!has_display_ || is_shown()) return write_command(true);
  write_text();
}

void DisplayWriter::write_command(bool locks) {
  const bool is_first = settings_.display == TerminalDisplay::display_1;
  const std::uint16_t index =
      is_first ? display_1_command_object.index : display_2_command_object.index;
  const auto command = locks ? AccessCommand::lock : AccessCommand::release;
  command_ = static_cast<std::uint8_t>(reserved_bits | static_cast<unsigned>(command));
  const AbortCode refused = client_.download(settings_.terminal, index, 0, std::span(&command_, 1),
                                             SdoClient::Done::to<&DisplayWriter::written>(*this));
  if (refused == AbortCode::none) step_ = locks ? Step::lock : Step::release;
}

void DisplayWriter::write_text() {
  const bool is_first = settings_.display == TerminalDisplay::display_1;
  const std::uint16_t index = is_first ? display_1_text_object.index : display_2_text_object.index;
  writing_ = wanted_;
  const AbortCode refused = client_.download(settings_.terminal, index, 0,
                                             bytes_of(writing_.bytes.data(), writing_.length),
                                             SdoClient::Done::to<&DisplayWriter::written>(*this));
  if (refused == AbortCode::none) step_ = Step::text;
}

void DisplayWriter::written(SdoClient::Outcome outcome) {
  const Step step = std::exchange(step_, Step::none);
  // Who is refused may have lost the display; the timer goes on. One that is not given back may
  // still be his, unless it is another's.
  if (!outcome) {
    is_known_ = step != Step::release || outcome.abort() == AbortCode::device_state;
    has_display_ = false;
    shown_ = {};
    return;
  }
  has_display_ = step != Step::release;
  is_known_ = step != Step::lock;
  shown_ = step == Step::text ? writing_ : Text{};
  const Time now = network_.node().now();
  network_.node().timers().arm(timer_, is_shown() ? now + settings_.repetition : now);
}

}  // namespace canvoy::cia447
