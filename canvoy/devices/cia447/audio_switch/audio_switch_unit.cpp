#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* audio_commands[] = {&audio_switch_command_object,
                                                &audio_switch_status_request_object};

}  // namespace

AudioSwitchUnit::AudioSwitchUnit(CarNetwork& network, const AudioSwitchHardware& hardware,
                                 const SwitchedSettings& settings)
    : network_(network),
      hardware_(hardware),
      commands_(network, audio_commands, {.lacking = settings.lacking}) {
  service_.reset = Callback<void(ResetScope)>::to<&AudioSwitchUnit::reset>(*this);
  network.node().attach(service_);
  auto& [command, request, response] = hooks_;
  command.first = command.last = audio_switch_command_object.index;
  command.after_write =
      Callback<void(const Entry&, Source)>::to<&AudioSwitchUnit::command_written>(*this);
  request.first = request.last = audio_switch_status_request_object.index;
  request.after_write =
      Callback<void(const Entry&, Source)>::to<&AudioSwitchUnit::request_written>(*this);
  response.first = response.last = audio_switch_status_response_object.index;
  response.before_read =
      Callback<AbortCode(const Entry&)>::to<&AudioSwitchUnit::response_read>(*this);
  for (Hook& hook : hooks_) network.node().dictionary().attach(hook);
}

/// What is connected stays so; what was asked for is forgotten.
void AudioSwitchUnit::reset(ResetScope) {
  asked_.fill({});
  respond(network_.client());
}

void AudioSwitchUnit::report_failure(bool has_failed) {
  has_failed_ = has_failed;
  respond(network_.client());
}

/// A command is about a pair of channels: all three parts of it make one (errata Z04).
void AudioSwitchUnit::command_written(const Entry&, Source) {
  const Values audio(network_.node().dictionary());
  const Pair pair{audio[audio_switch_command_input_channel].raw(),
                  audio[audio_switch_command_output_channel].raw()};
  const std::uint8_t gain = audio[audio_switch_command_gain].raw();
  if (!pair.is_whole() || gain > AudioMatrix::gain_max) return;
  matrix_.connect(pair.input, pair.output, gain, [&](unsigned from, unsigned to) {
    if (hardware_.connect) hardware_.connect(from, to, gain);
  });
}

void AudioSwitchUnit::request_written(const Entry&, Source) {
  const Values audio(network_.node().dictionary());
  const Pair pair{audio[audio_switch_status_request_input_channel].raw(),
                  audio[audio_switch_status_request_output_channel].raw()};
  if (pair.is_whole()) asked_[network_.client()] = pair;
}

AbortCode AudioSwitchUnit::response_read(const Entry&) {
  respond(network_.client());
  return AbortCode::none;
}

void AudioSwitchUnit::respond(NodeId client) {
  const auto response = Values(network_.node().dictionary())[audio_switch_status_response];
  const Pair& asked = asked_[client];
  response = std::nullopt;
  if (!asked.is_whole()) return;
  if (has_failed_) {
    response.set_raw(static_cast<std::uint8_t>(
        code_meaning(place_of(audio_switch_status_response), Meaning::failure).value_or(0)));
  } else if (const auto gain = matrix_.gain(asked.input, asked.output)) {
    response.set_raw(*gain);
  }
}

}  // namespace canvoy::cia447
