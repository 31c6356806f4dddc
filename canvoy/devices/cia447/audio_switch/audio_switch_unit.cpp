#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* audio_commands[] = {&audio_switch_command_object,
                                                &audio_switch_status_request_object};

}  // namespace

constexpr AccessHandlers AudioSwitchUnit::hook_calls[] = {
    after_write<&AudioSwitchUnit::command_written, audio_switch_command_object>,
    after_write<&AudioSwitchUnit::request_written, audio_switch_status_request_object>,
    before_read<&AudioSwitchUnit::answer_request, audio_switch_status_response_object>};
constexpr ServiceHandlers AudioSwitchUnit::service_calls = {
    .reset = method<&AudioSwitchUnit::reset>, .hooks = hook_calls};

AudioSwitchUnit::AudioSwitchUnit(CarNetwork& network, const AudioSwitchHardware& hardware,
                                 const SwitchedSettings& settings)
    : network_(network),
      hardware_(hardware),
      commands_(network, audio_commands, {.lacking = settings.lacking}) {
  network.node().attach(service_);
}

/// Connections stay; requests are discarded.
void AudioSwitchUnit::reset(ResetScope) {
  asked_.fill({});
  respond(network_.client());
}

void AudioSwitchUnit::report_failure(bool has_failed) {
  has_failed_ = has_failed;
  respond(network_.client());
}

/// A command applies to a pair of channels: all three parts of it make one (errata Z04).
void AudioSwitchUnit::command_written() {
  const Values audio(network_.node().dictionary());
  const Pair pair{audio[audio_switch_command_input_channel].raw(),
                  audio[audio_switch_command_output_channel].raw()};
  const std::uint8_t gain = audio[audio_switch_command_gain].raw();
  if (!pair.is_whole() || gain > AudioMatrix::gain_max) return;
  matrix_.connect(pair.input, pair.output, gain, [&](unsigned from, unsigned to) {
    if (hardware_.connect) hardware_.connect(from, to, gain);
  });
}

void AudioSwitchUnit::request_written() {
  const Values audio(network_.node().dictionary());
  const Pair pair{audio[audio_switch_status_request_input_channel].raw(),
                  audio[audio_switch_status_request_output_channel].raw()};
  if (pair.is_whole()) asked_[network_.client()] = pair;
}

void AudioSwitchUnit::answer_request() {
  respond(network_.client());
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
