#include "canvoy/tools/page/log_search.hpp"

#include <algorithm>

namespace canvoy::tools {

namespace {

/// True for CAN-IDs that only SDO parameters or a car make an SDO channel: may_teach() does not
/// consider these.
bool is_further_sdo(const decoder::Network& network, std::uint32_t can_id) {
  const std::uint32_t function = can_id & ~std::uint32_t{node_id_max};
  const bool is_default = function == can_id::sdo_request || function == can_id::sdo_response;
  return !is_default && network.sdo(can_id).has_value();
}

}  // namespace

void LogSearch::learn() {
  const Keys& all = store_.index().all_keys();
  has_channels_ = false;
  for (std::size_t key = 0; key < buses_.size() * FrameIndex::can_ids; ++key) {
    if (!all[key]) continue;
    const std::string& bus = buses_[FrameIndex::bus(static_cast<FrameIndex::Key>(key))];
    const std::uint32_t id = FrameIndex::can_id(static_cast<FrameIndex::Key>(key));
    const bool teaches = is_further_sdo(printer_.network(bus), id);
    has_channels_ = has_channels_ || teaches;
    wanted_[key] = teaches || printer_.may_pass(bus, Frame::data_frame(id, {}));
  }
  may_know_more_ = false;
}

bool LogSearch::may_pass(std::uint32_t buses, FrameFlags kind) {
  Frame frame;
  frame.flags = kind;
  for (std::size_t bus = 0; bus < buses_.size(); ++bus) {
    if ((buses >> bus & 1U) != 0 && printer_.may_pass(buses_[bus], frame)) return true;
  }
  return false;
}

bool LogSearch::is_needed(std::size_t block) {
  const FrameIndex& index = store_.index();
  if (block == 0 || index.teaches(block)) {
    may_know_more_ = true;
    return true;
  }
  if (may_know_more_) learn();
  const bool has_wanted =
      !index.is_kept(block) ||
      std::ranges::any_of(index.keys(block), [this](FrameIndex::Key key) { return wanted_[key]; });
  const auto [from, to] = store_.times(block);
  const bool is_in_time = printer_.may_pass(from - Time{}, to - Time{});
  may_know_more_ = has_wanted && has_channels_;
  if (may_know_more_) return true;
  return is_in_time && (has_wanted || may_pass(index.extended(block), FrameFlags::extended) ||
                        may_pass(index.errors(block), FrameFlags::error));
}

}  // namespace canvoy::tools
