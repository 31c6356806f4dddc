// A campaign of gaps in the communication of each world: 1 ms to 3 s, around each time after which
// a partner counts as lost, behind each node, at moments that matter in the world. A line for each
// wrong verdict, and for each building that stands still for longer than the gap and the time in
// which it is noticed; exit status 0: there was none.
//
//     canvoy_soak_gaps 1000          # seeds 1 to 1000 of each world
//     canvoy_soak_gaps 17 17         # seed 17 alone
#include <cstdint>
#include <cstdio>

#include "canvoy/sim/gap_runs.hpp"
#include "seeds.hpp"

namespace {

using namespace canvoy;

bool is_good(std::uint64_t seed) {
  bool good = true;
  for (const GapWorld& world : gap_worlds()) {
    const GapRun run = world.run(seed);
    for (const std::string& wrong : run.wrong) {
      std::printf("%s, seed %llu, %s: %s\n", world.name, static_cast<unsigned long long>(seed),
                  run.fault.c_str(), wrong.c_str());
      std::fflush(stdout);
    }
    good = good && run.wrong.empty();
  }
  return good;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_gaps", count, arguments, is_good);
}
