// A node that keeps its parameters and takes a program, for a stranger to talk to, on a bus that is
// a pair of pipes (pipe_node.hpp).
//
//     peer PARAMETERS PROGRAM    two files
#include <cstdio>
#include <memory>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/canopen/storage/storage.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace {

using namespace canvoy;

constexpr EntryRow number(DataType type, std::int64_t initial) {
  return {.type = type, .access = Access::rw, .initial = initial};
}
constexpr EntryRow count{.access = Access::const_, .initial = 1};
constexpr EntryRow first(DataType type, Access access, std::int64_t initial = 0) {
  return {.sub_first = 1, .sub_last = 1, .type = type, .access = access, .initial = initial};
}

constexpr auto layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1001, .entry_count = 1},
                              {.index = 0x1010, .count = 2, .entry_count = 2},
                              {.index = 0x1017, .entry_count = 1},
                              {.index = 0x1F50, .entry_count = 2},
                              {.index = 0x1F51, .entry_count = 2},
                              {.index = 0x1F56, .count = 2, .entry_count = 2},
                              {.index = 0x6000, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {number(DataType::unsigned32, 0), number(DataType::unsigned8, 0), count,
         first(DataType::unsigned32, Access::rw, 1), number(DataType::unsigned16, 0), count,
         first(DataType::domain, Access::wo), count, first(DataType::unsigned8, Access::rw), count,
         first(DataType::unsigned32, Access::ro), number(DataType::unsigned32, 42)})));

constexpr std::uint32_t sector_size = 4096;

std::unique_ptr<host::FileFlash> open(const char* path, std::uint32_t sectors) {
  auto file = host::FileFlash::open(path, {.sector_size = sector_size, .sectors = sectors});
  if (file) return *std::move(file);
  std::fprintf(stderr, "%s\n", file.error().line().c_str());
  return nullptr;
}

class Peer {
 public:
  Peer(const Flash& parameters, const Flash& program)
      : storage_(device_.node(), parameters, {.slot_size = sector_size}),
        programs_(device_.node(), program, slots_) {}

  Node& node() { return device_.node(); }

 private:
  DeviceNode<layout> device_{pipe_port, 5};
  Storage storage_;
  std::array<ProgramSlot, 1> slots_{{{.address = 0, .size = 16 * sector_size}}};
  ProgramServer programs_;
};

}  // namespace

int main(int arguments, char** argument) {
  if (arguments != 3) return 2;
  const auto parameters = open(argument[1], 2);
  const auto program = open(argument[2], 16);
  if (parameters == nullptr || program == nullptr) return 1;
  canvoy::PipeNode<Peer>(parameters->flash(), program->flash()).run();
}
