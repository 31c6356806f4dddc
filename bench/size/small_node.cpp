// The small node without SDO block transfers.
#include <new>

#include "bench/size/small_node.hpp"

using Node = canvoy::SmallNode<false>;

alignas(Node) static std::uint8_t memory[sizeof(Node)];

int main() {
  (new (memory) Node)->run();
}
