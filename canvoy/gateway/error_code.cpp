#include "canvoy/gateway/error_code.hpp"

#include <array>

namespace canvoy::gateway {

namespace {

struct ErrorText {
  ErrorCode code;
  std::string_view text;
};
constexpr auto error_texts = std::to_array<ErrorText>({
    {ErrorCode::not_supported, "not supported"},
    {ErrorCode::syntax, "syntax"},
    {ErrorCode::internal_state, "the present state forbids it"},
    {ErrorCode::time_out, "time-out"},
    {ErrorCode::no_default_net, "no default network"},
    {ErrorCode::no_default_node, "no default node"},
    {ErrorCode::unknown_net, "no such network"},
    {ErrorCode::unknown_node, "no such node-ID"},
    {ErrorCode::guarding_lost, "no answer to node guarding"},
    {ErrorCode::connection_lost, "connection lost"},
    {ErrorCode::heartbeat_started, "heartbeat began"},
    {ErrorCode::heartbeat_lost, "heartbeat lost"},
    {ErrorCode::wrong_nmt_state, "unexpected NMT state"},
    {ErrorCode::boot_up, "boot-up"},
    {ErrorCode::error_passive, "error passive"},
    {ErrorCode::bus_off, "bus-off"},
    {ErrorCode::buffer_overflow, "frames were lost"},
    {ErrorCode::can_init, "the CAN controller could not be set up"},
    {ErrorCode::can_active, "error active"},
    {ErrorCode::pdo_in_use, "the COB-ID belongs to another PDO"},
    {ErrorCode::pdo_length, "more than the PDO holds"},
    {ErrorCode::lss, "refused by the LSS slave"},
    {ErrorCode::lss_node_id, "node-ID refused"},
    {ErrorCode::lss_bit_rate, "bit rate refused"},
    {ErrorCode::lss_storing, "storing refused"},
    {ErrorCode::lss_media, "storage medium failed"},
    {ErrorCode::out_of_memory, "too much data"},
});

struct BootText {
  BootError code;
  std::string_view text;
};
constexpr auto boot_texts = std::to_array<BootText>({
    {BootError::not_in_list, "no slave"},
    {BootError::no_answer, "no answer"},
    {BootError::device_type, "another device type"},
    {BootError::vendor_id, "another vendor-ID"},
    {BootError::no_heartbeat, "no heartbeat to tell its state"},
    {BootError::no_guarding_answer, "no answer to node guarding"},
    {BootError::no_program_data, "nothing known of its program"},
    {BootError::program_not_allowed, "program update not allowed"},
    {BootError::program_download, "program update failed"},
    {BootError::configuration, "configuration failed"},
    {BootError::no_error_control, "no heartbeat"},
    {BootError::already_operational, "was operational"},
    {BootError::product_code, "another product code"},
    {BootError::revision_number, "another revision"},
    {BootError::serial_number, "another serial number"},
});

template <class Texts, class Code>
std::string_view find(const Texts& texts, Code code) {
  for (const auto& [known, text] : texts) {
    if (known == code) return text;
  }
  return {};
}

}  // namespace

std::string_view text_of(ErrorCode code) {
  return find(error_texts, code);
}

std::string_view text_of(BootError error) {
  return find(boot_texts, error);
}

}  // namespace canvoy::gateway
