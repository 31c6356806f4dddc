#include "canvoy/tools/device/catalogue/bootloader.hpp"

namespace canvoy::tools {

Bootloader::Bootloader(const Port& port, NodeId id, const std::string& store, ProgramStore::Say say)
    : store_(store, std::move(say)),
      device_(port, id),
      programs_(device_.node(), store_.flash(), slots_, store_.hooks()) {
  store_.on_under_way([this](bool is) { indicators_.program_under_way(is); });
  store_.say_what_is_there(slots_[0]);
}

}  // namespace canvoy::tools
